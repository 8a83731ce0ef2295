#![doc = include_str!("../../guide/motion.md")]

mod anchors;
mod change;
mod crossing;
mod ends;
mod junction;
mod limits;
mod proved_ends;
mod stopped;
mod walk;

pub(super) use anchors::{Anchors, positive_remainder};
pub(super) use proved_ends::sign_change;
pub use stopped::EndStop;

use super::angle_turn;
use super::change_point::Passages;
use super::engine::Engine;
use super::exact::Exact;
use super::fault::Fault;
use super::plan::GroupId;
use super::workspace::Workspace;
use crate::angle::TURN;
use proved_ends::BoundedEnd;
use walk::{MAX_TURNS, PUSH_REACH, Walker};

/// The range that the driver can cover from the scene's assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Range {
    /// Full turns; the motion repeats after `period` degrees (360 or a multiple).
    Full {
        /// In degrees.
        period: f64,
    },
    /// Between two limits, in degrees or in the scene's length unit. A slide that could be pushed
    /// without end is cut off at 64 times the longest length of the scene, a link that does not come round with
    /// what follows it after 16 turns.
    Limited {
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
}

impl Range {
    /// Its ends: the limits, or 0 and the period.
    #[must_use]
    pub fn ends(self) -> (f64, f64) {
        match self {
            Range::Full { period } => (0.0, period),
            Range::Limited { low, high } => (low, high),
        }
    }

    /// The place that a person means by a coordinate outside a limited range: the end that it is but for
    /// the decimals it was written with, or where the driver `turns`, the one place in the range that is a
    /// whole number of turns away. `None` where there is no such place, or more than one.
    #[must_use]
    pub fn meant(self, at: f64, turns: bool) -> Option<f64> {
        let Range::Limited { low, high } = self else {
            return None;
        };
        let covered = low..=high;
        if covered.contains(&at) {
            return None;
        }
        let written = |end: &f64| (at - end).abs() <= WRITTEN;
        if let Some(end) = [low, high].into_iter().find(written) {
            return Some(end);
        }
        let first = ((low - at) / TURN).ceil();
        // The quotient rounds: the turn before may be the first.
        let away = [first - 1.0, first, first + 1.0];
        let places = away.map(|away| at + TURN * away);
        let mut within = places.into_iter().filter(|at| covered.contains(at));
        match (within.next(), within.next()) {
            (Some(place), None) if turns => Some(place),
            _ => None,
        }
    }
}

/// Where the two assemblies of a group all but meet: lengths that differ by the square of the sine, as
/// a part of a link, would make it a change point or a dead point. The motion keeps its assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearMiss {
    /// The group.
    pub group: GroupId,
    /// The sine of its transmission angle, the smallest there is around.
    pub sine: f64,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

/// An end of the range at which the two assemblies of a group meet, and a passage is not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinedUp {
    /// The group.
    pub group: GroupId,
    /// The driver's coordinate, in degrees or the scene's length unit.
    pub at: f64,
}

/// The whole motion of a mechanism, found once.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The driver's range.
    pub range: Range,
    /// The error of the lower and the upper end of the range at most, in degrees or in the scene's length unit:
    /// zero for an end that no group sets, `None` for one whose error is not proved.
    pub range_bounds: [Option<f64>; 2],
    /// The ends of the range at which the mechanism cannot go on, in degrees or in the scene's length
    /// unit: there are two, or none.
    pub dead_points: Vec<f64>,
    /// The stops at the ends of the range, in order: those that end the motion.
    pub stops: Vec<EndStop>,
    /// Where two assemblies meet and the motion passes smoothly, within one period.
    pub change_points: Vec<f64>,
    /// Where the motion comes close to a change point or a dead point, and passes by.
    pub near_misses: Vec<NearMiss>,
    /// The ends of the range at which assemblies meet, and a passage is not proved.
    pub lined_up: Vec<LinedUp>,
    /// By how much lengths may differ that count as equal, where a ground point has coordinates of 15
    /// digits or more: what these have been rounded by, in the scene's length unit. 0 where all are
    /// shorter: lengths are equal, then, or they are not.
    pub tolerance: f64,
    /// The coordinates at which the walk has been.
    pub(super) samples: Vec<f64>,
    pub(super) anchors: Anchors,
    pub(super) passages: Passages,
    /// How far each watched constraint was from holding at the most, in the solver's unit.
    pub(super) misfits: Vec<f64>,
    /// The range that there would be without stops.
    whole: Range,
    /// The rounding of a coordinate.
    finest: f64,
    /// Between these no end of the range is near.
    clear: [f64; 2],
    folds: Vec<Folded>,
    stretched: Vec<Stretched>,
}

/// A limit at which a dyad is stretched.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretched {
    pub(super) at: f64,
    pub(super) group: usize,
}

/// A limit at which a coupled group folds: its own matrix is singular there, so that its state is kept.
#[derive(Clone, Debug)]
pub(super) struct Folded {
    pub(super) at: f64,
    pub(super) index: usize,
    pub(super) z: Vec<f64>,
}

/// Two walks find a near miss twice, with this between the coordinates at the most.
pub(super) const ONE_MISS: f64 = 1e-6;
/// What is lost of a coordinate that is written with 12 decimals.
const WRITTEN: f64 = 6e-13;
/// This near to a dead point doubles lose half of their digits and more, in radians or scaled lengths:
/// there states are found in twice the digits.
const EDGE: f64 = 1e-6;

