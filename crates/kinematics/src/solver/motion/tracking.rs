//! Tracks the motion step by step, finds barriers, and detects when a turn has closed.

use super::anchors::Anchors;
use super::change::ReachExtreme;
use super::crossing::CloseMiss;
use super::proved_ends::BoundedEnd;
use super::{Folded, MeetingAssemblies, NearMiss, ONE_MISS, Stretched};
use crate::solver::change_point::ChangePointCrossings;
use crate::solver::conditioning::condition;
use crate::solver::elements::Stretching;
use crate::solver::engine::Engine;
use crate::solver::exact::Exact;
use crate::solver::fault::Fault;
use crate::solver::plan::GroupId;
use crate::solver::state::{Condition, State};
use crate::solver::workspace::Workspace;
use crate::solver::{Order, angle_turn};
use crate::{Double, Number};
use std::ops::Range;

/// Maximum rotation of a link in one step, as the length of the change of its unit vector.
const TURN_STEP: f64 = 0.2;
/// Maximum first correction of a coupled group, as a fraction of the predicted move. With a larger
/// correction, the step could end on another assembly.
const MAX_RELATIVE_CORRECTION: f64 = 0.05;
/// Correction below which strain is ignored as rounding error, in units of about the longest link.
const STRAIN_FLOOR: f64 = 1e-9;
/// Maximum second-order part of a coupled group's move, as a fraction of the first-order part. At a
/// distance D from a dead point this fraction is h / 4 D for a step h, so that no step reaches
/// across it.
const BEND: f64 = 0.125;
/// Move below which the bend is ignored because the group is at rest, in units of about the longest
/// link.
const BEND_FLOOR: f64 = 1e-6;
/// Distance within which a coupled group may not turn sharply, in radians or scaled lengths.
///
/// Two solutions that cross miss each other by the rounding of the lengths, and the computed motion
/// turns from one to the other within the square root of that rounding. Such a corner is a change
/// point, and the motion must not follow it.
const CORNER: f64 = 1e-6;
/// Maximum part of a group's rates across the earlier ones, relative to their size, that is no
/// corner.
const SHARP: f64 = 0.3;
/// Condition of a coupled group, times its speed, below which the group is singular within rounding:
/// at a distance of about 1e-7 from a change point.
pub(super) const MAX_SINGULAR_CONDITION: f64 = 1e-7;
/// Condition of a coupled group at the start below which its rates are computed in double-double.
const MAX_REFINED_CONDITION: f64 = 1e-3;
/// Maximum shift of the unknowns at the start by double-double, in units of the smallest condition.
const MAX_SHIFT: f64 = 0.25;
/// Measure of a coupled group, relative to its maximum so far, below which its condition is computed.
const MAX_CHECKED_MEASURE: f64 = 1e-6;
/// Step of a linear driver, in the solver's unit length. The step of a turning driver is one
/// degree.
const PUSH_STEP: f64 = 1.0 / 128.0;
/// Maximum travel of a slide from the start, in units of the longest length.
pub(super) const MAX_SLIDE_TRAVEL: f64 = 64.0;
/// Maximum number of steps for one degree or one push: a hundred halvings and as many doublings.
const MAX_STEPS: usize = 400;
/// Maximum number of parts of a step with a fast input. Only a steep part of a table needs more, and
/// is halved further.
const MAX_PARTS: f64 = 1000.0;
/// Maximum ratio of an input's rate to that of the driver, in radians or scaled lengths: a degree of
/// the driver then has [`MAX_PARTS`].
pub(super) const MAX_RATIO: f64 = 11_000.0;
/// Maximum travel of an input in a step, relative to [`TURN_STEP`]: a part of a step is rounded.
const ROUNDED_PART: f64 = 1.001;
/// Maximum number of halvings between two doubles.
const MAX_HALVINGS: usize = 1100;
/// Number of turns after which tracking is cut if the motion has not closed.
pub(super) const MAX_TURNS: usize = 16;
/// Number of samples needed to detect a minimum of a measure.
pub(super) const SAMPLES: usize = 3;
/// Maximum distance between a limit and its exact coordinate, in radians or scaled lengths. An end
/// further away is another one.
const REFINED: f64 = 1e-9;
/// Parts of the distance to a limit, of which the first one that can be assembled is taken as the next
/// step towards it. A step may end exactly at a change point.
const PARTS: [f64; 3] = [0.5, 0.6, 0.7];
/// Fraction of the distance from the last sample to a limit within which samples are not kept.
const CLOSE_PART: f64 = 0.1;
/// Distance from a limit, in radians or scaled lengths, below which only the first of [`PARTS`] is
/// tried: there, the limit itself is lost in rounding.
const STEPPING: f64 = 1e-12;
/// Number of samples taken before a limit, each at a tenth of the distance of the last.
const HALF_WIDTH_COUNT: i32 = 12;
/// Number of steps after the start at which a motion is compared as well.
const LATER: usize = 3;
/// Maximum difference between z and its start in a closed motion.
pub(super) const CLOSURE_TOLERANCE: f64 = 1e-7;

