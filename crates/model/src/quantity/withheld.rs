//! Explains why existing values are not shown: forces that fail their check, and values too large
//! for a double.

use super::{Aspect, Quantity, QuantitySource, Share, Subject};
use crate::solver::{ForceCheck, Order, State, WithheldReason};
use crate::wording::words;

/// The reason why some values of a state are not shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Hidden {
    /// The driver's coordinate.
    pub at: f64,
    /// The reason.
    pub why: Reason,
}

/// The reason why a value is not shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Two computations of the forces disagree: no force, torque or power of the state is shown.
    Unbalanced {
        /// The name of the check's residual, in the form of a column, and its unit.
        residual: [String; 2],
        /// The residual.
        missed: f64,
        /// The maximum that rounding explains.
        most: f64,
    },
    /// A force is too large for a double: no forces are shown.
    Forces,
    /// The named value is too large for a double.
    Figure(String),
}

impl Hidden {
    /// Returns the first reason why one of these quantities is not shown in this state; `None` if
    /// all existing values are shown.
    #[must_use]
    pub fn of<'a>(
        quantities: impl IntoIterator<Item = &'a Quantity>,
        state: &State,
    ) -> Option<Hidden> {
        quantities.into_iter().find_map(|quantity| {
            if quantity.order() == Order::Force
                && let Some(hidden) = Hidden::of_forces(state)
            {
                return Some(hidden);
            }
            let name = || Reason::Figure(quantity.name.clone());
            let why = quantity.overflows(state).then(name)?;
            Some(Hidden {
                at: state.at(),
                why,
            })
        })
    }

    /// Returns the reason why the forces of this state are not shown; `None` if they are.
    #[must_use]
    pub fn of_forces(state: &State) -> Option<Hidden> {
        let why = match state.withheld()? {
            WithheldReason::Overflow => Reason::Forces,
            WithheldReason::Unbalanced {
                check,
                most: maximum,
            } => Reason::Unbalanced {
                residual: residual(check, state),
                missed: state.residual().map_or(f64::NAN, |of| of.of(check).abs()),
                most: maximum,
            },
        };
        Some(Hidden {
            at: state.at(),
            why,
        })
    }

    /// Returns the reason as a sentence without a full stop. `unit` is that of the driver's
    /// coordinate.
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let at = format!("{} {unit}", self.at);
        match &self.why {
            Reason::Unbalanced {
                residual: [name, unit],
                missed,
                most: maximum,
            } => {
                let [missed, maximum] = [missed, maximum].map(|size| format!("{size:.1e}"));
                words().forces_disagree(&at, name, &format!("{missed} {unit}"), &maximum)
            }
            Reason::Forces => words().forces_too_large(&at),
            Reason::Figure(name) => words().figure_too_large(name, &at),
        }
    }
}

/// Returns the name of a check's residual, in the form of a column, and its unit.
fn residual(check: ForceCheck, state: &State) -> [String; 2] {
    let (of, aspect) = match check {
        ForceCheck::Drive if state.turns() => ("driver", Aspect::Torque),
        ForceCheck::Drive => ("driver", Aspect::Force),
        ForceCheck::ForceX => ("ground", Aspect::Fx),
        ForceCheck::ForceY => ("ground", Aspect::Fy),
        ForceCheck::Moment => ("ground", Aspect::Moment),
    };
    let residual = Share::Residual.name().unwrap_or_default();
    // The units of forces do not depend on the length unit.
    [
        format!("{of}.{}.{residual}", aspect.name()),
        aspect.unit(""),
    ]
}

impl Quantity {
    /// Returns `true` if the value exists in this state and is too large for a double.
    pub(crate) fn overflows(&self, state: &State) -> bool {
        let found = self.found(state);
        match self.source {
            // Two coincident points have no direction, which gives NaN but is no overflow. The same
            // applies to indeterminate formulas.
            QuantitySource::Solved(Subject::Between(..), _) | QuantitySource::Derived(_) => {
                found.is_some_and(f64::is_infinite)
            }
            QuantitySource::Solved(..) => found.is_some_and(|value| !value.is_finite()),
        }
    }
}
