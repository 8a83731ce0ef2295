//! Limits between the samples of a walk: the zeros of a group's measure.

use super::walk::{SAMPLES, Walker};
use super::{NearMiss, ONE_MISS};
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::plan::GroupId;
use crate::solver::state::Condition;

/// A measure whose smallest sample is below this is searched for a zero between the samples.
const SUSPICIOUS: f64 = 0.05;
/// A measure below this part of its largest, some u, touches zero.
const TOUCH: f64 = 1e-14;
/// A measure that goes down to less than this part of its largest, and not to zero, is a near miss: a
/// sine below 0.032, which is a transmission angle of 1.8 degrees. A gap of some 5e-4 of a link, 0.05 mm
/// in 100, is as much as workshops leave open; without it the motion would end there, or could change
/// its assembly.
const NEAR: f64 = 1e-3;
/// Sections that narrow a minimum down to the square root of the rounding.
const GOLDEN_SECTIONS: usize = 44;

impl Walker<'_> {
    /// A limit that the last three samples have stepped over: the zero of a measure that has a
    /// minimum between them. What lies behind the start is for the walk the other way.
    pub(super) fn limit_passed(&mut self) -> Option<f64> {
        let [(a, first), (m, middle), (b, last)] = &self.seen[..] else {
            return None;
        };
        let (a, m, b) = (*a, *m, *b);
        let dips = (0..first.len()).filter(|&g| {
            let is_lowest = middle[g] < first[g] && middle[g] <= last[g];
            is_lowest && middle[g] < SUSPICIOUS
        });
        let dips: Vec<usize> = dips.collect();
        if dips.is_empty() {
            return None;
        }
        let saved = self.state.clone();
        let told = self.misses.len();
        let limits: Vec<f64> = dips
            .into_iter()
            .filter_map(|group| self.limit_of(group, [a, m, b]))
            .collect();
        self.state = saved;
        let first = limits
            .into_iter()
            .filter(|&limit| self.ahead(limit) > 0.0)
            .min_by(|&x, &y| self.ahead(x).total_cmp(&self.ahead(y)));
        if let Some(limit) = first {
            // What lies at the limit or beyond is seen from its wrong side.
            let (mut number, sense) = (0, self.sense);
            self.misses.retain(|miss| {
                number += 1;
                number <= told || (limit - miss.at) * sense > ONE_MISS
            });
        }
        first
    }

    /// The zero of one group's measure that a minimum between three samples touches or crosses.
    fn limit_of(&mut self, group: usize, samples: [f64; SAMPLES]) -> Option<f64> {
        let lowest = self.lowest(group, samples);
        let measure = self.measure(group, lowest);
        let is_open = measure < 0.0 && self.state.condition == Condition::NoAssembly;
        if !is_open {
            let touches = self.touches(group, lowest, measure);
            if !touches && measure < NEAR * self.peaks[group] {
                let (sine, at) = (measure.sqrt(), lowest);
                let group = GroupId::new(group);
                self.misses.push(NearMiss { group, sine, at });
            }
            return touches.then_some(lowest);
        }
        let [before, middle, _] = samples;
        let is_past_middle = (lowest - middle) * self.sense > 0.0;
        let good = if is_past_middle { middle } else { before };
        Some(self.edge(group, good, lowest))
    }

    /// A group's measure between the last samples, negative where the mechanism does not exist.
    fn measure(&mut self, group: usize, at: f64) -> f64 {
        self.aim_at(at);
        let condition = self.engine.run(at, Order::Position, &mut self.state);
        if condition == Condition::Ok && self.is_coupled(group) {
            self.engine.measure_coupled(at, &mut self.state);
        }
        let measure = self.state.measures[group];
        match condition {
            Condition::Ok => measure,
            Condition::DeadPoint | Condition::ChangePoint => measure.min(0.0),
            Condition::NoAssembly if measure < 0.0 => measure,
            // Another group is open: this one's measure may be that of another coordinate.
            Condition::NoAssembly => -1.0,
        }
    }

    /// The coordinate of the smallest measure between two samples: for a dyad where its stretch is
    /// extreme; else by golden section, at once the sample between them if that touches zero.
    fn lowest(&mut self, group: usize, [a, middle, b]: [f64; 3]) -> f64 {
        if let Some(lowest) = self.most_stretched(group, a, b) {
            return lowest;
        }
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        if self.measure(group, middle) < TOUCH * self.peaks[group] {
            return middle;
        }
        let (mut a, mut b) = (a, b);
        let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        let (mut at_c, mut at_d) = (self.measure(group, c), self.measure(group, d));
        for _ in 0..GOLDEN_SECTIONS {
            if at_c < at_d {
                (b, d, at_d) = (d, c, at_c);
                c = b - GOLDEN * (b - a);
                at_c = self.measure(group, c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + GOLDEN * (b - a);
                at_d = self.measure(group, d);
            }
        }
        if at_c < at_d { c } else { d }
    }

    /// Whether a group whose measure is smallest here is stretched to its limit.
    fn touches(&mut self, group: usize, at: f64, measure: f64) -> bool {
        if self.is_coupled(group) {
            return measure < NEAR * self.peaks[group] && self.crosses(group, at);
        }
        let mut steps = self.engine.program.steps.iter();
        let dyad = steps.position(|step| step.choice() == Some(group));
        measure < TOUCH * self.peaks[group] || dyad.is_some_and(|i| self.is_stretched(i, group, at))
    }

    fn is_coupled(&self, group: usize) -> bool {
        let mut coupled = self.engine.program.coupled.iter();
        coupled.any(|c| c.group == group)
    }

    /// Where a dyad's stretch is extreme, if it is between two coordinates.
    fn most_stretched(&mut self, group: usize, a: f64, b: f64) -> Option<f64> {
        let mut steps = self.engine.program.steps.iter();
        let step = steps.position(|step| step.choice() == Some(group))?;
        let (rate_a, rate_b) = (self.stretch_rate(step, a)?, self.stretch_rate(step, b)?);
        let finest = self.engine.finest();
        let at = root((a, rate_a), (b, rate_b), finest, |at| {
            self.stretch_rate(step, at)
        });
        at.ok()
    }

    /// The last coordinate on the way from `good` to `bad` at which a measure is positive.
    fn edge(&mut self, group: usize, good: f64, bad: f64) -> f64 {
        let (mut good, mut bad) = (good, bad);
        loop {
            let middle = good + 0.5 * (bad - good);
            if middle == good || middle == bad {
                return good;
            }
            if self.measure(group, middle) > 0.0 {
                good = middle
            } else {
                bad = middle
            }
        }
    }
}
