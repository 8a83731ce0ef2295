//! Linkages whose tracer comes through points, in any number, with the crank's angles given or free.
//!
//! A linkage of known shape (the ratios of its lengths) meets the points by a linear problem. So a search has two stages:
//! differential evolution over the few numbers that are not linear, from many starts, and from the best of each a
//! descent over all unknowns with exact derivatives. What is found are minima, each a linkage of its own; a search with
//! many starts proves nothing complete.
//!
//! ```text
//! wanted     the path in a frame of its own
//! shape      crank and coupler of a linkage of known ratios
//! linear     its place, turning, size and tracer, by least squares
//! evolution  from chance to a rough linkage
//! descent    from a rough linkage to a minimum
//! order      angles of the crank that go one way, where noise has put points out of order
//! wishes     what is wished beside the path
//! distinct   which minima are different linkages
//! ```

mod descent;
mod distinct;
mod evolution;
mod linear;
mod order;
mod shape;
#[cfg(test)]
mod tests;
mod wanted;
mod wishes;

use super::{Partner, PathTask, Proposal, Proposals, Wishes};
use descent::Fit;
use distinct::{Ranked, chosen};
use evolution::{Evolution, Quarry};
use kinematics::{angle, parallel};
use shape::LinkageForm;
use wanted::{HeldPivots, WantedPath};

/// Points that the evolution looks at; the descent looks at all.
const ROUGH_POINTS: usize = 36;
/// How many of a start's designs descend, and by how many steps.
const DESCENTS: usize = 3;
const ROUGH_STEPS: usize = 80;
/// By how many steps those that are chosen are followed to the end.
const STEPS: usize = 1500;
const LAST_STEPS: usize = 12;
/// The part of the work that the starts are.
const STARTS_PART: f64 = 0.85;

/// A search for linkages whose tracer comes through points.
#[derive(Clone, Copy, Debug)]
pub struct PathSearch<'a> {
    /// The points.
    pub task: &'a PathTask,
    /// Whether four-bars are looked for.
    pub four_bars: bool,
    /// Whether slider-cranks are looked for.
    pub slider_cranks: bool,
    /// What is wished beside: every other round of starts looks for linkages that keep it.
    pub wishes: Wishes,
    /// From which chance follows.
    pub seed: u64,
    /// Threads; they change the time alone.
    pub threads: usize,
    /// How many starts are made.
    pub starts: u32,
}

