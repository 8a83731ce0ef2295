//! The whole motion, followed once when a mechanism is opened.
//!
//! The walk goes from the start in both directions until the motion closes or ends. It looks for
//! the end on each group's own measure (the square of the sine of its transmission angle, negative
//! where the group is open), also between its steps, and keeps anchor states of coupled groups, from
//! which any angle is solved later without any history.

use super::engine::Engine;
use super::fault::Fault;
use super::passage::{Passage, Passages};
use super::state::{Condition, State};
use super::{Order, angle_turn};

/// The range that the driver can cover from the scene's assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Full turns; the motion repeats after `period` degrees (360 or a multiple).
    Full {
        /// In degrees.
        period: f64,
    },
    /// Between two limits, in degrees or in the scene's length unit. A slide that could be pushed
    /// without end is cut off at 64 times the longest length of the scene.
    Limited {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
}

/// The whole motion of a mechanism, found once.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The driver's range.
    pub range: Range,
    /// The ends of the range at which the mechanism cannot go on, in degrees or in the scene's length
    /// unit: there are two, or none.
    pub dead_points: Vec<f64>,
    /// Where two assemblies meet and the motion passes smoothly, within one period.
    pub change_points: Vec<f64>,
    pub(super) anchors: Anchors,
    pub(super) passages: Passages,
}

impl Motion {
    /// Whether the motion from the scene's assembly comes to this coordinate.
    pub(super) fn covers(&self, at: f64) -> bool {
        match self.range {
            Range::Full { .. } => at.is_finite(),
            Range::Limited { low, high } => low <= at && at <= high,
        }
    }
}

/// States of the coupled groups along the motion, by the driver's coordinate.
#[derive(Clone, Debug, Default)]
pub(super) struct Anchors {
    at: Vec<f64>,
    /// z, z' and z'' of every group, anchor by anchor.
    numbers: Vec<f64>,
    /// The period by which coordinates are reduced; 0 where they are not.
    period: f64,
}

impl Anchors {
    fn stride(engine: &Engine) -> usize {
        engine
            .program
            .coupled
            .iter()
            .map(|c| c.width() + 2 * c.unknowns())
            .sum()
    }

    /// Puts into the scratch what the nearest anchor predicts for `at`.
    pub(super) fn aim(&self, engine: &Engine, at: f64, state: &mut State) {
        if self.at.is_empty() {
            return;
        }
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
        self.aim_from(nearest, engine, reduced, state);
    }

    /// As [`Anchors::aim`], from the nearest of the anchors that were pushed last.
    fn aim_from_latest(&self, engine: &Engine, at: f64, state: &mut State) {
        let latest = self.at.len().saturating_sub(SAMPLES)..self.at.len();
        let far = |&i: &usize| (self.at[i] - at).abs();
        if let Some(nearest) = latest.min_by(|i, j| far(i).total_cmp(&far(j))) {
            self.aim_from(nearest, engine, at, state);
        }
    }

    fn aim_from(&self, anchor: usize, engine: &Engine, at: f64, state: &mut State) {
        let dq = engine.difference(self.at[anchor], at);
        let mut from = anchor * Anchors::stride(engine);
        for group in &engine.program.coupled {
            let mut room = group.open(&mut state.scratch);
            for part in [&mut *room.z, &mut *room.first, &mut *room.second] {
                part.copy_from_slice(&self.numbers[from..from + part.len()]);
                from += part.len();
            }
            group.predict(&mut room, dq);
        }
    }

    /// Forgets the latest anchors as far as they lie beyond a limit.
    fn forget_beyond(&mut self, engine: &Engine, limit: f64, sense: f64) {
        while self
            .at
            .last()
            .is_some_and(|&at| (at - limit) * sense >= 0.0)
        {
            self.at.pop();
            self.numbers
                .truncate(self.at.len() * Anchors::stride(engine));
        }
    }

    fn push(&mut self, engine: &Engine, at: f64, state: &mut State) {
        if engine.program.coupled.is_empty() {
            return;
        }
        self.at.push(at);
        for group in &engine.program.coupled {
            let room = group.open(&mut state.scratch);
            for part in [&*room.z, &*room.first, &*room.second] {
                self.numbers.extend_from_slice(part);
            }
        }
    }

