#![doc = include_str!("../../guide/motion.md")]

mod anchors;
mod change;
mod crossing;
mod ends;
mod group_inputs;
mod junction;
mod limits;
mod proved_ends;
mod stops;
mod tracking;

pub(super) use anchors::{Anchors, positive_remainder};
pub(super) use proved_ends::sign_change;
pub use stops::EndStop;

use super::angle_turn;
use super::change_point::ChangePointCrossings;
use super::engine::Engine;
use super::exact::Exact;
use super::fault::Fault;
use super::plan::GroupId;
use super::workspace::Workspace;
use crate::angle::TURN;
use proved_ends::BoundedEnd;
use tracking::{MAX_RATIO, MAX_SLIDE_TRAVEL, MAX_TURNS, Walker};

/// The range that the driver can cover from the scene's assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Full turns. The motion repeats after `period` degrees, which is 360 or a multiple of it.
    Full {
        /// The period, in degrees.
        period: f64,
    },
    /// Between two limits, in degrees or in the scene's length unit. The range of an unlimited
    /// slide is cut at 64 times the longest length of the scene. The range of a link that never
    /// returns with its followers to the start is cut after 16 turns.
    Limited {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
}

impl Range {
    /// Returns the lower and upper end of the range: the two limits, or 0 and the period.
    #[must_use]
    pub fn ends(self) -> (f64, f64) {
        match self {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        }
    }

    /// Returns the coordinate in the range that the user probably meant by `at`, a coordinate
    /// outside a limited range.
    ///
    /// This is an end of the range if `at` equals it within the rounding of its printed decimals.
    /// If the driver `turns`, it is also the only coordinate in the range that is a whole number of
    /// turns away. Returns `None` if there is no such coordinate or more than one, if `at` lies in
    /// the range, and if the range is full.
    #[must_use]
    pub fn equivalent_in_range(self, at: f64, is_rotary: bool) -> Option<f64> {
        let Range::Limited { low, high } = self else {
            return None;
        };
        let covered = low..=high;
        if covered.contains(&at) {
            return None;
        }
        let written = |end: &f64| (at - end).abs() <= WRITTEN_ROUNDING;
        if let Some(end) = [low, high].into_iter().find(written) {
            return Some(end);
        }
        let first = ((low - at) / TURN).ceil();
        // The quotient is rounded: the turn before may be the first.
        let away = [first - 1.0, first, first + 1.0];
        let places = away.map(|away| at + TURN * away);
        let mut within = places.into_iter().filter(|at| covered.contains(at));
        match (within.next(), within.next()) {
            (Some(place), None) if is_rotary => Some(place),
            _ => None,
        }
    }
}

/// A coordinate where the two assemblies of a group almost meet.
///
/// A change in lengths by the square of the sine, relative to a link, would turn it into a change
/// point or a dead point. The motion keeps its assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearMiss {
    /// The group.
    pub group: GroupId,
    /// The sine of the group's transmission angle at this local minimum.
    pub sine: f64,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

/// An end of the range at which the two assemblies of a group meet, without a proved crossing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeetingAssemblies {
    /// The group.
    pub group: GroupId,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

/// The whole motion of a mechanism, computed once.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The driver's range.
    pub range: Range,
    /// The maximum errors of the lower and upper end of the range, in degrees or in the scene's
    /// length unit. The error is zero for an end not set by a group, and `None` if it is not
    /// proved.
    pub range_bounds: [Option<f64>; 2],
    /// The ends of the range at which the mechanism cannot move further, in degrees or in the
    /// scene's length unit.
    pub dead_points: Vec<f64>,
    /// The stops that end the motion, in the order of their coordinates.
    pub stops: Vec<EndStop>,
    /// The coordinates where two assemblies meet and the motion passes smoothly, within one period.
    pub change_points: Vec<f64>,
    /// The near misses: positions where the motion passes close to a change point or a dead point.
    pub near_misses: Vec<NearMiss>,
    /// The ends of the range at which assemblies meet, without a proved crossing.
    pub meeting_assemblies: Vec<MeetingAssemblies>,
    /// The maximum difference of lengths that count as equal, in the scene's length unit. It is the
    /// rounding error of ground coordinates with 15 digits or more. If all coordinates are shorter,
    /// it is 0: then lengths are equal only if they are exactly equal.
    pub tolerance: f64,
    /// The coordinates of the samples.
    pub(super) samples: Vec<f64>,
    pub(super) anchors: Anchors,
    pub(super) crossings: ChangePointCrossings,
    /// The largest residual of each watched constraint, in the solver's unit.
    pub(super) misfits: Vec<f64>,
    /// The range without stops.
    whole: Range,
    /// The finest resolution of a coordinate.
    finest: f64,
    /// The interval of coordinates that are not close to an end of the range.
    clear: [f64; 2],
    folds: Vec<Folded>,
    stretched: Vec<Stretched>,
}

