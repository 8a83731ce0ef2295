//! The ends of a range, to the last digit.
//!
//! A walk ends where doubles end: within some roundings of the lengths of a dyad's reach, or of the
//! place where a coupled group folds. What ends there is known then, and its limit is the zero of a
//! function that is smooth: of a dyad the measure, in twice the precision; of a coupled group the
//! system of a fold.

use super::Folded;
use super::walk::Walker;
use crate::solver::Order;
use crate::solver::coupled::Correction;
use crate::solver::state::{Condition, State};
use crate::solver::step::{Outcome, POSITION, Step};
use crate::solver::workspace::Workspace;
use crate::solver::zero::zero;
use crate::{Double, Number};

/// Doublings of an ulp within which a limit is sought around where the walk ended.
const DOUBLINGS: i32 = 30;
/// Newton's steps to a fold, from a start that has half of the digits.
const FOLD_STEPS: usize = 20;
/// In a fold the corrections of z and of the null vector end at their rounding; that of the
/// coordinate then has all its digits. In units of about the longest link.
const FOLDED: f64 = 1e-11;
/// A fold further than this from where the walk ended is another one, in radians or scaled lengths.
const SAME_FOLD: f64 = 1e-6;

impl Walker<'_> {
    /// The limit at which the motion ends, to the last digit; `state` is the last one before it.
    pub(super) fn refined(&mut self, limit: f64, state: &Workspace) -> f64 {
        self.state.clone_from(state);
        let refined = self.ending_step(limit).and_then(|step| {
            if let Step::Coupled { index } = self.engine.program.steps[step] {
                self.fold(step, index, limit, state)
            } else {
                self.end_of_reach(step, limit)
            }
        });
        // A start within rounding of a limit belongs to the motion.
        let refined = refined.unwrap_or(limit);
        if self.ahead(refined) < 0.0 {
            self.start
        } else {
            refined
        }
    }

    fn ulp(&self, at: f64) -> f64 {
        f64::EPSILON * at.abs().max(self.start.abs())
    }

    /// The first step that cannot be done at a limit or just beyond it.
    fn ending_step(&mut self, limit: f64) -> Option<usize> {
        let by = self.sense * self.ulp(limit);
        let mut beyond = (0..DOUBLINGS).map(|k| limit + by * (f64::from(k).exp2() - 1.0));
        beyond.find_map(|at| {
            self.aim_at(at);
            let mut steps = 0..self.engine.program.steps.len();
            steps.find(|&i| {
                let order = Order::Position;
                self.engine.run_steps(i..i + 1, at, order, &mut self.state) != Condition::Ok
            })
        })
    }

    // ---- dyads

    /// Where a dyad's measure is zero, next to a limit; other steps have none.
    fn end_of_reach(&mut self, step: usize, limit: f64) -> Option<f64> {
        let group = self.engine.program.steps[step].choice()?;
        let mut exact = self.engine.state::<Double>(self.state.travels.len()).state;
        let signs = self.state.signs.iter();
        exact.signs = signs.map(|&s| Double::exactly(s)).collect();
        let by = self.sense * self.ulp(limit);
        let mut measure = |at: f64| self.exact_measure(step, group, at, &mut exact);
        let mut around = (2..DOUBLINGS).map(|k| by * f64::from(k).exp2());
        // Where the arms miss each other by a hair the motion ends before and begins again behind.
        let is_gap = measure(limit)? < 0.0;
        let (inside, outside) = around.find_map(|by| {
            let outside = if is_gap { limit } else { limit + by };
            let inside = limit - by;
            let (a, b) = (measure(inside)?, measure(outside)?);
            (a > 0.0 && b < 0.0).then_some(((inside, a), (outside, b)))
        })?;
        let found = zero(inside, outside, 0.0, &mut measure)?;
        // The measure has more digits than the coordinate: they tell the nearest double.
        let beside = found - by;
        let (here, there) = (measure(found)?, measure(beside)?);
        let correction = here * (found - beside) / (there - here);
        Some(
            found
                + if correction.is_finite() {
                    correction
                } else {
                    0.0
                },
        )
    }

    /// A dyad's measure, negative beyond its reach; in twice the precision where no coupled group
    /// comes before it.
    fn exact_measure(
        &mut self,
        step: usize,
        group: usize,
        at: f64,
        exact: &mut State<Double>,
    ) -> Option<f64> {
        let steps = &self.engine.program.steps[..=step];
        if steps.iter().any(|s| matches!(s, Step::Coupled { .. })) {
            self.aim_at(at);
            let inputs = self
                .engine
                .run_steps(0..step, at, Order::Position, &mut self.state);
            if inputs == Condition::NoAssembly {
                return None;
            }
            self.engine
                .place_dyad(&steps[step], at, &mut self.state.state);
            return Some(self.state.measures[group]);
        }
        let (q, direction) = self.engine.coordinate(Double::exactly(at));
        let mut inputs = steps[..step].iter();
        let is_done = |s: &Step, exact: &mut State<Double>| {
            s.run::<Double, POSITION>(q, direction, exact) == Outcome::Done
        };
        if !inputs.all(|s| is_done(s, exact)) {
            return None;
        }
        steps[step].run::<Double, POSITION>(q, direction, exact);
        Some(exact.measures[group].nearest())
    }

    // ---- coupled groups

    /// The fold of a coupled group that is next to a limit: Newton on {F = 0, J v = 0, c.v = 1}. Keeps
    /// the state there, since the group's own matrix is singular.
    fn fold(&mut self, step: usize, index: usize, limit: f64, state: &Workspace) -> Option<f64> {
        let group = &self.engine.program.coupled[index];
        self.state.clone_from(state);
        let mut fold = group.fold(&mut self.state.scratch)?;
        let (mut at, mut last) = (limit, f64::INFINITY);
        for _ in 0..FOLD_STEPS {
            let inputs = 0..step;
            let order = Order::Acceleration;
            if self.engine.run_steps(inputs, at, order, &mut self.state) == Condition::NoAssembly {
                return None;
            }
            let (q, _) = self.engine.coordinate(at);
            let Workspace { state, scratch, .. } = &mut self.state;
            let correction = group.approach_fold(&mut fold, q, state, scratch);
            let Correction { size, dq } = correction?;
            at = self.engine.moved(at, dq);
            if size < FOLDED || size >= last && size < FOLDED.sqrt() {
                break;
            }
            last = size;
        }
        if self.engine.difference(limit, at).abs() >= SAME_FOLD {
            return None;
        }
        let z = group.open(&mut self.state.scratch).z.to_vec();
        self.folds.push(Folded { at, index, z });
        Some(at)
    }
}
