//! Finds the extrema of a quantity.

use super::sampler::{FigureSample, MotionSampler, SampledFigure};
use super::{ExtremumPlace, FigurePlace, NoFigure, first_period};
use crate::numeric::{MinimumError, lowest, root, turns};
use crate::solver::Range;

/// The reversal below which an extremum is a rounding error, relative to the stroke; the larger one
/// applies without slopes.
const MIN_REVERSAL: f64 = 1e-9;
const MIN_REVERSAL_BY_VALUES: f64 = 1e-6;
/// The distance from a place without a slope at which a slope is sampled, relative to the stretch.
const SIDE_DISTANCE: f64 = 1e-6;
/// Bisections to find a jump of a slope.
const BISECTIONS: u32 = 60;
/// Bisections of a stretch between two samples.
const HALVINGS: u32 = 10;
/// Maximum sum of the slopes at both ends, relative to the mean slope, for which the cubic counts
/// as monotonic. A sum of 4 is also monotonic for equal slopes (Fritsch and Carlson 1980). At 3 the
/// slope half-way is 3/4 of the mean.
const ONE_WAY: f64 = 3.0;

/// All extrema of a quantity.
pub(super) struct ExtremaSet {
    /// The extrema by coordinate, over one period or including both ends of the range.
    pub(super) places: Vec<ExtremumPlace>,
    pub(super) least: FigurePlace,
    pub(super) greatest: FigurePlace,
}

impl ExtremaSet {
    pub(super) fn find(
        sampler: &mut MotionSampler,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<ExtremaSet, NoFigure> {
        if let Some(at) = sampled.gap() {
            return Err(match sampler.is_pole(column, at, sampled) {
                true => NoFigure::Unbounded(at),
                false => NoFigure::Gap(at),
            });
        }
        sampler.check_for_poles(column, sampled)?;
        sampler.check_for_jumps(column, sampled)?;
        let candidates = match sampler.has_slope(column) {
            true => by_slope(sampler, column, sampled),
            false => by_values(sampler, column, sampled),
        };
        let mut turns = candidates.iter();
        if let Some(turn) = turns.find(|turn| sampler.is_pole(column, turn.at, sampled)) {
            let at = first_period(turn.at, sampler.range());
            return Err(NoFigure::Unbounded(at));
        }
        let candidates: Vec<FigurePlace> = candidates
            .into_iter()
            .filter(|turn| turn.value.is_finite())
            .collect();
        let samples = (0..sampled.at.len()).map(|k| sampled.sample(k).place());
        let seen: Vec<FigurePlace> = samples.chain(candidates.iter().copied()).collect();
        let by_value = |a: &&FigurePlace, b: &&FigurePlace| a.value.total_cmp(&b.value);
        let (minimum, maximum) = (seen.iter().min_by(by_value), seen.iter().max_by(by_value));
        let (Some(&minimum), Some(&maximum)) = (minimum, maximum) else {
            return Err(NoFigure::Stands);
        };
        let undone = match sampler.has_slope(column) {
            true => MIN_REVERSAL,
            false => MIN_REVERSAL_BY_VALUES,
        };
        let finest = undone * (maximum.value - minimum.value);
        let is_periodic = sampled.revolutions(sampler.range(), sampler.cut(column)) == 0.0;
        let mut turnings = ExtremaSet {
            places: match sampler.range() {
                Range::Full { .. } if is_periodic => around(&candidates, finest),
                Range::Full { .. } => candidates.windows(3).filter_map(middle).collect(),
                Range::Limited { .. } => between_ends(sampled, &candidates, finest),
            },
            least: minimum,
            greatest: maximum,
        };
        turnings.find_plateaus(sampler, column, sampled);
        Ok(turnings)
    }
}

impl FigureSample {
    fn place(self) -> FigurePlace {
        FigurePlace {
            at: self.at,
            value: self.value,
        }
    }
}

/// Finds extrema as sign changes of the slope.
fn by_slope(
    sampler: &mut MotionSampler,
    column: usize,
    sampled: &SampledFigure,
) -> Vec<FigurePlace> {
    let mut found = Vec::new();
    let noise = f64::EPSILON * sampler.size(column);
    for k in 1..sampled.at.len() {
        let ends = [sampled.sample(k - 1), sampled.sample(k)];
        find_extrema_between(sampler, column, ends, noise, HALVINGS, &mut found);
    }
    found
}

/// Finds the extrema between two samples.
fn find_extrema_between(
    sampler: &mut MotionSampler,
    column: usize,
    [mut a, mut b]: [FigureSample; 2],
    noise: f64,
    halvings: u32,
    found: &mut Vec<FigurePlace>,
) {
    // At a kink of a formula, or at a pole of a rate, the slope does not exist; it exists next to
    // it.
    let aside = SIDE_DISTANCE * (b.at - a.at);
    for (end, by) in [(&mut a, aside), (&mut b, -aside)] {
        if !end.slope.is_finite() {
            found.push(end.place());
            *end = sampler.sample(column, end.at + by, end.value);
        }
    }
    if !a.slope.is_finite() || !b.slope.is_finite() {
        return;
    }
    if (a.slope < 0.0) != (b.slope < 0.0) {
        let finest = f64::EPSILON * (b.at - a.at);
        let slope = |at| sampler.degree(column, 1, at);
        let level = root((a.at, a.slope), (b.at, b.slope), finest, slope).ok();
        // At a kink of a formula the slope jumps to the other sign.
        let at = level.unwrap_or_else(|| jump(sampler, column, [a, b]));
        let value = sampler.value_near(column, at, a.value);
        found.push(FigurePlace { at, value });
        return;
    }
    if halvings == 0 || is_monotonic([a, b], noise) {
        return;
    }
    let middle = sampler.sample(column, 0.5 * (a.at + b.at), a.value);
    find_extrema_between(sampler, column, [a, middle], noise, halvings - 1, found);
    find_extrema_between(sampler, column, [middle, b], noise, halvings - 1, found);
}

/// Finds the place where a slope changes sign by a jump, to full precision.
fn jump(sampler: &mut MotionSampler, column: usize, [a, b]: [FigureSample; 2]) -> f64 {
    let (mut low, mut high) = (a.at, b.at);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        match sampler.degree(column, 1, middle) {
            Some(slope) if (slope < 0.0) == (a.slope < 0.0) => low = middle,
            Some(_) => high = middle,
            None => return middle,
        }
    }
    0.5 * (low + high)
}

