//! Where algebra does not reach: least squares from many starts, which proves nothing complete.
//!
//! A start is a linkage through a few of the pairs, or nearly through all, by algebra. Datums are found with it, and scales
//! are tried, by how far crank and output swing over the pairs; where scales are given and pairs are many, datums are tried
//! as well. Starts are the same ones at every call.

use super::refine::FunctionDesign;
use super::stages::Stages;
use super::wanted::WantedFunction;
use super::{ExactDesigns, USELESS, exact};
use crate::Output;
use std::f64::consts::{PI, TAU};

/// From where to where a crank may swing where its scale is free, an output, in degrees, and a slide, in cranks.
const CRANK_SWINGS: [f64; 2] = [30.0, 330.0];
const OUTPUT_SWINGS: [f64; 2] = [4.0, 330.0];
const STROKES: [f64; 2] = [0.4, 2.0];
/// Where a slide's travel may begin, in cranks.
const PLACES: [f64; 2] = [1.5, 3.5];
/// So many swings of each sign are tried where one scale is to be found by trial, and where two are.
const SWINGS: [usize; 2] = [20, 9];
/// Datums of each side that are tried of pairs that no linkage meets, where scales are given: there algebra, which weighs
/// a pair by more than its miss, leads elsewhere.
const DATUMS: usize = 12;
/// Of starts with the same scales so many are followed at the most.
const OF_A_CELL: usize = 4;
/// Starts that are followed at the most.
const STARTS: usize = 480;
/// They go so many steps, and so many of the best go on: of a smooth function the numbers are nearly dependent, and the way
/// to a minimum is long and narrow. Each time so much of the whole is done.
const WAYS: [(usize, usize, f64); 3] = [(100, 160, 0.4), (300, 48, 0.6), (3000, 48, 1.0)];
/// What is done of it before they go.
const BEGUN: f64 = 0.2;
/// Of more pairs than this only so many lead to a minimum, and all of them by so many steps to its bottom.
const LEADING: usize = 40;
const LAST_STEPS: usize = 60;
/// Every pair is met where the rest is this part of the output's swing.
const ROUNDED: f64 = 1e-10;
/// No length is longer than the shortest by more than this factor: it would be found for any function, and no use.
const SLENDER: f64 = 50.0;
/// Subsets of the pairs through which starts go.
const SUBSETS: usize = 8;
/// Minima are one where their numbers differ by less than this part.
const SAME: f64 = 1e-3;
/// And starts, by less than this part.
const NEAR: f64 = 1e-3;

/// In which order numbers are fixed where they are free: scales first, since algebra does not find them.
pub(super) fn order(output: Output) -> [usize; 4] {
    match output {
        Output::Angle => [1, 3, 0, 2],
        Output::Slide => [1, 0, 3, 2],
    }
}

/// Values at which a number of the law may be fixed, about so many.
pub(super) fn values(wanted: &WantedFunction, index: usize, count: usize) -> Vec<f64> {
    let span = wanted.span(index / 2);
    // Each is more than the one before it by the same part.
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
    match (index, wanted.output) {
        (1, _) => both(CRANK_SWINGS, turn),
        (3, Output::Angle) => both(OUTPUT_SWINGS, turn),
        (3, Output::Slide) => both(STROKES, 1.0 / span),
        (2, Output::Slide) => both(PLACES, 1.0),
        // Half a turn: what is beyond is the same link, opposite to its angle.
        (_, Output::Angle) => (0..count).map(|k| PI * k as f64 / count as f64).collect(),
        (_, Output::Slide) => (0..count).map(|k| TAU * k as f64 / count as f64).collect(),
    }
}

/// The minima that were found, the least first.
pub(super) fn minima(wanted: &WantedFunction, stages: &mut Stages<'_>) -> Vec<FunctionDesign> {
    let leading = wanted.thinned(LEADING);
    let cells = cells(&leading);
    let starts = stages.each([0.0, BEGUN], cells.len(), |i| {
        best_starts(&leading, &cells[i])
    });
    let mut starts: Vec<(f64, FunctionDesign)> = starts.into_iter().flatten().collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    // A start alone is no answer.
    starts.truncate(if stages.is_on() { STARTS } else { 0 });
    let mut found: Vec<FunctionDesign> = starts.into_iter().map(|(_, start)| start).collect();
    let mut begun = BEGUN;
    for (number, (steps, kept, done)) in (1..).zip(WAYS) {
        let is_last = number == WAYS.len();
        let follow = |i: usize| {
            let lower = found[i].refined(&leading, steps)?;
            match is_last && leading.pairs.len() < wanted.pairs.len() {
                true => lower.refined(wanted, LAST_STEPS),
                false => Some(lower),
            }
        };
        let mut followed = stages.each([begun, done], found.len(), follow);
        if !stages.is_on() && number > 1 {
            // What was not followed any more is what it was.
            followed.extend(found.into_iter().map(Some));
        }
        found = different(if is_last { wanted } else { &leading }, followed);
        found.truncate(kept);
        begun = done;
    }
    found
}

