//! Represents crossings of change points by Taylor series.
//!
//! If the arms of a dyad come exactly into line at an extreme of their reach, its two assemblies
//! meet. The motion continues smoothly on the other side, so that the sign of the assembly changes.
//! The sign of a coupled group's determinant changes in the same manner where two of its solutions
//! cross.
//!
//! At and near the change point, the group's equations lose their digits, the second derivatives as
//! the inverse cube of the distance. The motion itself is smooth: there, the group is placed by the
//! Taylor series of its motion.

use super::engine::Engine;
use super::motion::positive_remainder;
use super::state::{LinkState, PointState, State};
use crate::arithmetic::{Series, TERMS};
use crate::{Double, LinkId, PointId, Vec2};

/// Maximum distance from a change point at which the series replaces the group's equations, in
/// radians or scaled lengths. Beyond it, a dyad's own second derivatives are off by less than about
/// 1e-11, and its positions by some roundings. A wider zone would replace accurate equations.
const WIDTH: f64 = 0.02;
/// The same distance for a series about two change points, in units of their distance from its centre,
/// if it is wider.
const PAIR_WIDTH: f64 = 3.0;
/// Maximum size of the last terms of a series in the second derivatives, within its zone: about a
/// rounding error.
const MAX_LAST_TERM: f64 = 1e-15;
/// Maximum relative difference between a coordinate and a change point that counts as none.
const EQUALITY_TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// Maximum distance from a fold at which a bent series is evaluated.
const MAX_BENT_WIDTH: f64 = 0.1;
/// Maximum number of Newton steps from a coordinate to the parameter of a bent series. The start is
/// off by a part of the distance from the fold, and each step squares this part.
const INVERSIONS: usize = 8;
/// Relative size of the last Newton step: its square is below the rounding error.
const INVERTED: f64 = 1e-9;
/// Maximum difference between the fold of a bent series and the end of the range, in radians or scaled
/// lengths. Both are computed in double-double, and the end is rounded to a double.
pub(super) const FOLD_TOLERANCE: f64 = 1e-11;

/// The known Taylor coefficients of a function of the driver's coordinate.
type Taylor = Vec<Vec2>;

/// A crossing of one of a group's change points.
#[derive(Clone, Debug)]
pub(super) struct ChangePointCrossing {
    /// The driver's coordinate, reduced to one period if there is one.
    pub at: f64,
    /// The rounding error of `at`: the low part of the coordinate in double-double.
    rest: f64,
    /// The group that crosses the change point.
    pub group: usize,
    /// Whether the group's sign changes there.
    pub is_rotary: bool,
    /// Whether nothing branches there: a redundant constraint leads the group through, or the group
    /// only just misses a change point.
    pub is_led_through: bool,
    /// The maximum distance from the centre of the series at which the series replaces the group's equations, in
    /// radians or scaled lengths.
    pub zone: f64,
    /// The distance of the change point from the centre of the series, in radians or scaled
    /// lengths. It is not 0 for one of two change points that share a series.
    pub off_centre: f64,
    /// The sign of the distances from the centre at which the series holds, or 0 for both.
    pub side: f64,
    /// The driver's coordinate along the series, if it is not the parameter of the series.
    pub bend: Option<Bend>,
    points: Vec<(PointId, Taylor)>,
    links: Vec<(LinkId, Taylor)>,
}

/// All change point crossings of a motion.
#[derive(Clone, Debug, Default)]
pub(super) struct ChangePointCrossings {
    list: Vec<ChangePointCrossing>,
    /// The group and list index of every crossing, in order.
    by_group: Vec<(usize, usize)>,
    start: f64,
    /// The period in degrees; 0 if coordinates are not reduced.
    period: f64,
}

impl ChangePointCrossings {
    /// Reduces all coordinates to one period, if there is one.
    pub(super) fn of_motion(self, start: f64, period: f64) -> ChangePointCrossings {
        let ChangePointCrossings { mut list, .. } = self;
        for crossing in &mut list {
            crossing.at = reduced(crossing.at, period);
        }
        list.sort_by(|a, b| a.at.total_cmp(&b.at));
        let start = reduced(start, period);
        let mut crossings = ChangePointCrossings {
            list,
            by_group: Vec::new(),
            start,
            period,
        };
        crossings.sort_groups();
        crossings
    }

