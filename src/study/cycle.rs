//! An integration through many cycles, and its error in the last of them.

use super::rk4::Rk4;
use super::tally::{Stopwatch, Tally};
use super::{PASS, SAMPLES};
use crate::solver::{DriftMethod, Methods, Range};
use std::time::Duration;

/// Positions that are compared in one piece of work.
const COMPARED: u32 = 36;

/// An integration of the velocities, from a position to which it comes back every cycle.
pub(super) struct IntegrationCycle {
    drift: DriftMethod,
    rk4: Rk4,
    start: f64,
    /// The driver's coordinate from one step to the next, and as derivatives count it.
    step: f64,
    h: f64,
    /// Steps of a cycle.
    cycle: u32,
    /// Steps taken, and those after which the last cycle begins.
    taken: u32,
    blind: u32,
    /// No rates were found: it goes no further.
    stuck: bool,
}

impl IntegrationCycle {
    /// Begins at a position; `None` where the mechanism cannot go round.
    pub(super) fn begin(
        methods: &mut Methods,
        start: f64,
        steps: u16,
        turns: u16,
    ) -> Option<IntegrationCycle> {
        let Range::Full { period } = methods.range() else {
            return None;
        };
        if !methods.look_up(start) {
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
            stuck: false,
        })
    }

    /// How far it has come, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        f64::from(self.taken) / f64::from(self.blind + self.cycle)
    }

    /// One piece of work; whether that was all. The steps up to the last cycle are timed; where they are
    /// too few, so are some behind it.
    pub(super) fn go_on(
        &mut self,
        methods: &mut Methods,
        tally: &mut Tally,
        watch: &mut Stopwatch,
        clock: &mut dyn FnMut() -> Duration,
    ) -> bool {
        let end = self.blind + self.cycle;
        if self.stuck {
            self.give_up(tally);
            return true;
        }
        if self.taken >= self.blind && self.taken < end {
            for _ in self.taken..end.min(self.taken + COMPARED) {
                self.compare(methods, tally);
            }
            return false;
        }
        if self.taken >= end && watch.samples().len() >= SAMPLES {
            return true;
        }
        let most = match self.blind.checked_sub(self.taken) {
            Some(left) if left > 0 => left as usize,
            _ => usize::MAX,
        };
        watch.take(clock, most, |count| {
            for _ in 0..count {
                self.go(methods);
            }
        });
        false
    }

    /// The driver's coordinate after so many steps, and a part of one.
    fn at(&self, part: f64) -> f64 {
        self.start + (f64::from(self.taken % self.cycle) + part) * self.step
    }

    /// One step.
    fn go(&mut self, methods: &Methods) {
        let from = self.at(0.0);
        let IntegrationCycle { drift, step, .. } = self;
        let change = self.rk4.step(self.h, |part, change, rates| {
            drift.rates(methods, from + part * *step, change, rates)
        });
        match change {
            Some(change) => self.drift.advance(methods, change),
            None => self.stuck = true,
        }
        self.taken += 1;
    }

    /// One step, and how far it has led astray.
    fn compare(&mut self, methods: &mut Methods, tally: &mut Tally) {
        self.go(methods);
        let at = self.at(0.0);
        if !methods.look_up(at) {
            return;
        }
        let found = !self.stuck && self.drift.settle(methods, at);
        tally.note(found.then(|| methods.drifted(&self.drift)));
    }

    /// What it can no longer reach of the last cycle, it has failed at.
    fn give_up(&mut self, tally: &mut Tally) {
        let end = self.blind + self.cycle;
        for _ in self.taken.max(self.blind)..end {
            tally.note(None);
        }
        self.taken = end;
    }
}
