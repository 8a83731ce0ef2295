//! Searches for linkages whose tracer passes through any number of points, with the crank's angles
//! given or free.
//!
//! Fitting a linkage of known shape (the ratios of its lengths) to the points is a linear problem.
//! A search therefore has two stages. Differential evolution over the few nonlinear numbers runs
//! from many starts. From the best designs of each start, a descent over all unknowns follows, with
//! exact derivatives. The results are minima, each a different linkage; a search from many starts
//! proves no completeness.
//!
//! ```text
//! task         the path in a frame of its own
//! shape        crank and coupler of a linkage of known ratios
//! linear       its position, rotation, size and tracer, by least squares
//! evolution    from random numbers to a rough linkage
//! descent      from a rough linkage to a minimum
//! order        increasing crank angles, where noise has put points out of order
//! preferences  preferences beside the path
//! distinct     selects minima that are different linkages
//! ```

mod descent;
mod distinct;
mod evolution;
mod linear;
mod order;
mod preferences;
mod shape;
mod task;
#[cfg(test)]
mod tests;

use super::{PathTask, PinConstraint, Preferences, Proposal, Proposals};
use descent::Fit;
use distinct::{Ranked, chosen};
use evolution::{Evolution, SearchTarget};
use kinematics::{angle, parallel};
use shape::LinkageForm;
use task::{GivenPivots, TargetPath};

/// Number of points used by the evolution; the descent uses all.
const ROUGH_POINTS: usize = 36;
/// Number of descents per start, and number of steps of each.
const DESCENTS: usize = 3;
const ROUGH_STEPS: usize = 80;
/// Number of steps of the final descent of the chosen linkages, and of its last stage.
const STEPS: usize = 1500;
const LAST_STEPS: usize = 12;
/// The part of the work done by the starts.
const STARTS_PART: f64 = 0.85;

/// A search for linkages whose tracer passes through points.
#[derive(Clone, Copy, Debug)]
pub struct PathSearch<'a> {
    /// The points of the path.
    pub task: &'a PathTask,
    /// Whether to search for four-bars.
    pub four_bars: bool,
    /// Whether to search for slider-cranks.
    pub slider_cranks: bool,
    /// The preferences: every other round of starts searches for linkages that meet them.
    pub preferences: Preferences,
    /// The seed of the random numbers.
    pub seed: u64,
    /// The number of threads; it changes only the run time.
    pub threads: usize,
    /// The number of starts.
    pub starts: u32,
}

