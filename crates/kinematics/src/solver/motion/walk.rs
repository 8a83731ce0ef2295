//! The walk along the motion: steps, barriers, and when a turn has closed.

use super::anchors::Anchors;
use super::change::ReachExtreme;
use super::proved_ends::BoundedEnd;
use super::{Folded, LinedUp, NearMiss, Stretched};
use crate::Double;
use crate::solver::change_point::Passages;
use crate::solver::elements::Stretching;
use crate::solver::engine::Engine;
use crate::solver::exact::Exact;
use crate::solver::fault::Fault;
use crate::solver::plan::GroupId;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use crate::solver::{Order, angle_turn};
use std::ops::Range;

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
/// A turning driver steps by a degree, a pushed one by this part of the solver's unit length.
const PUSH_STEP: f64 = 1.0 / 128.0;
/// How many longest lengths a slide is followed.
pub(super) const PUSH_REACH: f64 = 64.0;
/// Steps into which one degree, or one push, may fall: a hundred halvings and as many doublings.
const MAX_STEPS: usize = 400;
/// Halvings between two doubles, at the most.
const MAX_HALVINGS: usize = 1100;
/// Turns after which a motion must have closed.
pub(super) const MAX_TURNS: usize = 16;
/// Samples that must have been seen before a minimum of a measure shows.
pub(super) const SAMPLES: usize = 3;
/// How near z must come to its start for the motion to have closed.
const CLOSED: f64 = 1e-7;

/// A state of the walk.
pub(super) struct WalkSample {
    /// The driver's coordinate.
    pub(super) at: f64,
    pub(super) measures: Vec<f64>,
    /// How every dyad is being stretched, by its step.
    pub(super) stretchings: Vec<(usize, Option<Stretching>)>,
}

/// How a walk ended.
pub(super) enum WalkEnd {
    Closed(usize),
    Limit(BoundedEnd),
    /// Followed no further.
    Cut(f64),
}

impl WalkEnd {
    /// The end of the range, or the number of turns after which the motion has closed.
    pub(super) fn end(self) -> Result<BoundedEnd, usize> {
        match self {
            WalkEnd::Closed(turns) => Err(turns),
            WalkEnd::Limit(end) => Ok(end),
            WalkEnd::Cut(at) => Ok(BoundedEnd::exact(at)),
        }
    }
}

/// Someone who follows the motion from its start, in one direction.
pub(super) struct Walker<'e> {
    pub(super) engine: &'e Engine,
    pub(super) exact: Option<&'e Exact>,
    /// The same, with room, where it tells more than doubles do.
    pub(super) closely: Option<(&'e Exact, State<Double>)>,
    pub(super) state: Workspace,
    pub(super) anchors: Anchors,
    /// The last few states.
    pub(super) seen: Vec<WalkSample>,
    /// The largest value of every measure so far, at most 1: what is small is small against this.
    pub(super) peaks: Vec<f64>,
    pub(super) start: f64,
    pub(super) sense: f64,
    pub(super) passages: Passages,
    /// The extreme that was found last, at the limit that it is.
    pub(super) ahead: Option<ReachExtreme>,
    /// The groups whose assemblies meet at the limit ahead, as far as that is known.
    pub(super) unproved: Vec<GroupId>,
    /// The ends at which groups are lined up.
    pub(super) lined_up: Vec<LinedUp>,
    /// The coordinates that have been reached.
    pub(super) samples: Vec<f64>,
    pub(super) misses: Vec<NearMiss>,
    /// How far each watched constraint was from holding at the most.
    pub(super) misfits: Vec<f64>,
    pub(super) folds: Vec<Folded>,
    pub(super) stretched: Vec<Stretched>,
    /// How many terms of series the last place took at which groups were singular.
    pub(super) terms: usize,
}

/// Why the motion goes no further.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stop {
    /// Somewhere between the last coordinate that was reached, and one that was not.
    Barrier { good: f64, bad: f64 },
    /// At a limit that is known already.
    Limit(f64),
}

