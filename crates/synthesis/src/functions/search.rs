//! Searches by least squares from many starts where algebra does not apply; such a search proves no
//! completeness.
//!
//! A start is a linkage through some of the pairs, or nearly through all of them, found by algebra.
//! Algebra also finds datums. Scales are tried by how far crank and output swing over the pairs. If
//! scales are given and there are many pairs, datums are tried as well. The starts are the same at
//! every call.

use super::refine::FunctionDesign;
use super::stages::Stages;
use super::task::TargetFunction;
use super::{ExactDesigns, MAX_RELATIVE_RMS, exact};
use crate::Output;
use std::f64::consts::{PI, TAU};

/// Ranges of the swing tried for a free scale: for a crank and an output in degrees, for a slide in
/// crank lengths.
const CRANK_SWINGS: [f64; 2] = [30.0, 330.0];
const OUTPUT_SWINGS: [f64; 2] = [4.0, 330.0];
const STROKES: [f64; 2] = [0.4, 2.0];
/// Range of a slide's free output datum, in crank lengths.
const PLACES: [f64; 2] = [1.5, 3.5];
/// Number of swings of each sign, if one scale must be found by trial, or two.
const SWINGS: [usize; 2] = [20, 9];
/// Number of values tried for each free datum if scales are given and no linkage meets all pairs.
/// Algebra weights a pair by more than its miss there, and may start far from the minimum.
const DATUMS: usize = 12;
/// Maximum number of starts followed per combination of tried values.
const MAX_STARTS_PER_CELL: usize = 4;
/// Maximum number of starts followed.
const STARTS: usize = 480;
/// Stages of the descent: number of steps, number of the best designs that continue, and completed
/// part of the work. The numbers of a smooth function are nearly dependent, so that the path to a
/// minimum is long and narrow.
const WAYS: [(usize, usize, f64); 3] = [(100, 160, 0.4), (300, 48, 0.6), (3000, 48, 1.0)];
/// Part of the work completed before the descent.
const PROGRESS_BEFORE_DESCENT: f64 = 0.2;
/// Maximum number of pairs used to reach a minimum. If there are more, a last descent of
/// `LAST_STEPS` steps uses all of them.
const LEADING: usize = 40;
const LAST_STEPS: usize = 60;
/// A design meets every pair if its root mean square is below this fraction of the output's swing.
const EXACT_FIT: f64 = 1e-10;
/// Maximum ratio of the longest length to the shortest. More slender linkages would be found for
/// any function, and are useless.
const MAX_LENGTH_RATIO: f64 = 50.0;
/// Number of subsets of the pairs used for starts.
const SUBSETS: usize = 8;
/// Minima count as one if their numbers differ by less than this relative tolerance.
const EQUALITY_TOLERANCE: f64 = 1e-3;
/// Starts count as one if their numbers differ by less than this relative tolerance.
const NEAR: f64 = 1e-3;

/// Returns the order in which free numbers are fixed: scales first, since algebra does not find
/// them.
pub(super) fn order(output: Output) -> [usize; 4] {
    match output {
        Output::Angle => [1, 3, 0, 2],
        Output::Slide => [1, 0, 3, 2],
    }
}

/// Returns about `count` values at which to fix a number of the law.
pub(super) fn values(target: &TargetFunction, index: usize, count: usize) -> Vec<f64> {
    let span = target.span(index / 2);
    // A geometric sequence.
    let growing = |[low, high]: [f64; 2], count: usize| {
        let parts = count.saturating_sub(1).max(1) as f64;
        (0..count).map(move |k| low * (high / low).powf(k as f64 / parts))
    };
    let both = |swings: [f64; 2], unit: f64| {
        let half = count.div_ceil(2);
        let swings = growing(swings, half).map(|swing| swing * unit);
        swings.flat_map(|swing| [swing, -swing]).collect()
    };
    let turn = PI / 180.0 / span;
    match (index, target.output) {
        (1, _) => both(CRANK_SWINGS, turn),
        (3, Output::Angle) => both(OUTPUT_SWINGS, turn),
        (3, Output::Slide) => both(STROKES, 1.0 / span),
        (2, Output::Slide) => both(PLACES, 1.0),
        // Half a turn: angles beyond it are the same link, opposite to its angle.
        (_, Output::Angle) => (0..count).map(|k| PI * k as f64 / count as f64).collect(),
        (_, Output::Slide) => (0..count).map(|k| TAU * k as f64 / count as f64).collect(),
    }
}