/// A sample of the walk.
#[derive(Clone, Default)]
pub(super) struct WalkSample {
    /// The driver's coordinate.
    pub(super) at: f64,
    pub(super) measures: Vec<f64>,
    /// The stretching of every dyad, with its step.
    pub(super) stretchings: Vec<(usize, Option<Stretching>)>,
}

/// The end of a walk.
pub(super) enum WalkEnd {
    /// The motion has closed after this number of turns.
    Closed(usize),
    /// The motion ends at this limit.
    Limit(BoundedEnd),
    /// The motion was cut at this coordinate.
    Cut(f64),
}

impl WalkEnd {
    /// Returns the end of the range. The error is the number of turns after which the motion has
    /// closed.
    pub(super) fn end(self) -> Result<BoundedEnd, usize> {
        match self {
            WalkEnd::Closed(turns) => Err(turns),
            WalkEnd::Limit(end) => Ok(end),
            WalkEnd::Cut(at) => Ok(BoundedEnd::exact(at)),
        }
    }
}

/// Tracks the motion from its start in one direction.
pub(super) struct Walker<'e> {
    pub(super) engine: &'e Engine,
    pub(super) exact: Option<&'e Exact>,
    /// The mechanism with its typed decimals and a state, if double-double decides more than
    /// doubles.
    pub(super) double_double: Option<(&'e Exact, State<Double>)>,
    pub(super) state: Workspace,
    pub(super) anchors: Anchors,
    /// The last samples, at most [`SAMPLES`].
    pub(super) seen: Vec<WalkSample>,
    /// The maximum of every measure so far, at most 1. Small values are judged relative to it.
    pub(super) peaks: Vec<f64>,
    pub(super) start: f64,
    pub(super) sense: f64,
    pub(super) crossings: ChangePointCrossings,
    /// The extreme found last, at the next limit.
    pub(super) ahead: Option<ReachExtreme>,
    /// The last of two close change points that are passed one by one.
    pub(super) singly: Option<f64>,
    /// The step, group and coordinate of a dyad whose extreme at the next limit is lost in rounding.
    pub(super) unresolved: Option<(usize, usize, f64)>,
    /// The near miss of a coupled group at the next limit, across which a step jumped.
    pub(super) missed: Option<CloseMiss>,
    /// The step and coordinate of the extreme that could not be passed at the next limit.
    pub(super) refused: Option<(usize, Double)>,
    /// The coordinate of the last step that ended at a corner.
    pub(super) corner: Option<f64>,
    /// Whether the walk stopped at a corner.
    pub(super) is_at_corner: bool,
    /// The coordinate of a near miss whose bend doubles resolve.
    pub(super) resolved: Option<f64>,
    /// The groups whose assemblies are known to meet at the next limit.
    pub(super) unproved: Vec<GroupId>,
    /// The ends of the range at which groups are lined up.
    pub(super) meeting_assemblies: Vec<MeetingAssemblies>,
    /// The coordinates of all samples.
    pub(super) samples: Vec<f64>,
    pub(super) misses: Vec<NearMiss>,
    /// The largest residual of each watched constraint.
    pub(super) misfits: Vec<f64>,
    pub(super) folds: Vec<Folded>,
    pub(super) stretched: Vec<Stretched>,
    /// The number of series terms used at the last junction.
    pub(super) terms: usize,
    /// Memory for the last good state of a step.
    pub(super) spare: Option<Box<Workspace>>,
}

/// The reason why a step ends before its target.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stop {
    /// A barrier between `good`, the last coordinate reached, and `bad`, which was not reached.
    Barrier { good: f64, bad: f64 },
    /// A limit with a known coordinate.
    Limit(f64),
}

