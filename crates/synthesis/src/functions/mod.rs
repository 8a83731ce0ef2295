//! Synthesis of functions of the crank's angle: a link's angle, or a slide's travel, follows the
//! crank.
//!
//! The crank A-B is at the angle `crank_datum + crank_scale x` on A = (0, 0). For [`Output::Angle`]
//! the link D-C is at the angle `output_datum + output_scale y` on D = (size, 0), both in degrees
//! from +x, counter-clockwise. For [`Output::Slide`] the crank is `size` long, the slide moves
//! along +x (its line's angle is 0) on a line found by the search, and C's x is `output_datum +
//! output_scale y`.
//!
//! A link may be opposite to its angle: a negative ratio in Freudenstein's equation is a datum
//! turned by 180 deg, and the linkage is as good as any. A mirror image of a linkage follows the
//! same function with all angles negative: it is proposed if the given scales and datums allow it.
//!
//! ```text
//! task           the task in radians and in parts of its size
//! angle, slide   all linkages through as many pairs as there are unknowns, by algebra
//! lines          linear equations with a condition of the third degree
//! trigonometric  zeros of a trigonometric polynomial
//! linkage        the output of a linkage, with derivatives
//! refine         least squares of the output's error
//! search         where scales are free, or pairs are many: from many starts
//! stages         pieces of work on several cores, with one progress count
//! fit            datums and scales from where the pins are
//! run            the structural error of a proposal at every x
//! spacing        the places at which a function is sampled
//! ```

mod angle;
mod fit;
mod lines;
mod linkage;
mod refine;
mod run;
mod search;
mod slide;
mod spacing;
mod stages;
mod task;
#[cfg(test)]
mod tests;
mod trigonometric;

pub use run::{FunctionRun, MaxError};
pub use spacing::chebyshev_pairs;

use super::{FunctionTask, Output, PinConstraint, Proposal, Proposals};
use kinematics::Vec2;
use refine::FunctionDesign;
use stages::Stages;
use task::TargetFunction;

/// Linkages count as one if all their pins differ by less than this fraction of the size.
const EQUALITY_TOLERANCE: f64 = 1e-7;
/// Number of values tried for each free number in a continuous family of solutions, indexed by how
/// many numbers must be fixed, less 1.
const FIXED: [usize; 4] = [24, 10, 5, 3];
/// Maximum number of proposed linkages; algebra finds at most six.
const MAX_COUNT: usize = 240;
/// Maximum root mean square of the misses relative to the output's swing; beyond it, a linkage does
/// not follow its function.
pub(super) const MAX_RELATIVE_RMS: f64 = 0.1;
/// Minimum number of pairs for a search.
const MIN_COUNT: usize = 3;

/// The designs found by algebra.
#[derive(Clone, Debug, Default)]
struct ExactDesigns {
    designs: Vec<FunctionDesign>,
    /// `true` if there are no other designs.
    is_complete: bool,
}

/// The search for linkages of the output's kind.
#[derive(Clone, Copy, Debug)]
pub struct FunctionSearch<'t> {
    /// The task.
    pub task: &'t FunctionTask,
    /// The number of threads.
    pub threads: usize,
}

impl FunctionSearch<'_> {
    /// Searches for linkages and returns them with the best first.
    ///
    /// `watch` receives the completed part, from 0 to 1, and stops the search by returning `false`;
    /// the linkages found until then are returned. Equal tasks give equal linkages for any
    /// number of threads.
    ///
    /// As many pairs as there are unknowns (three lengths, or two for a slide, and every free datum
    /// and scale) are met exactly. [`Proposals::is_complete`] is set if algebra found all such
    /// linkages: this needs a given crank scale and, for an angle, a given output scale. For fewer
    /// pairs, some solutions of the continuous family are proposed. More pairs are met in the least
    /// squares of the output's error, in several minima; then C is at the linkage's output, not at
    /// the wanted one. If a scale is free, or if there are many pairs, the search runs from many
    /// starts, the same ones at every call.
    ///
    /// The result is empty and not complete for fewer than three pairs, or for an unsound task: a
    /// number that is not finite, a given scale of 0, or a size that is not positive.
    #[must_use]
    pub fn run(&self, watch: &mut dyn FnMut(f64) -> bool) -> Proposals {
        let valid = TargetFunction::of(self.task);
        let Some(target) = valid.filter(|target| target.pairs.len() >= MIN_COUNT) else {
            return Proposals::default();
        };
        let (designs, is_complete) = designs(&target, &mut Stages::new(self.threads, watch));
        let thinned = designs.len().div_ceil(MAX_COUNT).max(1);
        let mut found: Vec<Proposal> = Vec::new();
        for (design, is_exact) in designs.into_iter().step_by(thinned) {
            let Some(proposal) = proposal(&target, &design, is_exact, self.task.size) else {
                continue;
            };
            let is_known = |other: &Proposal| is_same(other, &proposal, self.task);
            if !found.iter().any(is_known) {
                found.push(proposal);
            }
        }
        Proposals {
            found,
            is_complete,
            reason: None,
            curves: Vec::new(),
        }
    }
}

