//! Everything that has a name, a unit and a value.
//!
//! Tables, plots, CSV columns, JSON keys and the demand given to the solver all come from here.

mod catalogue;
mod clock;
mod curves;
mod derived;
mod formulas;
mod hidden;
mod leaving;
mod magnitude;
mod named;
mod sensitivity;
mod stand;
mod subject;
mod units;
mod value;

pub use catalogue::{Catalogue, UnknownColumn};
pub use clock::Clock;
pub use curves::{Abscissa, Curve, Curves, Extremum, Here, NoTime};
pub use derived::Derived;
pub use formulas::check_figures;
pub use hidden::{Hidden, Reason};
pub use leaving::MotionLeaves;
pub use sensitivity::length_name;
pub use sensitivity::{Derivatives, MOST_DERIVATIVES, Sensitivity};
pub use stand::DriverStand;
pub use subject::{Aspect, Share, Subject};
pub use units::{known_unit, other_units, rate_unit, unit_factor};
pub use value::{bound, state_word, value};

use crate::expression::{DirectionCut, LengthScale, Revolution};
use crate::solver::{Demand, Order, State};
use crate::{Ball, Dual, Number};
use std::sync::Arc;

/// A figure that can be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// The column's name: `C.vx`, `r3.omega`, `r4.length`, `r3.com.x`.
    pub name: String,
    /// The unit: `mm/s`.
    pub unit: String,
    /// Where its value comes from.
    pub source: FigureSource,
}

/// Where the value of a figure comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FigureSource {
    /// The solver finds it: what it is about, and which of its figures.
    Solved(Subject, Aspect),
    /// It is made of others.
    Derived(Arc<Derived>),
}

impl Quantity {
    /// The value in this state, or `None` where none exists.
    #[must_use]
    pub fn value<T: Number>(&self, state: &State<T>) -> Option<T> {
        self.found(state).filter(|v| v.is_finite())
    }

    /// The same, though it may be too large for a number.
    fn found<T: Number>(&self, state: &State<T>) -> Option<T> {
        match &self.source {
            FigureSource::Solved(subject, aspect) => value::found(*subject, *aspect, state),
            FigureSource::Derived(derived) => {
                derived.run(|subject, aspect| value::found(subject, aspect, state))
            }
        }
    }

    /// The value that it is made of, where `find` tells the figures of the solver; `None` where one of these is
    /// missing.
    #[must_use]
    pub fn made_of(&self, find: impl Fn(Subject, Aspect) -> Option<f64>) -> Option<f64> {
        let made = match &self.source {
            FigureSource::Solved(subject, aspect) => find(*subject, *aspect),
            FigureSource::Derived(derived) => derived.run(find),
        };
        made.filter(|v| v.is_finite())
    }

    /// How far the value in this state can be from the true one, in the same unit; `None` where
    /// there is no value, or no bound can be proved.
    #[must_use]
    pub fn bound(&self, state: &State, enclosure: &State<Ball>) -> Option<f64> {
        let (value, ball) = (self.value(state)?, self.value(enclosure)?);
        value::apart(value, ball, self.is_direction())
    }

    /// Whether it can turn over, by a formula.
    fn has_sides(&self) -> bool {
        matches!(&self.source, FigureSource::Derived(derived) if derived.has_sides())
    }

    /// The steps of its formula that may turn over in this state, within the bounds of what they take.
    fn kinks(&self, enclosure: &State<Ball>) -> Vec<usize> {
        match &self.source {
            FigureSource::Solved(..) => Vec::new(),
            FigureSource::Derived(derived) => {
                derived.kinks(|subject, aspect| value::found(subject, aspect, enclosure))
            }
        }
    }

    /// The derivative with these steps of its formula on their other side.
    fn slope_beyond(&self, kinks: &[usize], state: &State<Dual>) -> Option<f64> {
        match &self.source {
            FigureSource::Solved(..) => None,
            FigureSource::Derived(derived) => {
                let found = |subject, aspect| value::found(subject, aspect, state);
                derived.beyond(kinks, found).map(|dual| dual.slope)
            }
        }
    }

    /// What it is about, if that is one thing.
    #[must_use]
    pub fn subject(&self) -> Option<Subject> {
        match &self.source {
            FigureSource::Solved(subject, _) => Some(*subject),
            FigureSource::Derived(derived) => derived.subject(),
        }
    }

    /// Which figure of its subject it is; `None` where it is made of others.
    #[must_use]
    pub fn aspect(&self) -> Option<Aspect> {
        match &self.source {
            FigureSource::Solved(_, aspect) => Some(*aspect),
            FigureSource::Derived(_) => None,
        }
    }

    /// Whether it is the driver's coordinate.
    #[must_use]
    pub fn is_driver(&self) -> bool {
        matches!(self.source, FigureSource::Solved(Subject::Driver, _))
    }

    /// Whether it is a direction, in degrees from 0 to below 360.
    #[must_use]
    pub fn is_direction(&self) -> bool {
        match &self.source {
            FigureSource::Solved(subject, aspect) => {
                *aspect == Aspect::Angle && *subject != Subject::Driver
            }
            FigureSource::Derived(derived) => {
                derived.kind().revolution == Some(Revolution::Wrapped)
            }
        }
    }

    /// How it jumps where a direction that it is made of passes a full turn.
    pub(crate) fn cut(&self) -> DirectionCut {
        match &self.source {
            FigureSource::Solved(subject, aspect) => match aspect.kind(*subject).revolution {
                Some(Revolution::Wrapped | Revolution::Counted) => DirectionCut::ByTurns,
                None => DirectionCut::Nowhere,
            },
            FigureSource::Derived(derived) => derived.cut(),
        }
    }

    /// How far a state must be solved for it.
    #[must_use]
    pub fn order(&self) -> Order {
        match &self.source {
            FigureSource::Solved(_, aspect) => aspect.order(),
            FigureSource::Derived(derived) => {
                let orders = derived.parts().map(|(_, aspect)| aspect.order());
                orders.max().unwrap_or(Order::Position)
            }
        }
    }

    /// The figures of the solver that it is made of: itself, where it is one.
    fn parts(&self) -> Vec<(Subject, Aspect)> {
        match &self.source {
            FigureSource::Solved(subject, aspect) => vec![(*subject, *aspect)],
            FigureSource::Derived(derived) => derived.parts().collect(),
        }
    }

    /// What its slope over time is, if that is a quantity of a state: of a place the velocity, of that the
    /// acceleration. Its name and unit are still those of this one.
    pub(crate) fn rate(&self) -> Option<Quantity> {
        let source = match &self.source {
            FigureSource::Solved(subject, aspect) => FigureSource::Solved(*subject, aspect.rate()?),
            FigureSource::Derived(derived) => FigureSource::Derived(derived.rate().ok()?.into()),
        };
        Some(Quantity {
            source,
            ..self.clone()
        })
    }

    /// Of a figure that is made of others the slope over time in its own unit; the figure that has none, where it
    /// does not exist.
    fn differentiated(&self, length: LengthScale) -> Result<Quantity, String> {
        let FigureSource::Derived(derived) = &self.source else {
            return Err(self.name.clone());
        };
        let rate = derived.rate()?;
        Ok(Quantity {
            unit: rate.kind().dimension.symbol(length.symbol),
            source: FigureSource::Derived(rate.into()),
            ..self.clone()
        })
    }

    /// The name with the unit in brackets, as a column's header.
    #[must_use]
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// What the solver must do so that these can be read: the demand, and how far to solve.
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
