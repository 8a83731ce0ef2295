//! Everything that has a name, a unit and a value.
//!
//! Tables, plots, CSV columns, JSON keys and the demand given to the solver all come from here.

mod catalogue;
mod clock;
mod curves;
mod hidden;
mod named;
mod sensitivity;
mod subject;
mod value;

pub use catalogue::{Catalogue, UnknownColumn};
pub use clock::Clock;
pub use curves::{Abscissa, Curve, Curves, Extremum, Here, NoTime};
pub use hidden::{Hidden, Reason};
pub use sensitivity::{Derivatives, MOST_DERIVATIVES, Sensitivity};
pub use subject::{Aspect, Share, Subject};
pub use value::{bound, state_word, value};

use crate::solver::{Demand, Order, State};
use crate::{Ball, Number};

/// A figure that can be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// The column's name: `C.vx`, `r3.omega`, `r4.length`, `r3.com.x`.
    pub name: String,
    /// The unit: `mm/s`.
    pub unit: String,
    /// What it is about.
    pub subject: Subject,
    /// Which figure.
    pub aspect: Aspect,
}

impl Quantity {
    /// The value in this state, or `None` where none exists.
    #[must_use]
    pub fn value<T: Number>(&self, state: &State<T>) -> Option<T> {
        value(self.subject, self.aspect, state)
    }

    /// How far the value in this state can be from the true one, in the same unit; `None` where
    /// there is no value, or no bound can be proved.
    #[must_use]
    pub fn bound(&self, state: &State, enclosure: &State<Ball>) -> Option<f64> {
        bound(self.subject, self.aspect, state, enclosure)
    }

    /// What its slope over time is, if that is a quantity of a state: of a place the velocity, of that the
    /// acceleration. Its name and unit are still those of this one.
    fn rate(&self) -> Option<Quantity> {
        let aspect = self.aspect.rate()?;
        Some(Quantity {
            aspect,
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
    for quantity in quantities {
        if quantity.subject != Subject::Driver {
            order = order.max(quantity.aspect.order());
        }
        match quantity.subject {
            Subject::Driver => {}
            Subject::Point(point) => demand.points.push(point),
            Subject::Link(link) => demand.links.push(link),
            Subject::Slide(slide) => demand.slides.push(slide),
            Subject::Between(tail, head) => demand.points.extend([tail, head]),
            Subject::Drive(_) | Subject::Joint(..) | Subject::Frame | Subject::FrameResidual => {}
        }
        demand.forces |= quantity.aspect.order() == Order::Force;
    }
    (demand, order)
}