    /// Rebuilds the index by group.
    fn sort_groups(&mut self) {
        let groups = self.list.iter().enumerate();
        self.by_group.clear();
        self.by_group
            .extend(groups.map(|(i, crossing)| (crossing.group, i)));
        self.by_group.sort_unstable();
    }

    /// Returns the crossings of a group.
    fn of_group(&self, group: usize) -> impl Iterator<Item = &ChangePointCrossing> {
        let first = self.by_group.partition_point(|&(of, _)| of < group);
        let ours = self.by_group[first..].iter();
        let ours = ours.take_while(move |&&(of, _)| of == group);
        ours.map(|&(_, i)| &self.list[i])
    }

    /// Adds the crossings not yet known.
    pub(super) fn add(&mut self, mut crossings: Vec<ChangePointCrossing>) {
        crossings.retain(|new| {
            let mut known = self.of_group(new.group);
            known.all(|old| old.at != new.at)
        });
        self.list.extend(crossings);
        self.sort_groups();
    }

    pub(super) fn len(&self) -> usize {
        self.list.len()
    }

    /// Removes all but the first `kept` crossings.
    pub(super) fn truncate(&mut self, kept: usize) {
        self.list.truncate(kept);
        self.sort_groups();
    }

    /// Removes the crossings at these coordinates.
    pub(super) fn remove(&mut self, is_removed: impl Fn(f64) -> bool) {
        self.list.retain(|crossing| !is_removed(crossing.at));
        self.sort_groups();
    }

    /// Returns the crossings from index `from` on.
    pub(super) fn latest(&mut self, from: usize) -> &mut [ChangePointCrossing] {
        self.list.get_mut(from..).unwrap_or_default()
    }

    /// Returns `true` if a group has a change point within a distance of a coordinate, in radians
    /// or scaled lengths.
    pub(super) fn has(&self, engine: &Engine, (group, at): (usize, f64), within: f64) -> bool {
        let mut ours = self.of_group(group);
        ours.any(|p| engine.difference(p.at, at).abs() <= within)
    }

    /// Returns `true` if a group's assemblies meet within a distance of a coordinate, in radians or
    /// scaled lengths. The coordinates of the crossings are those of one period.
    pub(super) fn has_change(
        &self,
        engine: &Engine,
        (group, at): (usize, f64),
        within: f64,
    ) -> bool {
        let mut changes = self.of_group(group).filter(|p| !p.is_led_through);
        changes.any(|p| {
            let by = p.at - at;
            let turns = if self.period > 0.0 {
                (by / self.period).round()
            } else {
                0.0
            };
            engine.difference(0.0, by - turns * self.period).abs() <= within
        })
    }