/// Different designs that are of use, those that miss least first, and of those that meet every pair the ones whose lengths
/// are most alike.
fn different(
    wanted: &WantedFunction,
    followed: Vec<Option<FunctionDesign>>,
) -> Vec<FunctionDesign> {
    let span = output_span(wanted);
    let of_use = followed.into_iter().flatten().filter_map(|design| {
        let rms = design.rms(wanted).filter(|rms| *rms <= USELESS * span)?;
        let ratio = design.linkage.ratio();
        let is_linkage = ratio <= SLENDER && design.law.is_told_by(wanted);
        is_linkage.then_some(((rms.max(ROUNDED * span), ratio), design))
    });
    let mut ranked: Vec<((f64, f64), FunctionDesign)> = of_use.collect();
    ranked.sort_by(|(a, _), (b, _)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut found: Vec<FunctionDesign> = Vec::new();
    for (_, design) in ranked {
        if !found.iter().any(|other| other.is_near(&design, SAME)) {
            found.push(design);
        }
    }
    found
}

/// The swing of the output as misses are counted.
fn output_span(wanted: &WantedFunction) -> f64 {
    wanted.given[3].map_or(1.0, |scale| scale.abs() * wanted.span(1))
}

/// The task with values for the numbers that algebra does not find.
fn cells(wanted: &WantedFunction) -> Vec<WantedFunction> {
    // Of a slide algebra does not find both the crank's datum and a scale without the output's datum.
    let is_hard = wanted.given[3].is_none() && wanted.given[2].is_some();
    let is_tried = |index: usize| match wanted.output {
        Output::Angle => index == 1 || index == 3,
        Output::Slide => index == 1 || (index == 0 && is_hard),
    };
    let free: Vec<usize> = order(wanted.output)
        .into_iter()
        .filter(|&index| wanted.given[index].is_none())
        .collect();
    let tried: Vec<usize> = free.iter().copied().filter(|&i| is_tried(i)).collect();
    let count = 2 * SWINGS[usize::from(tried.len() > 1)];
    let mut all = vec![wanted.clone()];
    for index in &tried {
        all = with_each(&all, *index, &values(wanted, *index, count));
    }
    if tried.is_empty() && wanted.pairs.len() > wanted.unknowns() {
        // Of a slide the output's datum is linear whatever the crank's is.
        let datums = free.iter().filter(|&&index| match wanted.output {
            Output::Angle => index == 0 || index == 2,
            Output::Slide => index == 0,
        });
        let mut grid = all.clone();
        for index in datums {
            grid = with_each(&grid, *index, &values(wanted, *index, DATUMS));
        }
        all.extend(grid);
    }
    all
}

/// Each of these tasks with each of the values for a number.
fn with_each(all: &[WantedFunction], index: usize, values: &[f64]) -> Vec<WantedFunction> {
    let fixed = all
        .iter()
        .flat_map(|one| values.iter().map(move |&value| one.with(index, value)));
    fixed.collect()
}

/// The starts of a cell that miss least, with the sums of their squares.
fn best_starts(wanted: &WantedFunction, cell: &WantedFunction) -> Vec<(f64, FunctionDesign)> {
    let mut starts: Vec<(f64, FunctionDesign)> = starts_of(cell)
        .into_iter()
        .map(|design| design.on_the_better_side(wanted))
        .map(|(design, sum)| (sum, design))
        .filter(|(sum, _)| sum.is_finite())
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    starts.dedup_by(|a, b| a.1.is_near(&b.1, NEAR));
    // Where there is but one cell, all are followed.
    if wanted.given != cell.given {
        starts.truncate(OF_A_CELL);
    }
    starts
}

/// Through subsets of the pairs, and nearly through all of them.
fn starts_of(wanted: &WantedFunction) -> Vec<FunctionDesign> {
    let (needed, count) = (wanted.unknowns(), wanted.pairs.len());
    let designs = |wanted: &WantedFunction| {
        exact(wanted).map_or_else(Vec::new, |ExactDesigns { designs, .. }| designs)
    };
    let mut all = designs(wanted);
    if needed < count {
        for subset in subsets(needed, count) {
            all.extend(designs(&wanted.at(&subset)));
        }
    }
    all
}

/// So many of `count` indices: spread as Chebyshev's zeros over windows of different widths.
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
        // No index twice: upwards, then from the end downwards.
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
    fn a_subset_has_no_pair_twice() {
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