impl Motion {
    /// Whether a coordinate is a dead point: what is named as the end of the range is.
    pub(super) fn is_dead_point(&self, at: f64) -> bool {
        self.dead_points.contains(&at)
    }

    /// Whether a coordinate lies in the range, and no end of it is near.
    #[inline]
    pub(super) fn is_clear(&self, at: f64) -> bool {
        self.clear[0] < at && at < self.clear[1]
    }

    /// The group that is stretched to its limit at a coordinate, if that is an end of the range.
    pub(super) fn stretched_at(&self, at: f64) -> Option<usize> {
        let here = self.stretched.iter().find(|s| s.at == at);
        here.map(|stretched| stretched.group)
    }

    /// Coordinates further and further inside the range, if this one is close to an end of it: some ulps
    /// from a limit all that is left of a group's equations is rounding, and a state may not be found. Where the
    /// pivots of equal arms meet, a distance gives them a direction.
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

    /// The fold at a coordinate.
    pub(super) fn fold_at(&self, at: f64) -> Option<&Folded> {
        self.folds.iter().find(|fold| fold.at == at)
    }

    /// Whether the motion from the scene's assembly comes to this coordinate.
    pub(super) fn covers(&self, at: f64) -> bool {
        match self.range {
            Range::Full { .. } => at.is_finite(),
            Range::Limited { low, high } => low <= at && at <= high,
        }
    }
}

/// Doublings from one ulp by which a coordinate is drawn back from the end of a range, at the most.
const MAX_DRAWS: i32 = 24;

/// Follows the motion from a solved state at `start`.
///
/// # Errors
/// [`Fault::OverConstrained`] where a constraint that was set aside stops holding.
pub(super) fn explore<'e>(
    engine: &'e Engine,
    exact: Option<&'e Exact>,
    start: f64,
    state: &Workspace,
) -> Result<Motion, Fault> {
    let room = |exact: &'e Exact| (exact, exact.state(state.travels.len()));
    let mut walker = Walker {
        engine,
        exact,
        closely: exact
            .filter(|e| e.tells(engine.program.steps.len()))
            .map(room),
        state: state.clone(),
        anchors: Anchors::default(),
        seen: Vec::new(),
        peaks: state.measures.clone(),
        start,
        sense: 1.0,
        passages: Passages::default(),
        ahead: None,
        unproved: Vec::new(),
        lined_up: Vec::new(),
        samples: Vec::new(),
        misses: Vec::new(),
        misfits: vec![0.0; engine.program.watches.len()],
        folds: Vec::new(),
        stretched: Vec::new(),
        terms: junction::FIRST,
    };
    walker.check_fit()?;
    let up = walker.walk()?;
    let (range, period, range_bounds) = match up.end() {
        Err(turns) => {
            let period = angle_turn(turns);
            (Range::Full { period }, period, [Some(0.0); 2])
        }
        Ok(high) => {
            walker.state = state.clone();
            walker.sense = -1.0;
            let low = walker.walk()?.end();
            let low = low.unwrap_or_else(|turns| BoundedEnd::exact(start - angle_turn(turns)));
            let bounds = [low, high].map(|end| end.bound);
            let [low, high] = [low, high].map(|end| end.at);
            (Range::Limited { low, high }, 0.0, bounds)
        }
    };
    let anchors = walker.anchors.sorted(engine, period);
    let passages = walker.passages.of_motion(start, period);
    let dead_points = dead_points(range, engine, start);
    Ok(Motion {
        near_misses: near_misses(walker.misses, range, engine),
        lined_up: walker.lined_up,
        tolerance: exact.map_or(0.0, |exact| exact.rounding) * engine.frame.scale,
        samples: walker.samples,
        misfits: walker.misfits,
        range,
        range_bounds,
        whole: range,
        stops: Vec::new(),
        clear: clear(range, &dead_points, engine),
        dead_points,
        change_points: passages.coordinates(),
        anchors,
        passages,
        finest: engine.finest().max(f64::EPSILON * start.abs()),
        folds: walker.folds,
        stretched: walker.stretched,
    })
}

/// A range without what is near to its dead points.
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

/// The ends of a range, but for those at which the motion was merely followed no further.
fn dead_points(range: Range, engine: &Engine, start: f64) -> Vec<f64> {
    match range {
        Range::Full { .. } => Vec::new(),
        Range::Limited { low, high } => {
            let reach = if engine.turns {
                angle_turn(MAX_TURNS)
            } else {
                PUSH_REACH * engine.frame.scale
            };
            let is_cut = |end: f64| (end - start).abs() >= reach;
            [low, high]
                .into_iter()
                .filter(|&end| !is_cut(end))
                .collect()
        }
    }
}

/// Each near miss once, by its coordinate. What looks like one at an end of the range is the end: close
/// to it a measure comes down to its rounding.
fn near_misses(mut misses: Vec<NearMiss>, range: Range, engine: &Engine) -> Vec<NearMiss> {
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
    misses.sort_by(|a, b| a.at.total_cmp(&b.at));
    misses.dedup_by(|a, b| a.group == b.group && (a.at - b.at).abs() < ONE_MISS);
    misses
}