/// Returns the minima in ascending order of their misses.
pub(super) fn minima(target: &TargetFunction, stages: &mut Stages<'_>) -> Vec<FunctionDesign> {
    let leading = target.thinned(LEADING);
    let cells = cells(&leading);
    let starts = stages.each([0.0, PROGRESS_BEFORE_DESCENT], cells.len(), |i| {
        best_starts(&leading, &cells[i])
    });
    let mut starts: Vec<(f64, FunctionDesign)> = starts.into_iter().flatten().collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A start without descent is not a solution.
    starts.truncate(if stages.is_on() { STARTS } else { 0 });
    let mut found: Vec<FunctionDesign> = starts.into_iter().map(|(_, start)| start).collect();
    let mut started = PROGRESS_BEFORE_DESCENT;
    for (number, (steps, kept, done)) in (1..).zip(WAYS) {
        let is_last = number == WAYS.len();
        let follow = |i: usize| {
            let lower = found[i].refined(&leading, steps)?;
            match is_last && leading.pairs.len() < target.pairs.len() {
                true => lower.refined(target, LAST_STEPS),
                false => Some(lower),
            }
        };
        let mut followed = stages.each([started, done], found.len(), follow);
        if !stages.is_on() && number > 1 {
            // After a stop, designs without further descent stay as they are.
            followed.extend(found.into_iter().map(Some));
        }
        found = different(if is_last { target } else { &leading }, followed);
        found.truncate(kept);
        started = done;
    }
    found
}

