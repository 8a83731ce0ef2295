//! Where a driver is, and how it passes there.

use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{DriverMoment, Number};

/// Where a driver is, and how it passes there where that is not by the scene's speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverStand {
    /// In degrees or in the scene's length unit.
    pub at: f64,
    /// Its speed and its acceleration there, of a scene with a motion over time.
    pub pace: Option<DriverMoment>,
}

impl DriverStand {
    /// At a coordinate that it passes with the scene's speed.
    #[must_use]
    pub fn at(at: f64) -> DriverStand {
        DriverStand { at, pace: None }
    }

    /// Lets the driver of these states pass so from their next solution on, see [`Solver::drive`].
    pub fn drive<T: Number>(&self, solver: &Solver, work: &mut Workspace<T>) {
        if let Some(moment) = &self.pace {
            solver.drive(work, moment);
        }
    }

    /// Solves the state in which it passes so.
    pub fn solve(&self, solver: &Solver, order: Order, work: &mut Workspace) -> Condition {
        self.drive(solver, work);
        solver.solve(self.at, order, work)
    }
}
