//! Solves states again in double-double precision, as a reference for other results.

use super::Exact;
use crate::Double;
use crate::solver::elements::{ACCELERATION, POSITION, StepOutcome, VELOCITY};
use crate::solver::engine::Engine;
use crate::solver::state::{Condition, State};
use crate::solver::{Order, Solver, Workspace};

impl Solver {
    /// Creates a workspace in double-double precision.
    #[must_use]
    pub fn twice(&self) -> Workspace<Double> {
        let mut twice: Workspace<Double> = self.workspace();
        if let Some(intended) = self.close_state() {
            (twice.state.points, twice.state.links) = (intended.points, intended.links);
        }
        self.engine.reserve_work(&mut twice);
        twice
    }

    /// Solves `state` again in double-double precision from the typed decimals. Dyads use their
    /// formulas, coupled groups correct the solution found in doubles. Returns `true` if it was
    /// solved: not at the limits of the motion, and not at change points. Allocates nothing.
    pub fn solve_twice(
        &self,
        state: &State,
        order: Order,
        workspace: &mut Workspace<Double>,
    ) -> bool {
        let twice = &mut workspace.state;
        let order = order.min(state.order);
        twice.start(self.intended_coordinate(state.at), order);
        twice.condition = state.condition;
        if state.condition != Condition::Ok {
            twice.forget_forces();
            return false;
        }
        for (sign, &of) in twice.signs.iter_mut().zip(&state.signs) {
            *sign = Double::exactly(of);
        }
        let engine = self.exact.as_ref().map_or(&self.engine, |e| &e.engine);
        let solved = match order {
            Order::Position => engine.run_twice::<POSITION>(state, workspace),
            Order::Velocity => engine.run_twice::<VELOCITY>(state, workspace),
            Order::Acceleration | Order::Force => {
                engine.run_twice::<ACCELERATION>(state, workspace)
            }
        };
        self.balance(order, workspace);
        solved
    }
}

impl Exact {
    /// Creates a workspace in double-double precision.
    pub(in crate::solver) fn twice(&self, slides: usize) -> Workspace<Double> {
        let mut twice = self.engine.state(slides);
        self.engine.reserve_work(&mut twice);
        twice
    }

    /// Runs the first `steps` steps with the signs of `near`, a state in doubles at this coordinate.
    /// Coupled groups correct their solution in it. Returns `false` if a step is open or singular.
    pub(in crate::solver) fn run_twice(
        &self,
        steps: usize,
        at: Double,
        near: &State,
        workspace: &mut Workspace<Double>,
    ) -> bool {
        let Workspace { state, scratch, .. } = workspace;
        let closed = steps.min(self.closed);
        let how = (&near.signs[..], None);
        if self.run(closed, at, Order::Acceleration, how, state) != Condition::Ok {
            return false;
        }
        let (q, direction) = self.engine.coordinate(at);
        let mut others = self.engine.program.steps[closed..steps].iter();
        others.all(|step| match step.coupled() {
            Some(index) => {
                let group = &self.engine.program.coupled[index];
                group.refine(q, ACCELERATION, near, state, scratch)
            }
            None => step.run_to(ACCELERATION, (q, direction), state) == StepOutcome::Done,
        })
    }
}

impl Engine {
    /// Allocates the memory in which coupled groups correct their solutions.
    fn reserve_work(&self, workspace: &mut Workspace<Double>) {
        let groups = self.program.coupled.iter();
        let work = groups.map(|g| g.unknowns() * (g.unknowns() + 1)).max();
        workspace.scratch.work = vec![0.0; work.unwrap_or(0)];
    }

    fn run_twice<const ORDER: u8>(&self, state: &State, workspace: &mut Workspace<Double>) -> bool {
        self.run_in::<Double, ORDER>(workspace.state.at, workspace, |group, q, twice, scratch| {
            group.refine(q, ORDER, state, twice, scratch)
        })
    }
}
