//! Computes the ends of a range to the last digit.
//!
//! In doubles, a walk ends within some roundings of a dyad's limit or of a coupled group's fold.
//! Before the first coupled group, everything is decided in double-double from the typed decimals:
//! the end is the double nearest to the limit of the first dyad that reaches one. Behind a coupled
//! group, a dyad's limit is the zero of its measure, and a coupled group's limit solves the system
//! of a fold. Both are found in doubles and corrected from the typed decimals
//! ([`super::proved_ends`]).

use super::proved_ends::BoundedEnd;
use super::tracking::Walker;
use super::{Folded, Stretched};
use crate::Double;
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::coupled::Correction;
use crate::solver::exact::Exact;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;

/// Number of doublings of an ulp within which a limit is searched around the end of a walk.
const DOUBLINGS: i32 = 30;
/// Maximum number of doublings of an ulp: near zero, so many lie between an ulp and the rounding of
/// a length.
const NEAR_ZERO: i32 = 1100;
/// Maximum number of Newton steps to a fold, from a start with half of the digits.
const FOLD_STEPS: usize = 20;
/// Size of a correction that ends the iteration to a fold, in units of about the longest link. The
/// corrections of z and of the null vector end at their rounding error; the coordinate then has all
/// its digits.
const FOLDED: f64 = 1e-11;
/// Maximum distance of a fold from the end of the walk, in radians or scaled lengths. A fold
/// further away is another one.
const FOLD_TOLERANCE: f64 = 1e-6;
/// Distances before a limit, in radians or scaled lengths, from which a fold is searched.
const FOLD_STARTS: [f64; 6] = [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4];
/// Maximum difference between the unknowns at such a fold and at the limit.
const FOLD_REACH: f64 = 1e-2;
/// Maximum distance of such a fold behind the limit, in radians or scaled lengths: some thousand times the
/// rounding of a coordinate.
const FOLD_BEHIND: f64 = 1e-12;

