//! Finds limits between the samples of a walk: extremes of a dyad's reach, and zeros of other
//! groups' measures.

use super::change::ReachExtreme;
use super::crossing::CloseMiss;
use super::junction::DyadSingularity;
use super::tracking::{CLOSURE_TOLERANCE, SAMPLES, WalkSample, Walker};
use super::{NearMiss, ONE_MISS};
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::elements::{FRAMES, Stretching};
use crate::solver::plan::GroupId;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use crate::{Double, Vec2};

/// Minimum sample of a measure below which a zero is searched between the samples.
const MAX_UNSEARCHED_MEASURE: f64 = 0.05;
/// Fraction of a measure's maximum below which it touches zero: the square of a rounding error.
const TOUCH_TOLERANCE: f64 = 1e-28;
/// Measure at a dyad's extreme below which double-double decides. Doubles are accurate enough above
/// it, unless the dyad's inputs are themselves as close to a limit.
const CLOSE_LOOK_MEASURE: f64 = 1e-6;
/// Fraction of a measure's maximum below which a nonzero minimum is a near miss.
///
/// It corresponds to a sine below 0.032, a transmission angle of 1.8 degrees. The gap is then about
/// 5e-4 of a link, 0.05 mm in 100 mm, which is as much clearance as workshops leave. Without the
/// gap, the motion would end there or could change its assembly.
pub(super) const NEAR: f64 = 1e-3;
/// Part of the distance to a near miss at which its measure is compared with that at the whole
/// distance.
const NEARER: f64 = 0.1;
/// Minimum power of the distance with which the measure of a near miss grows.
const MIN_POWER: f64 = 1.0;
/// Number of golden sections that locate a minimum to the square root of the rounding error.
const GOLDEN_SECTIONS: usize = 44;
/// Distance within which two extremes of one dyad are the same, in radians or scaled lengths.
const EQUALITY_TOLERANCE: f64 = 1e-14;
/// Maximum error of an extreme found in doubles, in radians or scaled lengths.
const NEIGHBOURING: f64 = 1e-5;
/// Length of a Newton step, in units of [`NEIGHBOURING`], from which the method does not return.
const DEPARTURE: f64 = 100.0;
/// Half width of an interval around a coordinate, in radians or scaled lengths. Dyads whose stretch
/// is extreme within it are stretched at this coordinate.
const PLACE_TOLERANCE: f64 = 1e-12;
/// Fraction of the speeds on both sides below which a speed counts as zero.
const ZERO_SPEED_FRACTION: f64 = 1e-7;

/// The stretching of a dyad at the last two samples.
#[derive(Clone, Copy)]
struct Stretch {
    step: usize,
    group: usize,
    from: (f64, Stretching),
    to: (f64, Stretching),
}

