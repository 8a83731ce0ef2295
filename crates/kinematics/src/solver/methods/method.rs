//! Defines the compared methods, and the reasons why one cannot be used.

use crate::PointId;

/// The initial value of Newton's method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// The previous position, a degree away or a 360th of the range.
    Warm,
    /// The start position of the scene, for every position.
    Cold,
}

/// A method for computing a state from the driver's coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Every dyad in closed form, as the solver does for mechanisms of dyads only.
    ClosedForm,
    /// The closed form, with one correction by a residual in double-double.
    Polished,
    /// Newton's method from the nearest stored state, as the solver does for coupled groups.
    Anchored,
    /// The solver's method, with a proven error bound for every value.
    Bounded,
    /// The solver's formulas in single precision.
    Single,
    /// Newton's method as in textbooks: full steps until one is smaller than the tolerance.
    Newton {
        /// The tolerance in radians, and relative to about the longest length.
        tolerance: f64,
        /// The initial value.
        start: Start,
    },
    /// Bisection for the one unknown angle of each group.
    Bisection,
    /// The fourth-order Runge-Kutta method on the velocities, from the beginning of the cycle.
    Integration {
        /// The number of steps in 360 degrees.
        steps: u16,
        /// The cycle in which the error is measured, counted from 1.
        turns: u16,
    },
}

/// The reason why a method cannot be used for a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unsuitable {
    /// A group, named by one of its points, has no closed form.
    Coupled(Option<PointId>),
    /// Every group has a closed form, so that no iteration is needed.
    AllClosed,
    /// A group with several equations that must be solved together.
    Conditions {
        /// A point of the group.
        point: Option<PointId>,
        /// The number of unknowns of the group.
        unknowns: usize,
    },
    /// The driver has limits, which an integration cannot pass.
    Limits,
    /// The constraints of a group cannot be written as rows.
    NoRows,
}
