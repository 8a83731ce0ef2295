//! Passes a change point directly before a fold, where the driver reverses and the range ends.
//!
//! A series in the driver's coordinate converges only up to the fold. The parameter of these series
//! runs along a curve instead, through the change point and past the fold: the height of the dyad
//! that reaches its limit, or a component of the coupled group that folds. The driver's coordinate is
//! a series as well, and its extreme is the end of the range. The change point is one of the coupled
//! group itself, or one of dyads behind the group that reaches its limit.

use super::proof::PROOF_TOLERANCE;
use super::{Junction, SingularGroup};
use crate::arithmetic::Series;
use crate::solver::Order;
use crate::solver::change_point::{Bend, ChangePointCrossing, FOLD_TOLERANCE};
use crate::solver::coupled::{BRANCHES, CurvePlace};
use crate::solver::elements::SingularShift;
use crate::solver::exact::Exact;
use crate::solver::motion::Folded;
use crate::solver::motion::crossing::Meeting;
use crate::solver::motion::group_inputs::GroupInputs;
use crate::solver::motion::proved_ends::BoundedEnd;
use crate::solver::motion::tracking::Walker;
use crate::solver::state::Condition;
use crate::solver::workspace::Workspace;
use crate::{Double, Number, Vec2};

/// Distances before a limit, in radians or scaled lengths, from which the group's curve is followed.
/// Along the curve they correspond to about their square roots. The first one lies before every
/// change point in [`APART`], the last one close enough for curves of small radius.
const BEFORE: [f64; 8] = [3e-4, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
/// Number of terms of the series: at a tenth of its radius of convergence, the last one is about
/// 1e-20, which is below the rounding error of a double.
const CURVE_TERMS: usize = 20;
/// Number of corrections per coefficient of the driver's coordinate. Each is solved in doubles, so
/// that two give the digits of double-double.
const CORRECTIONS: usize = 2;
/// Maximum number of Newton steps to the fold. Each doubles the digits: six lead from one digit to
/// those of double-double.
const STEPS: usize = 12;
/// Size of the last Newton step to the fold: its square is below the rounding error of
/// double-double, and it is far below the smallest distance in [`APART`].
const MAX_LAST_STEP: f64 = 1e-25;
/// Range of the distance between change point and fold along the curve.
///
/// The driver's coordinates of both differ by about the square. Below 1e-8 this is less than a rounding
/// error of doubles, and both coordinates are one double. At the upper end it is 6e-4: there a series in
/// the driver's coordinate passes the change point. On a flat curve it can be a tenth of this, as 6e-5 at
/// 3e-2 in a planted motion, where such a series needs more terms. A zone of at most 0.04 contains
/// [`WIDER`] times the upper end.
const APART: std::ops::Range<f64> = 1e-12..2.5e-2;
/// Minimum zone of the series, in units of the distance between change point and fold. The zone must
/// contain the fold, and a part of the curve behind it, where the series is proved.
const WIDER: f64 = 1.5;
/// Factor by which a zone shrinks if the series cannot be proved in it.
const ZONE_RATIO: f64 = 0.3;
/// Maximum number of zones tried: the last one is 2e-4 of the first.
const ZONES: i32 = 8;
/// Maximum difference between the series and the arriving motion, relative to the distance along the
/// curve. The other branch is about as far away as that distance.
const ARRIVAL: f64 = 1e-3;

/// The driver's coordinate along a curve.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    /// The step of the group that folds.
    pub(super) step: usize,
    /// The height of that group if it is a dyad.
    height: Option<Series>,
    /// The coordinate relative to that of the junction, in radians or scaled lengths.
    offset: Series,
    /// Whether the motion reaches the fold before the change point, and ends without passing it.
    ends_before: bool,
}

impl Curve {
    /// Returns the driver's coordinate at a distance along the curve, relative to the junction's.
    pub(super) fn offset_at(&self, by: f64) -> Double {
        self.offset.value(Double::exactly(by))
    }

    /// Returns the distance along the curve at which the driver reverses.
    fn fold(&self) -> Option<Double> {
        let rate = self.offset.derivative();
        let bend = rate.derivative();
        let mut at = Double::ZERO;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let by = rate.value(at) / bend.value(at);
            at += -by;
            last = by.abs().hi;
        }
        // Negated so that NaN is rejected.
        let is_found = last < MAX_LAST_STEP && APART.contains(&at.abs().hi);
        is_found.then_some(at)
    }
}