    /// Sorted by coordinate, each reduced to one period.
    fn sorted(&self, engine: &Engine, period: f64) -> Anchors {
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
        // Across the end of the period, too, the nearest anchor is the nearest.
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

pub(super) fn positive_remainder(at: f64, period: f64) -> f64 {
    let rest = at % period;
    if rest < 0.0 { rest + period } else { rest }
}

/// A watched constraint may miss by the rounding that a long chain of groups gathers, not more;
/// in units of about the longest link.
const MISFIT: f64 = 1e-11;
/// No link turns more than this (as the length of the change of its unit vector) in one step.
const TURN_STEP: f64 = 0.2;
/// A coupled group's first correction may be this part of the predicted move: else the step could
/// land on another assembly.
const STRAIN: f64 = 0.05;
/// Below this correction, in units of about the longest link, no strain is counted: rounding.
const STRAIN_FLOOR: f64 = 1e-9;
/// The second-order part of a coupled group's move may be this part of the first-order one: at a
/// distance D from a dead point it is h / 4 D for a step h, so that no step reaches across it.
const BEND: f64 = 0.125;
/// Below this, in units of about the longest link, no bend is counted: the group stands still.
const BEND_FLOOR: f64 = 1e-6;
/// A measure whose smallest sample is below this is searched for a zero between the samples.
const SUSPICIOUS: f64 = 0.05;
/// A measure below this part of its largest, some u, touches zero.
const TOUCH: f64 = 1e-14;
/// A measure this small is a gap of the size of the rounding, squared.
const GAP: f64 = 1e-28;
/// A turning driver steps by a degree, a pushed one by this part of the solver's unit length.
const PUSH_STEP: f64 = 1.0 / 128.0;
/// How many longest lengths a slide is followed.
const PUSH_REACH: f64 = 64.0;
/// Sections that narrow a minimum down to the square root of the rounding.
const GOLDEN_SECTIONS: usize = 44;
/// Steps into which one degree, or one push, may fall: a hundred halvings and as many doublings.
const MOST_STEPS: usize = 400;
/// Halvings between two doubles, at the most.
const MOST_HALVINGS: usize = 1100;
/// Doublings from one ulp by which the end of a range is drawn back, at the most.
const MOST_DRAWS: i32 = 24;
/// Turns after which a motion must have closed.
const MOST_TURNS: usize = 16;
/// Samples that must have been seen before a minimum of a measure shows.
const SAMPLES: usize = 3;
/// A change point is passed in one step from this much before it to this much beyond, in radians or
/// scaled lengths: far enough for the dyad to have digits on both sides.
const PASSING: f64 = 1e-3;
/// An extreme of a dyad's stretch belongs to a limit if it is this close to it.
const EXTREME: f64 = 1e-3;
/// How near z must come to its start for the motion to have closed.
const CLOSED: f64 = 1e-7;

/// Follows the motion from a solved state at `start`.
///
/// # Errors
/// [`Fault::OverConstrained`] where a constraint that was set aside stops holding.
pub(super) fn explore(engine: &Engine, start: f64, state: &State) -> Result<Motion, Fault> {
    let mut walker = Walker {
        engine,
        state: state.clone(),
        anchors: Anchors::default(),
        seen: Vec::new(),
        peaks: state.measures.clone(),
        start,
        sense: 1.0,
        passages: Vec::new(),
    };
    walker.check_fit()?;
    let up = walker.walk()?;
    let (range, period) = match up {
        End::Closed(turns) => {
            let period = angle_turn(turns);
            (Range::Full { period }, period)
        }
        End::Limit(high) | End::Cut(high) => {
            walker.state = state.clone();
            walker.sense = -1.0;
            let low = match walker.walk()? {
                End::Limit(low) | End::Cut(low) => low,
                End::Closed(turns) => start - angle_turn(turns),
            };
            (Range::Limited { low, high }, 0.0)
        }
    };
    let anchors = walker.anchors.sorted(engine, period);
    let range = match range {
        Range::Full { .. } => range,
        Range::Limited { low, high } => {
            let mut settle = |end| settled_end(end, start, engine, &anchors, &mut walker.state);
            Range::Limited {
                low: settle(low),
                high: settle(high),
            }
        }
    };
    let passages = Passages::new(walker.passages, start, period);
    Ok(Motion {
        range,
        dead_points: dead_points(range, engine, start),
        change_points: passages.coordinates(),
        anchors,
        passages,
    })
}

/// The end of a range, drawn back by the few ulps by which a state that is predicted from another
/// anchor than in the walk may miss it.
fn settled_end(end: f64, start: f64, engine: &Engine, anchors: &Anchors, state: &mut State) -> f64 {
    let ulp = f64::EPSILON * end.abs().max(start.abs());
    let back = |k: i32| end - (end - start).signum() * ulp * (f64::from(k).exp2() - 1.0);
    let mut exists = |&at: &f64| {
        anchors.aim(engine, at, state);
        engine.run(at, Order::Position, state) != Condition::NoAssembly
    };
    let candidates = (0..MOST_DRAWS).map(back);
    let mut inside = candidates.take_while(|at| (at - start) * (end - start) > 0.0);
    inside.find(|at| exists(at)).unwrap_or(end)
}

/// The ends of a range, but for those at which a slide was merely followed no further.
fn dead_points(range: Range, engine: &Engine, start: f64) -> Vec<f64> {
    match range {
        Range::Full { .. } => Vec::new(),
        Range::Limited { low, high } => {
            let reach = PUSH_REACH * engine.frame.scale;
            let is_cut = |end: f64| !engine.turns && (end - start).abs() >= reach;
            [low, high]
                .into_iter()
                .filter(|&end| !is_cut(end))
                .collect()
        }
    }
}

enum End {
    Closed(usize),
    Limit(f64),
    /// Followed no further.
    Cut(f64),
}

struct Walker<'e> {
    engine: &'e Engine,
    state: State,
    anchors: Anchors,
    /// The last few states, by coordinate and measures.
    seen: Vec<(f64, Vec<f64>)>,
    /// The largest value of every measure so far, at most 1: what is small is small against this.
    peaks: Vec<f64>,
    start: f64,
    sense: f64,
    passages: Vec<Passage>,
}

/// Why the motion goes no further.
#[derive(Clone, Copy, Debug)]
enum Stop {
    /// Somewhere between the last coordinate that was reached, and one that was not.
    Barrier { good: f64, bad: f64 },
    /// At a limit that is known already.
    Limit(f64),
}

impl Walker<'_> {
    fn walk(&mut self) -> Result<End, Fault> {
        let (start, sense) = (self.start, self.sense);
        let step = if self.engine.turns {
            1.0
        } else {
            PUSH_STEP * self.engine.frame.scale
        };
        let per_turn = if self.engine.turns { 360 } else { usize::MAX };
        let most = if self.engine.turns {
            360 * MOST_TURNS
        } else {
            (PUSH_REACH / PUSH_STEP) as usize
        };
        let first_z = self.state.scratch.numbers.clone();
        self.look_behind(step);
        let (mut from, mut closed, mut k) = (start, None, 1);
        while k <= most {
            let to = start + sense * step * k as f64;
            let stop = self.advance(from, to);
            if let Err(stop) = stop {
                let limit = match stop {
                    Stop::Limit(limit) => limit,
                    Stop::Barrier { good, bad } => self.bisect(good, bad),
                };
                // What lies beyond a closed turn has been met at its beginning.
                if let Some(turns) = closed.filter(|&t| self.ahead(limit) > angle_turn(t)) {
                    return Ok(End::Closed(turns));
                }
                let Some(beyond) = self.pass(limit) else {
                    return Ok(End::Limit(limit));
                };
                // The steps between have been taken on the wrong side.
                (from, closed) = (beyond, None);
                k = (self.ahead(beyond) / step) as usize + 1;
                continue;
            }
            self.check_fit()?;
            // A turn ends a step after it has closed: only then has its last minimum been seen.
            if let Some(turns) = closed {
                return Ok(End::Closed(turns));
            }
            if k % per_turn == 0 && self.has_closed(&first_z) {
                closed = Some(k / per_turn);
            }
            (from, k) = (to, k + 1);
        }
        Ok(End::Cut(from))
    }