impl Walker<'_> {
    /// Tracks the motion to its end in the direction of `sense`.
    ///
    /// # Errors
    /// [`Fault::OverConstrained`] if a watched constraint stops holding.
    pub(super) fn walk(&mut self) -> Result<WalkEnd, Fault> {
        let kept = self.anchors.len();
        let end = self.walk_on();
        // The motion behind the start is tracked by the other walk, or at the end of the turn.
        self.anchors
            .remove_behind(self.engine, kept, (self.start, self.sense));
        end
    }

    /// Tracks the motion as [`Walker::walk`] does, and keeps anchors behind the start.
    fn walk_on(&mut self) -> Result<WalkEnd, Fault> {
        let (start, sense) = (self.start, self.sense);
        let step = if self.engine.is_rotary {
            1.0
        } else {
            PUSH_STEP * self.engine.frame.scale
        };
        let per_turn = if self.engine.is_rotary {
            360
        } else {
            usize::MAX
        };
        let maximum = if self.engine.is_rotary {
            360 * MAX_TURNS
        } else {
            (MAX_SLIDE_TRAVEL / PUSH_STEP) as usize
        };
        let opened = self.state.clone();
        if self.run(start, Order::Acceleration) != Condition::Ok {
            self.state.clone_from(&opened);
        }
        self.refine_start();
        self.sample_behind_start(step);
        let mut later = None;
        let (mut from, mut closed, mut k) = (start, None, 1);
        let mut passed = f64::NEG_INFINITY;
        while k <= maximum {
            let to = start + sense * step * k as f64;
            let stop = self.advance_by_table_ends(from, to);
            if let Err(stop) = stop {
                let limit = match stop {
                    Stop::Limit(limit) => self.before_limit(limit),
                    Stop::Barrier { good, bad } => {
                        let limit = self.bisect(good, bad);
                        self.approach(limit)
                    }
                };
                // Limits beyond a closed turn were found at its beginning.
                if let Some(turns) = closed.filter(|&t| self.ahead(limit) > angle_turn(t)) {
                    return Ok(self.closed(turns));
                }
                let is_here = |corner: f64| self.engine.difference(corner, limit).abs() < CORNER;
                self.is_at_corner = self.corner.take().is_some_and(is_here);
                self.check_fit_between(from, limit)?;
                let last = self.state.clone();
                // A change point already passed is not ahead: the continuation would be
                // undetermined.
                let beyond = match self.pass(limit).filter(|&at| self.ahead(at) > passed) {
                    Some(beyond) => beyond,
                    None => match self.pass_end((from, limit, passed), &last) {
                        Ok(beyond) => beyond,
                        Err(end) => return Ok(end),
                    },
                };
                // Nothing moves beyond a table, and doubles cannot solve it close to a change point.
                if self.engine.inwards(beyond) * sense < 0.0 {
                    return Ok(WalkEnd::Cut(beyond));
                }
                // The steps in between were computed on the wrong side.
                (from, closed, passed) = (beyond, None, self.ahead(beyond));
                let skipped = k..(self.ahead(beyond) / step) as usize + 1;
                k = skipped.end;
                // A turn may close between the change point and the end of its passage.
                let turns = (k - 1) / per_turn;
                if turns > 0 && skipped.contains(&(turns * per_turn)) {
                    let at = start + sense * step * (turns * per_turn) as f64;
                    closed = self.closes_at(at, turns, &opened).then_some(turns);
                }
                continue;
            }
            self.check_fit()?;
            // A turn ends one step after it has closed: only then is its last minimum detected.
            if let Some(turns) = closed {
                return Ok(WalkEnd::Closed(turns));
            }
            let turns = k / per_turn;
            if k % per_turn == 0 && self.has_closed(turns, &opened) {
                closed = Some(turns);
            }
            if k == LATER {
                later = Some(self.state.clone());
            } else if k % per_turn == LATER {
                // Close to a change point, the state at the start has too few digits.
                let has_closed = |first: &Workspace| self.has_closed(turns, first);
                if later.as_ref().is_some_and(has_closed) {
                    return Ok(self.closed(turns));
                }
            }
            (from, k) = (to, k + 1);
        }
        Ok(WalkEnd::Cut(from))
    }

    /// Crosses a limit that no series about itself crosses. Returns the coordinate reached.
    ///
    /// # Errors
    /// The end of the walk, if this is one.
    fn pass_end(
        &mut self,
        (from, limit, passed): (f64, f64, f64),
        last: &Workspace,
    ) -> Result<f64, WalkEnd> {
        if let Some(end) = self.end_behind_crossing(limit) {
            return Err(WalkEnd::Limit(end));
        }
        let stored = (self.folds.len(), self.stretched.len());
        let end = self.refined(limit, last);
        if end.bound.is_none() {
            let beyond = self.cross_by_continuation(limit);
            let beyond = beyond.or_else(|| self.resolves_bend(limit, last).then_some(limit));
            if let Some(beyond) = beyond.filter(|&at| self.ahead(at) > passed) {
                self.folds.truncate(stored.0);
                self.stretched.truncate(stored.1);
                return Ok(beyond);
            }
        }
        Err(self.ended((from, limit, passed), end, last))
    }

    /// Ends a walk at a limit behind the coordinate `from` that is not passed. `end` is its refined
    /// coordinate, `last` the last state before it, and `passed` the distance up to which change points are
    /// passed.
    fn ended(
        &mut self,
        (from, limit, passed): (f64, f64, f64),
        end: BoundedEnd,
        last: &Workspace,
    ) -> WalkEnd {
        if end.bound.is_none() {
            self.add_crossing_groups(limit, last);
        }
        let limit = self.last_resolved(from, limit);
        // Beyond a change point that is not passed, the motion may be another one.
        let beyond = self.sense * self.engine.difference(limit, end.at);
        let maximum = if self.unproved.is_empty() {
            REFINED
        } else {
            0.0
        };
        // A change point that is passed is no limit.
        let is_known = beyond <= maximum && self.ahead(end.at) >= passed;
        let limit = if is_known {
            end
        } else {
            BoundedEnd::unproved(self.before_refused(limit))
        };
        if limit.bound.is_none() {
            self.add_singular_groups(limit.at, last);
        }
        let groups = std::mem::take(&mut self.unproved).into_iter();
        self.meeting_assemblies
            .extend(groups.map(|group| MeetingAssemblies {
                group,
                at: limit.at,
            }));
        WalkEnd::Limit(limit)
    }

    /// Ends a walk that has closed, and removes what it found beyond.
    fn closed(&mut self, turns: usize) -> WalkEnd {
        let (start, sense, end) = (self.start, self.sense, angle_turn(turns));
        self.misses
            .retain(|miss| (miss.at - start) * sense < end + ONE_MISS);
        self.crossings.remove(|at| (at - start) * sense > end);
        WalkEnd::Closed(turns)
    }

    /// Computes the unknowns of the coupled groups at the start, and their rates, in double-double if a
    /// group is close to a change point. Doubles have no digits there from which a state could be
    /// predicted.
    fn refine_start(&mut self) {
        let Some(exact) = self.exact.filter(|_| self.has_path()) else {
            return;
        };
        let groups = &self.engine.program.coupled;
        let (q, _) = self.engine.coordinate(self.start);
        let Workspace { state, scratch, .. } = &mut self.state;
        let conditions = groups.iter().map(|group| {
            let condition = condition(group, q, state, scratch);
            condition.unwrap_or(0.0)
        });
        let smallest = conditions.fold(f64::INFINITY, f64::min);
        let mut twice = exact.twice(self.state.travels.len());
        let (steps, at) = (self.engine.program.steps.len(), Double::exactly(self.start));
        let is_close = smallest < MAX_REFINED_CONDITION;
        if !is_close || !exact.run_twice(steps, at, &self.state, &mut twice) {
            return;
        }
        let mut refined = self.state.scratch.clone();
        for (group, exact) in groups.iter().zip(&exact.engine.program.coupled) {
            let to = group.open(&mut refined);
            let from = exact.open(&mut twice.scratch);
            let mut shifts = to.z.iter().zip(&*from.z).map(|(z, exact)| z - exact.hi);
            // The other assembly is about as far away as the condition.
            if shifts.any(|shift| shift.abs() > MAX_SHIFT * smallest) {
                return;
            }
            let all = [
                (to.z, from.z),
                (to.first, from.first),
                (to.second, from.second),
            ];
            for (to, from) in all {
                to.iter_mut().zip(from).for_each(|(to, from)| *to = from.hi);
            }
        }
        self.state.scratch = refined;
    }

    /// Returns the last coordinate at which a dyad is clear of its limit, if rounding hides where
    /// that limit is. Otherwise returns `limit`.
    fn last_resolved(&mut self, from: f64, limit: f64) -> f64 {
        let unresolved = self.unresolved.take().filter(|&(.., at)| at == limit);
        let Some((step, group, _)) = unresolved else {
            return limit;
        };
        let (mut clear, mut stretched) = (from, limit);
        for _ in 0..MAX_HALVINGS {
            let middle = clear + 0.5 * (stretched - clear);
            if middle == clear || middle == stretched {
                break;
            }
            self.stretching(step, middle);
            if self.is_stretched(step, group, middle) {
                stretched = middle;
            } else {
                clear = middle;
            }
        }
        clear
    }

    /// Runs all steps. A mechanism of dyads alone that fails in doubles is run again in
    /// double-double if this decides more.
    pub(super) fn run(&mut self, at: f64, order: Order) -> Condition {
        let condition = if self.crossings.is_near(self.engine, at) {
            self.run_some(0..self.engine.program.steps.len(), at, order)
        } else {
            self.engine.run(at, order, &mut self.state)
        };
        match &mut self.double_double {
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
        if self.crossings.is_near(engine, at) {
            engine.run_near(steps, at, order, &self.crossings, &mut self.state)
        } else {
            engine.run_steps(steps, at, order, &mut self.state)
        }
    }

    /// Returns the maximum difference of lengths that count as equal, in the solver's unit.
    pub(super) fn slack(&self) -> f64 {
        self.exact.map_or(0.0, Exact::slack)
    }

    /// Returns the signed distance of a coordinate from the start, positive in the direction of
    /// motion.
    pub(super) fn ahead(&self, at: f64) -> f64 {
        (at - self.start) * self.sense
    }

    /// Predicts the state from the nearest of the latest anchors.
    pub(super) fn predict_nearest(&mut self, at: f64) {
        self.anchors
            .predict_from_latest(self.engine, at, &mut self.state);
    }

    /// Records a sample on the other side of the start, so that a minimum at the start is detected,
    /// and anchors there, from which a change point directly ahead is crossed.
    fn sample_behind_start(&mut self, step: f64) {
        let (at_start, kept) = (self.state.clone(), self.anchors.len());
        let (walked, missed) = (self.samples.len(), self.misses.len());
        let after = self.start - self.sense * step;
        self.seen.clear();
        // The motion behind the start is tracked later, and crosses a change point there only then.
        if self.advance(self.start, after).is_ok() {
            self.seen.drain(..self.seen.len().saturating_sub(1));
            self.anchors.reverse_from(self.engine, kept);
        } else {
            self.seen.clear();
            self.anchors.truncate(self.engine, kept);
        }
        self.state = at_start;
        self.samples.truncate(walked);
        self.misses.truncate(missed);
        self.note(self.start);
    }

    /// Stores the current state as a sample and as an anchor.
    pub(super) fn note(&mut self, at: f64) {
        self.engine.measure_coupled(at, &mut self.state);
        self.anchors.push(self.engine, at, &mut self.state);
        self.samples.push(at);
        let mut sample = WalkSample::default();
        if self.seen.len() == SAMPLES {
            // The memory of the oldest sample is used again.
            self.seen.rotate_left(1);
            sample = self.seen.pop().unwrap_or_default();
        }
        sample.at = at;
        sample.measures.clone_from(&self.state.measures);
        self.write_stretchings(at, &mut sample.stretchings);
        self.seen.push(sample);
        for (peak, measure) in self.peaks.iter_mut().zip(&self.state.measures) {
            *peak = peak.max(*measure).min(1.0);
        }
    }

    /// Writes the stretching of every dyad in the current state, with its step.
    fn write_stretchings(&self, at: f64, to: &mut Vec<(usize, Option<Stretching>)>) {
        let (q, _) = self.engine.coordinate(at);
        let steps = self.engine.program.steps.iter().enumerate();
        let dyads = steps.filter_map(|(i, step)| Some((i, step.dyad()?)));
        to.clear();
        to.extend(
            dyads.map(|(i, dyad)| (i, dyad.stretching(q, &self.engine.carriers, &self.state))),
        );
    }

    /// Returns `true` if every group is back at its start after some turns, at this coordinate of a
    /// passage through a change point. Keeps the state.
    fn closes_at(&mut self, at: f64, turns: usize, first: &Workspace) -> bool {
        let beyond = self.state.clone();
        self.predict_nearest(at);
        let closes =
            self.run(at, Order::Position) == Condition::Ok && self.has_closed(turns, first);
        self.state = beyond;
        closes
    }

    /// Returns `true` if every group is back at its first state after some turns.
    fn has_closed(&self, turns: usize, first: &Workspace) -> bool {
        let (now, then) = (&self.state.scratch.numbers, &first.scratch.numbers);
        self.engine.repeats_after(turns)
            && self.state.signs == first.signs
            && self.engine.program.coupled.iter().all(|group| {
                let z = group.offset..group.offset + group.width();
                let mut both = now[z.clone()].iter().zip(&then[z]);
                both.all(|(a, b)| (a - b).abs() < CLOSURE_TOLERANCE)
            })
    }

    /// Updates the largest residuals of the watched constraints and checks that these hold.
    ///
    /// # Errors
    /// [`Fault::OverConstrained`] if a watched constraint does not hold.
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

    /// Checks the watched constraints on the last part of a walk, even if shorter than a step. The
    /// check uses the middle because the rounding error at the limit exceeds the tolerance.
    fn check_fit_between(&mut self, from: f64, limit: f64) -> Result<(), Fault> {
        let last = self.state.clone();
        let middle = from + 0.5 * (limit - from);
        // Close to the limit, the derivatives in an anchor have lost their digits.
        let Walker { anchors, state, .. } = self;
        anchors.predict_from_before(self.engine, middle, self.sense, state);
        let exists = self.engine.run(middle, Order::Position, &mut self.state) == Condition::Ok;
        let fits = if exists { self.check_fit() } else { Ok(()) };
        self.state = last;
        fits
    }

    /// Advances as [`Walker::advance`] does, with an additional sample at each end of a table. An
    /// input is at rest there, and the motion just before cannot be detected from behind.
    fn advance_by_table_ends(&mut self, from: f64, to: f64) -> Result<(), Stop> {
        let mut from = from;
        while let Some(end) = self.engine.table_end(from, to) {
            self.advance(from, end)?;
            from = end;
        }
        self.advance(from, to)
    }

    /// Advances from `from`, the coordinate of the state, to `to` by as many steps as the motion
    /// needs. Records each as a sample. On an error, the state is the last good one.
    fn advance(&mut self, from: f64, to: f64) -> Result<(), Stop> {
        let spare = self.spare.take();
        let mut saved = spare.unwrap_or_else(|| Box::new(self.state.clone()));
        // A fast input could turn by whole turns in one step, which no direction shows.
        let travel = self.engine.largest_travel(from, to);
        let parts = (travel / TURN_STEP).ceil().clamp(1.0, MAX_PARTS);
        let place = |part: u32| match f64::from(part) {
            part if part == parts => to,
            part => from + (to - from) * (part / parts),
        };
        let end = (1..=parts as u32)
            .try_for_each(|part| self.advance_with(place(part - 1), place(part), &mut saved));
        self.spare = Some(saved);
        end
    }

    /// Advances as [`Walker::advance`] does; `saved` is the memory for the last good state.
    fn advance_with(&mut self, from: f64, to: f64, saved: &mut Workspace) -> Result<(), Stop> {
        let (mut good, mut bad, mut step) = (from, to, to - from);
        saved.clone_from(&self.state);
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
            if self.try_step(good, next, saved) && !self.is_singular(next) {
                self.note(next);
                if let Some(limit) = self.limit_passed() {
                    return Err(Stop::Limit(limit));
                }
                if next == to {
                    return Ok(());
                }
                saved.clone_from(&self.state);
                good = next;
                step *= 2.0;
                continue;
            }
            bad = next;
            let ends = !self.has_path() && self.fails_at(next);
            self.state.clone_from(saved);
            if ends {
                break;
            }
            step = 0.5 * (next - good);
        }
        Err(Stop::Barrier { good, bad })
    }

    /// Returns `true` if states depend on the path to them. A mechanism of dyads alone needs no
    /// path.
    pub(super) fn has_path(&self) -> bool {
        !self.engine.program.coupled.is_empty()
    }

    /// Returns `true` if a mechanism of dyads alone does not exist at a coordinate.
    fn fails_at(&mut self, at: f64) -> bool {
        self.run(at, Order::Position) != Condition::Ok
    }

    /// Tries one step and returns `true` if it is safe: it can be assembled, and the predicted
    /// moves, corrections and rotations are small enough. The state may change even if the step
    /// fails.
    pub(super) fn try_step(&mut self, from: f64, to: f64, before: &State) -> bool {
        self.try_part(self.engine.program.steps.len(), (from, to), before)
    }

    /// Returns `true` if a coupled group is at a change point within rounding: its rates have no
    /// digits, and no state could be predicted from them. At a fold, the rates grow with the inverse
    /// of the condition.
    fn is_singular(&mut self, at: f64) -> bool {
        self.engine.measure_coupled(at, &mut self.state);
        let (q, _) = self.engine.coordinate(at);
        let Workspace { state, scratch, .. } = &mut self.state;
        self.engine.program.coupled.iter().any(|c| {
            let is_small =
                state.measures[c.group].abs() < MAX_CHECKED_MEASURE * self.peaks[c.group];
            is_small && {
                let rates = &*c.open(scratch).first;
                let speed: f64 = rates.iter().map(|rate| rate * rate).sum::<f64>().sqrt();
                let condition = condition(c, q, state, scratch);
                condition.is_none_or(|condition| condition * (1.0 + speed) < MAX_SINGULAR_CONDITION)
            }
        })
    }

    /// Tries one step as [`Walker::try_step`] does, but runs and checks only the first `count` steps
    /// of the plan.
    pub(super) fn try_part(
        &mut self,
        count: usize,
        (from, to): (f64, f64),
        before: &State,
    ) -> bool {
        if self.engine.largest_travel(from, to) > TURN_STEP * ROUNDED_PART {
            return false;
        }
        let dq = self.engine.difference(from, to);
        let mut is_bent = false;
        for (index, group) in self.engine.program.coupled.iter().enumerate() {
            let mut buffers = group.open(&mut self.state.scratch);
            let [first, second] = group.move_sizes(&buffers, dq);
            is_bent |= second > BEND * first + BEND_FLOOR;
            group.predict(&mut buffers, dq);
            self.state.scratch.max_first[index] = MAX_RELATIVE_CORRECTION * first + STRAIN_FLOOR;
        }
        let is_reached = !is_bent && self.run_within(count, to);
        self.state.scratch.max_first.fill(f64::INFINITY);
        let mut turns = self.state.links.iter().zip(&before.links);
        let is_smooth =
            is_reached && turns.all(|(now, then)| (now.d - then.d).norm2() < TURN_STEP * TURN_STEP);
        is_smooth && !self.has_corner(to)
    }

    /// Runs the first `count` steps of the plan. Returns `true` if they can be assembled and the first
    /// correction of each coupled group is small enough.
    fn run_within(&mut self, count: usize, to: f64) -> bool {
        let condition = if count == self.engine.program.steps.len() {
            self.run(to, Order::Acceleration)
        } else {
            self.run_some(0..count, to, Order::Acceleration)
        };
        let scratch = &self.state.scratch;
        let mut corrections = scratch.first.iter().zip(&scratch.max_first);
        condition == Condition::Ok && !corrections.any(|(first, maximum)| first > maximum)
    }

    /// Returns `true` if a coupled group that is almost singular turns sharply just before the coordinate of
    /// the state. A regular group follows its inputs, which turn before a fold.
    fn has_corner(&mut self, at: f64) -> bool {
        if self.is_resolved(at) {
            return false;
        }
        let engine = self.engine;
        let mut sharp = Vec::new();
        for anchor in self.anchors.within(engine, at, CORNER) {
            let rates = self.anchors.rates(engine, anchor);
            for (group, then) in engine.program.coupled.iter().zip(rates) {
                let now = &*group.open(&mut self.state.scratch).first;
                if turns_sharply(then, now) {
                    sharp.push(group.group);
                }
            }
        }
        if sharp.is_empty() {
            return false;
        }
        engine.measure_coupled(at, &mut self.state);
        let measure = |group: usize| self.state.measures[group].abs();
        let is_corner = sharp
            .into_iter()
            .any(|group| measure(group) < MAX_CHECKED_MEASURE * self.peaks[group]);
        if is_corner {
            self.corner = Some(at);
        }
        is_corner
    }

    /// Returns a limit, or its neighbour if a change point that was not passed lies between: directly
    /// before a fold, even this distance is much on the other side.
    fn before_refused(&self, limit: f64) -> f64 {
        let is_beyond = |(_, at): (usize, Double)| {
            let by = (Double::exactly(limit) - at).hi * self.sense;
            by > 0.0 && at.nearest() == limit
        };
        match self.refused.filter(|&refused| is_beyond(refused)) {
            Some(_) if self.sense > 0.0 => limit.next_down(),
            Some(_) => limit.next_up(),
            None => limit,
        }
    }

    /// Narrows a barrier down to neighbouring doubles and returns the last coordinate that exists,
    /// the dead point itself included. The state must be the one at `good`.
    fn bisect(&mut self, mut good: f64, mut bad: f64) -> f64 {
        // A step may have reached the dead point itself, which belongs to the range.
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

    /// Approaches a limit from the last sample, about halving the distance each time, in steps over which
    /// no link turns too far. Returns the first limit or barrier before it, otherwise `limit`. If states
    /// depend on the path, bisection did this already.
    fn approach(&mut self, limit: f64) -> f64 {
        if self.has_path() {
            return limit;
        }
        let (mut limit, walked) = (limit, self.samples.len());
        let Some(mut from) = self.seen.last().map(|sample| sample.at) else {
            return limit;
        };
        let mut at_end = self.state.clone();
        let nearest = CLOSE_PART * (limit - from).abs();
        loop {
            let is_far = self.engine.difference(from, limit).abs() > STEPPING;
            let parts = if is_far { &PARTS[..] } else { &PARTS[..1] };
            let tried = parts.iter().map(|part| from + part * (limit - from));
            let next = tried.into_iter().find(|&next| {
                let is_between = next != from && next != limit;
                is_between && self.run(next, Order::Acceleration) == Condition::Ok
            });
            let Some(next) = next else {
                break;
            };
            if self.run(from, Order::Acceleration) == Condition::NoAssembly {
                break;
            }
            match self.advance(from, next) {
                Ok(()) => from = next,
                Err(Stop::Limit(earlier)) => {
                    limit = self.before_limit(earlier);
                    break;
                }
                Err(Stop::Barrier { good, bad }) => {
                    limit = self.bisect(good, bad);
                    at_end.clone_from(&self.state);
                    from = good;
                }
            }
        }
        // The samples close to the limit and beyond it only served this search.
        let is_kept = |at: &f64| (limit - at) * self.sense > nearest;
        let kept = self.samples[walked..].iter().take_while(|at| is_kept(at));
        let kept = walked + kept.count();
        self.samples.truncate(kept);
        self.state = at_end;
        limit
    }

    /// Returns the first limit at or before a limit found between the last two samples.
    ///
    /// The last sample lies beyond the limit. Dyads behind the one that reaches it were placed on
    /// the wrong side there, and their own extremes before the limit may be hidden.
    fn before_limit(&mut self, limit: f64) -> f64 {
        let mut limit = limit;
        while let Some(earlier) = self.earlier_limit(limit) {
            limit = earlier;
        }
        limit
    }

    /// Returns a limit between the last sample but one and a limit, if there is one.
    fn earlier_limit(&mut self, limit: f64) -> Option<f64> {
        if self.has_path() {
            return None;
        }
        let (at_end, walked) = (self.state.clone(), self.samples.len());
        let (ahead, unresolved) = (self.ahead.take(), self.unresolved.take());
        self.seen.pop();
        let from = self.seen.last()?.at;
        let mut found = None;
        for k in 1..=HALF_WIDTH_COUNT {
            let next = limit - (limit - from) * 0.1_f64.powi(k);
            if self.run(next, Order::Acceleration) != Condition::Ok {
                break;
            }
            self.note(next);
            found = self
                .limit_passed()
                .filter(|&at| self.ahead(at) < self.ahead(limit));
            if found.is_some() {
                break;
            }
        }
        self.samples.truncate(walked);
        self.state = at_end;
        if found.is_none() {
            (self.ahead, self.unresolved) = (ahead, unresolved);
        }
        found
    }

    /// Moves to a coordinate, with intermediate steps only if states depend on the path.
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

/// Returns `true` if a part of `now` larger than [`SHARP`] lies across `then`, or if it points back.
fn turns_sharply(then: &[f64], now: &[f64]) -> bool {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (along, before, size) = (dot(then, now), dot(then, then), dot(now, now));
    along < 0.0 || size * before - along * along > SHARP * SHARP * size * before
}
