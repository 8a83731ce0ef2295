//! Solves states again in double-double precision, as a reference for other results.

use crate::Double;
use crate::solver::elements::{ACCELERATION, POSITION, VELOCITY};
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
        let groups = self.engine.program.coupled.iter();
        let work = groups.map(|g| g.unknowns() * (g.unknowns() + 1)).max();
        twice.scratch.work = vec![0.0; work.unwrap_or(0)];
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

impl Engine {
    fn run_twice<const ORDER: u8>(&self, state: &State, workspace: &mut Workspace<Double>) -> bool {
        self.run_in::<Double, ORDER>(workspace.state.at, workspace, |group, q, twice, scratch| {
            group.refine(q, ORDER, state, twice, scratch)
        })
    }
}
