//! Stores states of the coupled groups along the motion, so that any coordinate can be solved
//! without a history.

use super::tracking::SAMPLES;
use crate::solver::engine::Engine;
use crate::solver::workspace::Workspace;

/// States of the coupled groups along the motion, by the driver's coordinate.
#[derive(Clone, Debug, Default)]
pub(in crate::solver) struct Anchors {
    at: Vec<f64>,
    /// The values z, z' and z'' of every group, anchor by anchor.
    numbers: Vec<f64>,
    /// The period by which coordinates are reduced; 0 if they are not.
    period: f64,
}

impl Anchors {
    /// Returns the count of numbers stored per anchor.
    pub(super) fn stride(engine: &Engine) -> usize {
        engine
            .program
            .coupled
            .iter()
            .map(|c| c.width() + 2 * c.unknowns())
            .sum()
    }

    /// Writes the state predicted by the nearest anchor for `at` into the scratch.
    #[inline(always)]
    pub(in crate::solver) fn predict(&self, engine: &Engine, at: f64, workspace: &mut Workspace) {
        if !self.at.is_empty() {
            self.predict_from_nearest(engine, at, workspace);
        }
    }

    #[inline(never)]
    fn predict_from_nearest(&self, engine: &Engine, at: f64, workspace: &mut Workspace) {
        let reduced = if self.period > 0.0 {
            positive_remainder(at, self.period)
        } else {
            at
        };
        let above = self
            .at
            .partition_point(|&a| a < reduced)
            .min(self.at.len() - 1);
        let below = above.saturating_sub(1);
        let nearest = if reduced - self.at[below] <= self.at[above] - reduced {
            below
        } else {
            above
        };
        self.predict_from(nearest, engine, reduced, workspace);
    }

    /// Predicts a state as [`Anchors::predict`] does, from the nearest of the anchors pushed last.
    pub(super) fn predict_from_latest(&self, engine: &Engine, at: f64, workspace: &mut Workspace) {
        let latest = self.at.len().saturating_sub(SAMPLES)..self.at.len();
        let far = |&i: &usize| (self.at[i] - at).abs();
        if let Some(nearest) = latest.min_by(|i, j| far(i).total_cmp(&far(j))) {
            self.predict_from(nearest, engine, at, workspace);
        }
    }

    /// Returns the coordinate of the latest anchor at or before `at` in the direction of `sense`.
    pub(super) fn latest_before(&self, at: f64, sense: f64) -> Option<f64> {
        let mut anchors = self.at.iter().rev().copied();
        anchors.find(|anchor| (anchor - at) * sense <= 0.0)
    }

    /// Predicts a state as [`Anchors::predict`] does, from the latest anchor at or before `at` in the
    /// direction of `sense`.
    pub(super) fn predict_from_before(
        &self,
        engine: &Engine,
        at: f64,
        sense: f64,
        workspace: &mut Workspace,
    ) {
        let is_before = |&anchor: &f64| (anchor - at) * sense <= 0.0;
        if let Some(latest) = self.at.iter().rposition(is_before) {
            self.predict_from(latest, engine, at, workspace);
        }
    }

    /// Predicts the state for `at` from one anchor.
    pub(super) fn predict_from(
        &self,
        anchor: usize,
        engine: &Engine,
        at: f64,
        workspace: &mut Workspace,
    ) {
        let dq = engine.difference(self.at[anchor], at);
        let mut from = anchor * Anchors::stride(engine);
        for group in &engine.program.coupled {
            let mut buffers = group.open(&mut workspace.scratch);
            for part in [&mut *buffers.z, &mut *buffers.first, &mut *buffers.second] {
                part.copy_from_slice(&self.numbers[from..from + part.len()]);
                from += part.len();
            }
            group.predict(&mut buffers, dq);
        }
    }

    /// Returns the latest anchors within a distance of a coordinate, in radians or scaled lengths.
    pub(super) fn within(
        &self,
        engine: &Engine,
        at: f64,
        distance: f64,
    ) -> impl Iterator<Item = usize> {
        let is_near = move |&i: &usize| engine.difference(self.at[i], at).abs() < distance;
        (0..self.at.len()).rev().take_while(is_near)
    }

    /// Returns the rates z' of every group in an anchor.
    pub(super) fn rates(&self, engine: &Engine, anchor: usize) -> impl Iterator<Item = &[f64]> {
        let mut from = anchor * Anchors::stride(engine);
        engine.program.coupled.iter().map(move |group| {
            let rates = from + group.width()..from + group.width() + group.unknowns();
            from += group.width() + 2 * group.unknowns();
            &self.numbers[rates]
        })
    }

    pub(super) fn len(&self) -> usize {
        self.at.len()
    }

    /// Removes all but the first `kept` anchors.
    pub(super) fn truncate(&mut self, engine: &Engine, kept: usize) {
        self.at.truncate(kept);
        self.numbers.truncate(kept * Anchors::stride(engine));
    }

