//! Figures that exist in a state and are not shown: what does not balance, and what no double holds.

use super::{Aspect, FigureSource, Quantity, Share, Subject};
use crate::solver::{ForceCheck, Order, State, Withheld};
use crate::wording::words;

/// Why some figures of a state are not shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Hidden {
    /// The driver's coordinate.
    pub at: f64,
    /// The reason.
    pub why: Reason,
}

/// Why a figure is not shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Two ways to find the forces disagree: no force, torque or power of the state is shown.
    Unbalanced {
        /// What is left of the check, as columns are named, and its unit.
        residual: [String; 2],
        /// How much that is.
        missed: f64,
        /// What rounding explains of it.
        most: f64,
    },
    /// Some force is too large for a double: none is shown.
    Forces,
    /// This figure is too large for a double.
    Figure(String),
}

impl Hidden {
    /// What is not shown of these figures in this state; `None` where all that exist are.
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

    /// Why the forces of this state are withheld; `None` where they are not.
    #[must_use]
    pub fn of_forces(state: &State) -> Option<Hidden> {
        let why = match state.withheld()? {
            Withheld::Overflow => Reason::Forces,
            Withheld::Unbalanced { check, most } => Reason::Unbalanced {
                residual: residual(check, state),
                missed: state.residual().map_or(f64::NAN, |of| of.of(check).abs()),
                most,
            },
        };
        Some(Hidden {
            at: state.at(),
            why,
        })
    }

    /// The reason in a sentence without its full stop; `unit` is that of the driver's coordinate.
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let at = format!("{} {unit}", self.at);
        match &self.why {
            Reason::Unbalanced {
                residual: [name, unit],
                missed,
                most,
            } => {
                let [missed, most] = [missed, most].map(|size| format!("{size:.1e}"));
                words().forces_disagree(&at, name, &format!("{missed} {unit}"), &most)
            }
            Reason::Forces => words().forces_too_large(&at),
            Reason::Figure(name) => words().figure_too_large(name, &at),
        }
    }
}

/// What a check leaves, as columns are named, with its unit.
fn residual(check: ForceCheck, state: &State) -> [String; 2] {
    let (of, aspect) = match check {
        ForceCheck::Drive if state.turns() => ("driver", Aspect::Torque),
        ForceCheck::Drive => ("driver", Aspect::Force),
        ForceCheck::ForceX => ("ground", Aspect::Fx),
        ForceCheck::ForceY => ("ground", Aspect::Fy),
        ForceCheck::Moment => ("ground", Aspect::Moment),
    };
    let residual = Share::Residual.name().unwrap_or_default();
    // Forces have their units whatever that of lengths is.
    [
        format!("{of}.{}.{residual}", aspect.name()),
        aspect.unit(""),
    ]
}

impl Quantity {
    /// Whether the figure exists in this state and is too large for a double.
    pub(crate) fn overflows(&self, state: &State) -> bool {
        let found = self.found(state);
        match self.source {
            // Of two points in one place no direction exists: that is no number, and none too large. So it is with
            // what a formula leaves open.
            FigureSource::Solved(Subject::Between(..), _) | FigureSource::Derived(_) => {
                found.is_some_and(f64::is_infinite)
            }
            FigureSource::Solved(..) => found.is_some_and(|value| !value.is_finite()),
        }
    }
}