    /// Returns the distance of a coordinate from the group's nearest other change point, in radians
    /// or scaled lengths. Returns `None` if there is no other.
    pub(super) fn distance(&self, engine: &Engine, group: usize, at: f64) -> Option<f64> {
        let others = self.of_group(group).filter(|p| p.at != at);
        let away = others.map(|p| engine.difference(p.at, at).abs());
        away.min_by(f64::total_cmp)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Returns the driver's coordinates of the branching change points, each once.
    pub(super) fn coordinates(&self) -> Vec<f64> {
        let branching = self.list.iter().filter(|p| !p.is_led_through);
        let mut at: Vec<f64> = branching.map(|p| p.at).collect();
        at.dedup();
        at
    }

    /// Sets every group's sign at a coordinate: the sign at the start, changed by every crossing in
    /// between.
    pub(super) fn choose(&self, engine: &Engine, at: f64, signs: &mut [f64]) {
        signs.copy_from_slice(&engine.signs);
        for group in self.changed(at) {
            signs[group] = -signs[group];
        }
    }

    /// Returns the groups whose sign changes between the start and a coordinate, once per change.
    pub(super) fn changed(&self, at: f64) -> impl Iterator<Item = usize> {
        let here = reduced(at, self.period);
        let between = move |p: &&ChangePointCrossing| (p.at < here) != (p.at < self.start);
        let turning = self.list.iter().filter(|p| p.is_rotary);
        turning.filter(between).map(|p| p.group)
    }

    /// Returns the crossing of a group whose zone contains a coordinate, with the signed distance
    /// from it. The nearest one counts if there are several.
    pub(super) fn near(
        &self,
        engine: &Engine,
        at: f64,
        group: usize,
    ) -> Option<(&ChangePointCrossing, f64)> {
        let here = reduced(at, self.period);
        let away = self
            .of_group(group)
            .map(|p| (p, self.distance_from_crossing(engine, p, here)));
        away.filter(|(p, dq)| p.holds(*dq))
            .min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
    }

    /// Returns `true` if a series replaces the equations of any group at a coordinate.
    pub(super) fn is_near(&self, engine: &Engine, at: f64) -> bool {
        let here = reduced(at, self.period);
        let mut crossings = self.list.iter();
        crossings.any(|p| p.holds(self.distance_from_crossing(engine, p, here)))
    }

    /// Returns the signed distance from a crossing to a coordinate, across the end of the period if
    /// that is shorter.
    fn distance_from_crossing(
        &self,
        engine: &Engine,
        crossing: &ChangePointCrossing,
        here: f64,
    ) -> f64 {
        let straight = here - crossing.at;
        let around = straight - self.period * straight.signum();
        let shorter = if around.abs() < straight.abs() {
            around
        } else {
            straight
        };
        if shorter.abs() <= EQUALITY_TOLERANCE * crossing.at.abs() {
            return 0.0;
        }
        engine.difference(crossing.rest, shorter)
    }
}

/// Reduces a coordinate to one period, if there is one.
fn reduced(at: f64, period: f64) -> f64 {
    if period > 0.0 {
        positive_remainder(at, period)
    } else {
        at
    }
}

/// Evaluates a series and its first two derivatives at a distance from the change point.
fn eval_series(series: &[Vec2], dq: f64) -> [Vec2; 3] {
    let mut sums = [Vec2::ZERO; 3];
    for (n, &c) in series.iter().enumerate().rev() {
        let n = n as f64;
        // Horner's scheme: each lower power gains another factor dq.
        sums[0] = sums[0] * dq + c;
        if n >= 1.0 {
            sums[1] = sums[1] * dq + c * n;
        }
        if n >= 2.0 {
            sums[2] = sums[2] * dq + c * (n * (n - 1.0));
        }
    }
    sums
}

impl ChangePointCrossing {
    /// Returns `true` if the series holds at a distance from the change point.
    fn holds(&self, dq: f64) -> bool {
        if let Some(bend) = &self.bend {
            return bend.parameter(dq).is_some_and(|by| by.abs() < self.zone);
        }
        let away = dq + self.off_centre;
        // At the end of a table, both summands differ by their rounding.
        let rounding = EQUALITY_TOLERANCE * self.off_centre.abs();
        away.abs() < self.zone && away * self.side >= -rounding
    }

    /// Returns the crossing by the same series of a change point at a distance from its centre,
    /// with the other sign beyond it.
    pub(super) fn turning_at(&self, at: Double, off_centre: f64) -> ChangePointCrossing {
        ChangePointCrossing {
            at: at.hi,
            rest: at.lo,
            is_rotary: true,
            off_centre,
            ..self.clone()
        }
    }

    /// Stores the motion of a group's points and links from a state in series about `at`, which is
    /// singular up to a distance `spread` from it. Returns `None` if too few coefficients are known.
    pub(super) fn new(
        (at, spread): (Double, f64),
        of: (usize, bool),
        outputs: (Vec<PointId>, Vec<LinkId>),
        series: &State<Series>,
    ) -> Option<ChangePointCrossing> {
        let width = WIDTH.max(PAIR_WIDTH * spread);
        ChangePointCrossing::within(width, at, of, outputs, series)
    }

    /// Stores the motion as [`ChangePointCrossing::new`] does, from series along a curve. The
    /// coordinate grows with the square of the distance from the fold, so that the equations need a
    /// wider zone.
    pub(super) fn bent(
        at: Double,
        of: (usize, bool),
        outputs: (Vec<PointId>, Vec<LinkId>),
        series: &State<Series>,
    ) -> Option<ChangePointCrossing> {
        ChangePointCrossing::within(2.0 * WIDTH, at, of, outputs, series)
    }