/// Returns designs, each with whether its output is as wanted at every pair, and whether these are
/// all.
fn designs(
    target: &TargetFunction,
    stages: &mut Stages<'_>,
) -> (Vec<(FunctionDesign, bool)>, bool) {
    let missing = target.unknowns().saturating_sub(target.pairs.len());
    if missing > 0 {
        return (family(target, missing, stages), false);
    }
    if target.pairs.len() == target.unknowns()
        && let Some(exact) = exact(target)
    {
        let designs = exact.designs.into_iter().map(|design| (design, true));
        return (designs.collect(), exact.is_complete);
    }
    let designs = search::minima(target, stages).into_iter();
    (designs.map(|design| (design, false)).collect(), false)
}

/// Samples a continuous family of solutions: assigns values to as many free numbers as pairs are
/// missing.
fn family(
    target: &TargetFunction,
    missing: usize,
    stages: &mut Stages<'_>,
) -> Vec<(FunctionDesign, bool)> {
    let count = FIXED[(missing - 1).min(FIXED.len() - 1)];
    let mut all = vec![target.clone()];
    let frees = search::order(target.output)
        .into_iter()
        .filter(|&i| target.given[i].is_none());
    for index in frees.take(missing) {
        let values = search::values(target, index, count);
        let fixed = all
            .iter()
            .flat_map(|one| values.iter().map(|&value| one.with(index, value)));
        all = fixed.collect();
    }
    // Each member is searched in one thread.
    let alone = |i: usize| designs(&all[i], &mut Stages::new(1, &mut |_| true)).0;
    let found = stages.each([0.0, 1.0], all.len(), alone);
    found.into_iter().flatten().collect()
}

/// Solves by algebra if possible.
fn exact(target: &TargetFunction) -> Option<ExactDesigns> {
    match target.output {
        Output::Angle => angle::exact(target),
        Output::Slide => slide::exact(target),
    }
}

/// Returns every pair as angles of crank and output, without the free datums, and both scales.
/// Returns `None` if a scale is free.
fn law_angles(target: &TargetFunction) -> Option<(Vec<[f64; 2]>, f64, f64)> {
    let [crank, crank_scale, output, output_scale] = target.given;
    let (crank_scale, output_scale) = (crank_scale?, output_scale?);
    let (crank, output) = (crank.unwrap_or(0.0), output.unwrap_or(0.0));
    let pair = |[x, y]: &[f64; 2]| [crank + crank_scale * x, output + output_scale * y];
    Some((
        target.pairs.iter().map(pair).collect(),
        crank_scale,
        output_scale,
    ))
}

fn proposal(
    target: &TargetFunction,
    design: &FunctionDesign,
    is_exact: bool,
    size: f64,
) -> Option<Proposal> {
    let place = |[x, y]: &[f64; 2]| {
        let at = |[datum, scale]: [f64; 2], value| datum + scale * value;
        let angle = at(design.law.crank, *x);
        let output = if is_exact {
            at(design.law.output, *y)
        } else {
            design.linkage.output(angle, design.side)?
        };
        let pins = [design.linkage.b(angle), design.linkage.c(output)];
        let pins = pins.map(|pin| Vec2::new(pin.x * size, pin.y * size));
        pins.iter().all(|pin| pin.is_finite()).then_some(pins)
    };
    let places: Option<Vec<[Vec2; 2]>> = target.pairs.iter().map(place).collect();
    let constraint = match target.output {
        Output::Angle => PinConstraint::Rocker(Vec2::new(size, 0.0)),
        Output::Slide => PinConstraint::Slide(0.0),
    };
    Some(Proposal {
        pivot: Vec2::new(0.0, 0.0),
        partner: constraint,
        places: places?,
        tracer: None,
    })
}

fn is_same(one: &Proposal, other: &Proposal, task: &FunctionTask) -> bool {
    let pins = one.places.iter().flatten();
    let mut pairs = pins.zip(other.places.iter().flatten());
    pairs.all(|(a, b)| (*a - *b).norm() <= EQUALITY_TOLERANCE * task.size.max(a.norm()))
}