    /// Notes a state on the other side of the start, so that a minimum at the start shows.
    fn look_behind(&mut self, step: f64) {
        let at_start = self.state.clone();
        let behind = self.start - self.sense * step;
        self.seen.clear();
        if self.advance(self.start, behind).is_ok() {
            self.seen.drain(..self.seen.len().saturating_sub(1));
        } else {
            self.seen.clear();
        }
        self.state = at_start;
        self.note(self.start);
    }

    /// Keeps the state that was reached as a sample and as an anchor.
    fn note(&mut self, at: f64) {
        self.anchors.push(self.engine, at, &mut self.state);
        if self.seen.len() == SAMPLES {
            self.seen.rotate_left(1);
            self.seen.pop();
        }
        self.seen.push((at, self.state.measures.clone()));
        for (peak, measure) in self.peaks.iter_mut().zip(&self.state.measures) {
            *peak = peak.max(*measure).min(1.0);
        }
    }

    /// Whether every group is where it was at the start.
    fn has_closed(&self, first: &[f64]) -> bool {
        let now = &self.state.scratch.numbers;
        self.state.signs == self.engine.signs
            && self.engine.program.coupled.iter().all(|group| {
                let z = group.offset..group.offset + group.width();
                now[z.clone()]
                    .iter()
                    .zip(&first[z])
                    .all(|(a, b)| (a - b).abs() < CLOSED)
            })
    }