/// A limit at which a dyad is stretched to the end of its reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretched {
    pub(super) at: f64,
    pub(super) group: usize,
}

/// A limit at which a coupled group folds. Its state is stored because its matrix is singular
/// there.
#[derive(Clone, Debug)]
pub(super) struct Folded {
    pub(super) at: f64,
    pub(super) index: usize,
    pub(super) z: Vec<f64>,
}

/// Maximum distance between the coordinates of a near miss that is found by both walks.
pub(super) const ONE_MISS: f64 = 1e-6;
/// Distance from a change point of a coupled group, in radians or scaled lengths, within which a
/// minimum of its measure is that change point.
pub(super) const CHANGE_POINT_DISTANCE: f64 = 1e-4;
/// Rounding error of a coordinate written with 12 decimals.
const WRITTEN_ROUNDING: f64 = 6e-13;
/// Distance from a dead point, in radians or scaled lengths, within which states are computed in
/// double-double. Doubles lose at least half of their digits there.
const EDGE: f64 = 1e-6;

impl Motion {
    /// Returns `true` if a coordinate is exactly a dead point, that is, equal to a stored end of
    /// the range.
    pub(super) fn is_dead_point(&self, at: f64) -> bool {
        self.dead_points.contains(&at)
    }

    /// Returns `true` if a coordinate lies in the range and is not close to an end of it.
    #[inline]
    pub(super) fn is_clear(&self, at: f64) -> bool {
        self.clear[0] < at && at < self.clear[1]
    }

    /// Returns the group stretched to its limit at a coordinate, if that coordinate is an end of
    /// the range.
    pub(super) fn stretched_at(&self, at: f64) -> Option<usize> {
        let here = self.stretched.iter().find(|s| s.at == at);
        here.map(|stretched| stretched.group)
    }

    /// Returns coordinates at increasing distances inside the nearest end of the range, all further
    /// inside than `at`.
    ///
    /// Within some ulps of a limit, a group's equations consist of rounding errors only, and no
    /// state may be found. If the pivots of equal arms coincide, a distance gives them a direction.
    pub(super) fn drawn_back(&self, at: f64) -> impl Iterator<Item = f64> + use<> {
        let (low, high) = match self.whole {
            Range::Full { .. } => (f64::NEG_INFINITY, f64::INFINITY),
            Range::Limited { low, high } => (low, high),
        };
        let (end, inwards) = if at - low < high - at {
            (low, 1.0)
        } else {
            (high, -1.0)
        };
        let ulp = self.finest.max(f64::EPSILON * end.abs());
        let draws = (0..MAX_DRAWS).map(move |k| end + inwards * ulp * f64::from(k).exp2());
        draws.filter(move |&drawn| (drawn - at) * inwards > 0.0 && low < drawn && drawn < high)
    }

    /// Returns the fold at a coordinate.
    pub(super) fn fold_at(&self, at: f64) -> Option<&Folded> {
        self.folds.iter().find(|fold| fold.at == at)
    }

    /// Returns `true` if the motion from the scene's assembly reaches this coordinate.
    pub(super) fn covers(&self, at: f64) -> bool {
        match self.range {
            Range::Full { .. } => at.is_finite(),
            Range::Limited { low, high } => low <= at && at <= high,
        }
    }
}

/// Maximum number of doublings, starting at one ulp, for the distances in [`Motion::drawn_back`].
const MAX_DRAWS: i32 = 24;

