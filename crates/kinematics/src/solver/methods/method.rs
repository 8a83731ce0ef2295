//! The methods that are set against each other, and why one of them cannot be used.

use crate::PointId;

/// Where Newton's method begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// At the position before, a degree away, or a 360th of the range.
    Warm,
    /// Where the scene opens, whatever the position.
    Cold,
}

/// A way from the driver's coordinate to a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Every dyad in closed form: what the solver does where there are only dyads.
    ClosedForm,
    /// The closed form, and one correction from a residual of twice the precision.
    Polished,
    /// Newton's method from the nearest state that was kept: what the solver does for coupled groups.
    Anchored,
    /// What the solver does, and a proven bound for every figure.
    Bounded,
    /// The same formulas in single precision.
    Single,
    /// Newton's method as in textbooks: full steps until one is smaller than the tolerance.
    Newton {
        /// In radians, and in parts of about the longest length.
        tolerance: f64,
        /// Where it begins.
        start: Start,
    },
    /// Halving an interval of the one unknown angle of each group.
    Bisection,
    /// Runge and Kutta's method of fourth order on the velocities, from the beginning of the cycle.
    Integration {
        /// Steps in 360 degrees.
        steps: u16,
        /// The cycle in which the error is looked at, counted from 1.
        turns: u16,
    },
}

/// Why a method cannot be used for a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// A group, named by one of its points, has no closed form.
    Coupled(Option<PointId>),
    /// Every group has a closed form, so that there is nothing to be iterated.
    AllClosed,
    /// A group closes by more than one condition at once.
    Conditions {
        /// A point of the group.
        point: Option<PointId>,
        /// The unknowns that are solved for at once.
        unknowns: usize,
    },
    /// The driver has limits, which no integration can pass.
    Limits,
    /// The constraints of a group cannot be written as rows of their own.
    NoRows,
}