impl PathSearch<'_> {
    /// Starts that are usual.
    pub const STARTS: u32 = 128;

    /// Searches. `watch` is told the part that is done, from 0 to 1, and stops by answering false: what was found until
    /// then comes out. The same seed gives the same linkages.
    ///
    /// Nothing is found for fewer than two different points, and for numbers that are none.
    #[must_use]
    pub fn run(&self, watch: &mut dyn FnMut(f64) -> bool) -> Proposals {
        let Some(wanted) = WantedPath::of(self.task, &self.wishes) else {
            return Proposals::default();
        };
        let quarries = self.quarries(&wanted);
        if quarries.is_empty() {
            return Proposals::default();
        }
        let rough = wanted.thinned(ROUGH_POINTS);
        let starts = usize::try_from(self.starts).unwrap_or(usize::MAX);
        let found = parallel::each(
            starts,
            self.threads,
            || (),
            |(), i| {
                let round = i / quarries.len();
                let quarry = Quarry {
                    is_wished: wanted.wishes.is_any() && round % 2 == 1,
                    ..quarries[i % quarries.len()]
                };
                start(&wanted, &rough, quarry, self.seed, i)
            },
            &mut |part| watch(STARTS_PART * part),
        );
        let rough = chosen(found.into_iter().flatten().collect(), &wanted);
        let found = parallel::each(
            rough.len(),
            self.threads,
            || (),
            |(), i| {
                let mut fit = rough[i].fit.clone();
                fit.descend(&wanted, STEPS);
                fit.polish(&wanted, LAST_STEPS);
                if wanted.wishes.ordered {
                    fit.put_in_order(&wanted);
                }
                Ranked::of(fit, &wanted)
            },
            &mut |part| watch(STARTS_PART + (1.0 - STARTS_PART) * part),
        );
        let found = chosen(found.into_iter().flatten().collect(), &wanted);
        Proposals {
            found: found
                .iter()
                .map(|ranked| self.proposal(&ranked.fit, &wanted))
                .collect(),
            is_complete: false,
            reason: None,
            curves: Vec::new(),
        }
    }

    /// What the starts look for, in turn.
    fn quarries(&self, wanted: &WantedPath) -> Vec<Quarry> {
        let forms = [
            (self.four_bars, LinkageForm::FourBar),
            (self.slider_cranks, LinkageForm::SliderCrank),
        ];
        let senses: &[f64] = if wanted.turns.is_some() {
            &[1.0]
        } else {
            &[1.0, -1.0]
        };
        let mut quarries = Vec::new();
        for &sense in senses {
            for sign in [1.0, -1.0] {
                for (_, form) in forms.iter().filter(|(is_wanted, _)| *is_wanted) {
                    for held in self.held(wanted, *form) {
                        quarries.push(Quarry {
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
        quarries
    }

    /// To which links the pivots that are given may belong.
    fn held(&self, wanted: &WantedPath, form: LinkageForm) -> Vec<HeldPivots> {
        let pivots: Vec<_> = self.task.pivots.iter().map(|&p| wanted.inside(p)).collect();
        match (pivots[..].as_ref(), form) {
            ([], _) => vec![HeldPivots::Free],
            ([one], LinkageForm::FourBar) => {
                vec![HeldPivots::Crank(*one), HeldPivots::Rocker(*one)]
            }
            ([one], LinkageForm::SliderCrank) => vec![HeldPivots::Crank(*one)],
            ([one, two], LinkageForm::FourBar) if one != two => {
                vec![HeldPivots::Both(*one, *two), HeldPivots::Both(*two, *one)]
            }
            // A slider-crank has one pivot, and nothing has three.
            _ => Vec::new(),
        }
    }

    /// A linkage in the frame of the task; what was given is in it as it was given.
    fn proposal(&self, fit: &Fit, wanted: &WantedPath) -> Proposal {
        let given = |held| {
            let all = self.task.pivots.iter().copied();
            all.into_iter().find(|&p| wanted.inside(p) == held)
        };
        let (crank, rocker) = match fit.quarry.held {
            HeldPivots::Free => (None, None),
            HeldPivots::Crank(a) => (given(a), None),
            HeldPivots::Rocker(d) => (None, given(d)),
            HeldPivots::Both(a, d) => (given(a), given(d)),
        };
        let places = |&degrees: &f64| fit.places(degrees).map(|p| wanted.outside(p));
        let all: Vec<_> = fit.angles.iter().map(places).collect();
        Proposal {
            pivot: crank.unwrap_or_else(|| wanted.outside(fit.place.origin)),
            partner: match fit.shape.form {
                LinkageForm::FourBar => {
                    Partner::Rocker(rocker.unwrap_or_else(|| wanted.outside(fit.far_pivot())))
                }
                LinkageForm::SliderCrank => Partner::Slide(angle::degrees(fit.place.scale)),
            },
            places: all.iter().map(|[b, c, _]| [*b, *c]).collect(),
            tracer: all.first().map(|[_, _, tracer]| *tracer),
        }
    }
}

/// What comes of one start.
fn start(
    wanted: &WantedPath,
    rough: &WantedPath,
    quarry: Quarry,
    seed: u64,
    number: usize,
) -> Vec<Ranked> {
    // The golden ratio's bits keep the chances of the starts apart.
    let seed = seed ^ (number as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let last = Evolution::new(rough, quarry, seed).run();
    let step = (last.len() / DESCENTS).max(1);
    last.iter()
        .step_by(step)
        .filter_map(|raw| {
            let mut fit = Fit::of(wanted, quarry, raw);
            let begins = fit.descend(wanted, ROUGH_STEPS);
            if begins && wanted.wishes.ordered {
                fit.put_in_order(wanted);
            }
            begins.then(|| Ranked::of(fit, wanted)).flatten()
        })
        .collect()
}
