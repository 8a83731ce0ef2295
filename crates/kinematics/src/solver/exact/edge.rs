//! Evaluates states in double-double where doubles lose too much precision.
//!
//! Near an end of its motion, a mechanism's distance from its limit position is the square root of
//! the remaining travel. Doubles lose half of their digits there, and within some rounding errors
//! of the end they cannot even decide whether it closes. The steps before the first coupled group
//! are then run in double-double from the typed decimals, and the values are rounded once.

use crate::solver::exact::Exact;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{Condition, LinkState, PointState, State, TravelState};
use crate::solver::{Order, Solver, Workspace};
use crate::{Double, Number};

impl Solver {
    /// Solves at any coordinate, with the motion's knowledge of its ends, and in double-double
    /// where doubles do not suffice.
    #[cold]
    pub(in crate::solver) fn solve_closely(
        &self,
        at: f64,
        order: Order,
        workspace: &mut Workspace,
    ) {
        workspace.state.start(at, order);
        workspace.state.condition = Condition::NoAssembly;
        if !self.motion.covers(at) {
            return;
        }
        let mut found = at;
        let is_coupled = !self.engine.program.coupled.is_empty();
        if self.solve_closely_at(at, order, workspace) == Condition::NoAssembly {
            let exists = |&at: &f64| {
                let condition = match is_coupled {
                    true => self.run(at, order, workspace),
                    false => self.solve_closely_at(at, order, workspace),
                };
                condition != Condition::NoAssembly
            };
            found = self.motion.drawn_back(at).find(exists).unwrap_or(at);
        }
        let state = &mut workspace.state;
        state.at = at;
        // Within rounding of a limit, rates are as worthless as at the limit itself.
        let is_dead = found != at || self.motion.is_dead_point(at);
        if state.condition == Condition::Ok && is_dead {
            state.condition = Condition::DeadPoint;
        }
    }

    fn solve_closely_at(&self, at: f64, order: Order, workspace: &mut Workspace) -> Condition {
        let Some(exact) = self.exact.as_ref().filter(|_| !self.is_overridden(at)) else {
            return self.run(at, order, workspace);
        };
        let Some(mut close) = workspace.close.take() else {
            return self.run(at, order, workspace);
        };
        self.aim(at, workspace);
        let how = (&workspace.state.signs[..], self.motion.stretched_at(at));
        let mut condition = exact.run(exact.closed, Double::exactly(at), order, how, &mut close);
        exact.write(exact.closed, &close, &mut workspace.state);
        workspace.close = Some(close);
        let after = exact.closed..self.engine.program.steps.len();
        if condition != Condition::NoAssembly && !after.is_empty() {
            let found = self.engine.run_steps(after, at, order, workspace);
            if found != Condition::Ok {
                condition = found;
            }
        }
        workspace.state.condition = condition;
        condition
    }

    /// Solves the steps before the first coupled group again in double-double, if that improves
    /// them.
    #[cold]
    pub(in crate::solver) fn refine(&self, at: f64, order: Order, workspace: &mut Workspace) {
        let Some(exact) = self.exact.as_ref().filter(|_| !self.is_overridden(at)) else {
            return;
        };
        let Some(mut close) = workspace.close.take() else {
            return;
        };
        let how = (&workspace.state.signs[..], None);
        let intended = self.intended_coordinate(at);
        if exact.run(exact.closed, intended, order, how, &mut close) == Condition::Ok {
            exact.write(exact.closed, &close, &mut workspace.state);
            let after = exact.closed..self.engine.program.steps.len();
            if self.engine.run_steps(after, at, order, workspace) != Condition::Ok {
                let _ = self.run_between(at, order, workspace);
            }
        }
        workspace.close = Some(close);
    }

    /// Returns `true` if data kept by the motion replaces the solution at a coordinate: a fold, or
    /// a series.
    fn is_overridden(&self, at: f64) -> bool {
        self.motion.fold_at(at).is_some() || self.is_passing(at)
    }
}

impl Exact {
    /// Writes the results of the first `steps` steps, rounded to doubles.
    pub(in crate::solver) fn write(&self, steps: usize, from: &State<Double>, to: &mut State) {
        let program = &self.engine.program;
        for step in &program.steps[..steps] {
            step.outputs(&program.coupled, &mut |part| match part {
                PlacedPart::Point(point) => {
                    let PointState { p, v, a } = from.points[point.index()];
                    let [p, v, a] = [p, v, a].map(|v| v.nearest());
                    to.points[point.index()] = PointState { p, v, a };
                }
                PlacedPart::Link(link) => {
                    to.links[link.index()] = rounded(&from.links[link.index()]);
                }
                PlacedPart::Slide(slide) => {
                    let TravelState { s, v, a, guide } = &from.travels[slide.index()];
                    to.travels[slide.index()] = TravelState {
                        s: s.nearest(),
                        v: v.nearest(),
                        a: a.nearest(),
                        guide: rounded(guide),
                    };
                }
            });
            if let Some(group) = step.choice() {
                to.measures[group] = from.measures[group].nearest();
            }
        }
    }
}

fn rounded(link: &LinkState<Double>) -> LinkState {
    LinkState {
        d: link.d.nearest(),
        w: link.w.nearest(),
        a: link.a.nearest(),
    }
}