impl Walker<'_> {
    /// Returns the end of the range at a fold close to a limit, if there is a change point directly
    /// before it. The motion up to the fold is then known.
    pub(in crate::solver::motion) fn end_behind_crossing(
        &mut self,
        limit: f64,
    ) -> Option<BoundedEnd> {
        if self.refused.is_none() && !self.has_path() {
            return None;
        }
        let anchors = self.anchors.clone();
        let saved = self.state.clone();
        BEFORE.into_iter().find_map(|by| {
            let found = self.end_behind_crossing_from(limit, by);
            if found.is_none() {
                self.anchors.clone_from(&anchors);
                self.state.clone_from(&saved);
            }
            found
        })
    }

    /// Returns the end as [`Walker::end_behind_crossing`] does, from a distance `by` before the limit.
    fn end_behind_crossing_from(&mut self, limit: f64, by: f64) -> Option<BoundedEnd> {
        let engine = self.engine;
        let before = engine.moved(limit, -self.sense * by);
        self.anchors.forget_beyond(engine, before, self.sense);
        if self.ahead(before) <= 0.0 || !self.step_to(before) {
            return None;
        }
        let arrived = self.state.clone();
        let (step, at) = self.refused.unwrap_or_default();
        let by_dyad = self.leaders(step, at).into_iter().find_map(|leader| {
            self.state.clone_from(&arrived);
            let junction = self.junction_by_height(leader, at)?;
            self.end_on_curve(&junction, before, &arrived)
        });
        if by_dyad.is_some() {
            return by_dyad;
        }
        let mut earlier = engine
            .coupled_steps()
            .take_while(|&(leader, _)| leader < step);
        let by_group = earlier.find_map(|(leader, _)| {
            self.state.clone_from(&arrived);
            let junction = self.junction_by_group(leader, at)?;
            self.end_on_curve(&junction, before, &arrived)
        });
        if by_group.is_some() {
            return by_group;
        }
        for (step, _) in engine.coupled_steps() {
            self.state.clone_from(&arrived);
            if self
                .nearest_crossing(step, (limit, by), GroupInputs::Steps)
                .is_none()
            {
                continue;
            }
            let curves = (0..BRANCHES).flat_map(|branch| [(branch, false), (branch, true)]);
            for (branch, ends_before) in curves {
                self.state.clone_from(&arrived);
                let junction = self.curve_junction(((step, branch), ends_before), (limit, by));
                let end = junction.and_then(|found| self.end_on_curve(&found, before, &arrived));
                if end.is_some() {
                    return end;
                }
            }
        }
        None
    }

    /// Returns the dyads before a step that reach their limit directly behind a change point.
    fn leaders(&mut self, step: usize, at: Double) -> Vec<usize> {
        let mut leaders = Vec::new();
        let Some(Exact { engine, .. }) = self.exact else {
            return leaders;
        };
        let (q, direction) = self.coordinate_of(at, 2);
        let mut series = engine.state::<Series>(self.state.travels.len());
        for i in 0..step {
            if let Some(dyad) = engine.program.steps[i].dyad() {
                let square = dyad.square(q, SingularShift::default(), &series);
                let [first, slope] = [square.c[0].hi, square.c[1].hi];
                if APART.contains(&(first / slope.abs()).sqrt()) {
                    leaders.push(i);
                }
            }
            let placed = self.place_in_series(i..i + 1, at.hi, q, direction, &mut series);
            if placed.is_none() {
                break;
            }
        }
        leaders
    }

    /// Expands the mechanism about a change point along the height of a dyad close to its limit.
    fn junction_by_height(&mut self, step: usize, at: Double) -> Option<Junction> {
        let engine = &self.exact?.engine;
        let dyad = engine.program.steps[step].dyad()?;
        let group = dyad.group();
        let plain = SingularShift::default();
        let mut series = engine.state::<Series>(self.state.travels.len());
        let mut square = |walker: &mut Self, by: Series| {
            let (q, direction) = walker.coordinate_along(at, by);
            walker.place_in_series(0..step, at.hi, q, direction, &mut series)?;
            Some(dyad.square(q, plain, &series))
        };
        let straight = square(self, Series::line(Double::ZERO, Double::ONE).cut(2))?;
        let (first, slope) = (straight.c[0], straight.c[1]);
        if !(first.hi > 0.0 && slope.hi != 0.0) {
            return None;
        }
        // The parameter grows with the driver's coordinate on the arriving motion.
        let rate = slope.abs().sqrt();
        let rate = if slope.hi < 0.0 { -rate } else { rate };
        let height = Series::line(first.sqrt(), rate).cut(CURVE_TERMS);
        let wanted = height * height;
        let mut offset = Series::default();
        for k in 1..CURVE_TERMS {
            for _ in 0..CORRECTIONS {
                let found = square(self, offset.cut(k + 1))?;
                offset.c[k] += (wanted.c[k] - found.c[k]) / slope;
            }
        }
        let offset = offset.cut(CURVE_TERMS);
        square(self, offset)?;
        let coordinate = self.coordinate_along(at, offset);
        let signs = self.state.signs.clone();
        let signed = if signs[group] < 0.0 { -height } else { height };
        dyad.run_through(coordinate.0, plain, signed, &mut series.state);
        let curve = Curve {
            step,
            height: Some(signed),
            offset,
            ends_before: false,
        };
        self.expanded(at, series, curve, None)
    }

    /// Expands the mechanism about a change point of a dyad, along the curve of a coupled group before
    /// it that is close to its fold.
    fn junction_by_group(&mut self, step: usize, at: Double) -> Option<Junction> {
        self.predict_nearest(at.hi);
        let condition = self
            .engine
            .run_steps(0..step + 1, at.hi, Order::Position, &mut self.state);
        if condition != Condition::Ok {
            return None;
        }
        let (series, offset) = self.group_along_curve(step, at, None)?;
        let curve = Curve {
            step,
            height: None,
            offset,
            ends_before: false,
        };
        self.expanded(at, series, curve, None)
    }

    /// Expands a coupled group along its curve through the z in the scratch; if this is a crossing,
    /// along one of its branches. Returns the series with the steps up to the group, and that of the
    /// driver's coordinate relative to the place.
    fn group_along_curve(
        &mut self,
        step: usize,
        at: Double,
        branch: Option<usize>,
    ) -> Option<(Workspace<Series>, Series)> {
        let exact = self.exact?;
        let index = exact.engine.program.steps[step].coupled()?;
        let group = &exact.engine.program.coupled[index];
        let (q, _) = self.engine.coordinate(at.hi);
        let z = group.open(&mut self.state.scratch).z.to_vec();
        let matrix = group.matrix(q, &mut self.state);
        let place = CurvePlace {
            z: &z,
            matrix: &matrix,
        };
        let mut series = exact.engine.state(self.state.travels.len());
        let offset = group.follow_curve(
            &place,
            (branch, CURVE_TERMS),
            &mut series,
            &mut |by, series| {
                let (q, direction) = self.coordinate_along(at, by);
                self.place_in_series(0..step, at.hi, q, direction, series)?;
                Some(q)
            },
        )?;
        Some((series, offset))
    }

    /// Expands the steps behind the group of a curve. `fold` is that group if it is singular.
    fn expanded(
        &mut self,
        at: Double,
        series: Workspace<Series>,
        curve: Curve,
        fold: Option<SingularGroup>,
    ) -> Option<Junction> {
        let coordinate = self.coordinate_along(at, curve.offset);
        let steps = curve.step + 1..self.engine.program.steps.len();
        let mut junction = Junction {
            curve: Some(curve),
            ..Junction::about(at, series, &self.state.signs)
        };
        // The signs of the state are those behind the change point if the motion ends before it.
        let sense = self.sense;
        if junction
            .curve
            .as_ref()
            .is_some_and(|curve| curve.ends_before)
        {
            self.sense = -sense;
        }
        if let Some(fold) = fold {
            junction.fold(fold, self.sense);
        }
        let expanded = self.expand(steps, coordinate, &[], &mut junction);
        self.sense = sense;
        expanded.ok()?;
        (!junction.is_miss()).then_some(junction)
    }

    /// Expands the mechanism along one of the curves of a coupled group through a crossing close to a
    /// limit. The state is one before the limit.
    fn curve_junction(
        &mut self,
        ((step, branch), ends_before): ((usize, usize), bool),
        near: (f64, f64),
    ) -> Option<Junction> {
        let exact = self.exact?;
        let index = exact.engine.program.steps[step].coupled()?;
        let group = &exact.engine.program.coupled[index];
        let (crossing, at) = self.nearest_crossing(step, near, GroupInputs::Steps)?;
        let z = group.open(&mut self.state.scratch).z.to_vec();
        let Meeting { at, .. } = self.meets(step, at, crossing, GroupInputs::Steps)?;
        group.open(&mut self.state.scratch).z.copy_from_slice(&z);
        let condition = self
            .engine
            .run_steps(0..step, at.hi, Order::Position, &mut self.state);
        if condition == Condition::NoAssembly {
            return None;
        }
        let (series, offset) = self.group_along_curve(step, at, Some(branch))?;
        let of = (step, group.group);
        let fold = SingularGroup::tolerances_at(of, SingularShift::default(), 2);
        let curve = Curve {
            step,
            height: None,
            offset,
            ends_before,
        };
        self.expanded(at, series, curve, Some(fold))
    }

    /// Returns the driver's coordinate for the steps at a distance from another, both as series.
    fn coordinate_along(&self, at: Double, by: Series) -> (Series, Vec2<Series>) {
        let engine = self.engine;
        let unit = if engine.is_rotary {
            Double::DEGREES
        } else {
            Double::exactly(engine.frame.scale)
        };
        let (q, direction) = engine.coordinate(Series::constant(at) + by * Series::constant(unit));
        (q.cut(by.known), direction)
    }

    /// Returns the end of the range at the fold of a curve, if the curve is proved on both sides and
    /// agrees with the arriving motion. Stores the change points and the state at the fold.
    fn end_on_curve(
        &mut self,
        junction: &Junction,
        before: f64,
        arrived: &Workspace,
    ) -> Option<BoundedEnd> {
        let engine = self.engine;
        let curve = junction.curve.as_ref()?;
        let grows = curve.offset.c[1].hi > 0.0;
        let fold = curve
            .fold()
            .filter(|fold| grows && fold.hi * self.sense > 0.0)?;
        // The parameter grows with the coordinate at the change point. Before the fold, the motion
        // lies on the side of the change point, or on the other one.
        let ends_before = curve.ends_before;
        let side = if ends_before { fold.hi } else { -fold.hi };
        let bend = Bend::new(&curve.offset, fold, side)?;
        let is_known = |group: usize| {
            let place = (group, junction.at.hi);
            self.crossings.has(engine, place, PROOF_TOLERANCE)
        };
        let is_plain = junction.folds.iter().all(|fold| !fold.pair);
        if !is_plain || junction.groups().any(is_known) || self.ahead(junction.at.hi) <= 0.0 {
            return None;
        }
        // The state before must lie before the change point, or before the fold on the other side.
        let from = bend.parameter(engine.difference(junction.at.hi, before))?;
        let disc = from.abs().max(fold.abs().hi);
        let is_before = if ends_before {
            (from - fold.hi) * self.sense > 0.0
        } else {
            from * self.sense < 0.0
        };
        if !is_before || !self.has_no_other_change(junction, disc) {
            return None;
        }
        let crossings = junction.folds.iter().map(|fold| {
            let of = (fold.group, fold.turns() && !ends_before);
            let outputs = engine.outputs(fold.step);
            let mut crossing =
                ChangePointCrossing::bent(junction.at, of, outputs, &junction.series)?;
            crossing.is_led_through = ends_before;
            Some(crossing)
        });
        let mut crossings = crossings.collect::<Option<Vec<ChangePointCrossing>>>()?;
        let leads = junction.folds.iter().all(|fold| fold.step != curve.step);
        if let Some(group) = engine.group_of(curve.step).filter(|_| leads) {
            // The group at its limit follows the same series, without a change point.
            let outputs = engine.outputs(curve.step);
            let of = (group, false);
            let mut crossing =
                ChangePointCrossing::bent(junction.at, of, outputs, &junction.series)?;
            crossing.is_led_through = true;
            crossings.push(crossing);
        }
        let widest = crossings
            .iter()
            .map(|c| c.zone)
            .fold(f64::INFINITY, f64::min);
        let minimum = WIDER * fold.abs().hi;
        let steps = engine.program.steps.len();
        let zones = (0..ZONES).map(|k| widest * ZONE_RATIO.powi(k));
        let zone = zones
            .take_while(|&zone| zone > minimum && zone > from.abs())
            .find(|&zone| {
                let sides = [-zone, zone].map(|by| curve.offset_at(by).abs().hi);
                let wide = sides[0].max(sides[1]);
                // The series does not hold beyond a knot of an input table.
                let is_smooth = engine.smooth(junction.at.hi) >= wide;
                let is_alone = junction.groups().all(|group| {
                    let other = self.crossings.distance(engine, group, junction.at.hi);
                    other.is_none_or(|other| other > 2.0 * wide)
                });
                let is_bent = bend.is_monotonic(zone + fold.abs().hi);
                is_smooth && is_alone && is_bent && self.proves(junction, zone, steps)
            })?;
        if !self.arrives(junction, from, arrived) {
            return None;
        }
        for crossing in &mut crossings {
            crossing.zone = zone;
            crossing.bend = Some(bend.clone());
        }
        let known = self.crossings.len();
        self.crossings.add(crossings);
        let end = (ends_before || self.exists_on_curve(junction, fold.scaled(0.5)))
            .then(|| self.fold_on_curve(junction, fold, arrived))
            .flatten();
        let Some(end) = end else {
            self.crossings.truncate(known);
            return None;
        };
        let is_beyond = |at: f64| (at - before) * self.sense > 0.0;
        self.misses.retain(|miss| !is_beyond(miss.at));
        self.samples.retain(|&at| !is_beyond(at));
        self.unproved.clear();
        let zone = curve.offset_at(zone.copysign(from)).hi;
        let saved = std::mem::replace(&mut self.state, arrived.clone());
        self.store_approach(junction.at.hi, engine.moved(junction.at.hi, zone));
        self.state = saved;
        Some(end)
    }

    /// Returns `true` if no group has another change point or limit within a distance along the
    /// curve, from before the change point to the fold.
    ///
    /// A group that follows the driver alone would pass such a place twice, before and behind the
    /// fold. A proof on both sides of the curve cannot detect that. By Pellet's theorem, the square
    /// of a height has as many zeros in a disc as the power of its dominant term.
    fn has_no_other_change(&self, junction: &Junction, disc: f64) -> bool {
        let (Some(curve), Some(Exact { engine, .. })) = (&junction.curve, self.exact) else {
            return false;
        };
        let (q, _) = self.coordinate_along(junction.at, curve.offset);
        engine.program.steps.iter().enumerate().all(|(i, step)| {
            if i == curve.step {
                return true;
            }
            if step.coupled().is_some() {
                return false;
            }
            let Some(dyad) = step.dyad() else {
                return true;
            };
            let fold = junction.folds.iter().find(|fold| fold.step == i);
            let snap = fold.map_or_else(SingularShift::default, |fold| fold.snap);
            let square = dyad.square(q, snap, &junction.series);
            let size = |n: usize| square.c[n].abs().hi * disc.powi(n as i32);
            let total: f64 = (0..square.known).map(size).sum();
            let dominant = (0..square.known).find(|&n| 2.0 * size(n) > total);
            dominant.is_some_and(|order| match fold {
                None => order == 0,
                Some(fold) => order > 0 && order % 2 == 0 && fold.turns() == (order % 4 == 2),
            })
        })
    }

    /// Returns `true` if the mechanism exists at a distance along the curve beyond the change point,
    /// and the watched constraints hold there.
    fn exists_on_curve(&mut self, junction: &Junction, by: Double) -> bool {
        let Some(curve) = &junction.curve else {
            return false;
        };
        let at = self.moved_exactly(junction.at, curve.offset.value(by)).hi;
        let signs = self.state.signs.clone();
        for step in junction.turning() {
            self.flip(step);
        }
        let steps = 0..self.engine.program.steps.len();
        let condition = self.run_some(steps, at, Order::Position);
        self.state.state.signs = signs;
        // Change point and fold may be one double.
        matches!(condition, Condition::Ok | Condition::ChangePoint) && self.check_fit().is_ok()
    }

    /// Returns `true` if the series agrees with a state of the motion before the change point.
    fn arrives(&self, junction: &Junction, by: f64, arrived: &Workspace) -> bool {
        let maximum = ARRIVAL * by.abs();
        let at = Double::exactly(by);
        let is_near = |text: Vec2<Series>, here: Vec2| {
            (text.map(|s| s.value(at).hi) - here).norm() <= maximum
        };
        (0..self.engine.program.steps.len()).all(|step| {
            let (points, links) = self.engine.outputs(step);
            let mut points = points.iter().map(|p| p.index());
            let mut links = links.iter().map(|l| l.index());
            let (text, here) = (&junction.series, &arrived.state);
            points.all(|p| is_near(text.points[p].p, here.points[p].p))
                && links.all(|l| is_near(text.links[l].d, here.links[l].d))
        })
    }

    /// Returns the fold of the curve's group as an end of the range, and stores the state there.
    fn fold_on_curve(
        &mut self,
        junction: &Junction,
        fold: Double,
        arrived: &Workspace,
    ) -> Option<BoundedEnd> {
        let engine = self.engine;
        let curve = junction.curve.as_ref()?;
        let at = self.moved_exactly(junction.at, curve.offset.value(fold)).hi;
        let is_here = |end: &BoundedEnd| engine.difference(at, end.at).abs() <= FOLD_TOLERANCE;
        self.state.clone_from(arrived);
        let Some(index) = engine.program.steps[curve.step].coupled() else {
            for step in junction.turning() {
                self.flip(step);
            }
            let near = self.state.clone();
            let stored = self.stretched.len();
            let end = self.refined(at, &near);
            if !is_here(&end) {
                self.stretched.truncate(stored);
                return None;
            }
            return Some(end);
        };
        let group = &engine.program.coupled[index];
        // The rates along the curve are those of the null vector at the fold.
        let value = |v: Vec2<Series>| v.map(|s| s.value(fold).hi);
        let rate = |v: Vec2<Series>| v.map(|s| s.derivative().value(fold).hi);
        for point in group.joints() {
            let place = junction.series.points[point.index()].p;
            let here = &mut self.state.state.points[point.index()];
            (here.p, here.v) = (value(place), rate(place));
        }
        for link in group.turning() {
            let direction = junction.series.links[link.index()].d;
            let here = &mut self.state.state.links[link.index()];
            here.d = value(direction);
            here.w = here.d.cross(rate(direction));
        }
        let Workspace { state, scratch, .. } = &mut self.state;
        let buffers = group.open(scratch);
        group.read(state, buffers.z);
        group.read_rates(state, buffers.first, buffers.second);
        // Newton's method in doubles would not separate the fold from the change point.
        let start = group.fold(&mut self.state.scratch)?;
        let z = group.open(&mut self.state.scratch).z.to_vec();
        let found = self.exact_fold((curve.step, index), start, at);
        let found = found.filter(|(end, _)| is_here(end));
        let (end, z) = found.unwrap_or((BoundedEnd::unproved(at), z));
        self.folds.push(Folded {
            at: end.at,
            index,
            z,
        });
        Some(end)
    }

    /// Places the group of a curve at a distance along it. Returns `true` if the group's equations
    /// hold there.
    pub(super) fn stays_on_curve(
        &mut self,
        curve: &Curve,
        (at, q): (Double, Series),
        (junction, by): (&Junction, f64),
        here: &mut Workspace<Series>,
    ) -> bool {
        let engine = self.engine;
        let by = Double::exactly(by);
        if let (Some(height), Some(exact)) = (&curve.height, self.exact) {
            let Some(dyad) = exact.engine.program.steps[curve.step].dyad() else {
                return false;
            };
            let plain = SingularShift::default();
            let height = height.value(by);
            let square = dyad.square(q, plain, here);
            let off = (square.c[0] - height * height).abs().hi;
            let height = Series::constant(height).cut(1);
            dyad.run_through(q, plain, height, &mut here.state);
            return off <= PROOF_TOLERANCE * square.c[0].abs().hi;
        }
        let Some(index) = engine.program.steps[curve.step].coupled() else {
            return false;
        };
        let (points, links) = engine.outputs(curve.step);
        let value = |v: Vec2<Series>| v.map(|s| Series::constant(s.value(by)).cut(1));
        for point in points {
            let place = junction.series.points[point.index()].p;
            here.state.points[point.index()].p = value(place);
        }
        for link in links {
            let direction = junction.series.links[link.index()].d;
            here.state.links[link.index()].d = value(direction);
        }
        self.take_places(here, Double::ZERO);
        let (q, _) = engine.coordinate(at.nearest());
        let correction = engine.program.coupled[index].correction_at(q, &mut self.state);
        correction.is_some_and(|size| size <= PROOF_TOLERANCE)
    }
}
