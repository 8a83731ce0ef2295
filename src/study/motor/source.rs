//! What the driver must do in one state of the cycle, as the solver finds it.

use super::Effort;
use super::course::Course;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{Mechanism, Vec2};

/// Solves at places of a cycle, on the way back with the opposite speed.
#[derive(Clone, Debug)]
pub(super) struct CycleSource {
    solvers: [Solver; 2],
}

/// What the driver must do in a state, and what the ground feels; what does not exist there is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The driver's coordinate.
    pub at: f64,
    /// The condition of the state.
    pub condition: Condition,
    /// What the driver must do, in N m or N, positive along its coordinate.
    pub torque: Option<f64>,
    /// What of it goes into loads, gravity and inertia.
    pub parts: Option<[f64; 3]>,
    /// The power of the driver in W.
    pub power: Option<f64>,
    /// The force of the mechanism on the ground in N, and its moment about the scene's origin in N m.
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

    /// States to solve into, one for each way.
    pub(super) fn states(&self) -> [Workspace; 2] {
        self.solvers.each_ref().map(Solver::state)
    }

    pub(super) fn step(&self, at: f64, back: bool, states: &mut [Workspace; 2]) -> Step {
        let way = usize::from(back);
        let state = &mut states[way];
        let condition = self.solvers[way].solve(at, Order::Force, state);
        Step::of(state, condition)
    }

    /// The cycle in equal steps of the way, its beginning and its end included.
    pub(super) fn steps(&self, course: Course, count: u32) -> impl Iterator<Item = (f64, Step)> {
        let mut states = self.states();
        (0..=count).map(move |k| {
            let way = course.length() * (f64::from(k) / f64::from(count));
            let place = course.place(way);
            (way, self.step(place.at, place.back, &mut states))
        })
    }
}

impl Step {
    /// Of a state that was solved with its forces.
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

    /// All figures; those that inertia takes part in without it, where the cycle is a slow one. `None`
    /// where the driver's do not exist; the ground's are then 0.
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
