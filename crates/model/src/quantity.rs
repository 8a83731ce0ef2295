//! Defines quantities: everything with a name, a unit and a value.
//!
//! Tables, plots, CSV columns, JSON keys and the demand on the solver are all derived from them.

mod catalogue;
mod clock;
mod curves;
mod derived;
mod driver_state;
mod formulas;
mod magnitude;
mod range_exceeded;
mod sensitivity;
mod subject;
mod units;
mod value;
mod value_subject;
mod withheld;

pub use catalogue::{Catalogue, UnknownColumn};
pub use clock::Clock;
pub use curves::{Abscissa, Curve, Curves, Extremum, StateValues, TimeError};
pub use derived::Derived;
pub use driver_state::DriverState;
pub use formulas::check_figures;
pub use range_exceeded::MotionOutOfRange;
pub use sensitivity::length_name;
pub use sensitivity::{Derivatives, MAX_DERIVATIVES, Sensitivity};
pub use subject::{Aspect, Share, Subject};
pub use units::{known_unit, other_units, rate_unit, unit_factor};
pub use value::{bound, state_word, value};
pub use withheld::{Hidden, Reason};

use crate::expression::{DirectionCut, LengthScale, Revolution};
use crate::solver::{Demand, Order, State};
use crate::{Ball, Dual, Number};
use std::sync::Arc;

/// A quantity that can be displayed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// The column name: `C.vx`, `r3.omega`, `r4.length`, `r3.com.x`.
    pub name: String,
    /// The unit: `mm/s`.
    pub unit: String,
    /// The source of its value.
    pub source: QuantitySource,
}

/// The source of a quantity's value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum QuantitySource {
    /// Computed by the solver: the subject and its aspect.
    Solved(Subject, Aspect),
    /// Computed from other quantities.
    Derived(Arc<Derived>),
}

impl Quantity {
    /// Returns the value in this state, or `None` if it does not exist.
    #[must_use]
    pub fn value<T: Number>(&self, state: &State<T>) -> Option<T> {
        self.found(state).filter(|v| v.is_finite())
    }

    /// Returns the value in this state, which may be infinite or NaN.
    fn found<T: Number>(&self, state: &State<T>) -> Option<T> {
        match &self.source {
            QuantitySource::Solved(subject, aspect) => value::found(*subject, *aspect, state),
            QuantitySource::Derived(derived) => {
                derived.run(|subject, aspect| value::found(subject, aspect, state))
            }
        }
    }

    /// Returns the value computed from the solver's values given by `find`; `None` if one of these
    /// is missing.
    #[must_use]
    pub fn made_of(&self, find: impl Fn(Subject, Aspect) -> Option<f64>) -> Option<f64> {
        let made = match &self.source {
            QuantitySource::Solved(subject, aspect) => find(*subject, *aspect),
            QuantitySource::Derived(derived) => derived.run(find),
        };
        made.filter(|v| v.is_finite())
    }

    /// Returns a bound on the error of the value in this state, in the quantity's unit. Returns
    /// `None` if there is no value or no bound can be proved.
    #[must_use]
    pub fn bound(&self, state: &State, enclosure: &State<Ball>) -> Option<f64> {
        let (value, ball) = (self.value(state)?, self.value(enclosure)?);
        value::distance_bound(value, ball, self.is_direction())
    }

    /// Returns `true` if its formula has kinks.
    pub(crate) fn has_sides(&self) -> bool {
        matches!(&self.source, QuantitySource::Derived(derived) if derived.has_sides())
    }

    /// Returns the steps of its formula that may be at a kink in this state, within the bounds of
    /// their arguments.
    fn kinks(&self, enclosure: &State<Ball>) -> Vec<usize> {
        match &self.source {
            QuantitySource::Solved(..) => Vec::new(),
            QuantitySource::Derived(derived) => {
                derived.kinks(|subject, aspect| value::found(subject, aspect, enclosure))
            }
        }
    }

    /// Returns the derivative with these steps of its formula on the other side of their kinks.
    fn slope_beyond(&self, kinks: &[usize], state: &State<Dual>) -> Option<f64> {
        match &self.source {
            QuantitySource::Solved(..) => None,
            QuantitySource::Derived(derived) => {
                let found = |subject, aspect| value::found(subject, aspect, state);
                derived.beyond(kinks, found).map(|dual| dual.slope)
            }
        }
    }

