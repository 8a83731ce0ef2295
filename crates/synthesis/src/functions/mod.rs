//! A function of the crank's angle: a link's angle, or a slide's travel, that follows it.
//!
//! The crank A-B stands at `crank_datum + crank_scale x` on A = (0, 0). Of [`Output::Angle`] the link D-C stands at
//! `output_datum + output_scale y` on D = (size, 0), both in degrees from +x, counter-clockwise. Of [`Output::Slide`]
//! the crank is `size` long, the slide goes along +x (its line's angle is 0) on a line that is found, and C's x is
//! `output_datum + output_scale y`.
//!
//! A link may stand opposite to its angle: a negative ratio in Freudenstein's equation is a datum that is turned by 180
//! deg, and the linkage is as good as any. A mirror image of a linkage follows the same function with all angles
//! negative: it is proposed where the scales and datums that are given allow it.
//!
//! ```text
//! wanted         the task in radians and in parts of its size
//! angle, slide   all linkages through as many pairs as there are unknowns, by algebra
//! lines          linear equations with a condition of the third degree
//! trigonometric  zeros of a trigonometric polynomial
//! linkage        the output of a linkage, with derivatives
//! refine         least squares of the output's error
//! search         where scales are free, or pairs are many: from many starts
//! stages         pieces of work on several cores, with one account of what is done
//! fit            datums and scales from where the pins are
//! run            what a proposal makes of every x: the structural error
//! spacing        where to ask a function for pairs
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
#[cfg(test)]
mod tests;
mod trigonometric;
mod wanted;

pub use run::{FunctionRun, GreatestError};
pub use spacing::chebyshev_pairs;

use super::{FunctionTask, Output, Partner, Proposal, Proposals};
use kinematics::Vec2;
use refine::FunctionDesign;
use stages::Stages;
use wanted::WantedFunction;

/// Linkages whose pins nowhere differ by more than this part of the size are one.
const SAME: f64 = 1e-7;
/// Of solutions without number so many values of each free number are tried, by how many are to be fixed.
const FIXED: [usize; 4] = [24, 10, 5, 3];
/// And so many linkages are proposed at the most; algebra finds no more than six.
const MOST: usize = 240;
/// What misses by more than this part of the output's swing, in the root of the mean square, follows its function no more.
pub(super) const USELESS: f64 = 0.1;
/// Fewer pairs say too little.
const FEWEST: usize = 3;

/// What algebra finds.
#[derive(Clone, Debug, Default)]
struct ExactDesigns {
    designs: Vec<FunctionDesign>,
    /// Whether there are no others.
    is_complete: bool,
}

/// The search for linkages of the kind that the output asks for.
#[derive(Clone, Copy, Debug)]
pub struct FunctionSearch<'t> {
    /// What is wanted.
    pub task: &'t FunctionTask,
    /// Threads.
    pub threads: usize,
}

