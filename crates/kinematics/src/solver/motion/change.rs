//! Crosses the change points of dyads: finds the first dyad at an extreme of its reach, its exact
//! coordinate, and the motion beyond it with all groups that are singular there.

use super::CHANGE_POINT_DISTANCE;
use super::crossing::CloseMiss;
use super::junction::{DyadSingularity, Junction, PairFound};
use super::tracking::Walker;
use crate::Double;
use crate::numeric::root;
use crate::solver::Order;
use crate::solver::elements::{Dyad, REACH_SLACK, StepOutcome, Stretching};
use crate::solver::plan::GroupId;
use crate::solver::state::Condition;

/// Maximum measure of a gap no larger than a rounding error: the square of the rounding.
const GAP: f64 = 1e-28;
/// Half the width of the single step across a change point, in radians or scaled lengths. The dyad
/// has enough digits at this distance on both sides.
const PASSING: f64 = 1e-3;
/// Ratio between successive half widths, for links that rotate too fast for the widest step. An
/// almost square antiparallelogram turns its follower hundreds of times as fast as its crank, and
/// several of them in series turn it many times more.
const HALF_WIDTH_RATIO: f64 = 0.1;
/// Number of half widths. At the smallest one, only the series can locate the points and links.
const HALF_WIDTH_COUNT: i32 = 11;
/// Further half widths, for several coupled groups that are singular together. Each multiplies the
/// rounding error of those before it by the inverse of the distance.
pub(super) const FURTHER: [f64; 2] = [3e-3, 1e-2];
/// Distance before a change point, in radians or scaled lengths, within which a minimum of a group that
/// changes there with or behind a coupled group is that change point.
const ONE_CHANGE_POINT: f64 = 3e-3;
/// Distance beyond a change point at which the redundant constraints are checked with the other
/// assembly.
const CHECK_DISTANCE: f64 = 1e-4;
/// Minimum residual at [`CHECK_DISTANCE`] that is not a rounding error.
const MIN_MISS: f64 = 1e-9;
/// Distances from a limit, in radians or scaled lengths, within which an extreme of a dyad's
/// stretch is searched, from the first to the widest. An extreme further away does not belong to
/// the limit.
const EXTREMES: [f64; 4] = [1e-12, 1e-9, 1e-6, 1e-3];
/// Measure below which a dyad is in line at a limit, within its rounding.
const IN_LINE: f64 = 1e-13;
/// Maximum measure, at a limit, of a dyad that ends the motion or has a change point there.
const LARGE: f64 = 1e-3;

/// Minimum distance of two close change points that can be passed one by one.
const APART: f64 = 1e-4;
/// Maximum difference between a change point of a pair and its coordinate as a single one.
const EQUALITY_TOLERANCE: f64 = 1e-12;
/// Half width of the step across two close change points, in units of their distance from the
/// middle.
const ACROSS: f64 = 3.0;
/// Ratio between successive distances at which a coupled group's equations are solved outside the
/// zone of its series, beginning at the zone.
const OUTSIDE: f64 = 1.2;
/// Maximum number of such distances: the last one is 38 times as far as the zone.
const OUTSIDES: i32 = 20;

/// The next position at which a dyad reaches an extreme of its stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct ReachExtreme {
    pub(super) step: usize,
    pub(super) at: Double,
    /// The first change point on the way, if there are two close to each other about `at`.
    pub(super) first: Option<f64>,
    /// The last change point, if both can be passed one by one.
    pub(super) last: Option<f64>,
}

impl ReachExtreme {
    pub(super) fn single(step: usize, at: Double) -> ReachExtreme {
        let (first, last) = (None, None);
        ReachExtreme {
            step,
            at,
            first,
            last,
        }
    }

    /// Returns the limit at which the walk stops.
    pub(super) fn limit(&self) -> f64 {
        self.first.unwrap_or(self.at.hi)
    }
}

