//! Change points on the way: which dyads are stretched to an extreme of their reach, where exactly,
//! and on beyond it.

use super::walk::Walker;
use crate::solver::Order;
use crate::solver::passage::{Passage, Passages};
use crate::solver::state::Condition;

/// A measure this small is a gap of the size of the rounding, squared.
const GAP: f64 = 1e-28;
/// A change point is passed in one step from this much before it to this much beyond, in radians or
/// scaled lengths: far enough for the dyad to have digits on both sides.
const PASSING: f64 = 1e-3;
/// An extreme of a dyad's stretch belongs to a limit if it is this close to it.
const EXTREME: f64 = 1e-3;

impl Walker<'_> {
    /// Goes on beyond a limit, if it is a change point of dyads: the coordinate that was reached.
    pub(super) fn pass(&mut self, limit: f64) -> Option<f64> {
        self.anchors.forget_beyond(self.engine, limit, self.sense);
        let changes = self.changes(limit);
        let first = changes
            .iter()
            .map(|c| c.1)
            .min_by(|x, y| self.ahead(*x).total_cmp(&self.ahead(*y)))?;
        let last = changes
            .iter()
            .map(|c| c.1)
            .max_by(|x, y| self.ahead(*x).total_cmp(&self.ahead(*y)))?;
        let before = self.engine.moved(first, -self.sense * PASSING);
        let beyond = self.engine.moved(last, self.sense * PASSING);
        self.aim_at(before);
        if self
            .engine
            .run(before, Order::Acceleration, &mut self.state)
            != Condition::Ok
        {
            return None;
        }
        let saved = self.state.clone();
        self.flip(&changes);
        if !self.try_step(before, beyond, &saved) {
            return None;
        }
        let reached = self.state.clone();
        // A passage that could not be kept would leave the states beyond it with the wrong signs.
        self.record(&changes, &saved.signs, &reached.signs)?;
        self.state = reached;
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    fn flip(&mut self, changes: &[(usize, f64)]) {
        for &(step, _) in changes {
            if let Some(group) = self.engine.program.steps[step].choice() {
                self.state.signs[group] = -self.state.signs[group];
            }
        }
    }

    /// The dyads that are stretched to an extreme of their reach at a limit, and where exactly: by
    /// step and coordinate.
    fn changes(&mut self, limit: f64) -> Vec<(usize, f64)> {
        let choices = (0..self.engine.program.steps.len())
            .filter(|&i| self.engine.program.steps[i].choice().is_some());
        let choices: Vec<usize> = choices.collect();
        choices
            .into_iter()
            .filter_map(|i| Some((i, self.extreme(i, limit)?)))
            .collect()
    }

    /// Where a dyad's stretch is extreme close to a limit, if its arms are in line there.
    fn extreme(&mut self, step: usize, limit: f64) -> Option<f64> {
        let group = self.engine.program.steps[step].choice()?;
        let (mut a, mut b) = (
            self.engine.moved(limit, -EXTREME),
            self.engine.moved(limit, EXTREME),
        );
        let rate_a = self.stretch_rate(step, a)?;
        if !(rate_a * self.stretch_rate(step, b)? < 0.0) {
            return None;
        }
        loop {
            let middle = a + 0.5 * (b - a);
            if middle == a || middle == b {
                break;
            }
            let rate = self.stretch_rate(step, middle)?;
            if rate == 0.0 {
                (a, b) = (middle, middle);
                break;
            }
            if rate * rate_a > 0.0 {
                a = middle
            } else {
                b = middle
            }
        }
        let nearer = if self.stretch_rate(step, a)?.abs() < self.stretch_rate(step, b)?.abs() {
            a
        } else {
            b
        };
        // So close to 0 the rates underflow, and the coordinate that is meant is 0.
        let nearer = if nearer.abs() < f64::EPSILON * EXTREME {
            0.0
        } else {
            nearer
        };
        self.stretch_rate(step, nearer);
        let at = self
            .engine
            .run_steps(step..step + 1, nearer, Order::Position, &mut self.state);
        // Equal arms whose pivots meet have no direction, but no gap either.
        let has_no_gap = self.state.measures[group].abs() <= GAP;
        (at == Condition::DeadPoint || has_no_gap).then_some(nearer)
    }

    /// A dyad's rate of stretch, from its inputs: it may be open itself.
    fn stretch_rate(&mut self, step: usize, at: f64) -> Option<f64> {
        self.aim_at(at);
        let inputs = self
            .engine
            .run_steps(0..step, at, Order::Velocity, &mut self.state);
        if inputs == Condition::NoAssembly {
            return None;
        }
        self.engine
            .run_steps(step..step + 1, at, Order::Position, &mut self.state);
        self.engine.program.steps[step].stretch_rate(&self.state)
    }

    /// Keeps the passages of dyads through a change point, each in the order of the plan, since later
    /// ones are built on earlier ones. None of them where one has no series.
    fn record(&mut self, changes: &[(usize, f64)], before: &[f64], beyond: &[f64]) -> Option<()> {
        let (engine, sense, kept) = (self.engine, self.sense, self.passages.len());
        for &(step, at) in changes {
            let group = engine.program.steps[step].choice()?;
            if self.passages.iter().any(|p| p.group == group && p.at == at) {
                continue;
            }
            let sample = |dq: f64| {
                let there = engine.moved(at, dq);
                self.aim_at(there);
                let signs = if dq * sense < 0.0 { before } else { beyond };
                self.state.signs.copy_from_slice(signs);
                let steps = 0..step + 1;
                let order = Order::Acceleration;
                let condition = engine.run_steps(steps, there, order, &mut self.state);
                (condition == Condition::Ok).then(|| self.state.clone())
            };
            let through = Passage::through(at, &engine.program.steps[step], group, sample);
            let Some(mut passage) = through else {
                self.passages.truncate(kept);
                return None;
            };
            let so_far = Passages::new(self.passages.clone(), self.start, 0.0);
            let end = engine.run_near(at, Order::Position, &so_far, &mut self.state);
            if end != Condition::NoAssembly {
                passage.take_positions(&self.state);
            }
            self.passages.push(passage);
        }
        Some(())
    }
}