impl PathSearch<'_> {
    /// The default number of starts.
    pub const STARTS: u32 = 128;

    /// Searches for linkages.
    ///
    /// `watch` receives the completed part, from 0 to 1, and stops the search by returning `false`;
    /// the linkages found until then are returned. Equal seeds give equal linkages.
    ///
    /// The result is empty for fewer than two different points, or if a number is not finite.
    #[must_use]
    pub fn run(&self, watch: &mut dyn FnMut(f64) -> bool) -> Proposals {
        let Some(goal) = TargetPath::of(self.task, &self.preferences) else {
            return Proposals::default();
        };
        let targets = self.search_targets(&goal);
        if targets.is_empty() {
            return Proposals::default();
        }
        let rough = goal.thinned(ROUGH_POINTS);
        let starts = usize::try_from(self.starts).unwrap_or(usize::MAX);
        let found = parallel::each(
            starts,
            self.threads,
            || (),
            |(), i| {
                let round = i / targets.len();
                let target = SearchTarget {
                    is_wished: goal.preferences.has_searched_preference() && round % 2 == 1,
                    ..targets[i % targets.len()]
                };
                start(&goal, &rough, target, self.seed, i)
            },
            &mut |part| watch(STARTS_PART * part),
        );
        let rough = chosen(found.into_iter().flatten().collect(), &goal);
        let found = parallel::each(
            rough.len(),
            self.threads,
            || (),
            |(), i| {
                let mut fit = rough[i].fit.clone();
                fit.descend(&goal, STEPS);
                fit.polish(&goal, LAST_STEPS);
                if goal.preferences.ordered {
                    fit.sort_angles(&goal);
                }
                Ranked::of(fit, &goal)
            },
            &mut |part| watch(STARTS_PART + (1.0 - STARTS_PART) * part),
        );
        let found = chosen(found.into_iter().flatten().collect(), &goal);
        Proposals {
            found: found
                .iter()
                .map(|ranked| self.proposal(&ranked.fit, &goal))
                .collect(),
            is_complete: false,
            reason: None,
            curves: Vec::new(),
        }
    }

    /// Returns the kinds of linkage for which successive starts search.
    fn search_targets(&self, target: &TargetPath) -> Vec<SearchTarget> {
        let forms = [
            (self.four_bars, LinkageForm::FourBar),
            (self.slider_cranks, LinkageForm::SliderCrank),
        ];
        let senses: &[f64] = if target.turns.is_some() {
            &[1.0]
        } else {
            &[1.0, -1.0]
        };
        let mut targets = Vec::new();
        for &sense in senses {
            for sign in [1.0, -1.0] {
                for (_, form) in forms.iter().filter(|(is_wanted, _)| *is_wanted) {
                    for held in self.held(target, *form) {
                        targets.push(SearchTarget {
                            form: *form,
                            held,
                            sign,
                            sense,
                            is_wished: false,
                        });
                    }
                }
            }
        }
        targets
    }

    /// Returns the possible assignments of the given pivots to links.
    fn held(&self, target: &TargetPath, form: LinkageForm) -> Vec<GivenPivots> {
        let pivots: Vec<_> = self.task.pivots.iter().map(|&p| target.inside(p)).collect();
        match (pivots[..].as_ref(), form) {
            ([], _) => vec![GivenPivots::Free],
            ([one], LinkageForm::FourBar) => {
                vec![GivenPivots::Crank(*one), GivenPivots::Rocker(*one)]
            }
            ([one], LinkageForm::SliderCrank) => vec![GivenPivots::Crank(*one)],
            ([one, two], LinkageForm::FourBar) if one != two => {
                vec![GivenPivots::Both(*one, *two), GivenPivots::Both(*two, *one)]
            }
            // A slider-crank has one pivot, and no linkage has three.
            _ => Vec::new(),
        }
    }

    /// Converts a linkage to the task's frame; given pivots keep their exact values.
    fn proposal(&self, fit: &Fit, target: &TargetPath) -> Proposal {
        let given = |held| {
            let all = self.task.pivots.iter().copied();
            all.into_iter().find(|&p| target.inside(p) == held)
        };
        let (crank, rocker) = match fit.target.held {
            GivenPivots::Free => (None, None),
            GivenPivots::Crank(a) => (given(a), None),
            GivenPivots::Rocker(d) => (None, given(d)),
            GivenPivots::Both(a, d) => (given(a), given(d)),
        };
        let places = |&degrees: &f64| fit.places(degrees).map(|p| target.outside(p));
        let all: Vec<_> = fit.angles.iter().map(places).collect();
        Proposal {
            pivot: crank.unwrap_or_else(|| target.outside(fit.place.origin)),
            partner: match fit.shape.form {
                LinkageForm::FourBar => {
                    PinConstraint::Rocker(rocker.unwrap_or_else(|| target.outside(fit.far_pivot())))
                }
                LinkageForm::SliderCrank => PinConstraint::Slide(angle::degrees(fit.place.scale)),
            },
            places: all.iter().map(|[b, c, _]| [*b, *c]).collect(),
            tracer: all.first().map(|[_, _, tracer]| *tracer),
        }
    }
}

/// Runs one start and returns its linkages.
fn start(
    goal: &TargetPath,
    rough: &TargetPath,
    target: SearchTarget,
    seed: u64,
    number: usize,
) -> Vec<Ranked> {
    // The golden ratio's bits give every start a different random sequence.
    let seed = seed ^ (number as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let last = Evolution::new(rough, target, seed).run();
    let step = (last.len() / DESCENTS).max(1);
    last.iter()
        .step_by(step)
        .filter_map(|raw| {
            let mut fit = Fit::of(goal, target, raw);
            let starts = fit.descend(goal, ROUGH_STEPS);
            if starts && goal.preferences.ordered {
                fit.sort_angles(goal);
            }
            starts.then(|| Ranked::of(fit, goal)).flatten()
        })
        .collect()
}
