//! Solves the driving torque in one state of a cycle.

use super::Effort;
use super::cycle_travel::CyclePath;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{Mechanism, Vec2};

/// Solves at places of a cycle, with the opposite speed on the way back.
#[derive(Clone, Debug)]
pub(super) struct CycleSource {
    solvers: [Solver; 2],
}

/// The driving torque in a state, and the force on the ground; `None` for values that do not exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The driver's coordinate.
    pub at: f64,
    /// The condition of the state.
    pub condition: Condition,
    /// The driving torque in N m, or force in N, positive along the coordinate.
    pub torque: Option<f64>,
    /// The parts of the torque due to loads, gravity and inertia.
    pub parts: Option<[f64; 3]>,
    /// The driver's power in W.
    pub power: Option<f64>,
    /// The force of the mechanism on the ground in N, and its moment about the scene's origin in N
    /// m.
    pub ground: Option<(Vec2, f64)>,
}

impl CycleSource {
    pub(super) fn new(mechanism: &Mechanism, solver: &Solver) -> CycleSource {
        let driver = mechanism.driver();
        let back = solver.at_speed(-driver.speed, -driver.acceleration);
        CycleSource {
            solvers: [solver.clone(), back],
        }
    }

    /// Creates the states to solve into, one per direction.
    pub(super) fn states(&self) -> [Workspace; 2] {
        self.solvers.each_ref().map(Solver::state)
    }

    pub(super) fn step(&self, at: f64, back: bool, states: &mut [Workspace; 2]) -> Step {
        let travel = usize::from(back);
        let state = &mut states[travel];
        let condition = self.solvers[travel].solve(at, Order::Force, state);
        Step::of(state, condition)
    }

    /// Returns the cycle in equal steps of the travel, including both ends.
    pub(super) fn steps(&self, course: CyclePath, count: u32) -> impl Iterator<Item = (f64, Step)> {
        let mut states = self.states();
        (0..=count).map(move |k| {
            let travel = course.length() * (f64::from(k) / f64::from(count));
            let place = course.place(travel);
            (travel, self.step(place.at, place.back, &mut states))
        })
    }
}

impl Step {
    /// Reads the values of a state solved with its forces.
    pub(super) fn of(state: &Workspace, condition: Condition) -> Step {
        let exists = |v: &f64| v.is_finite();
        Step {
            at: state.at(),
            condition,
            torque: state.drive().filter(exists),
            parts: state.drive_parts().filter(|p| p.iter().all(exists)),
            power: state.power().filter(exists),
            ground: state.frame_force().zip(state.frame_moment()),
        }
    }

    /// Returns all values; with `is_slow`, those without the effects of inertia. Returns `None` if
    /// the torque does not exist. A force on the ground that does not exist is 0.
    pub(super) fn effort(&self, is_slow: bool) -> Option<Effort> {
        let (mut torque, mut parts) = (self.torque?, self.parts?);
        if is_slow {
            parts[2] = 0.0;
            torque = parts[0] + parts[1];
        }
        let ground = self.ground.filter(|_| !is_slow);
        let (force, moment) = ground.unwrap_or((Vec2::ZERO, 0.0));
        Some(Effort {
            torque,
            parts,
            force,
            moment,
        })
    }
}