    fn check_fit(&self) -> Result<(), Fault> {
        match self.engine.misfit(&self.state, MISFIT) {
            None => Ok(()),
            Some((watch, miss)) => Err(Fault::OverConstrained {
                element: watch.element,
                misfit: miss.abs() * self.engine.frame.scale,
                at: self.state.at,
            }),
        }
    }

    /// Goes from one coordinate, at which the state is, to another by as many steps as the motion
    /// needs, and notes each; stopped, the state is the last good one.
    fn advance(&mut self, from: f64, to: f64) -> Result<(), Stop> {
        let (mut good, mut bad, mut step) = (from, to, to - from);
        let mut saved = self.state.clone();
        for _ in 0..MOST_STEPS {
            if good == to {
                return Ok(());
            }
            let next = if (to - good).abs() <= step.abs() {
                to
            } else {
                good + step
            };
            if next == good {
                break;
            }
            if self.try_step(good, next, &saved) {
                self.note(next);
                if let Some(limit) = self.limit_passed() {
                    return Err(Stop::Limit(limit));
                }
                saved.clone_from(&self.state);
                good = next;
                step *= 2.0;
                continue;
            }
            bad = next;
            let ends = !self.has_path() && self.fails_at(next);
            self.state.clone_from(&saved);
            if ends {
                break;
            }
            step = 0.5 * (next - good);
        }
        Err(Stop::Barrier { good, bad })
    }

    /// Whether states depend on the path to them: a mechanism of dyads alone needs none.
    fn has_path(&self) -> bool {
        !self.engine.program.coupled.is_empty()
    }

    /// Whether a mechanism of dyads alone does not exist at a coordinate.
    fn fails_at(&mut self, at: f64) -> bool {
        self.engine.run(at, Order::Position, &mut self.state) != Condition::Ok
    }

    fn try_step(&mut self, from: f64, to: f64, before: &State) -> bool {
        let dq = self.engine.difference(from, to);
        let mut planned = Vec::new();
        for group in &self.engine.program.coupled {
            let mut room = group.open(&mut self.state.scratch);
            let [first, second] = group.move_sizes(&room, dq);
            if second > BEND * first + BEND_FLOOR {
                return false;
            }
            planned.push(first);
            group.predict(&mut room, dq);
        }
        if self.engine.run(to, Order::Acceleration, &mut self.state) != Condition::Ok {
            return false;
        }
        let corrections = &self.state.scratch.first;
        let mut strains = corrections.iter().zip(&planned);
        let strained = strains.any(|(c, planned)| *c > STRAIN * planned + STRAIN_FLOOR);
        let mut turns = self.state.links.iter().zip(&before.links);
        !strained && turns.all(|(now, then)| (now.d - then.d).norm2() < TURN_STEP * TURN_STEP)
    }

    /// Narrows a barrier down to neighbouring doubles and returns the last coordinate that exists,
    /// the dead point itself included. The state must be the one at `good`.
    fn bisect(&mut self, mut good: f64, mut bad: f64) -> f64 {
        // A step may have met the dead point itself, which belongs to the range.
        if !self.has_path() && self.reach(good, bad).is_ok() {
            return bad;
        }
        for _ in 0..MOST_HALVINGS {
            let middle = good + 0.5 * (bad - good);
            if middle == good || middle == bad {
                break;
            }
            match self.reach(good, middle) {
                Ok(()) => good = middle,
                Err(Stop::Barrier { good: g, bad: b }) => (good, bad) = (g, b),
                Err(Stop::Limit(limit)) => return limit,
            }
        }
        good
    }