/// Returns `true` if the cubic through two samples is monotonic, with a margin.
fn is_monotonic([a, b]: [FigureSample; 2], noise: f64) -> bool {
    let travel = b.at - a.at;
    let change = b.value - a.value;
    let slopes = (a.slope + b.slope) * travel;
    // Both are as small as rounding errors.
    let is_level = change.abs() + slopes.abs() <= 16.0 * noise;
    is_level || (change * slopes > 0.0 && slopes / change <= ONE_WAY)
}

/// Finds extrema of a quantity without slopes.
fn by_values(
    sampler: &mut MotionSampler,
    column: usize,
    sampled: &SampledFigure,
) -> Vec<FigurePlace> {
    let (at, values) = (&sampled.at, &sampled.by_degree[0]);
    let last = at.len() - 1;
    let size = values
        .iter()
        .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
    let is_periodic = matches!(sampler.range(), Range::Full { .. })
        && (values[last] - values[0]).abs() <= MIN_REVERSAL_BY_VALUES * size;
    let all = turns(values, MIN_REVERSAL_BY_VALUES * size, is_periodic);
    let inner = all.into_iter().filter(|turn| !turn.is_end);
    let mut found: Vec<FigurePlace> = inner
        .map(|turn| {
            let k = turn.sample;
            // At the seam, the previous sample is a period earlier.
            let before = match k {
                0 => sampled.before_first(),
                _ => at[k - 1],
            };
            let after = at.get(k + 1).copied().unwrap_or(at[last]);
            let sense = if turn.is_peak { -1.0 } else { 1.0 };
            let nearby = values[k];
            let f = |at| Some(sense * sampler.value_near(column, at, nearby));
            let first = (at[k], sense * values[k]);
            let found = lowest(f, [before, after], first).unwrap_or_else(MinimumError::best);
            FigurePlace {
                at: found.0,
                value: sense * found.1,
            }
        })
        .collect();
    found.sort_by(|a, b| a.at.total_cmp(&b.at));
    found
}

/// Selects the extrema among the candidates of one period.
fn around(candidates: &[FigurePlace], finest: f64) -> Vec<ExtremumPlace> {
    let Some(first) = candidates.first() else {
        return Vec::new();
    };
    let round = candidates.iter().chain([first]);
    let values: Vec<f64> = round.map(|place| place.value).collect();
    let mut found: Vec<ExtremumPlace> = turns(&values, finest, true)
        .into_iter()
        .map(|turn| ExtremumPlace {
            is_peak: turn.is_peak,
            place: candidates[turn.sample],
            until: None,
            is_limit: false,
        })
        .collect();
    found.sort_by(|a, b| a.place.at.total_cmp(&b.place.at));
    found
}

/// Returns the extremum at the second of three candidates, for a quantity that makes full turns.
fn middle(three: &[FigurePlace]) -> Option<ExtremumPlace> {
    let [before, place, after] = *three else {
        return None;
    };
    let (rise, fall) = (place.value - before.value, place.value - after.value);
    (rise * fall > 0.0).then_some(ExtremumPlace {
        is_peak: rise > 0.0,
        place,
        until: None,
        is_limit: false,
    })
}

/// Selects the extrema among the candidates of a range, and adds both ends, where the driver
/// reverses.
fn between_ends(
    sampled: &SampledFigure,
    candidates: &[FigurePlace],
    finest: f64,
) -> Vec<ExtremumPlace> {
    let last = sampled.at.len() - 1;
    let [low, high] = [0, last].map(|k| sampled.sample(k).place());
    let inner = candidates.iter().copied();
    let all: Vec<FigurePlace> = [low].into_iter().chain(inner).chain([high]).collect();
    let values: Vec<f64> = all.iter().map(|place| place.value).collect();
    let kept = turns(&values, finest, false);
    let kept = kept.into_iter().filter(|turn| {
        let sample = turn.sample;
        0 < sample && sample < all.len() - 1
    });
    let kept: Vec<ExtremumPlace> = kept
        .map(|turn| ExtremumPlace {
            is_peak: turn.is_peak,
            place: all[turn.sample],
            until: None,
            is_limit: false,
        })
        .collect();
    let next_to = |place: FigurePlace, other: Option<&ExtremumPlace>, end: FigurePlace| {
        let other = other.map_or(end.value, |turn| turn.place.value);
        ExtremumPlace {
            is_peak: place.value > other,
            place,
            until: None,
            is_limit: true,
        }
    };
    let first = next_to(low, kept.first(), high);
    let end = next_to(high, kept.last(), low);
    [first].into_iter().chain(kept).chain([end]).collect()
}