    fn within(
        width: f64,
        at: Double,
        (group, is_rotary): (usize, bool),
        (points, links): (Vec<PointId>, Vec<LinkId>),
        series: &State<Series>,
    ) -> Option<ChangePointCrossing> {
        let mut known = TERMS;
        let mut kept = |v: Vec2<Series>| {
            known = known.min(v.x.known).min(v.y.known);
            // The remaining coefficients are zero.
            let terms = v.x.known.max(v.y.known);
            let text = v.x.c.iter().zip(&v.y.c).take(terms);
            text.map(|(x, y)| Vec2::new(x.hi, y.hi)).collect::<Taylor>()
        };
        let points = points.into_iter();
        let points: Vec<_> = points
            .map(|p| (p, kept(series.points[p.index()].p)))
            .collect();
        let links = links.into_iter();
        let links: Vec<_> = links
            .map(|l| (l, kept(series.links[l.index()].d)))
            .collect();
        let all = points
            .iter()
            .map(|p| &p.1)
            .chain(links.iter().map(|l| &l.1));
        let zone = zone(all, known, width)?;
        Some(ChangePointCrossing {
            at: at.hi,
            rest: at.lo,
            group,
            is_rotary,
            is_led_through: false,
            zone,
            off_centre: 0.0,
            side: 0.0,
            bend: None,
            points,
            links,
        })
    }

    /// Writes the states of the group's points and links at a distance from the change point.
    pub(super) fn write(&self, dq: f64, state: &mut State) {
        let (by, rates) = match &self.bend {
            None => (dq + self.off_centre, None),
            Some(bend) => {
                let by = bend.parameter(dq).unwrap_or(0.0);
                (by, Some(bend.rates(by)))
            }
        };
        let values = |series: &[Vec2]| {
            let [p, first, second] = eval_series(series, by);
            match rates {
                None => [p, first, second],
                // x' = (dx/dt) / (dq/dt), and its derivative by q in the same manner.
                Some([rate, curvature]) => {
                    let v = first / rate;
                    [p, v, (second - v * curvature) / (rate * rate)]
                }
            }
        };
        for (point, series) in &self.points {
            let [p, v, a] = values(series);
            state.points[point.index()] = PointState { p, v, a };
        }
        for (link, series) in &self.links {
            // d' = w k x d and d'' = a k x d - w^2 d.
            let [d, rate, second] = values(series);
            let length = d.norm();
            let (w, a) = (d.cross(rate), d.cross(second));
            state.links[link.index()] = LinkState {
                d: d / length,
                w,
                a,
            };
        }
    }
}

/// The driver's coordinate along a series whose parameter runs along a curve of the motion: the driver
/// reverses at a fold.
#[derive(Clone, Debug)]
pub(super) struct Bend {
    /// The parameter at the fold; it is 0 at the change point.
    fold: f64,
    /// The sign of the parameter, relative to the fold, on the side of the motion.
    side: f64,
    /// The coordinate at the fold, relative to the change point, in radians or scaled lengths.
    end: f64,
    /// The coefficients of the coordinate about the fold, from the second power on.
    coefficients: Vec<f64>,
}

impl Bend {
    /// Creates the coordinate from its series about the change point. `side` is the sign of the
    /// parameter, relative to the fold, on the side of the motion. Returns `None` if the fold is not
    /// an extreme of the coordinate.
    pub(super) fn new(coordinate: &Series, fold: Double, side: f64) -> Option<Bend> {
        let shifted = coordinate.shifted(fold);
        let shifted = &shifted.c[..coordinate.known];
        let coefficients: Vec<f64> = shifted.get(2..)?.iter().map(|c| c.hi).collect();
        let is_extreme = coefficients.first().is_some_and(|c| c.abs() > 0.0);
        is_extreme.then_some(Bend {
            fold: fold.hi,
            side,
            end: shifted[0].hi,
            coefficients,
        })
    }

    /// Returns `true` if the coordinate has no other extreme within a distance from the fold.
    pub(super) fn is_monotonic(&self, distance: f64) -> bool {
        let terms = self.coefficients.iter().enumerate();
        let mut sizes = terms.map(|(k, c)| c.abs() * (k + 2) as f64 * distance.powi(k as i32));
        let first = sizes.next().unwrap_or(0.0);
        sizes.sum::<f64>() < first
    }

