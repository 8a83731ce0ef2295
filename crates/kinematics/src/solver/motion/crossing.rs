//! Crosses the change points of coupled groups: finds where two solutions cross, its exact
//! coordinate, and the motion beyond it.

use super::anchors::Anchors;
use super::change::{Change, FURTHER, approaches};
use super::group_inputs::GroupInputs;
use super::junction::{CHANGE_POINT_TOLERANCE, MORE};
use super::tracking::Walker;
use crate::Double;
use crate::solver::Order;
use crate::solver::coupled::{Correction, Crossing};
use crate::solver::elements::REACH_SLACK;
use crate::solver::plan::GroupId;
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;

/// Maximum number of Newton steps to a crossing, from a start with half of the digits.
const STEPS: usize = 20;
/// Ratio of a Newton step to the previous one above which the method diverges, if the step is also
/// larger than the longest link or a radian, and far away. Directly beside a near miss, steps grow and
/// shrink without leaving it.
const MAX_GROWTH: f64 = 2.0;
/// Distance from a limit, in radians or scaled lengths, from which a growing Newton step does not return.
const FAR: f64 = 0.01;
/// Number of series tried at a crossing, each with more terms than the last.
const SERIES: usize = 3;
/// Minimum zone of a series with more terms, in radians or scaled lengths. A smaller one lies directly
/// before a fold, where doubles do not solve the equations outside the zone.
const MIN_ZONE: f64 = 1e-7;
/// Number of half widths tried for the step across, each a tenth of the last.
const WAYS: usize = 7;
/// Maximum number of steps from an anchor to a coordinate before a crossing. A fold may be close
/// behind the crossing.
const STEPS_BEFORE: usize = 200;
/// Size of a correction at its rounding error, which ends the iteration, in units of about the
/// longest link.
const MAX_LAST_CORRECTION: f64 = 1e-13;
/// Maximum opening of the equations at which the branches count as crossing in doubles, in units of
/// about the longest link. It covers the rounding of lengths; that of given coordinates is added to
/// it. A larger opening is a near miss.
const OPENED: f64 = 1e-13;
/// Number of corrections in double-double. The second one has all digits, unless another kind of
/// singularity is close.
const CORRECTIONS: usize = 5;
/// Maximum number of halvings of the distance to a near miss.
const HALVINGS: i32 = 40;
/// Distance from a near miss at which halving ends, in units of its width.
const CLOSEST: f64 = 0.1;
/// Width of a near miss, in radians or scaled lengths, above which doubles resolve the bend in it.
const RESOLVED: f64 = 1e-7;
/// Distance from a near miss, in radians or scaled lengths, within which the motion bends.
const BENT: f64 = 1e-3;

/// Measure of a coupled group, relative to its maximum so far, below which its solutions may cross
/// within the widest step.
const MAX_CROSSING_MEASURE: f64 = 1e-2;
/// Maximum distance of a crossing from an end of the range that it causes, in radians or scaled
/// lengths.
pub(super) const MAX_END_DISTANCE: f64 = 1e-6;

/// A near miss of a coupled group between samples of the walk.
#[derive(Clone, Copy, Debug)]
pub(super) struct CloseMiss {
    pub(super) group: usize,
    /// The sine of the group's transmission angle.
    pub(super) sine: f64,
    /// The driver's coordinate.
    pub(super) at: f64,
    /// The samples before and behind it.
    pub(super) between: [f64; 2],
    /// The distance within which the motion bends, in radians or scaled lengths.
    pub(super) width: f64,
}

/// A crossing of two solutions of a coupled group.
pub(super) struct Meeting {
    /// The driver's coordinate.
    pub(super) at: Double,
    /// The unknowns z.
    pub(super) z: Vec<Double>,
}

