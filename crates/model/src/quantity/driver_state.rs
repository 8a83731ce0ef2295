//! Describes a driver's coordinate together with its rates.

use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{DriverMoment, Number};

/// A driver's coordinate, with its rates if these are not the scene's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverState {
    /// The coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The speed and acceleration, in a scene with a motion law.
    pub pace: Option<DriverMoment>,
}

impl DriverState {
    /// Creates a state that passes the coordinate with the scene's speed.
    #[must_use]
    pub fn at(at: f64) -> DriverState {
        DriverState { at, pace: None }
    }

    /// Sets the driver's rates for the next solutions in this workspace, see [`Solver::drive`].
    pub fn drive<T: Number>(&self, solver: &Solver, workspace: &mut Workspace<T>) {
        if let Some(moment) = &self.pace {
            solver.drive(workspace, moment);
        }
    }

    /// Solves the mechanism in this state of the driver.
    pub fn solve(&self, solver: &Solver, order: Order, workspace: &mut Workspace) -> Condition {
        self.drive(solver, workspace);
        solver.solve(self.at, order, workspace)
    }
}