    /// Returns the parameter at a distance of the coordinate from the change point, on the side of
    /// the motion. Returns `None` at the fold, beyond it, and outside every zone.
    ///
    /// The end of the range is a double, which may lie beyond the fold by its rounding. A coordinate
    /// between them is as close to the fold as its mirror image.
    pub(super) fn parameter(&self, dq: f64) -> Option<f64> {
        let first = *self.coefficients.first()?;
        let left = dq - self.end;
        let is_rounded_end = left * first < 0.0 && left.abs() <= FOLD_TOLERANCE;
        let left = if is_rounded_end { -left } else { left };
        let square = left / first;
        // Far away, the coefficients do not represent the coordinate.
        if !(0.0 < square && square < MAX_BENT_WIDTH * MAX_BENT_WIDTH) {
            return None;
        }
        let mut by = square.sqrt().copysign(self.side);
        for _ in 0..INVERSIONS {
            let terms = self.coefficients.iter().enumerate().rev();
            let (value, rate) = terms.fold((0.0, 0.0), |(value, rate), (k, c)| {
                (value * by + c, rate * by + c * (k + 2) as f64)
            });
            let step = (value * by - left / by) / rate;
            by -= step;
            if step.abs() <= INVERTED * by.abs() {
                return Some(self.fold + by);
            }
        }
        None
    }

    /// Returns the first two derivatives of the coordinate by the parameter.
    fn rates(&self, parameter: f64) -> [f64; 2] {
        let by = parameter - self.fold;
        let terms = self.coefficients.iter().enumerate().rev();
        let [rate, curvature] = terms.fold([0.0; 2], |[rate, curvature], (k, c)| {
            let n = (k + 2) as f64;
            [rate * by + c * n, curvature * by + c * (n * (n - 1.0))]
        });
        [rate * by, curvature]
    }
}

/// Returns the distance from the change point, at most `width`, within which `known` coefficients determine the
/// second derivatives: their last two terms must be at most [`MAX_LAST_TERM`]. Returns `None` if there are
/// too few coefficients.
fn zone<'a>(series: impl Iterator<Item = &'a Taylor>, known: usize, width: f64) -> Option<f64> {
    let last = known.checked_sub(1).filter(|&last| last >= 4)?;
    let mut zone = width;
    for taylor in series {
        for n in [last - 1, last] {
            let size = taylor[n].norm() * (n * (n - 1)) as f64;
            let power = 1.0 / (n - 2) as f64;
            zone = zone.min((MAX_LAST_TERM / size).powf(power));
        }
    }
    (zone > 0.0).then_some(zone)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Number;

    /// Returns q = s^2 (s - 1) / 2 + c with s = t - 1e-5. It is 0 at t = 0 and reverses at t = 1e-5.
    fn bent() -> (Bend, impl Fn(f64) -> f64) {
        let fold = Double::exactly(1e-5);
        let s = Series::line(-fold, Double::ONE).cut(8);
        let cubic = s * s * (s - Series::exactly(1.0)) * Series::exactly(0.5);
        let at_zero = cubic.c[0];
        let bend = Bend::new(&(cubic - Series::constant(at_zero)), fold, -1.0).unwrap();
        (bend, move |t: f64| {
            let s = t - 1e-5;
            s * s * (s - 1.0) * 0.5 - at_zero.hi
        })
    }

    #[test]
    fn parameter_is_the_inverse_of_the_coordinate_before_the_fold() {
        let (bend, coordinate) = bent();
        for t in [-1e-2, -1e-4, -1e-5, 0.0, 5e-6, 9.9e-6] {
            let found = bend.parameter(coordinate(t)).unwrap();
            assert!((found - t).abs() < 1e-12, "{t}: {found}");
        }
        assert_eq!(bend.parameter(coordinate(1e-5) + 2e-11), None);
    }

    #[test]
    fn end_rounded_beyond_the_fold_is_as_close_to_it_as_its_mirror_image() {
        let (bend, coordinate) = bent();
        let end = coordinate(1e-5);
        for by in [1e-13, 1e-15] {
            let [before, beyond] = [end - by, end + by].map(|at| bend.parameter(at).unwrap());
            assert!(
                (before - beyond).abs() < 1e-6 * (1e-5 - before),
                "{before} {beyond}"
            );
        }
    }

    #[test]
    fn rates_are_the_derivatives_of_the_coordinate() {
        let (bend, _) = bent();
        for t in [-1e-2, -1e-4, 5e-6] {
            let s = t - 1e-5;
            let [rate, curvature] = bend.rates(t);
            assert!((rate / (1.5 * s * s - s) - 1.0).abs() < 1e-14);
            assert!((curvature / (3.0 * s - 1.0) - 1.0).abs() < 1e-14);
        }
    }
}