impl Walker<'_> {
    /// Returns the first limit between the last samples. Limits behind the start are left to the
    /// walk in the other direction.
    pub(super) fn limit_passed(&mut self) -> Option<f64> {
        // The range ends at the end of a table. Behind it, the rates of resting dyads are rounding
        // errors, which would show an extreme at almost every sample.
        let last = self.seen.last().map(|sample| sample.at);
        if last.is_some_and(|at| self.engine.is_beyond_table(at)) {
            return None;
        }
        let stretches = self.stretches();
        let dips = self.dips();
        if stretches.is_empty() && dips.is_empty() {
            return None;
        }
        let saved = self.state.clone();
        let count = self.misses.len();
        let first = self.first_extreme(stretches);
        let limits = dips
            .into_iter()
            .filter_map(|(group, samples)| self.limit_of(group, samples, &saved));
        let limits: Vec<f64> = limits.chain(first).collect();
        self.state = saved;
        let first = limits
            .into_iter()
            .filter(|&limit| self.ahead(limit) > 0.0)
            .min_by(|&x, &y| self.ahead(x).total_cmp(&self.ahead(y)));
        if let Some(limit) = first {
            // Near misses at the limit or beyond it are on the wrong side.
            let (mut number, sense) = (0, self.sense);
            self.misses.retain(|miss| {
                number += 1;
                number <= count || (limit - miss.at) * sense > ONE_MISS
            });
        }
        first
    }

    // ---- dyads

    /// Returns the dyads whose reach has an extreme between the last two samples that may be their
    /// limit.
    fn stretches(&self) -> Vec<Stretch> {
        let [.., a, b] = &self.seen[..] else {
            return Vec::new();
        };
        let pairs = a.stretchings.iter().zip(&b.stretchings);
        let all = pairs.filter_map(|(&(step, from), &(_, to))| {
            let group = self.engine.program.steps[step].choice()?;
            let lowest = a.measures[group].min(b.measures[group]);
            let stretch = Stretch {
                step,
                group,
                from: (a.at, from?),
                to: (b.at, to?),
            };
            let is_leaving = self.engine.inwards(b.at) * self.sense < 0.0;
            let may_have =
                lowest < MAX_UNSEARCHED_MEASURE && (is_leaving || stretch.has_extreme(self.sense));
            may_have.then_some(stretch)
        });
        all.collect()
    }

    /// Returns the first extreme of a reach that is a limit. Records the near misses before it.
    fn first_extreme(&mut self, stretches: Vec<Stretch>) -> Option<f64> {
        self.ahead = None;
        self.unresolved = None;
        let mut found: Vec<(Stretch, f64)> = Vec::new();
        let mut is_known = vec![false; self.engine.program.steps.len()];
        for (number, stretch) in stretches.iter().enumerate() {
            if is_known[stretch.step] {
                continue;
            }
            let extremes = self.extremes(stretch);
            found.extend(extremes.iter().map(|&at| (*stretch, at)));
            // Near the end of a table, doubles do not tell whether there is an extreme.
            if self.engine.inwards(stretch.to.0) * self.sense < 0.0 {
                found.push((*stretch, stretch.to.0));
            }
            // In a long row of dyads, all are stretched at one coordinate: one run evaluates them.
            if let ([at], false) = (&extremes[..], stretch.turns_back()) {
                for together in self.stretched_together(*at, &stretches[number + 1..]) {
                    is_known[together.step] = true;
                    found.push((together, *at));
                }
            }
        }
        found.retain(|(stretch, at)| {
            let place = (stretch.group, *at);
            self.ahead(*at) > 0.0 && !self.crossings.has(self.engine, place, EQUALITY_TOLERANCE)
        });
        found.sort_by(|x, y| self.ahead(x.1).total_cmp(&self.ahead(y.1)));
        let first = found.iter().find_map(|&(stretch, at)| {
            if !is_known[stretch.step] || self.exactly_near(stretch.step, at).is_some() {
                return self.limit_at(&stretch, at);
            }
            // Doubles assigned it to the extreme of another dyad.
            let mut extremes = self.extremes(&stretch).into_iter();
            extremes.find_map(|at| {
                let is_passed =
                    self.crossings
                        .has(self.engine, (stretch.group, at), EQUALITY_TOLERANCE);
                let is_new = self.ahead(at) > 0.0 && !is_passed;
                is_new.then(|| self.limit_at(&stretch, at)).flatten()
            })
        });
        self.limit_of_earlier_step(&found).or(first)
    }

    /// Returns the limit of an earlier dyad close to that of a dyad whose extreme is lost in
    /// rounding: directly before a change point of the earlier one, the later one has few digits.
    fn limit_of_earlier_step(&mut self, found: &[(Stretch, f64)]) -> Option<f64> {
        let lost = self.unresolved.take()?;
        let (later, _, limit) = lost;
        for &(stretch, at) in found {
            let is_near = self.engine.difference(at, limit).abs() <= NEIGHBOURING;
            if stretch.step < later && is_near {
                let earlier = self.limit_at(&stretch, at);
                if self.ahead.is_some() {
                    return earlier;
                }
            }
        }
        self.unresolved = Some(lost);
        None
    }

    /// Returns the coordinate close to `at` where a dyad's reach is extreme, in double-double.
    /// Returns `None` if Newton's method leaves for another extreme.
    pub(super) fn exactly_near(&mut self, step: usize, at: f64) -> Option<Double> {
        let exact = self.exactly_by(step, at, DEPARTURE * NEIGHBOURING);
        exact.filter(|exact| self.engine.difference(exact.hi, at).abs() <= NEIGHBOURING)
    }

    /// Returns the dyads of `rest` whose reach is extreme at the same coordinate as that of another
    /// one.
    fn stretched_together(&mut self, at: f64, rest: &[Stretch]) -> Vec<Stretch> {
        if rest.is_empty() {
            return Vec::new();
        }
        let sides =
            [-PLACE_TOLERANCE, PLACE_TOLERANCE].map(|by| self.all_rates(self.engine.moved(at, by)));
        let rate = |side: usize, step: usize| sides[side].get(step).copied().flatten();
        let is_here = |of: &&Stretch| {
            let (before, after) = (rate(0, of.step), rate(1, of.step));
            !of.turns_back() && matches!((before, after), (Some(a), Some(b)) if a * b < 0.0)
        };
        rest.iter().filter(is_here).copied().collect()
    }

    /// Returns the rates of stretch of all steps at a coordinate, up to the first step that cannot
    /// be assembled there.
    fn all_rates(&mut self, at: f64) -> Vec<Option<f64>> {
        self.predict_nearest(at);
        let engine = self.engine;
        let (q, _) = engine.coordinate(at);
        let mut rates = Vec::with_capacity(engine.program.steps.len());
        for (i, step) in engine.program.steps.iter().enumerate() {
            let stretching = step.dyad().and_then(|dyad| {
                engine.place_dyad(step, at, &mut self.state.state);
                dyad.stretching(q, &engine.carriers, &self.state)
            });
            rates.push(stretching.and_then(|s| s.rate()));
            if self.run_some(i..i + 1, at, Order::Acceleration) == Condition::NoAssembly {
                break;
            }
        }
        rates
    }

    /// Returns the coordinates between two samples where a dyad's reach is extreme. If the input
    /// reverses between them, so does the rate: the parts before and behind the reversal are
    /// examined separately.
    fn extremes(&mut self, stretch: &Stretch) -> Vec<f64> {
        let &Stretch { step, from, to, .. } = stretch;
        let rates = stretch.rates(self.sense);
        let [a, b] = [(from.0, rates[0]), (to.0, rates[1])];
        let Some((back, still, frame)) = self.turning_back(stretch) else {
            return self.extreme_stretch(step, a, b).into_iter().collect();
        };
        let sense = self.sense;
        let [before, after] =
            [-sense, sense].map(|side| (back, still.adjacent_rate_sign(frame, side)));
        let first = self.extreme_stretch(step, a, before);
        let last = self.extreme_stretch(step, after, b);
        let mut all: Vec<f64> = first.into_iter().chain([back]).chain(last).collect();
        all.dedup();
        all
    }

    /// Returns where the motion that stretches a dyad reverses between two samples: the coordinate,
    /// the stretching there, and the frame.
    fn turning_back(&mut self, stretch: &Stretch) -> Option<(f64, Stretching, usize)> {
        let &Stretch { step, from, to, .. } = stretch;
        let finest = self.engine.finest();
        (0..FRAMES).find_map(|frame| {
            if !stretch.turns_back_in(frame) {
                return None;
            }
            let velocity = |s: &Stretching| s.seen[frame].v;
            let (v, w) = (velocity(&from.1), velocity(&to.1));
            let along = |s: &Stretching| velocity(s).dot(v - w);
            let ends = [from, to].map(|(at, s)| (at, along(&s)));
            let back = root(ends[0], ends[1], finest, |at| {
                self.stretching(step, at).as_ref().map(along)
            });
            let back = back.ok()?;
            let there = self.stretching(step, back)?;
            let is_still = velocity(&there).norm() <= ZERO_SPEED_FRACTION * v.norm().max(w.norm());
            is_still.then_some((back, there, frame))
        })
    }

    /// Returns the limit at an extreme of a dyad's reach, or just before it. Returns `None` if the
    /// extreme is no limit; records near misses.
    fn limit_at(&mut self, stretch: &Stretch, at: f64) -> Option<f64> {
        let &Stretch { step, group, .. } = stretch;
        let measure = self.measure(group, at);
        let is_open = measure < 0.0 && self.state.condition == Condition::NoAssembly;
        if is_open || measure.abs() < CLOSE_LOOK_MEASURE {
            if let Some(pair) = self.pair_near(step, at)
                && self.ahead(pair.first) > 0.0
            {
                if self.is_passed(&pair) {
                    return None;
                }
                let extreme = ReachExtreme::from(pair);
                self.ahead = Some(extreme);
                return Some(extreme.limit());
            }
            if !is_open && self.engine.inwards(at) != 0.0 {
                return None;
            }
            match self.exact_extreme(step, at) {
                Some((at, DyadSingularity::Singular { .. })) if self.is_split_off(step, at) => {
                    return None;
                }
                Some((at, DyadSingularity::Singular { .. })) => {
                    self.ahead = Some(ReachExtreme::single(step, at));
                    return Some(at.hi);
                }
                Some((at, DyadSingularity::Regular)) => {
                    self.note_miss(group, measure.max(0.0).sqrt(), at.hi);
                    return None;
                }
                Some((at, DyadSingularity::Missing { sine })) => {
                    let seen = if measure > 0.0 { measure.sqrt() } else { sine };
                    self.note_miss(group, seen, at.hi);
                    return None;
                }
                None if !is_open && self.is_stretched(step, group, at) => {
                    self.unresolved = Some((step, group, at));
                    return Some(at);
                }
                None => {}
            }
        }
        if is_open {
            return Some(self.edge(group, stretch.from.0, at));
        }
        if measure < NEAR * self.peaks[group] {
            self.note_miss(group, measure.sqrt(), at);
        }
        None
    }

    /// Returns the coordinate of an extreme of a dyad's reach and the dyad's singularity there, in
    /// double-double. Returns `None` if this cannot be determined.
    fn exact_extreme(&mut self, step: usize, at: f64) -> Option<(Double, DyadSingularity)> {
        let at = self.exactly_near(step, at)?;
        Some((at, self.singularity_at(step, at)?))
    }

    /// Records a near miss.
    pub(super) fn note_miss(&mut self, group: usize, sine: f64, at: f64) {
        let group = GroupId::new(group);
        self.misses.push(NearMiss { group, sine, at });
    }

    // ---- other groups

    /// Returns the groups other than dyads whose measure has a small minimum among the last three
    /// samples, with the coordinates of the samples.
    fn dips(&self) -> Vec<(usize, [f64; SAMPLES])> {
        let [first, middle, last] = &self.seen[..] else {
            return Vec::new();
        };
        let is_dyad = |group: usize| {
            let mut dyads = last.stretchings.iter();
            dyads.any(|&(step, s)| {
                s.is_some() && self.engine.program.steps[step].choice() == Some(group)
            })
        };
        let value = |sample: &WalkSample, group: usize| sample.measures[group];
        let dips = (0..first.measures.len()).filter(|&g| {
            let lowest = value(middle, g);
            let is_lowest = lowest < value(first, g) && lowest <= value(last, g);
            is_lowest && lowest < MAX_UNSEARCHED_MEASURE && !is_dyad(g)
        });
        dips.map(|group| (group, [first.at, middle.at, last.at]))
            .collect()
    }

    /// Returns the zero that a group's measure touches or crosses near a minimum between three
    /// samples.
    fn limit_of(&mut self, group: usize, samples: [f64; SAMPLES], last: &Workspace) -> Option<f64> {
        // The measure of a group at rest is constant except for its rounding error.
        if samples.iter().all(|&at| self.is_at_rest(group, at)) {
            return None;
        }
        let lowest = self.lowest(group, samples);
        let measure = self.measure(group, lowest);
        let is_open = measure < 0.0 && self.state.condition == Condition::NoAssembly;
        if !is_open {
            let touches = self.touches(group, lowest, measure);
            if touches {
                return Some(lowest);
            }
            if measure < NEAR * self.peaks[group] {
                if self.is_coupled(group) && self.jumps((group, lowest, measure), samples, last) {
                    return Some(lowest);
                }
                self.note_miss(group, measure.sqrt(), lowest);
            }
            return None;
        }
        let [before, middle, _] = samples;
        let is_past_middle = (lowest - middle) * self.sense > 0.0;
        let good = if is_past_middle { middle } else { before };
        Some(self.edge(group, good, lowest))
    }

    /// Returns `true` if the last steps jumped to another assembly across a near miss of a coupled
    /// group, or if this cannot be excluded. `last` is the state reached.
    fn jumps(
        &mut self,
        (group, at, measure): (usize, f64, f64),
        [from, _, to]: [f64; SAMPLES],
        last: &Workspace,
    ) -> bool {
        let far = self.engine.difference(from, at).abs();
        let [one, other] = [from, at + NEARER * (from - at)].map(|at| self.measure(group, at));
        // One singular place makes the measure grow with the square of the distance, two with its
        // fourth power.
        let power = (other / one).ln() / NEARER.ln();
        // Directly before a fold, a minimum is a rounding error.
        if power <= MIN_POWER {
            return false;
        }
        // The width is unknown if a measure is that of no state: then steps become as short as possible.
        let power = if power.is_nan() {
            2.0
        } else {
            power.clamp(2.0, 4.0)
        };
        let width = far * (measure / one).powf(1.0 / power);
        let miss = CloseMiss {
            group,
            sine: measure.sqrt(),
            at,
            between: [from, to],
            width: if width.is_finite() { width } else { 0.0 },
        };
        let anchors = self.anchors.clone();
        let reached = self.step_past(&miss);
        self.anchors = anchors;
        let is_same = |(now, then): (&f64, &f64)| (now - then).abs() < CLOSURE_TOLERANCE;
        let mut groups = self.engine.program.coupled.iter();
        let stays = reached == Some(to)
            && groups.all(|group| {
                let z = group.offset..group.offset + group.width();
                let [now, then] =
                    [&self.state, last].map(|state| &state.scratch.numbers[z.clone()]);
                now.iter().zip(then).all(is_same)
            });
        if !stays {
            self.missed = Some(miss);
        }
        !stays
    }

    /// Returns `true` if nothing in a group moves with the driver at a coordinate.
    fn is_at_rest(&mut self, group: usize, at: f64) -> bool {
        self.predict_nearest(at);
        let is_solved = self.run(at, Order::Velocity) == Condition::Ok;
        let mut steps = 0..self.engine.program.steps.len();
        let step = steps.find(|&step| self.engine.group_of(step) == Some(group));
        step.is_some_and(|step| {
            let (points, links) = self.engine.outputs(step);
            let here: &State = &self.state;
            let mut speeds = points.iter().map(|p| here.points[p.index()].v.norm());
            let mut rates = links.iter().map(|l| here.links[l.index()].w);
            is_solved && speeds.all(|speed| speed == 0.0) && rates.all(|rate| rate == 0.0)
        })
    }

    /// Returns a group's measure between the last samples, negative if the mechanism does not exist
    /// there.
    fn measure(&mut self, group: usize, at: f64) -> f64 {
        self.predict_nearest(at);
        let mut condition = self.run(at, Order::Position);
        if condition == Condition::NoAssembly && self.has_path() {
            // A sample beyond a crossing may be on the other branch, which may not reach back to here.
            let Walker { anchors, state, .. } = self;
            anchors.predict_from_before(self.engine, at, self.sense, state);
            condition = self.run(at, Order::Position);
        }
        // Another group may be at its limit.
        if condition != Condition::NoAssembly && self.is_coupled(group) {
            self.engine.measure_coupled(at, &mut self.state);
            return self.state.measures[group];
        }
        let measure = self.state.measures[group];
        match condition {
            Condition::Ok => measure,
            Condition::DeadPoint | Condition::ChangePoint => measure.min(0.0),
            Condition::NoAssembly if measure < 0.0 => measure,
            // Another group is open: the stored measure may belong to another coordinate.
            Condition::NoAssembly => -1.0,
        }
    }

    /// Returns the coordinate of the minimum of a measure between two samples, by golden section.
    /// Returns the sample between them immediately if its measure touches zero.
    fn lowest(&mut self, group: usize, [a, middle, b]: [f64; 3]) -> f64 {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        if self.measure(group, middle) < TOUCH_TOLERANCE * self.peaks[group] {
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

    /// Returns `true` if a group is at its limit where its measure has a minimum.
    fn touches(&mut self, group: usize, at: f64, measure: f64) -> bool {
        if self.is_coupled(group) {
            return measure < NEAR * self.peaks[group] && self.crosses(group, at);
        }
        measure < TOUCH_TOLERANCE * self.peaks[group]
    }

    /// Returns `true` if a group is coupled.
    fn is_coupled(&self, group: usize) -> bool {
        let mut coupled = self.engine.program.coupled.iter();
        coupled.any(|c| c.group == group)
    }

    /// Returns the last coordinate between `good` and `bad` at which a measure is positive, by
    /// bisection.
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

impl Stretch {
    /// Returns `true` if the relative velocity reverses between the samples, in any frame.
    fn turns_back(&self) -> bool {
        (0..FRAMES).any(|frame| self.turns_back_in(frame))
    }

    /// Returns `true` if the relative velocity reverses between the samples or at the second one, in
    /// one frame.
    fn turns_back_in(&self, frame: usize) -> bool {
        let [from, to] = [self.from.1, self.to.1].map(|s| s.seen[frame]);
        let reverses_at_end = to.v == Vec2::ZERO && to.a != Vec2::ZERO && from.v != Vec2::ZERO;
        from.v.dot(to.v) < 0.0 || reverses_at_end
    }

    /// Returns the rates at both samples. If a sample is at rest, as at the end of a table, its
    /// rate is always zero. Then the sign just next to it counts, on the inner side.
    fn rates(&self, sense: f64) -> [f64; 2] {
        let [from, to] = [self.from.1, self.to.1];
        let rate = |own: Stretching, other: Stretching, inwards: f64| {
            let speed = |s: &Stretching, frame: usize| s.seen[frame].v.norm();
            let is_still = |&f: &usize| speed(&own, f) <= ZERO_SPEED_FRACTION * speed(&other, f);
            match (0..FRAMES).find(is_still) {
                Some(frame) => own.adjacent_rate_sign(frame, inwards),
                None => own.rate().unwrap_or(0.0),
            }
        };
        let rates = [rate(from, to, sense), rate(to, from, -sense)];
        // Behind the end of a table, nothing moves: there is no extreme.
        match (from.is_at_rest(), to.is_at_rest()) {
            (true, true) => [0.0; 2],
            (true, false) => [rates[1]; 2],
            (false, true) => [rates[0]; 2],
            (false, false) => rates,
        }
    }

    /// Returns `true` if there may be an extreme between the samples. An extreme at the first
    /// sample was found before.
    fn has_extreme(&self, sense: f64) -> bool {
        let [from, to] = self.rates(sense);
        self.turns_back() || from != 0.0 && (to == 0.0 || (from < 0.0) != (to < 0.0))
    }
}
