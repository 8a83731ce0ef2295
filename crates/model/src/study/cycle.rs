//! Integrates the velocities through many cycles and measures the error in the last one.

use super::method_cost::{Stopwatch, Tally};
use super::rk4::Rk4;
use super::{PASS, SAMPLES};
use crate::solver::{DriftMethod, Methods, Range};
use std::time::Duration;

/// Positions compared in one piece of work.
const POSITIONS_PER_BATCH: u32 = 36;

/// An integration of the velocities from a position that recurs every cycle.
pub(super) struct IntegrationCycle {
    drift: DriftMethod,
    rk4: Rk4,
    start: f64,
    /// The step of the driver's coordinate, and the step in the unit of derivatives.
    step: f64,
    h: f64,
    /// The number of steps per cycle.
    cycle: u32,
    /// The number of steps taken, and the number before the last cycle.
    taken: u32,
    blind: u32,
    /// `true` if rates do not exist, which ends the integration.
    is_stuck: bool,
}

impl IntegrationCycle {
    /// Begins at a position; `None` if the mechanism does not have a full cycle, or if its state
    /// cannot be found there.
    pub(super) fn start(
        methods: &mut Methods,
        start: f64,
        steps: u16,
        turns: u16,
    ) -> Option<IntegrationCycle> {
        let Range::Full { period } = methods.range() else {
            return None;
        };
        if !methods.compute_reference(start) {
            return None;
        }
        let drift = methods.drift()?;
        let step = f64::from(PASS) / f64::from(steps);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few turns of at most 65535 steps"
        )]
        let cycle = (period / step).round() as u32;
        Some(IntegrationCycle {
            rk4: Rk4::new(drift.unknowns()),
            drift,
            start,
            step,
            h: methods.difference(0.0, step),
            cycle,
            taken: 0,
            blind: u32::from(turns.max(1) - 1) * cycle,
            is_stuck: false,
        })
    }

    /// Returns the progress, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        f64::from(self.taken) / f64::from(self.blind + self.cycle)
    }

    /// Does one piece of work; returns `true` if it was the last. The steps before the last cycle
    /// are timed; if they are too few, further steps after it are timed too.
    pub(super) fn run_step(
        &mut self,
        methods: &mut Methods,
        tally: &mut Tally,
        watch: &mut Stopwatch,
        clock: &mut dyn FnMut() -> Duration,
    ) -> bool {
        let end = self.blind + self.cycle;
        if self.is_stuck {
            self.count_as_failures(tally);
            return true;
        }
        if self.taken >= self.blind && self.taken < end {
            for _ in self.taken..end.min(self.taken + POSITIONS_PER_BATCH) {
                self.compare(methods, tally);
            }
            return false;
        }
        if self.taken >= end && watch.samples().len() >= SAMPLES {
            return true;
        }
        let maximum = match self.blind.checked_sub(self.taken) {
            Some(left) if left > 0 => left as usize,
            _ => usize::MAX,
        };
        watch.take(clock, maximum, |count| {
            for _ in 0..count {
                self.go(methods);
            }
        });
        false
    }

    /// Returns the driver's coordinate after the steps taken plus a fraction of a step.
    fn at(&self, part: f64) -> f64 {
        self.start + (f64::from(self.taken % self.cycle) + part) * self.step
    }

    /// Takes one step.
    fn go(&mut self, methods: &Methods) {
        let from = self.at(0.0);
        let IntegrationCycle { drift, step, .. } = self;
        let change = self.rk4.step(self.h, |part, change, rates| {
            drift.rates(methods, from + part * *step, change, rates)
        });
        match change {
            Some(change) => self.drift.advance(methods, change),
            None => self.is_stuck = true,
        }
        self.taken += 1;
    }

    /// Takes one step and notes the error there.
    fn compare(&mut self, methods: &mut Methods, tally: &mut Tally) {
        self.go(methods);
        let at = self.at(0.0);
        if !methods.compute_reference(at) {
            return;
        }
        let found = !self.is_stuck && self.drift.settle(methods, at);
        tally.note(found.then(|| methods.drifted(&self.drift)));
    }

    /// Counts the remaining steps of the last cycle as failures.
    fn count_as_failures(&mut self, tally: &mut Tally) {
        let end = self.blind + self.cycle;
        for _ in self.taken.max(self.blind)..end {
            tally.note(None);
        }
        self.taken = end;
    }
}