    /// Returns the subject, if it has exactly one.
    #[must_use]
    pub fn subject(&self) -> Option<Subject> {
        match &self.source {
            QuantitySource::Solved(subject, _) => Some(*subject),
            QuantitySource::Derived(derived) => derived.subject(),
        }
    }

    /// Returns the aspect of its subject; `None` for a quantity computed from others.
    #[must_use]
    pub fn aspect(&self) -> Option<Aspect> {
        match &self.source {
            QuantitySource::Solved(_, aspect) => Some(*aspect),
            QuantitySource::Derived(_) => None,
        }
    }

    /// Returns `true` for the driver's coordinate.
    #[must_use]
    pub fn is_driver(&self) -> bool {
        matches!(self.source, QuantitySource::Solved(Subject::Driver, _))
    }

    /// Returns `true` for a direction, in degrees in [0, 360).
    #[must_use]
    pub fn is_direction(&self) -> bool {
        match &self.source {
            QuantitySource::Solved(subject, aspect) => {
                *aspect == Aspect::Angle && *subject != Subject::Driver
            }
            QuantitySource::Derived(derived) => {
                derived.kind().revolution == Some(Revolution::Wrapped)
            }
        }
    }

    /// Returns how it jumps where a direction in it passes a full turn.
    pub(crate) fn cut(&self) -> DirectionCut {
        match &self.source {
            QuantitySource::Solved(subject, aspect) => match aspect.kind(*subject).revolution {
                Some(Revolution::Wrapped | Revolution::Counted) => DirectionCut::ByTurns,
                None => DirectionCut::Nowhere,
            },
            QuantitySource::Derived(derived) => derived.cut(),
        }
    }

    /// Returns the order to which a state must be solved for it.
    #[must_use]
    pub fn order(&self) -> Order {
        match &self.source {
            QuantitySource::Solved(_, aspect) => aspect.order(),
            QuantitySource::Derived(derived) => {
                let orders = derived.parts().map(|(_, aspect)| aspect.order());
                orders.max().unwrap_or(Order::Position)
            }
        }
    }

    /// Returns the solver's values that it depends on: itself, for one computed by the solver.
    fn parts(&self) -> Vec<(Subject, Aspect)> {
        match &self.source {
            QuantitySource::Solved(subject, aspect) => vec![(*subject, *aspect)],
            QuantitySource::Derived(derived) => derived.parts().collect(),
        }
    }

    /// Returns the time derivative, if that is a quantity of a state: the velocity for a position,
    /// the acceleration for a velocity. Its name and unit remain those of this quantity.
    pub(crate) fn rate(&self) -> Option<Quantity> {
        let source = match &self.source {
            QuantitySource::Solved(subject, aspect) => {
                QuantitySource::Solved(*subject, aspect.rate()?)
            }
            QuantitySource::Derived(derived) => {
                QuantitySource::Derived(derived.rate().ok()?.into())
            }
        };
        Some(Quantity {
            source,
            ..self.clone()
        })
    }

    /// Returns the time derivative of a formula's value, in its own unit.
    ///
    /// # Errors
    /// The name of the quantity without a derivative.
    fn differentiated(&self, length: LengthScale) -> Result<Quantity, String> {
        let QuantitySource::Derived(derived) = &self.source else {
            return Err(self.name.clone());
        };
        let rate = derived.rate()?;
        Ok(Quantity {
            unit: rate.kind().dimension.symbol(length.symbol),
            source: QuantitySource::Derived(rate.into()),
            ..self.clone()
        })
    }

    /// Returns the name with the unit in brackets, as a column header.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// Returns the demand on the solver for these quantities, and the order to which it must solve.
#[must_use]
pub fn demand<'a>(quantities: impl IntoIterator<Item = &'a Quantity>) -> (Demand, Order) {
    let mut demand = Demand::default();
    let mut order = Order::Position;
    let parts = quantities.into_iter().flat_map(Quantity::parts);
    for (subject, aspect) in parts {
        if subject != Subject::Driver {
            order = order.max(aspect.order());
        }
        match subject {
            Subject::Driver => {}
            Subject::Point(point) => demand.points.push(point),
            Subject::Link(link) => demand.links.push(link),
            Subject::Slide(slide) => demand.slides.push(slide),
            Subject::Between(tail, head) => demand.points.extend([tail, head]),
            Subject::Drive(_) | Subject::Joint(..) | Subject::Frame | Subject::FrameResidual => {}
        }
        demand.forces |= aspect.order() == Order::Force;
    }
    (demand, order)
}