impl Walker<'_> {
    /// Returns the proved fold of a coupled group at a limit, from states before it. Beside a near miss,
    /// doubles count a state behind the fold as solved, and its rates do not lead back. `last` is the last
    /// state before the limit. A fold behind the limit belongs to a motion that was not followed: a change
    /// point may end it.
    fn fold_before(&mut self, limit: f64, last: &Workspace) -> Option<BoundedEnd> {
        let engine = self.engine;
        let stored = self.folds.len();
        FOLD_STARTS.into_iter().find_map(|by| {
            let before = engine.moved(limit, -self.sense * by);
            let is_placed = self.ahead(before) > 0.0 && self.step_to(before);
            let start = is_placed.then(|| self.state.clone())?;
            engine.coupled_steps().find_map(|(step, index)| {
                let end = self.fold(step, index, limit, &start);
                let end = end.filter(|end| {
                    let behind = engine.difference(limit, end.at) * self.sense;
                    end.bound.is_some() && behind <= FOLD_BEHIND && self.is_near_fold(index, last)
                });
                if end.is_none() {
                    self.folds.truncate(stored);
                }
                end
            })
        })
    }

    /// Returns `true` if a state is close to the fold stored last of a coupled group.
    fn is_near_fold(&self, index: usize, state: &Workspace) -> bool {
        let group = &self.engine.program.coupled[index];
        let z = &state.scratch.numbers[group.offset..group.offset + group.width()];
        let fold = self.folds.last().filter(|fold| fold.index == index);
        fold.is_some_and(|fold| {
            let mut apart = fold.z.iter().zip(z);
            apart.all(|(fold, z)| (fold - z).abs() <= FOLD_REACH)
        })
    }

    /// Returns the limit that ends the motion, to the last digit. `state` is the last one before
    /// it.
    pub(super) fn refined(&mut self, limit: f64, state: &Workspace) -> BoundedEnd {
        self.state.clone_from(state);
        if let Some((step, end)) = self.exact.and_then(|exact| self.end_exactly(exact, limit)) {
            self.stretched.push(end);
            let bound = self.bound_of_reach(step, end.group, end.at);
            return BoundedEnd { at: end.at, bound };
        }
        let refined = self.ending_step(limit).and_then(|step| {
            if let Some(index) = self.engine.program.steps[step].coupled() {
                self.fold(step, index, limit, state)
            } else {
                self.end_of_reach(step, limit)
            }
        });
        let refined = match refined {
            Some(end) if end.bound.is_some() => Some(end),
            other => self.fold_before(limit, state).or(other),
        };
        // A start within the rounding of a limit belongs to the motion.
        let refined = refined.unwrap_or(BoundedEnd::unproved(limit));
        let before = -self.ahead(refined.at);
        if before > 0.0 {
            let bound = refined.bound.map(|bound| bound + before);
            let at = self.start;
            BoundedEnd { at, bound }
        } else {
            refined
        }
    }

    /// Returns the ulp of a coordinate or of the start, whichever is larger.
    fn ulp(&self, at: f64) -> f64 {
        f64::EPSILON * at.abs().max(self.start.abs())
    }

    /// Returns distances from a limit: zero, then growing ones up to 2^30 times the finest
    /// resolution.
    pub(super) fn distances(&self, limit: f64) -> impl Iterator<Item = f64> + use<> {
        let ulp = self.ulp(limit).max(f64::MIN_POSITIVE);
        let maximum = self.engine.finest().max(ulp) * f64::from(DOUBLINGS).exp2();
        let growing = (0..NEAR_ZERO).map(move |k| ulp * (f64::from(k).exp2() - 1.0));
        growing.take_while(move |&by| by < maximum)
    }

    // ---- dyads before the first coupled group

    /// Returns the double nearest to the coordinate where the first dyad reaches its limit, close
    /// to the end of a walk, with the dyad's step.
    fn end_exactly(&self, exact: &Exact, limit: f64) -> Option<(usize, Stretched)> {
        let mut state: State<Double> = exact.state(self.state.travels.len());
        let signs = self.state.signs.iter();
        state.signs = signs.map(|&s| Double::exactly(s)).collect();
        let buffers = self.ahead(limit).max(0.0);
        let mut goes = |at: f64| exact.stops(at, &mut state).is_none();
        let mut back = self
            .distances(limit)
            .map(|by| limit - self.sense * by.min(buffers));
        let mut inside = back.find(|&at| goes(at))?;
        let mut on = self.distances(limit).map(|by| limit + self.sense * by);
        let mut outside = on.find(|&at| !goes(at))?;
        loop {
            let middle = inside + 0.5 * (outside - inside);
            if middle == inside || middle == outside {
                break;
            }
            if goes(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        // The measure has more digits than the coordinate: it decides which of the two is nearer.
        let step = exact.stops(outside, &mut state)?;
        let group = exact.engine.program.steps[step].choice()?;
        let beyond = state.measures[group].hi;
        let _ = exact.stops(inside, &mut state);
        let before = state.measures[group].hi;
        let nearest = if before <= -beyond { inside } else { outside };
        // Double-double resolves differences from zero only to a limited precision.
        let is_nought = nearest.abs() < f64::EPSILON * self.engine.finest()
            && exact.stops(0.0, &mut state) == Some(step);
        let at = if is_nought { 0.0 } else { nearest };
        Some((step, Stretched { at, group }))
    }

    // ---- dyads behind a coupled group

    /// Returns the first step that cannot be assembled at a limit or just beyond it.
    fn ending_step(&mut self, limit: f64) -> Option<usize> {
        let sense = self.sense;
        let mut beyond = self.distances(limit).map(|by| limit + sense * by);
        beyond.find_map(|at| {
            self.predict_nearest(at);
            let mut steps = 0..self.engine.program.steps.len();
            steps.find(|&i| {
                let order = Order::Position;
                self.engine.run_steps(i..i + 1, at, order, &mut self.state) != Condition::Ok
            })
        })
    }

    /// Returns the coordinate close to a limit where a dyad's measure is zero; `None` for other
    /// steps.
    fn end_of_reach(&mut self, step: usize, limit: f64) -> Option<BoundedEnd> {
        let group = self.engine.program.steps[step].choice()?;
        if let Some(end) = self.exact_reach(step, group, limit) {
            return Some(end);
        }
        let by = self.sense * self.ulp(limit);
        let mut around = (2..DOUBLINGS).map(|k| by * f64::from(k).exp2());
        // If the arms only just miss each other, the motion ends before the limit and exists again
        // behind it.
        let is_gap = self.measure_behind(step, group, limit)? < 0.0;
        let (inside, outside) = around.find_map(|by| {
            let outside = if is_gap { limit } else { limit + by };
            let inside = limit - by;
            let a = self.measure_behind(step, group, inside)?;
            let b = self.measure_behind(step, group, outside)?;
            (a > 0.0 && b < 0.0).then_some(((inside, a), (outside, b)))
        })?;
        let at = root(inside, outside, 0.0, |at| {
            self.measure_behind(step, group, at)
        });
        at.ok().map(BoundedEnd::unproved)
    }

    /// Returns a dyad's measure, negative beyond its reach; `None` if its inputs cannot be
    /// assembled.
    fn measure_behind(&mut self, step: usize, group: usize, at: f64) -> Option<f64> {
        self.predict_nearest(at);
        let engine = self.engine;
        let order = Order::Position;
        if engine.run_steps(0..step, at, order, &mut self.state) == Condition::NoAssembly {
            return None;
        }
        engine.place_dyad(&engine.program.steps[step], at, &mut self.state.state);
        Some(self.state.measures[group])
    }

    // ---- coupled groups

    /// Returns the fold of a coupled group close to a limit by Newton's method on {F = 0, J v = 0,
    /// c.v = 1}. Stores the state at the fold because the group's own matrix is singular there.
    pub(super) fn fold(
        &mut self,
        step: usize,
        index: usize,
        limit: f64,
        state: &Workspace,
    ) -> Option<BoundedEnd> {
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
        if self.engine.difference(limit, at).abs() >= FOLD_TOLERANCE {
            return None;
        }
        let z = group.open(&mut self.state.scratch).z.to_vec();
        let found = self.exact_fold((step, index), fold, at);
        let is_here = |end: &BoundedEnd| self.engine.difference(at, end.at).abs() < FOLD_TOLERANCE;
        let found = found.filter(|(end, _)| is_here(end));
        let (end, z) = found.unwrap_or((BoundedEnd::unproved(at), z));
        let at = end.at;
        self.folds.push(Folded { at, index, z });
        Some(end)
    }
}