/// Returns the different useful designs, those with the smallest misses first. Designs that meet
/// every pair are sorted by the ratio of their lengths.
fn different(
    target: &TargetFunction,
    followed: Vec<Option<FunctionDesign>>,
) -> Vec<FunctionDesign> {
    let span = output_span(target);
    let of_use = followed.into_iter().flatten().filter_map(|design| {
        let rms = design
            .rms(target)
            .filter(|rms| *rms <= MAX_RELATIVE_RMS * span)?;
        let ratio = design.linkage.ratio();
        let is_linkage = ratio <= MAX_LENGTH_RATIO && design.law.is_determined_by(target);
        is_linkage.then_some(((rms.max(EXACT_FIT * span), ratio), design))
    });
    let mut ranked: Vec<((f64, f64), FunctionDesign)> = of_use.collect();
    ranked.sort_by(|(a, _), (b, _)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut found: Vec<FunctionDesign> = Vec::new();
    for (_, design) in ranked {
        if !found
            .iter()
            .any(|other| other.is_near(&design, EQUALITY_TOLERANCE))
        {
            found.push(design);
        }
    }
    found
}

/// Returns the output's swing in the unit of the misses.
fn output_span(target: &TargetFunction) -> f64 {
    target.given[3].map_or(1.0, |scale| scale.abs() * target.span(1))
}

/// Returns copies of the task with values for the numbers that algebra does not find.
fn cells(target: &TargetFunction) -> Vec<TargetFunction> {
    // For a slide, algebra cannot find both the crank's datum and a scale without the output's
    // datum.
    let is_hard = target.given[3].is_none() && target.given[2].is_some();
    let is_tried = |index: usize| match target.output {
        Output::Angle => index == 1 || index == 3,
        Output::Slide => index == 1 || (index == 0 && is_hard),
    };
    let free: Vec<usize> = order(target.output)
        .into_iter()
        .filter(|&index| target.given[index].is_none())
        .collect();
    let tried: Vec<usize> = free.iter().copied().filter(|&i| is_tried(i)).collect();
    let count = 2 * SWINGS[usize::from(tried.len() > 1)];
    let mut all = vec![target.clone()];
    for index in &tried {
        all = with_each(&all, *index, &values(target, *index, count));
    }
    if tried.is_empty() && target.pairs.len() > target.unknowns() {
        // For a slide, the output's datum is linear for any datum of the crank.
        let datums = free.iter().filter(|&&index| match target.output {
            Output::Angle => index == 0 || index == 2,
            Output::Slide => index == 0,
        });
        let mut grid = all.clone();
        for index in datums {
            grid = with_each(&grid, *index, &values(target, *index, DATUMS));
        }
        all.extend(grid);
    }
    all
}

/// Combines each of these tasks with each of the values for a number.
fn with_each(all: &[TargetFunction], index: usize, values: &[f64]) -> Vec<TargetFunction> {
    let fixed = all
        .iter()
        .flat_map(|one| values.iter().map(move |&value| one.with(index, value)));
    fixed.collect()
}

/// Returns the starts of a cell with the smallest misses, each with its sum of squares.
fn best_starts(target: &TargetFunction, cell: &TargetFunction) -> Vec<(f64, FunctionDesign)> {
    let mut starts: Vec<(f64, FunctionDesign)> = starts_of(cell)
        .into_iter()
        .map(|design| design.on_the_better_side(target))
        .map(|(design, sum)| (sum, design))
        .filter(|(sum, _)| sum.is_finite())
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    starts.dedup_by(|a, b| a.1.is_near(&b.1, NEAR));
    // A single cell keeps all its starts.
    if target.given != cell.given {
        starts.truncate(MAX_STARTS_PER_CELL);
    }
    starts
}

/// Returns the designs through subsets of the pairs, and nearly through all of them.
fn starts_of(target: &TargetFunction) -> Vec<FunctionDesign> {
    let (needed, count) = (target.unknowns(), target.pairs.len());
    let designs = |target: &TargetFunction| {
        exact(target).map_or_else(Vec::new, |ExactDesigns { designs, .. }| designs)
    };
    let mut all = designs(target);
    if needed < count {
        for subset in subsets(needed, count) {
            all.extend(designs(&target.at(&subset)));
        }
    }
    all
}

/// Returns subsets of `needed` of `count` indices, spaced like Chebyshev's zeros over windows of
/// different widths.
fn subsets(needed: usize, count: usize) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = Vec::new();
    for k in 0..SUBSETS {
        // From the whole range to its two halves.
        let width = 1.0 - 0.5 * (k / 3) as f64 / (SUBSETS / 3) as f64;
        let low = (1.0 - width) * 0.5 * (k % 3) as f64;
        let place = |i: usize| {
            let zero = (1.0 - (PI * (2 * i + 1) as f64 / (2 * needed) as f64).cos()) / 2.0;
            ((low + width * zero) * (count - 1) as f64).round() as usize
        };
        let mut subset: Vec<usize> = (0..needed).map(place).collect();
        // Makes the indices distinct: upwards, then from the end downwards.
        for i in 1..needed {
            subset[i] = subset[i].max(subset[i - 1] + 1);
        }
        for i in (0..needed).rev() {
            subset[i] = subset[i].min(count - (needed - i));
        }
        if !all.contains(&subset) {
            all.push(subset);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subsets_have_distinct_ascending_indices() {
        for needed in 2..6 {
            for count in needed + 1..30 {
                for subset in subsets(needed, count) {
                    assert!(subset.windows(2).all(|two| two[0] < two[1]), "{subset:?}");
                    assert!(subset.len() == needed && subset[needed - 1] < count);
                }
            }
        }
    }
}