    /// Removes the anchors behind a start in the direction of motion, from an index on.
    pub(super) fn remove_behind(
        &mut self,
        engine: &Engine,
        first: usize,
        (start, sense): (f64, f64),
    ) {
        let stride = Anchors::stride(engine);
        let kept = first..self.at.len();
        let kept = kept.filter(|&i| (self.at[i] - start) * sense >= 0.0);
        let kept: Vec<usize> = kept.collect();
        let numbers = kept.iter();
        let numbers = numbers.flat_map(|&i| &self.numbers[i * stride..(i + 1) * stride]);
        let (numbers, at): (Vec<f64>, Vec<f64>) = (
            numbers.copied().collect(),
            kept.iter().map(|&i| self.at[i]).collect(),
        );
        self.truncate(engine, first);
        self.at.extend(at);
        self.numbers.extend(numbers);
    }

    /// Reverses the order of the anchors from an index on.
    pub(super) fn reverse_from(&mut self, engine: &Engine, first: usize) {
        let stride = Anchors::stride(engine);
        self.at[first..].reverse();
        let numbers = self.numbers.split_off(first * stride);
        let anchors = numbers.rchunks(stride.max(1));
        anchors.for_each(|anchor| self.numbers.extend_from_slice(anchor));
    }

    /// Removes the latest anchors at or beyond a limit.
    pub(super) fn forget_beyond(&mut self, engine: &Engine, limit: f64, sense: f64) {
        let is_on_the_way = |&at: &f64| (at - limit) * sense < 0.0;
        let kept = self.at.iter().rposition(is_on_the_way).map_or(0, |i| i + 1);
        self.truncate(engine, kept);
    }

    /// Stores the state of all coupled groups as the latest anchor.
    pub(super) fn push(&mut self, engine: &Engine, at: f64, workspace: &mut Workspace) {
        self.store(engine, (self.at.len(), at), workspace);
    }

    /// Stores the state of all coupled groups as an anchor behind those before it in the direction of
    /// `sense`.
    pub(super) fn insert(
        &mut self,
        engine: &Engine,
        (at, sense): (f64, f64),
        workspace: &mut Workspace,
    ) {
        let is_before = |&anchor: &f64| (anchor - at) * sense < 0.0;
        let place = self.at.iter().rposition(is_before).map_or(0, |i| i + 1);
        self.store(engine, (place, at), workspace);
    }

    /// Adds anchors that follow one another in the direction of `sense`, and removes those at or beyond
    /// the first of them.
    pub(super) fn add(&mut self, engine: &Engine, later: &Anchors, sense: f64) {
        if let Some(&first) = later.at.first() {
            self.forget_beyond(engine, first, sense);
        }
        self.at.extend_from_slice(&later.at);
        self.numbers.extend_from_slice(&later.numbers);
    }

    fn store(&mut self, engine: &Engine, (place, at): (usize, f64), workspace: &mut Workspace) {
        if engine.program.coupled.is_empty() {
            return;
        }
        self.at.insert(place, at);
        let later = self.numbers.split_off(place * Anchors::stride(engine));
        for group in &engine.program.coupled {
            let buffers = group.open(&mut workspace.scratch);
            for part in [&*buffers.z, &*buffers.first, &*buffers.second] {
                self.numbers.extend_from_slice(part);
            }
        }
        self.numbers.extend(later);
    }

    /// Returns the anchors sorted by coordinate, each reduced to one period.
    pub(super) fn sorted(&self, engine: &Engine, period: f64) -> Anchors {
        let reduce = |at: f64| {
            if period > 0.0 {
                positive_remainder(at, period)
            } else {
                at
            }
        };
        let mut order: Vec<(f64, usize)> = self.at.iter().map(|&a| reduce(a)).zip(0..).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        order.dedup_by(|a, b| a.0 == b.0);
        // The nearest anchor may lie across the end of the period.
        if let ([first, ..], [.., last], true) = (&order[..], &order[..], period > 0.0) {
            let (before, after) = ((last.0 - period, last.1), (first.0 + period, first.1));
            order.insert(0, before);
            order.push(after);
        }
        let stride = Anchors::stride(engine);
        let numbers = order
            .iter()
            .flat_map(|&(_, i)| &self.numbers[i * stride..(i + 1) * stride]);
        Anchors {
            at: order.iter().map(|&(a, _)| a).collect(),
            numbers: numbers.copied().collect(),
            period,
        }
    }
}

/// Reduces a coordinate to the range from 0 to below `period`.
pub(in crate::solver) fn positive_remainder(at: f64, period: f64) -> f64 {
    let rest = at % period;
    let rest = if rest < 0.0 { rest + period } else { rest };
    // The sum of a rounding error and the period is the period. The remainder of a negative multiple
    // is -0.
    if rest < period { rest + 0.0 } else { 0.0 }
}