impl Walker<'_> {
    /// Crosses a limit at which two solutions of a coupled group cross. Returns the coordinate
    /// reached beyond it.
    pub(super) fn cross(&mut self, limit: f64) -> Option<f64> {
        // If the motion is shorter than the widest step, its anchors are restored for the next
        // step.
        let anchors = self.anchors.clone();
        approaches().take(WAYS).chain(FURTHER).find_map(|by| {
            let passed = self.cross_at(limit, by);
            if passed.is_none() {
                self.anchors.clone_from(&anchors);
            }
            passed
        })
    }

    /// Crosses a limit as [`Walker::cross`] does, from a distance `by` before it to the same
    /// distance beyond.
    fn cross_at(&mut self, limit: f64, by: f64) -> Option<f64> {
        let engine = self.engine;
        let before = engine.moved(limit, -self.sense * by);
        let beyond = engine.moved(limit, self.sense * by);
        // Closer to the limit, the derivatives in an anchor have lost their digits.
        self.anchors.forget_beyond(engine, before, self.sense);
        if !self.step_to(before) {
            return None;
        }
        let saved = self.state.clone();
        let flat = self.flat(limit);
        // Dyads before the group may have a change point at the same coordinate.
        let ways = engine.coupled_steps().flat_map(|(step, _)| {
            let earlier = &flat[..flat.partition_point(|&dyad| dyad < step)];
            let both = [&[], earlier].into_iter();
            both.take(1 + earlier.len().min(1))
                .map(move |dyads| (step, dyads))
        });
        let ways: Vec<(usize, &[usize])> = ways.collect();
        let passed = ways.into_iter().find_map(|way| {
            let changes = self.changes(way, &flat, (limit, by), &saved)?;
            let mut reached = std::mem::replace(&mut self.state, saved.clone());
            let is_stored = self.store_approach(limit, before);
            self.state.clone_from(&saved);
            if !is_stored {
                self.anchors.push(engine, before, &mut self.state);
            }
            self.anchors.push(engine, beyond, &mut reached);
            let passed = self.pass_crossings(&changes);
            if passed.is_none() {
                self.anchors.forget_beyond(engine, before, self.sense);
            }
            passed
        });
        if passed.is_none() {
            // Restore the state before the limit for the next width.
            self.state = saved;
        }
        passed
    }

    /// Returns the crossings of coupled groups at one coordinate close to a limit: that of the group of
    /// `first`, before which the given dyads have a change point, and those of later groups. `flat`
    /// are all dyads almost in line there. Leaves the state beyond the limit; `saved` is the one before
    /// it.
    fn changes(
        &mut self,
        (first, dyads): (usize, &[usize]),
        flat: &[usize],
        (limit, by): (f64, f64),
        saved: &Workspace,
    ) -> Option<Vec<Change>> {
        let engine = self.engine;
        let beyond = engine.moved(limit, self.sense * by);
        let mut turned = dyads.to_vec();
        let mut changes: Vec<Change> = Vec::new();
        let mut reached = None;
        for step in first..engine.program.steps.len() {
            if engine.program.steps[step].coupled().is_none() {
                if changes.is_empty() || !flat.contains(&step) {
                    continue;
                }
                // The junction decides on which side a dyad behind the group continues.
                turned.push(step);
                continue;
            }
            let found = match changes.first() {
                // A regular group keeps its distance from a crossing.
                Some(_) if !self.is_near_crossing(step, saved) => None,
                Some(change) => {
                    let at = change.at;
                    let series = self.series_before(step, at, &changes);
                    series.and_then(|series| {
                        let inputs = GroupInputs::Series {
                            about: at,
                            series: &series,
                        };
                        self.crossing(step, (limit, by), inputs, saved)
                    })
                }
                None => {
                    self.state.clone_from(saved);
                    self.first_crossing((step, dyads), (limit, by), saved)
                }
            };
            let Some(Meeting { at, z }) = found else {
                if changes.is_empty() {
                    return None;
                }
                continue;
            };
            turned.push(step);
            self.state.clone_from(saved);
            turned.iter().for_each(|&step| self.flip(step));
            if !self.try_part(step + 1, (saved.at, beyond), saved) {
                return None;
            }
            let group = &engine.program.coupled[engine.program.steps[step].coupled()?];
            let rate = group.open(&mut self.state.scratch).first.to_vec();
            reached = Some(self.state.clone());
            self.state.clone_from(saved);
            changes.push(Change { step, at, z, rate });
        }
        self.state = reached?;
        Some(changes)
    }

    /// Returns `true` if the measure of a coupled group is small in a state.
    fn is_near_crossing(&mut self, step: usize, state: &Workspace) -> bool {
        self.state.clone_from(state);
        self.has_small_measure(step, state.at)
    }

    /// Returns `true` if the measure of a coupled group is small at the z in the scratch.
    fn has_small_measure(&mut self, step: usize, at: f64) -> bool {
        self.engine.measure_coupled(at, &mut self.state);
        let group = self.engine.group_of(step);
        group.is_some_and(|group| {
            self.state.measures[group].abs() < MAX_CROSSING_MEASURE * self.peaks[group]
        })
    }

    /// Crosses crossings of coupled groups' solutions. Close to a fold, a series of few terms holds
    /// only so close to the crossing that it cannot be proved there: more terms are tried. Returns the
    /// coordinate reached.
    fn pass_crossings(&mut self, changes: &[Change]) -> Option<f64> {
        let at = changes.first()?.at;
        let (saved, terms) = (self.state.clone(), self.terms);
        for attempt in 0..SERIES {
            let junction = self.junction(at, changes);
            let minimum = if attempt == 0 { 0.0 } else { MIN_ZONE };
            let passed = junction.and_then(|junction| self.pass_in_zone(&junction, minimum));
            if passed.is_some() {
                return passed;
            }
            self.state.clone_from(&saved);
            self.terms += MORE;
        }
        self.terms = terms;
        None
    }

    /// Returns `true` if the solutions of a coupled group cross at the minimum of its measure.
    ///
    /// Lengths and coordinates are rounded, so that the solutions may miss each other by that
    /// rounding. The motion would then turn sharply from one solution to the other and follow
    /// neither.
    pub(super) fn crosses(&mut self, group: usize, at: f64) -> bool {
        let engine = self.engine;
        let mut steps = 0..engine.program.steps.len();
        let Some(step) = steps.find(|&i| engine.group_of(i) == Some(group)) else {
            return false;
        };
        let crosses = approaches().take(WAYS).any(|by| {
            let before = engine.moved(at, -self.sense * by);
            let driver_states = self.step_to(before);
            let saved = self.state.clone();
            let near = (at, by);
            let steps = GroupInputs::Steps;
            driver_states && self.crossing(step, near, steps, &saved).is_some()
        });
        crosses || self.has_pair(step, at)
    }

    /// Adds the coupled groups whose solutions cross at a limit to those that are not proved to pass.
    /// `last` is the last state before the limit.
    pub(super) fn add_crossing_groups(&mut self, limit: f64, last: &Workspace) {
        let engine = self.engine;
        let saved = self.state.clone();
        for (step, index) in engine.coupled_steps() {
            let near = (limit, MAX_END_DISTANCE);
            let meets = self.crossing(step, near, GroupInputs::Steps, last);
            let group = GroupId::new(engine.program.coupled[index].group);
            if meets.is_some() && !self.unproved.contains(&group) {
                self.unproved.push(group);
            }
        }
        self.state = saved;
    }

    /// Adds the coupled groups that are almost singular at an end without a bound, or in the last state
    /// before it, to those that are not proved to pass, unless others are known.
    pub(super) fn add_singular_groups(&mut self, end: f64, last: &Workspace) {
        if !self.unproved.is_empty() {
            return;
        }
        let engine = self.engine;
        for (step, index) in engine.coupled_steps() {
            let is_singular = self.is_near_crossing(step, last) || {
                self.predict_nearest(end);
                let is_placed = self.place_inputs(step, end, GroupInputs::Steps);
                is_placed && self.has_small_measure(step, end)
            };
            if is_singular {
                let group = engine.program.coupled[index].group;
                self.unproved.push(GroupId::new(group));
            }
        }
    }

    /// Steps to a coordinate from the latest known state before it, by as many steps as the motion
    /// needs. Returns `true` if the coordinate was reached without leaving the motion.
    pub(super) fn step_to(&mut self, to: f64) -> bool {
        let known = self.latest_before(to).filter(|&at| self.place_at(at));
        known.is_some_and(|at| self.step_from(at, to, |_, _| {}))
    }

    /// Steps from a coordinate, which is that of the state, to another one, and calls `reached` after
    /// each step. Returns `true` if the coordinate was reached without leaving the motion.
    fn step_from(&mut self, from: f64, to: f64, mut reached: impl FnMut(&mut Self, f64)) -> bool {
        let (mut good, mut saved, mut step) = (from, self.state.clone(), to - from);
        for _ in 0..STEPS_BEFORE {
            if good == to {
                return true;
            }
            let is_last = (to - good).abs() <= step.abs();
            let next = if is_last { to } else { good + step };
            if next == good {
                return false;
            }
            if self.try_step(good, next, &saved) {
                reached(self, next);
                saved.clone_from(&self.state);
                (good, step) = (next, 2.0 * step);
            } else {
                self.state.clone_from(&saved);
                step = 0.5 * (next - good);
            }
        }
        false
    }

    /// Stores states on the way to a change point, from the latest known one to a coordinate before it. A
    /// search for the change point removes them, and directly before a fold, the rates of one state do
    /// not predict another that is much farther away from it. Returns `true` if the coordinate was
    /// reached.
    pub(super) fn store_approach(&mut self, change: f64, to: f64) -> bool {
        let engine = self.engine;
        let known = self.latest_before(to).filter(|&at| self.place_at(at));
        let Some(mut here) = known else {
            return false;
        };
        let nearest = engine.difference(change, to).abs();
        let from = here;
        let parts = (1..=HALVINGS).map(|k| to + (from - to) * 0.5_f64.powi(k));
        let places = parts.take_while(|&place| engine.difference(to, place).abs() > nearest);
        for place in places.chain([to]) {
            if !self.step_from(here, place, Walker::insert_anchor) {
                return false;
            }
            here = place;
        }
        true
    }

    /// Stores the state at a coordinate as an anchor.
    fn insert_anchor(&mut self, at: f64) {
        let Walker { anchors, state, .. } = self;
        anchors.insert(self.engine, (at, self.sense), state);
    }

    /// Steps past a near miss of a coupled group, by steps that become shorter towards it, and stores
    /// the states on the way. Returns the coordinate reached behind it, which is that of a sample, or
    /// lies before the next change point.
    ///
    /// A step across several near misses at one coordinate could end on another assembly, which
    /// continues the motion without a bend.
    pub(super) fn step_past(&mut self, miss: &CloseMiss) -> Option<f64> {
        let &CloseMiss {
            at,
            between: [from, to],
            width,
            ..
        } = miss;
        let engine = self.engine;
        self.anchors.forget_beyond(engine, at, self.sense);
        if !self.place_at(from) {
            return None;
        }
        let towards = |end: f64| {
            let parts = (1..=HALVINGS).map(move |k| at + (end - at) * 0.5_f64.powi(k));
            let nearest = CLOSEST * width;
            parts.take_while(move |&place| engine.difference(at, place).abs() > nearest)
        };
        let after: Vec<f64> = towards(to).collect();
        let places = towards(from).chain(after.into_iter().rev()).chain([to]);
        // Anchors stored at once would make a bend of this width a corner.
        let mut passed = Anchors::default();
        let is_wide = width > RESOLVED;
        let (mut here, mut reached) = (from, self.state.clone());
        for place in places {
            let is_reached = self.step_from(here, place, |walker, at| {
                if is_wide {
                    passed.push(engine, at, &mut walker.state);
                } else {
                    walker.insert_anchor(at);
                }
            });
            if !is_reached {
                let by = engine.difference(at, here) * self.sense;
                if by > width {
                    // Partial steps have left the state between both places.
                    self.state = reached;
                    break;
                }
                return None;
            }
            here = place;
            reached.clone_from(&self.state);
        }
        self.anchors.add(engine, &passed, self.sense);
        Some(here)
    }

    /// Returns `true` if the walk stopped at a limit in the bend of a near miss, which doubles resolve. From
    /// now on, it is no corner. `last` is the state there.
    pub(super) fn resolves_bend(&mut self, limit: f64, last: &Workspace) -> bool {
        let engine = self.engine;
        if self.is_resolved(limit) || !self.is_at_corner {
            return false;
        }
        let is_open = engine.coupled_steps().any(|(step, _)| {
            self.state.clone_from(last);
            let near = (limit, BENT);
            let found = self.nearest_opening(step, near, GroupInputs::Steps);
            found.is_some_and(|(crossing, at)| {
                // The opening is about the square of the sine.
                let is_wide = crossing.unfolding.abs() > RESOLVED * RESOLVED;
                is_wide && self.meets(step, at, crossing, GroupInputs::Steps).is_none()
            })
        });
        self.state.clone_from(last);
        if is_open {
            self.resolved = Some(limit);
        }
        is_open
    }

    /// Returns `true` if doubles resolve the bends close to a coordinate.
    pub(super) fn is_resolved(&self, at: f64) -> bool {
        let resolved = self.resolved;
        resolved.is_some_and(|bend| self.engine.difference(bend, at).abs() < BENT)
    }

    /// Returns the latest coordinate at or before `at` with a known state.
    fn latest_before(&self, at: f64) -> Option<f64> {
        if self.has_path() {
            return self.anchors.latest_before(at, self.sense);
        }
        let is_before = |&&sample: &&f64| (sample - at) * self.sense <= 0.0;
        self.samples.iter().rev().find(is_before).copied()
    }

    /// Computes the known state at a coordinate. Returns `true` if it exists.
    fn place_at(&mut self, at: f64) -> bool {
        let Walker { anchors, state, .. } = self;
        anchors.predict_from_before(self.engine, at, self.sense, state);
        self.run(at, Order::Acceleration) == Condition::Ok
    }

    /// Returns the crossing of a coupled group's solutions within `by` of a limit, at which the given
    /// dyads before it have a change point. `before` is the state before the limit.
    fn first_crossing(
        &mut self,
        (step, dyads): (usize, &[usize]),
        near: (f64, f64),
        before: &Workspace,
    ) -> Option<Meeting> {
        let Some(&dyad) = dyads.first() else {
            return self.crossing(step, near, GroupInputs::Steps, before);
        };
        let about = self.exactly(dyad, near.0)?;
        let series = &self.series_before(step, about, &[])?;
        self.crossing(step, near, GroupInputs::Series { about, series }, before)
    }

    /// Returns the crossing of a coupled group's solutions within `by` of a limit, and exactly at the
    /// coordinate of the series that give its inputs, if any. `before` is the state before the limit.
    fn crossing(
        &mut self,
        step: usize,
        (limit, by): (f64, f64),
        inputs: GroupInputs<'_>,
        before: &Workspace,
    ) -> Option<Meeting> {
        let engine = self.engine;
        self.state.clone_from(before);
        let dq = engine.difference(before.at, limit);
        // The groups before it give its inputs.
        for group in &engine.program.coupled {
            group.predict(&mut group.open(&mut self.state.scratch), dq);
        }
        let (crossing, at) = self.nearest_crossing(step, (limit, by), inputs)?;
        let Meeting { at, z } = self.meets(step, at, crossing, inputs)?;
        let GroupInputs::Series { about, .. } = inputs else {
            return Some(Meeting { at, z });
        };
        let distance = self.distance_exactly(about, at).abs().hi;
        (distance <= CHANGE_POINT_TOLERANCE).then_some(Meeting { at: about, z })
    }

    /// Solves the equations of a crossing from the z in the scratch. Returns the crossing of a coupled
    /// group within `by` of a limit at which the branches count as crossing in doubles, and its
    /// coordinate.
    pub(super) fn nearest_crossing(
        &mut self,
        step: usize,
        near: (f64, f64),
        inputs: GroupInputs<'_>,
    ) -> Option<(Crossing, f64)> {
        let maximum = OPENED + REACH_SLACK * self.engine.frame.far;
        let found = self.nearest_opening(step, near, inputs);
        found.filter(|(crossing, _)| crossing.unfolding.abs() <= maximum)
    }

    /// Returns the place within `by` of a limit at which the branches of a coupled group cross or are
    /// closest to each other, as [`Walker::nearest_crossing`] does.
    fn nearest_opening(
        &mut self,
        step: usize,
        (limit, by): (f64, f64),
        inputs: GroupInputs<'_>,
    ) -> Option<(Crossing, f64)> {
        let engine = self.engine;
        let group = &engine.program.coupled[engine.program.steps[step].coupled()?];
        let mut at = limit;
        let mut crossing = None;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            if !self.place_inputs(step, at, inputs) {
                return None;
            }
            let (q, _) = engine.coordinate(at);
            let Workspace { state, scratch, .. } = &mut self.state;
            let mut start = match crossing.take() {
                Some(crossing) => Some(crossing),
                None => group.crossing(q, state, scratch),
            };
            let correction = start
                .as_mut()
                .and_then(|crossing| group.approach_crossing(crossing, q, state, scratch));
            let Correction { size, dq } = correction?;
            crossing = start;
            at = engine.moved(at, dq);
            let is_far = engine.difference(limit, at).abs() > FAR;
            if is_far && size > 1.0 && size > MAX_GROWTH * last {
                return None;
            }
            last = size;
            if size < MAX_LAST_CORRECTION {
                break;
            }
        }
        let is_here = engine.difference(limit, at).abs() < by;
        crossing.filter(|_| is_here).map(|crossing| (crossing, at))
    }

    /// Returns the crossing in double-double if the branches meet according to the typed decimals. If
    /// these are not available, the result in doubles counts. The scratch holds the z in doubles.
    pub(super) fn meets(
        &mut self,
        step: usize,
        at: f64,
        crossing: Crossing,
        inputs: GroupInputs<'_>,
    ) -> Option<Meeting> {
        let index = self.engine.program.steps[step].coupled()?;
        let own = &self.engine.program.coupled[index];
        let z = own.open(&mut self.state.scratch).z.iter();
        let in_doubles = Meeting {
            at: Double::exactly(at),
            z: z.map(|&z| Double::exactly(z)).collect(),
        };
        let Some(exact) = self.exact else {
            return Some(in_doubles);
        };
        let group = &exact.engine.program.coupled[index];
        let mut twice = exact.twice(self.state.travels.len());
        let (q, _) = self.engine.coordinate(at);
        let unfolding = group.unfolding(crossing, q, &mut self.state, &mut twice.scratch);
        let mut unfolding = unfolding?;
        let mut at = in_doubles.at;
        for _ in 0..CORRECTIONS {
            if !self.place_inputs_exactly(exact, (step, at), inputs, &mut twice) {
                // An earlier coupled group may be singular at the same coordinate.
                return (step > exact.closed).then_some(in_doubles);
            }
            let (q, _) = exact.engine.coordinate(at);
            let Workspace { state, scratch, .. } = &mut twice;
            let dq = group.unfold(&mut unfolding, q, state, scratch);
            at = self.moved_exactly(at, Double::exactly(dq));
        }
        if !unfolding.by.hi.is_finite() && step > exact.closed {
            return Some(in_doubles);
        }
        // An error of a length shifts an equation by at most twice that error.
        let unknowns = unfolding.unknowns() as f64;
        let is_met = unfolding.by.hi.abs() <= 2.0 * unknowns * exact.typed_slack();
        let is_zero = at.hi.abs() < f64::EPSILON * f64::EPSILON * self.engine.finest();
        let at = if is_zero { Double::ZERO } else { at };
        let z = group.open(&mut twice.scratch).z.to_vec();
        is_met.then_some(Meeting { at, z })
    }
}