/// Tracks the motion from a solved state at `start`.
///
/// # Errors
/// [`Fault::OverConstrained`] if a watched constraint, which repeats others, stops holding.
pub(super) fn explore<'e>(
    engine: &'e Engine,
    exact: Option<&'e Exact>,
    start: f64,
    state: &Workspace,
) -> Result<Motion, Fault> {
    if let Some(number) = engine.input_faster_than(MAX_RATIO) {
        return Err(Fault::FastInput { number });
    }
    let buffers = |exact: &'e Exact| (exact, exact.state(state.travels.len()));
    let mut state = state.clone();
    engine.measure_coupled(start, &mut state);
    let towards = |sense: f64| Walker {
        engine,
        exact,
        double_double: exact
            .filter(|e| e.decides_more(engine.program.steps.len()))
            .map(buffers),
        state: state.clone(),
        anchors: Anchors::default(),
        seen: Vec::new(),
        peaks: state.measures.clone(),
        start,
        sense,
        crossings: ChangePointCrossings::default(),
        ahead: None,
        singly: None,
        unresolved: None,
        missed: None,
        refused: None,
        corner: None,
        is_at_corner: false,
        resolved: None,
        unproved: Vec::new(),
        meeting_assemblies: Vec::new(),
        samples: Vec::new(),
        misses: Vec::new(),
        misfits: vec![0.0; engine.program.watches.len()],
        folds: Vec::new(),
        stretched: Vec::new(),
        terms: junction::FIRST,
        spare: None,
    };
    let mut walker = towards(1.0);
    walker.check_fit()?;
    let mut up = walker.walk()?.end();
    if up.is_ok_and(|high| high.bound.is_none()) {
        // A change point may be passed from the other side only. The motion then turns fully.
        let mut down = towards(-1.0);
        if let Err(turns) = down.walk()?.end() {
            (walker, up) = (down, Err(turns));
        }
    }
    let (range, period, range_bounds) = match up {
        Err(turns) => {
            let period = angle_turn(turns);
            (Range::Full { period }, period, [Some(0.0); 2])
        }
        Ok(high) => {
            walker.state = state.clone();
            walker.sense = -1.0;
            walker.singly = None;
            let low = walker.walk()?.end();
            let low = low.unwrap_or_else(|turns| BoundedEnd::exact(start - angle_turn(turns)));
            let bounds = [low, high].map(|end| end.bound);
            let [low, high] = [low, high].map(|end| end.at);
            (Range::Limited { low, high }, 0.0, bounds)
        }
    };
    let anchors = walker.anchors.sorted(engine, period);
    let crossings = walker.crossings.of_motion(start, period);
    let dead_points = dead_points(range, engine, start);
    Ok(Motion {
        near_misses: near_misses(walker.misses, range, &crossings, engine),
        meeting_assemblies: walker.meeting_assemblies,
        tolerance: exact.map_or(0.0, |exact| exact.rounding) * engine.frame.scale,
        samples: walker.samples,
        misfits: walker.misfits,
        range,
        range_bounds,
        whole: range,
        stops: Vec::new(),
        clear: clear(range, &dead_points, engine),
        dead_points,
        change_points: crossings.coordinates(),
        anchors,
        crossings,
        finest: engine.finest().max(f64::EPSILON * start.abs()),
        folds: walker.folds,
        stretched: walker.stretched,
    })
}

/// Returns the part of a range that is not close to its dead points.
fn clear(range: Range, dead_points: &[f64], engine: &Engine) -> [f64; 2] {
    let off = |end: f64, inwards: f64| {
        if dead_points.contains(&end) {
            engine.moved(end, inwards * EDGE)
        } else {
            end - inwards * f64::EPSILON * end.abs()
        }
    };
    match range {
        Range::Full { .. } => [f64::NEG_INFINITY, f64::INFINITY],
        Range::Limited { low, high } => [off(low, 1.0), off(high, -1.0)],
    }
}

/// Returns the ends of a range except those at which tracking was merely cut.
fn dead_points(range: Range, engine: &Engine, start: f64) -> Vec<f64> {
    match range {
        Range::Full { .. } => Vec::new(),
        Range::Limited { low, high } => {
            let reach = if engine.is_rotary {
                angle_turn(MAX_TURNS)
            } else {
                MAX_SLIDE_TRAVEL * engine.frame.scale
            };
            let is_cut = |end: f64| (end - start).abs() >= reach;
            [low, high]
                .into_iter()
                .filter(|&end| !is_cut(end) && engine.inwards(end) == 0.0)
                .collect()
        }
    }
}

/// Sorts near misses by coordinate and removes duplicates. Also removes those at an end of the
/// range and directly beside a coupled group's own change point, where a measure drops to its rounding
/// error and only looks like a near miss.
fn near_misses(
    mut misses: Vec<NearMiss>,
    range: Range,
    crossings: &ChangePointCrossings,
    engine: &Engine,
) -> Vec<NearMiss> {
    match range {
        Range::Full { period } => {
            let reduce = |miss: &mut NearMiss| miss.at = positive_remainder(miss.at, period);
            misses.iter_mut().for_each(reduce);
        }
        Range::Limited { low, high } => {
            let is_end = |at: f64, end: f64| engine.difference(at, end).abs() < ONE_MISS;
            misses.retain(|miss| !is_end(miss.at, low) && !is_end(miss.at, high));
        }
    }
    misses.retain(|miss| {
        let group = miss.group.index();
        let is_coupled = engine.program.coupled.iter().any(|c| c.group == group);
        !is_coupled || !crossings.has_change(engine, (group, miss.at), CHANGE_POINT_DISTANCE)
    });
    misses.sort_by(|a, b| a.at.total_cmp(&b.at));
    misses.dedup_by(|a, b| a.group == b.group && (a.at - b.at).abs() < ONE_MISS);
    misses
}