impl From<PairFound> for ReachExtreme {
    fn from(found: PairFound) -> ReachExtreme {
        let PairFound {
            step,
            centre: at,
            first,
            last,
            spread,
        } = found;
        ReachExtreme {
            step,
            at,
            first: Some(first),
            last: (spread > APART).then_some(last),
        }
    }
}

/// A crossing of two solutions of a coupled group.
#[derive(Clone, Debug)]
pub(super) struct Change {
    pub(super) step: usize,
    /// The driver's coordinate.
    pub(super) at: Double,
    /// The unknowns z at the crossing.
    pub(super) z: Vec<Double>,
    /// The rates of z with which the motion arrives.
    pub(super) rate: Vec<f64>,
}

/// Returns the half widths of the step across a change point, in decreasing order.
pub(super) fn approaches() -> impl Iterator<Item = f64> {
    (0..HALF_WIDTH_COUNT).map(|k| PASSING * HALF_WIDTH_RATIO.powi(k))
}

impl Walker<'_> {
    /// Crosses a limit if it is a change point or a near miss. Returns the coordinate reached beyond it.
    pub(super) fn pass(&mut self, limit: f64) -> Option<f64> {
        self.anchors.forget_beyond(self.engine, limit, self.sense);
        self.unproved.clear();
        self.refused = None;
        self.missed = self.missed.take().filter(|missed| missed.at == limit);
        let kept = self.missed.and_then(|missed| self.keep_assembly(&missed));
        kept.or_else(|| self.pass_change_point(limit)).or_else(|| {
            self.has_path()
                .then(|| self.cross_by_continuation(limit))
                .flatten()
        })
    }

    /// Crosses a limit if it is a change point. Returns the coordinate reached beyond it.
    fn pass_change_point(&mut self, limit: f64) -> Option<f64> {
        if self.has_path()
            && let Some(beyond) = self.cross_twice(limit)
        {
            return Some(beyond);
        }
        if let Some(extreme) = self.ahead.take().filter(|e| e.limit() == limit) {
            let passed = self
                .pass_extreme(&extreme)
                .or_else(|| self.pass_singly(&extreme));
            return passed.or_else(|| self.has_path().then(|| self.cross(limit)).flatten());
        }
        let flat = self.flat(limit);
        let is_hidden = self.may_hide(&flat);
        // The search up to the last of them covers all.
        let last = flat.last();
        let pair = last.and_then(|&step| self.pair_near(step, limit));
        let pair = pair.filter(|pair| !self.is_passed(pair));
        let beyond = pair.and_then(|pair| self.pass_extreme(&pair.into()));
        if beyond.is_some() {
            return beyond;
        }
        // Only dyads of the plan's first group are certain: later ones depend on its side.
        let mut is_stretched = false;
        let passed = flat.iter().find_map(|&step| {
            let at = self.extreme(step, limit)?;
            is_stretched = true;
            let at = self.exactly(step, at)?;
            self.pass_extreme(&ReachExtreme::single(step, at))
        });
        if !is_stretched {
            let hidden = is_hidden.then(|| self.pass_hidden(&flat, limit)).flatten();
            return hidden.or_else(|| self.cross(limit));
        }
        // A coupled group may cross first, and with it a dyad behind it.
        passed.or_else(|| self.has_path().then(|| self.cross(limit)).flatten())
    }

    /// Returns `true` if a limit may be a change point of dyads directly before the end of the motion,
    /// not that end. Then the first dyad, which ends the motion, is not yet in line. The state must be
    /// that of [`Walker::flat`].
    fn may_hide(&self, flat: &[usize]) -> bool {
        let first = flat.first().and_then(|&step| self.engine.group_of(step));
        let is_before = |group: usize| self.state.measures[group] > IN_LINE;
        flat.len() > 1 && first.is_some_and(is_before) || self.has_path() && !flat.is_empty()
    }

    /// Crosses a change point that doubles do not locate, because a group before the dyad that reaches
    /// it ends the motion directly behind it. Returns the coordinate reached.
    fn pass_hidden(&mut self, flat: &[usize], limit: f64) -> Option<f64> {
        // The first dyad is that group, unless a coupled one is.
        let behind = flat.iter().skip(usize::from(!self.has_path()));
        behind.copied().find_map(|step| {
            let at = self.exactly_near(step, limit)?;
            self.pass_extreme(&ReachExtreme::single(step, at))
        })
    }

    /// Steps past a near miss of a coupled group, which keeps its assembly. Returns the coordinate
    /// reached.
    fn keep_assembly(&mut self, miss: &CloseMiss) -> Option<f64> {
        let saved = (self.state.clone(), self.anchors.clone());
        let Some(beyond) = self.step_past(miss) else {
            (self.state, self.anchors) = saved;
            return None;
        };
        self.note_miss(miss.group, miss.sine, miss.at);
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// Crosses the first of two close change points. Returns the coordinate reached.
    fn pass_singly(&mut self, extreme: &ReachExtreme) -> Option<f64> {
        let (first, last) = extreme.first.zip(extreme.last)?;
        self.singly = Some(last);
        let at = self.exactly(extreme.step, first)?;
        let is_first = self.engine.difference(first, at.hi).abs() <= EQUALITY_TOLERANCE;
        is_first.then_some(())?;
        self.pass_extreme(&ReachExtreme {
            at,
            first: None,
            last: None,
            ..*extreme
        })
    }

    /// Crosses a position at which a dyad's reach is extreme. Returns the coordinate reached.
    fn pass_extreme(&mut self, extreme: &ReachExtreme) -> Option<f64> {
        let &ReachExtreme {
            step, at, first, ..
        } = extreme;
        let junction = self.junction(at, &[]);
        let beyond = junction.and_then(|junction| self.pass_junction(&junction));
        let beyond = beyond.or_else(|| {
            // A series about two close change points may not reach beyond both.
            first.is_none().then_some(())?;
            self.singly = Some(at.hi);
            let junction = self.junction(at, &[])?;
            self.pass_junction(&junction)
        });
        let is_earlier = |&(_, other): &(usize, Double)| self.ahead(other.hi) <= self.ahead(at.hi);
        if beyond.is_none() && first.is_none() && !self.refused.as_ref().is_some_and(is_earlier) {
            self.refused = Some((step, at));
        }
        let mut is_singular = || {
            matches!(
                self.singularity_at(step, at),
                Some(DyadSingularity::Singular { .. })
            )
        };
        if beyond.is_none() && (first.is_some() || is_singular()) {
            let group = self.engine.group_of(step);
            self.unproved.extend(group.map(GroupId::new));
        }
        beyond
    }

    /// Crosses a junction, or steps over it if it is only a near miss.
    fn pass_junction(&mut self, junction: &Junction) -> Option<f64> {
        if junction.is_miss() {
            self.step_over(junction)
        } else {
            self.pass_through(junction)
        }
    }

    /// Steps over a near miss; the groups keep their sides. Returns the coordinate reached.
    fn step_over(&mut self, junction: &Junction) -> Option<f64> {
        let beyond = approaches().find_map(|by| self.step_across(junction, by))?;
        for missed in &junction.missed {
            self.note_miss(missed.group, missed.sine, junction.at.hi);
        }
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// Crosses a junction in a single step of the largest possible width. Returns the coordinate
    /// reached, or `None` if no width can be proved.
    pub(super) fn pass_through(&mut self, junction: &Junction) -> Option<f64> {
        self.pass_in_zone(junction, 0.0)
    }

    /// Crosses a junction as [`Walker::pass_through`] does, if the zones of its series are at least as
    /// wide as `minimum`.
    pub(super) fn pass_in_zone(&mut self, junction: &Junction, minimum: f64) -> Option<f64> {
        let crossings = self.passages(junction)?;
        if crossings.iter().any(|crossing| crossing.zone < minimum) {
            return None;
        }
        let known = self.crossings.len();
        let signs = self.state.signs.clone();
        let buffers = self.change_point_distance(junction);
        self.crossings.add(crossings);
        let spread = ACROSS * junction.spread();
        let mut closer = junction
            .widths()
            .chain(approaches())
            .chain((spread > 0.0).then_some(spread))
            .chain(FURTHER)
            .filter(|&by| spread <= by && by < buffers);
        let passed = closer.find_map(|by| Some((by, self.pass_at(junction, by)?)));
        let Some((by, beyond)) = passed else {
            self.crossings.truncate(known);
            return None;
        };
        if !self.joins_equations(junction, known, beyond) {
            self.crossings.truncate(known);
            return None;
        }
        let places: Vec<(usize, f64)> = self
            .crossings
            .latest(known)
            .iter()
            .map(|p| (p.group, p.at))
            .collect();
        let guided: Vec<bool> = places
            .iter()
            .map(|&(group, at)| {
                // After both change points of a pair, the group has the sign that it had before the first.
                let is_first = places
                    .iter()
                    .any(|&(other, place)| other == group && (place - at) * self.sense > 0.0);
                let outwards = if is_first { -self.sense } else { self.sense };
                self.is_led_through(group, at, outwards)
            })
            .collect();
        for (crossing, is_led) in self.crossings.latest(known).iter_mut().zip(guided) {
            crossing.is_led_through |= is_led;
        }
        self.forget_misses(junction);
        for missed in &junction.missed {
            self.note_miss(missed.group, missed.sine, junction.at.hi);
        }
        if self.has_path() {
            let reached = self.state.clone();
            self.state.state.signs = signs;
            let before = self.engine.moved(junction.at.hi, -self.sense * by);
            self.store_approach(junction.at.hi, before);
            self.state = reached;
        }
        self.seen.clear();
        self.note(beyond);
        Some(beyond)
    }

    /// Removes the near misses directly before a junction that was passed, and those beyond it. A group
    /// has lost digits there, or was on the wrong side at the last samples.
    fn forget_misses(&mut self, junction: &Junction) {
        let (engine, sense) = (self.engine, self.sense);
        let is_coupled = |group: &usize| {
            let mut coupled = engine.program.coupled.iter();
            coupled.any(|c| c.group == *group)
        };
        let groups: Vec<usize> = junction.groups().collect();
        let first = groups.iter().copied().find(is_coupled);
        self.misses.retain(|miss| {
            let group = miss.group.index();
            let has_lost_digits = first.is_some_and(|first| first <= group);
            let distance = match (groups.contains(&group), has_lost_digits) {
                (false, false) => return true,
                (true, true) => ONE_CHANGE_POINT,
                _ => CHANGE_POINT_DISTANCE,
            };
            let before = engine.moved(junction.at.hi, -sense * distance);
            (miss.at - before) * sense <= 0.0
        });
    }

    /// Returns `true` if the equations of the coupled groups hold directly outside the zones of the
    /// single crossings from index `known` on, up to `beyond`. Directly before a fold, doubles may not
    /// solve them there.
    fn joins_equations(&mut self, junction: &Junction, known: usize, beyond: f64) -> bool {
        let (engine, sense) = (self.engine, self.sense);
        let mut places: Vec<(usize, f64, bool)> = Vec::new();
        for (step, of) in engine.program.steps.iter().enumerate() {
            if of.coupled().is_none() {
                continue;
            }
            let latest = self.crossings.latest(known).iter();
            let ours = latest.filter(|c| engine.group_of(step) == Some(c.group));
            for crossing in ours.filter(|c| c.off_centre == 0.0) {
                let end = engine.difference(crossing.at, beyond).abs();
                let outside = (1..=OUTSIDES).map(|k| crossing.zone * OUTSIDE.powi(k));
                let outside = outside.take_while(|&by| by < end);
                places.extend(outside.flat_map(|by| [-by, by]).map(|by| {
                    let is_before = by * sense < 0.0;
                    let at = engine.moved(crossing.at, by);
                    (step, at, is_before)
                }));
            }
        }
        if places.is_empty() {
            return true;
        }
        let saved = self.state.clone();
        let joined = places.into_iter().all(|(step, at, is_before)| {
            self.state.clone_from(&saved);
            if is_before {
                junction.turning().for_each(|step| self.flip(step));
            }
            self.predict_nearest(at);
            self.run_some(0..step + 1, at, Order::Position) == Condition::Ok
        });
        self.state = saved;
        joined
    }

    /// Returns the distance to the nearest change point that one of the singular groups has already
    /// passed.
    fn change_point_distance(&self, junction: &Junction) -> f64 {
        let groups = junction.groups();
        let away =
            groups.filter_map(|group| self.crossings.distance(self.engine, group, junction.at.hi));
        away.fold(f64::INFINITY, f64::min)
    }

    /// Crosses a junction in one step of half width `by`, if the series are proved at both ends.
    /// Returns the coordinate reached.
    fn pass_at(&mut self, junction: &Junction, by: f64) -> Option<f64> {
        let signs = self.state.signs.clone();
        let beyond = self.step_across(junction, by)?;
        let reached = self.state.clone();
        let proved = self.proves(junction, by, self.engine.program.steps.len());
        self.state = reached;
        if !proved {
            self.state.state.signs = signs;
        }
        proved.then_some(beyond)
    }

    /// Steps from a distance `by` before a junction to the same distance beyond it. The singular
    /// groups that turn get the other sign. Returns the coordinate reached.
    fn step_across(&mut self, junction: &Junction, by: f64) -> Option<f64> {
        let engine = self.engine;
        let at = junction.at.hi;
        let before = engine.moved(at, -self.sense * by);
        let beyond = match self.sense * junction.side {
            // The motion leaves a table: nothing moves beyond its end.
            side if side < 0.0 => at,
            0.0 => engine.moved(at, self.sense * by),
            _ => return None,
        };
        if !self.step_to(before) {
            return None;
        }
        let saved = self.state.clone();
        for step in junction.turning() {
            self.flip(step);
        }
        let is_across = match junction.coupled_pair() {
            Some(pair) => self.step_by_series(junction, (pair, by), beyond),
            None => self.try_step(before, beyond, &saved),
        };
        if is_across {
            return Some(beyond);
        }
        // The motion may come to rest exactly at a change point.
        let steps = 0..engine.program.steps.len();
        if junction.side != 0.0
            && self.run_some(steps, beyond, Order::Acceleration) == Condition::ChangePoint
        {
            return Some(beyond);
        }
        self.state = saved;
        None
    }

    /// Returns `true` if a redundant constraint fails for the other assembly of a group directly
    /// beside its change point, on the side `outwards`. Then the constraint leads the group through, and
    /// the whole mechanism is not singular there. The group must have the same sign on this side as in the
    /// state, which is the one beyond.
    fn is_led_through(&mut self, group: usize, at: f64, outwards: f64) -> bool {
        let engine = self.engine;
        if engine.program.watches.is_empty() || !engine.program.coupled.is_empty() {
            return false;
        }
        let saved = self.state.clone();
        let sign = &mut self.state.state.signs[group];
        *sign = -*sign;
        let mut other = |by: f64| {
            let nearby = engine.moved(at, outwards * by);
            let exists = engine.run(nearby, Order::Position, &mut self.state) == Condition::Ok;
            let misses = engine.misses(&self.state).map(|(_, miss, _)| miss.abs());
            exists.then(|| misses.fold(0.0, f64::max))
        };
        let misses = (other(CHECK_DISTANCE), other(2.0 * CHECK_DISTANCE));
        self.state = saved;
        // The residual must be proportional to the distance; if it grows with its square, the
        // constraint is singular as well.
        matches!(misses, (Some(near), Some(far)) if near > MIN_MISS && far < 3.0 * near)
    }

    /// Changes the sign of a step's group.
    pub(super) fn flip(&mut self, step: usize) {
        if let Some(group) = self.engine.group_of(step) {
            let sign = &mut self.state.state.signs[group];
            *sign = -*sign;
        }
    }

    /// Returns the steps of all dyads almost in line at a limit, up to the first open one.
    pub(super) fn flat(&mut self, limit: f64) -> Vec<usize> {
        let engine = self.engine;
        let mut flat = Vec::new();
        self.predict_nearest(limit);
        for (step, of) in engine.program.steps.iter().enumerate() {
            let condition = self.run_some(step..step + 1, limit, Order::Position);
            let is_flat = |group: usize| self.state.measures[group].abs() < LARGE;
            flat.extend(of.choice().filter(|&group| is_flat(group)).map(|_| step));
            if condition == Condition::NoAssembly {
                break;
            }
        }
        flat
    }

    /// Returns the coordinate close to a limit where a dyad's stretch is extreme, if its arms are
    /// in line there.
    fn extreme(&mut self, step: usize, limit: f64) -> Option<f64> {
        let group = self.engine.program.steps[step].choice()?;
        let at = EXTREMES.into_iter().find_map(|by| {
            let a = self.engine.moved(limit, -by);
            let b = self.engine.moved(limit, by);
            let rates = (self.stretch_rate(step, a)?, self.stretch_rate(step, b)?);
            self.extreme_stretch(step, (a, rates.0), (b, rates.1))
        })?;
        self.stretch_rate(step, at)?;
        // Inputs with rounding errors may open it. Double-double decides.
        let is_in_line = self.state.measures[group].abs() < IN_LINE;
        (is_in_line || self.is_stretched(step, group, at)).then_some(at)
    }

    /// Returns the coordinate where a dyad's stretch is extreme, between two coordinates at which
    /// its rates have different signs. Each pair holds a coordinate and a rate.
    pub(super) fn extreme_stretch(
        &mut self,
        step: usize,
        a: (f64, f64),
        b: (f64, f64),
    ) -> Option<f64> {
        let finest = self.engine.finest();
        let at = root(a, b, finest, |at| self.stretch_rate(step, at));
        at.ok()
    }

    /// Returns `true` if a dyad's arms may be in line, within the rounding of the given lengths and
    /// coordinates. Later steps decide whether they are. The state must be that of the dyad's
    /// inputs.
    pub(super) fn is_stretched(&mut self, step: usize, group: usize, at: f64) -> bool {
        let engine = self.engine;
        let step = &engine.program.steps[step];
        let placed = engine.place_dyad(step, at, &mut self.state.state);
        // Equal arms with coinciding pivots have no direction, but no gap either.
        let has_no_gap = self.state.measures[group].abs() <= GAP;
        let (q, _) = engine.coordinate(at);
        let slack = (REACH_SLACK * engine.frame.far).max(2.0 * self.slack());
        let is_rounding = |dyad: Dyad<'_>| dyad.reserve(q, &self.state).abs() <= slack;
        let is_rounding = step.dyad().is_some_and(is_rounding);
        placed == StepOutcome::Stretched || has_no_gap || is_rounding
    }

    /// Returns a dyad's rate of stretch, or 0 if nothing moves. Returns `None` if its inputs cannot
    /// be assembled.
    pub(super) fn stretch_rate(&mut self, step: usize, at: f64) -> Option<f64> {
        Some(self.stretching(step, at)?.rate().unwrap_or(0.0))
    }

    /// Returns a dyad's stretching, computed from its inputs. The dyad itself may be open.
    pub(super) fn stretching(&mut self, step: usize, at: f64) -> Option<Stretching> {
        self.predict_nearest(at);
        let engine = self.engine;
        if self.run_some(0..step, at, Order::Acceleration) == Condition::NoAssembly {
            return None;
        }
        let (q, _) = engine.coordinate(at);
        engine.place_dyad(&engine.program.steps[step], at, &mut self.state.state);
        engine.program.steps[step]
            .dyad()?
            .stretching(q, &engine.carriers, &self.state)
    }
}