    fn reach(&mut self, good: f64, to: f64) -> Result<(), Stop> {
        if self.has_path() {
            return self.advance(good, to);
        }
        match self.engine.run(to, Order::Position, &mut self.state) {
            Condition::NoAssembly => Err(Stop::Barrier { good, bad: to }),
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => Ok(()),
        }
    }

    // ---- change points

    /// Goes on beyond a limit, if it is a change point of dyads: the coordinate that was reached.
    fn pass(&mut self, limit: f64) -> Option<f64> {
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
        self.record(&changes, &saved.signs, &reached.signs);
        self.state = reached;
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    fn ahead(&self, at: f64) -> f64 {
        (at - self.start) * self.sense
    }

    fn flip(&mut self, changes: &[(usize, f64)]) {
        for &(step, _) in changes {
            if let Some(group) = self.engine.program.steps[step].choice() {
                self.state.signs[group] = -self.state.signs[group];
            }
        }
    }

    fn aim_at(&mut self, at: f64) {
        self.anchors
            .aim_from_latest(self.engine, at, &mut self.state);
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
    /// ones are built on earlier ones.
    fn record(&mut self, changes: &[(usize, f64)], before: &[f64], beyond: &[f64]) {
        for &(step, at) in changes {
            let (engine, sense) = (self.engine, self.sense);
            let Some(group) = engine.program.steps[step].choice() else {
                continue;
            };
            let known = self.passages.iter().any(|p| p.group == group && p.at == at);
            let sample = |dq: f64| {
                let there = engine.moved(at, dq);
                self.aim_at(there);
                let signs = if dq * sense < 0.0 { before } else { beyond };
                self.state.signs.copy_from_slice(signs);
                let condition = engine.run(there, Order::Acceleration, &mut self.state);
                (condition == Condition::Ok).then(|| self.state.clone())
            };
            let through = Passage::through(at, &engine.program.steps[step], group, sample);
            let Some(mut passage) = through.filter(|_| !known) else {
                continue;
            };
            let so_far = Passages::new(self.passages.clone(), self.start, 0.0);
            let end = engine.run_near(at, Order::Position, &so_far, &mut self.state);
            if end != Condition::NoAssembly {
                passage.take_positions(&self.state);
            }
            self.passages.push(passage);
        }
    }

    /// A limit that the last three samples have stepped over: the zero of a measure that has a
    /// minimum between them. What lies behind the start is for the walk the other way.
    fn limit_passed(&mut self) -> Option<f64> {
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
        let limits: Vec<f64> = dips
            .into_iter()
            .filter_map(|group| self.limit_of(group, [a, m, b]))
            .collect();
        self.state = saved;
        let ahead = |limit: f64| (limit - self.start) * self.sense;
        limits
            .into_iter()
            .filter(|&limit| ahead(limit) > 0.0)
            .min_by(|&x, &y| ahead(x).total_cmp(&ahead(y)))
    }

    /// The zero of one group's measure that a minimum between three samples touches or crosses.
    fn limit_of(&mut self, group: usize, samples: [f64; SAMPLES]) -> Option<f64> {
        let lowest = self.lowest(group, samples);
        let measure = self.measure(group, lowest);
        let is_open = measure < 0.0 && self.state.condition == Condition::NoAssembly;
        if !is_open {
            return (measure < TOUCH * self.peaks[group]).then_some(lowest);
        }
        let [before, middle, _] = samples;
        let is_past_middle = (lowest - middle) * self.sense > 0.0;
        let good = if is_past_middle { middle } else { before };
        Some(self.edge(group, good, lowest))
    }

    /// A group's measure between the last samples, negative where the mechanism does not exist.
    fn measure(&mut self, group: usize, at: f64) -> f64 {
        self.anchors
            .aim_from_latest(self.engine, at, &mut self.state);
        let condition = self.engine.run(at, Order::Position, &mut self.state);
        let measure = self.state.measures[group];
        match condition {
            Condition::Ok => measure,
            Condition::DeadPoint | Condition::ChangePoint => measure.min(0.0),
            Condition::NoAssembly if measure < 0.0 => measure,
            // Another group is open: this one's measure may be that of another coordinate.
            Condition::NoAssembly => -1.0,
        }
    }

    /// The coordinate of the smallest measure between two samples, by golden section; at once the
    /// sample between them if that touches zero.
    fn lowest(&mut self, group: usize, [a, middle, b]: [f64; 3]) -> f64 {
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