impl FunctionSearch<'_> {
    /// Searches; the better linkages come first. `watch` is told the part that is done, from 0 to 1, and stops by answering
    /// false: what was found until then comes out. The same task gives the same linkages, whatever the threads.
    ///
    /// As many pairs as there are unknowns (three lengths, of a slide two, and every datum and scale that is free) are met
    /// exactly, [`Proposals::is_complete`] where all such linkages were found by algebra: where the crank's scale is given,
    /// and of an angle the output's, too. Of fewer pairs some of the solutions without number are proposed. More are met in
    /// the least squares of the output's error, in several minima; then C is where the linkage has it, not where it was
    /// wanted. Where a scale is free, or pairs are many, the search is from many starts, the same ones at every call.
    ///
    /// Nothing is found, and nothing complete, of fewer than three pairs or of a task that is not sound: a number that is
    /// none, a given scale of 0, a size that is not positive.
    #[must_use]
    pub fn run(&self, watch: &mut dyn FnMut(f64) -> bool) -> Proposals {
        let sound = WantedFunction::of(self.task);
        let Some(wanted) = sound.filter(|wanted| wanted.pairs.len() >= FEWEST) else {
            return Proposals::default();
        };
        let (designs, is_complete) = designs(&wanted, &mut Stages::new(self.threads, watch));
        let thinned = designs.len().div_ceil(MOST).max(1);
        let mut found: Vec<Proposal> = Vec::new();
        for (design, is_exact) in designs.into_iter().step_by(thinned) {
            let Some(proposal) = proposal(&wanted, &design, is_exact, self.task.size) else {
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

/// Designs, of each whether its output is as wanted at every pair, and whether there are no others.
fn designs(
    wanted: &WantedFunction,
    stages: &mut Stages<'_>,
) -> (Vec<(FunctionDesign, bool)>, bool) {
    let missing = wanted.unknowns().saturating_sub(wanted.pairs.len());
    if missing > 0 {
        return (family(wanted, missing, stages), false);
    }
    if wanted.pairs.len() == wanted.unknowns()
        && let Some(exact) = exact(wanted)
    {
        let designs = exact.designs.into_iter().map(|design| (design, true));
        return (designs.collect(), exact.is_complete);
    }
    let designs = search::minima(wanted, stages).into_iter();
    (designs.map(|design| (design, false)).collect(), false)
}

/// Some of the solutions without number: with values for as many free numbers as pairs are missing.
fn family(
    wanted: &WantedFunction,
    missing: usize,
    stages: &mut Stages<'_>,
) -> Vec<(FunctionDesign, bool)> {
    let count = FIXED[(missing - 1).min(FIXED.len() - 1)];
    let mut all = vec![wanted.clone()];
    let frees = search::order(wanted.output)
        .into_iter()
        .filter(|&i| wanted.given[i].is_none());
    for index in frees.take(missing) {
        let values = search::values(wanted, index, count);
        let fixed = all
            .iter()
            .flat_map(|one| values.iter().map(|&value| one.with(index, value)));
        all = fixed.collect();
    }
    // Each of them is searched in one thread.
    let alone = |i: usize| designs(&all[i], &mut Stages::new(1, &mut |_| true)).0;
    let found = stages.each([0.0, 1.0], all.len(), alone);
    found.into_iter().flatten().collect()
}

/// By algebra, where that is known.
fn exact(wanted: &WantedFunction) -> Option<ExactDesigns> {
    match wanted.output {
        Output::Angle => angle::exact(wanted),
        Output::Slide => slide::exact(wanted),
    }
}

/// Every pair as angles of crank and output without the datums that are free, and both scales; where these are given.
fn law_angles(wanted: &WantedFunction) -> Option<(Vec<[f64; 2]>, f64, f64)> {
    let [crank, crank_scale, output, output_scale] = wanted.given;
    let (crank_scale, output_scale) = (crank_scale?, output_scale?);
    let (crank, output) = (crank.unwrap_or(0.0), output.unwrap_or(0.0));
    let pair = |[x, y]: &[f64; 2]| [crank + crank_scale * x, output + output_scale * y];
    Some((
        wanted.pairs.iter().map(pair).collect(),
        crank_scale,
        output_scale,
    ))
}

fn proposal(
    wanted: &WantedFunction,
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
    let places: Option<Vec<[Vec2; 2]>> = wanted.pairs.iter().map(place).collect();
    let partner = match wanted.output {
        Output::Angle => Partner::Rocker(Vec2::new(size, 0.0)),
        Output::Slide => Partner::Slide(0.0),
    };
    Some(Proposal {
        pivot: Vec2::new(0.0, 0.0),
        partner,
        places: places?,
        tracer: None,
    })
}

fn is_same(one: &Proposal, other: &Proposal, task: &FunctionTask) -> bool {
    let pins = one.places.iter().flatten();
    let mut pairs = pins.zip(other.places.iter().flatten());
    pairs.all(|(a, b)| (*a - *b).norm() <= SAME * task.size.max(a.norm()))
}
