//! The whole motion, followed once when a mechanism is opened.
//!
//! The walk goes from the start in both directions until the motion closes or ends. It looks for
//! the end on each group's own measure (the square of the sine of its transmission angle, negative
//! where the group is open), also between its steps, and keeps anchor states of coupled groups, from
//! which any angle is solved later without any history.

use super::engine::Engine;
use super::fault::Fault;
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
    pub(super) anchors: Anchors,
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
        let dq = engine.difference(self.at[nearest], reduced);
        let mut from = nearest * Anchors::stride(engine);
        for group in &engine.program.coupled {
            let mut room = group.open(&mut state.scratch);
            for part in [&mut *room.z, &mut *room.first, &mut *room.second] {
                part.copy_from_slice(&self.numbers[from..from + part.len()]);
                from += part.len();
            }
            group.predict(&mut room, dq);
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

fn positive_remainder(at: f64, period: f64) -> f64 {
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
/// A measure whose smallest sample is below this is searched for a zero between the samples.
const SUSPICIOUS: f64 = 0.05;
/// A measure below this, some u, touches zero.
const TOUCH: f64 = 1e-14;
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
/// Turns after which a motion must have closed.
const MOST_TURNS: usize = 16;
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
    };
    walker.anchors.push(engine, start, &mut walker.state);
    walker.check_fit()?;
    let up = walker.walk(start, 1.0)?;
    let (range, period) = match up {
        End::Closed(turns) => {
            let period = angle_turn(turns);
            (Range::Full { period }, period)
        }
        End::Limit(high) => {
            walker.state = state.clone();
            let low = match walker.walk(start, -1.0)? {
                End::Limit(low) => low,
                End::Closed(turns) => start - angle_turn(turns),
            };
            (Range::Limited { low, high }, 0.0)
        }
    };
    let anchors = walker.anchors.sorted(engine, period);
    Ok(Motion { range, anchors })
}

enum End {
    Closed(usize),
    Limit(f64),
}

struct Walker<'e> {
    engine: &'e Engine,
    state: State,
    anchors: Anchors,
}

/// The last coordinate that was reached, and one that was not.
#[derive(Clone, Copy, Debug)]
struct Barrier {
    good: f64,
    bad: f64,
}

impl Walker<'_> {
    fn walk(&mut self, start: f64, sense: f64) -> Result<End, Fault> {
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
        let mut seen = vec![(start, self.state.measures.clone())];
        let mut from = start;
        for k in 1..=most {
            let to = start + sense * step * k as f64;
            if let Err(barrier) = self.advance(from, to) {
                return Ok(End::Limit(self.bisect(barrier)));
            }
            self.check_fit()?;
            self.anchors.push(self.engine, to, &mut self.state);
            seen.push((to, self.state.measures.clone()));
            if let Some(limit) = self.limit_between(&seen) {
                return Ok(End::Limit(limit));
            }
            if seen.len() == 3 {
                seen.remove(0);
            }
            from = to;
            if k % per_turn == 0 && self.has_closed(&first_z) {
                return Ok(End::Closed(k / per_turn));
            }
        }
        Ok(End::Limit(from))
    }

    /// Whether every coupled group is where it was at the start.
    fn has_closed(&self, first: &[f64]) -> bool {
        let now = &self.state.scratch.numbers;
        self.engine.program.coupled.iter().all(|group| {
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
    /// needs; stopped by a barrier, the state is the last good one.
    fn advance(&mut self, from: f64, to: f64) -> Result<(), Barrier> {
        let (mut good, mut step) = (from, to - from);
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
            if next != good && self.try_step(good, next, &saved) {
                saved.clone_from(&self.state);
                good = next;
                step *= 2.0;
                continue;
            }
            let ends = next == good || (!self.has_path() && self.fails_at(next));
            self.state.clone_from(&saved);
            if ends {
                let bad = if next == good { to } else { next };
                return Err(Barrier { good, bad });
            }
            step = 0.5 * (next - good);
        }
        self.state.clone_from(&saved);
        Err(Barrier { good, bad: to })
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
        let mut planned = 0.0_f64;
        for group in &self.engine.program.coupled {
            let mut room = group.open(&mut self.state.scratch);
            planned = planned.max(group.move_size(&room, dq));
            group.predict(&mut room, dq);
        }
        self.state.scratch.first = 0.0;
        if self.engine.run(to, Order::Acceleration, &mut self.state) != Condition::Ok {
            return false;
        }
        let strained = self.state.scratch.first > STRAIN * planned + STRAIN_FLOOR;
        let mut turns = self.state.links.iter().zip(&before.links);
        !strained && turns.all(|(now, then)| (now.d - then.d).norm2() < TURN_STEP * TURN_STEP)
    }

    /// Narrows a barrier down to neighbouring doubles and returns the last coordinate that exists,
    /// the dead point itself included. The state must be the one at `barrier.good`.
    fn bisect(&mut self, barrier: Barrier) -> f64 {
        let Barrier { mut good, mut bad } = barrier;
        let mut middle = bad;
        for _ in 0..MOST_HALVINGS {
            match self.reach(good, middle) {
                Ok(()) => good = middle,
                Err(barrier) => Barrier { good, bad } = barrier,
            }
            middle = good + 0.5 * (bad - good);
            if good == bad || middle == good || middle == bad {
                break;
            }
        }
        good
    }

    fn reach(&mut self, good: f64, to: f64) -> Result<(), Barrier> {
        if self.has_path() {
            return self.advance(good, to);
        }
        match self.engine.run(to, Order::Position, &mut self.state) {
            Condition::NoAssembly => Err(Barrier { good, bad: to }),
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => Ok(()),
        }
    }

    /// A limit that the last three samples have stepped over: the zero of a measure that has a
    /// minimum between them.
    fn limit_between(&mut self, seen: &[(f64, Vec<f64>)]) -> Option<f64> {
        let [(a, first), (m, middle), (b, last)] = seen else {
            return None;
        };
        let groups = 0..first.len();
        let dips = groups
            .filter(|&g| middle[g] < first[g] && middle[g] <= last[g] && middle[g] < SUSPICIOUS);
        let dips: Vec<usize> = dips.collect();
        let saved = self.state.clone();
        let limit = dips.into_iter().find_map(|group| {
            let lowest = self.lowest(group, [*a, *m, *b]);
            let measure = self.measure(group, lowest);
            if measure < -TOUCH {
                Some(self.edge(group, *a, lowest))
            } else {
                (measure < TOUCH).then_some(lowest)
            }
        });
        self.state = saved;
        limit
    }

    fn measure(&mut self, group: usize, at: f64) -> f64 {
        let anchors = self.anchors.sorted(self.engine, 0.0);
        anchors.aim(self.engine, at, &mut self.state);
        match self.engine.run(at, Order::Position, &mut self.state) {
            Condition::Ok => self.state.measures[group],
            Condition::DeadPoint | Condition::ChangePoint | Condition::NoAssembly => {
                self.state.measures[group].min(0.0)
            }
        }
    }

    /// The coordinate of the smallest measure between two samples, by golden section; at once the
    /// sample between them if that touches zero.
    fn lowest(&mut self, group: usize, [a, middle, b]: [f64; 3]) -> f64 {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        if self.measure(group, middle) < TOUCH {
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