impl Walker<'_> {
    pub(super) fn walk(&mut self) -> Result<WalkEnd, Fault> {
        let (start, sense) = (self.start, self.sense);
        let step = if self.engine.turns {
            1.0
        } else {
            PUSH_STEP * self.engine.frame.scale
        };
        let per_turn = if self.engine.turns { 360 } else { usize::MAX };
        let most = if self.engine.turns {
            360 * MAX_TURNS
        } else {
            (PUSH_REACH / PUSH_STEP) as usize
        };
        let first_z = self.state.scratch.numbers.clone();
        let opened = self.state.clone();
        if self.run(start, Order::Acceleration) != Condition::Ok {
            self.state = opened;
        }
        self.look_behind(step);
        let (mut from, mut closed, mut k) = (start, None, 1);
        let mut passed = f64::NEG_INFINITY;
        while k <= most {
            let to = start + sense * step * k as f64;
            let stop = self.advance_by_table_ends(from, to);
            if let Err(stop) = stop {
                let limit = match stop {
                    Stop::Limit(limit) => limit,
                    Stop::Barrier { good, bad } => {
                        let limit = self.bisect(good, bad);
                        self.approach(limit).unwrap_or(limit)
                    }
                };
                // What lies beyond a closed turn has been met at its beginning.
                if let Some(turns) = closed.filter(|&t| self.ahead(limit) > angle_turn(t)) {
                    return Ok(WalkEnd::Closed(turns));
                }
                self.check_fit_between(from, limit)?;
                let last = self.state.clone();
                // A place that was passed before is none ahead: there is no way on that could be told.
                let beyond = self.pass(limit).filter(|&at| self.ahead(at) > passed);
                let Some(beyond) = beyond else {
                    let limit = self.refined(limit, &last);
                    let groups = std::mem::take(&mut self.unproved).into_iter();
                    self.lined_up.extend(groups.map(|group| LinedUp {
                        group,
                        at: limit.at,
                    }));
                    return Ok(WalkEnd::Limit(limit));
                };
                // The steps between have been taken on the wrong side.
                (from, closed, passed) = (beyond, None, self.ahead(beyond));
                k = (self.ahead(beyond) / step) as usize + 1;
                continue;
            }
            self.check_fit()?;
            // A turn ends a step after it has closed: only then has its last minimum been seen.
            if let Some(turns) = closed {
                return Ok(WalkEnd::Closed(turns));
            }
            let comes_round = || self.engine.comes_round(k / per_turn);
            if k % per_turn == 0 && comes_round() && self.has_closed(&first_z) {
                closed = Some(k / per_turn);
            }
            (from, k) = (to, k + 1);
        }
        Ok(WalkEnd::Cut(from))
    }

    /// Runs every step, of a mechanism of dyads alone in twice the digits where doubles do not tell.
    pub(super) fn run(&mut self, at: f64, order: Order) -> Condition {
        let condition = if self.passages.is_near(self.engine, at) {
            self.run_some(0..self.engine.program.steps.len(), at, order)
        } else {
            self.engine.run(at, order, &mut self.state)
        };
        match &mut self.closely {
            Some((exact, close)) if condition != Condition::Ok => {
                let state = &mut self.state.state;
                let how = (&state.signs[..], None);
                let found = exact.run(exact.closed, Double::exactly(at), order, how, close);
                exact.write(exact.closed, close, state);
                state.condition = found;
                found
            }
            _ => condition,
        }
    }

    /// Runs some steps, in doubles.
    pub(super) fn run_some(&mut self, steps: Range<usize>, at: f64, order: Order) -> Condition {
        let engine = self.engine;
        if self.passages.is_near(engine, at) {
            engine.run_near(steps, at, order, &self.passages, &mut self.state)
        } else {
            engine.run_steps(steps, at, order, &mut self.state)
        }
    }

    /// By how much lengths differ that count as equal.
    pub(super) fn slack(&self) -> f64 {
        self.exact.map_or(0.0, Exact::slack)
    }

    /// How far on the way a coordinate is.
    pub(super) fn ahead(&self, at: f64) -> f64 {
        (at - self.start) * self.sense
    }

    /// Puts into the state what the nearest of the latest anchors predicts.
    pub(super) fn aim_at(&mut self, at: f64) {
        self.anchors
            .aim_from_latest(self.engine, at, &mut self.state);
    }

    /// Notes a state on the other side of the start, so that a minimum at the start shows.
    fn look_behind(&mut self, step: f64) {
        let (at_start, kept) = (self.state.clone(), self.anchors.len());
        let walked = self.samples.len();
        let behind = self.start - self.sense * step;
        self.seen.clear();
        if self.advance(self.start, behind).is_ok() {
            self.seen.drain(..self.seen.len().saturating_sub(1));
        } else {
            self.seen.clear();
        }
        self.state = at_start;
        // What lies behind is walked in its turn; a change point there is only passed then.
        self.anchors.truncate(self.engine, kept);
        self.samples.truncate(walked);
        self.note(self.start);
    }

    /// Keeps the state that was reached as a sample and as an anchor.
    pub(super) fn note(&mut self, at: f64) {
        self.engine.measure_coupled(at, &mut self.state);
        self.anchors.push(self.engine, at, &mut self.state);
        self.samples.push(at);
        if self.seen.len() == SAMPLES {
            self.seen.rotate_left(1);
            self.seen.pop();
        }
        let sample = WalkSample {
            at,
            measures: self.state.measures.clone(),
            stretchings: self.stretchings(at),
        };
        self.seen.push(sample);
        for (peak, measure) in self.peaks.iter_mut().zip(&self.state.measures) {
            *peak = peak.max(*measure).min(1.0);
        }
    }

    /// How every dyad is being stretched in the state.
    fn stretchings(&self, at: f64) -> Vec<(usize, Option<Stretching>)> {
        let (q, _) = self.engine.coordinate(at);
        let steps = self.engine.program.steps.iter().enumerate();
        let dyads = steps.filter_map(|(i, step)| Some((i, step.dyad()?)));
        dyads
            .map(|(i, dyad)| (i, dyad.stretching(q, &self.engine.carriers, &self.state)))
            .collect()
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

    pub(super) fn check_fit(&mut self) -> Result<(), Fault> {
        let misses = self.engine.misses(&self.state);
        for (largest, (_, miss, _)) in self.misfits.iter_mut().zip(misses) {
            *largest = largest.max(miss.abs());
        }
        match self.engine.misfit(&self.state) {
            None => Ok(()),
            Some((watch, miss)) => Err(Fault::OverConstrained {
                element: watch.element,
                others: Vec::new(),
                misfit: miss.abs() * self.engine.frame.scale,
                at: self.state.at,
            }),
        }
    }

    /// Whether what was set aside fits on the last part of a way, be it shorter than a step. At its end
    /// rounding grows beyond what may be asked: halfway there it does not.
    fn check_fit_between(&mut self, from: f64, limit: f64) -> Result<(), Fault> {
        let last = self.state.clone();
        let middle = from + 0.5 * (limit - from);
        self.aim_at(middle);
        let exists = self.engine.run(middle, Order::Position, &mut self.state) == Condition::Ok;
        let fits = if exists { self.check_fit() } else { Ok(()) };
        self.state = last;
        fits
    }

    /// As [`Walker::advance`], with a sample where a table begins or ends: there its input stands still, and what
    /// happens just before is not seen from behind.
    fn advance_by_table_ends(&mut self, from: f64, to: f64) -> Result<(), Stop> {
        let mut from = from;
        while let Some(end) = self.engine.table_end(from, to) {
            self.advance(from, end)?;
            from = end;
        }
        self.advance(from, to)
    }

    /// Goes from one coordinate, at which the state is, to another by as many steps as the motion
    /// needs, and notes each; stopped, the state is the last good one.
    fn advance(&mut self, from: f64, to: f64) -> Result<(), Stop> {
        let (mut good, mut bad, mut step) = (from, to, to - from);
        let mut saved = self.state.clone();
        for _ in 0..MAX_STEPS {
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
        self.run(at, Order::Position) != Condition::Ok
    }

    pub(super) fn try_step(&mut self, from: f64, to: f64, before: &State) -> bool {
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
        if self.run(to, Order::Acceleration) != Condition::Ok {
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
        for _ in 0..MAX_HALVINGS {
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

    /// Goes from the last sample towards a limit, half of the way at a time, for what lies close before it:
    /// the first limit that is found. Where states depend on the path, narrowing down did that.
    fn approach(&mut self, limit: f64) -> Option<f64> {
        if self.has_path() {
            return None;
        }
        let (at_end, walked) = (self.state.clone(), self.samples.len());
        let mut from = self.seen.last()?.at;
        let mut found = None;
        while found.is_none() {
            let next = from + 0.5 * (limit - from);
            if next == from || next == limit || self.run(next, Order::Acceleration) != Condition::Ok
            {
                break;
            }
            self.note(next);
            found = self.limit_passed();
            from = next;
        }
        self.samples.truncate(walked);
        self.state = at_end;
        found
    }

    fn reach(&mut self, good: f64, to: f64) -> Result<(), Stop> {
        if self.has_path() {
            return self.advance(good, to);
        }
        match self.run(to, Order::Position) {
            Condition::NoAssembly => Err(Stop::Barrier { good, bad: to }),
            Condition::Ok | Condition::ChangePoint | Condition::DeadPoint => Ok(()),
        }
    }
}
