//! Finds the best design under constraints by differential evolution (Storn and Price, 1997), which
//! needs no derivatives.
//!
//! The better of two designs is, in this order, the valid one, the one with smaller misses of the
//! constraints, and the one with the better figure (Deb, 2000). Equality constraints define a set
//! without interior, which random designs do not hit, so every design is projected onto them before
//! its evaluation. The places of extrema in the design that it was made from are followed on the way,
//! and often prove that it is worse. The first generation contains the given design and other known
//! ones. A wide generation is projected with a loose tolerance, because its designs differ by much
//! more than that. The best design is polished. Equal seeds give equal designs, for any number of
//! cores.

use super::polish::{Polished, polished};
use super::projection::{DesignEvaluator, DesignProjection, DesignScore, NONE};
use super::{DesignFigures, DesignPlan, Goal, PlanAxis};
use crate::numeric::{SeededRng, mutate};
use crate::parallel;
use crate::study::excursion::PlacedFigure;
use nalgebra::DMatrix;
use std::sync::Arc;

/// Designs per generation for each variable value, and their minimum.
const FOR_EACH: usize = 12;
const MIN_COUNT: usize = 24;
/// The spread of a generation, relative to the bounds, below which the search has converged.
const CONVERGED_SPREAD: f64 = 1e-8;
/// Tolerances of equality constraints, relative to their sizes: that of the first generation, and
/// the smallest one.
const LOOSE: f64 = 1e-3;
const TIGHT: f64 = 1e-11;
/// Part of the tolerance that remains at followed places.
const LOCAL_PART: f64 = 0.1;
/// The change of the best value, relative to its size, that counts as no improvement; the last steps
/// towards an optimum are those of the polish.
const SAME: f64 = 1e-9;
/// The tolerance is multiplied by `TIGHTER` once the spread is below `WIDE` times the tolerance.
const TIGHTER: f64 = 1e-3;
const WIDE: f64 = 100.0;

/// The parameters of an optimization.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OptimiseOrder {
    /// `true` to maximize, `false` to minimize.
    pub greatest: bool,
    /// Maximum number of generations.
    pub generations: u32,
    /// The seed of the random numbers.
    pub seed: u64,
    /// The number of threads.
    pub threads: usize,
}

/// The best design of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct BestDesign {
    /// The numbers.
    pub numbers: Vec<f64>,
    /// The optimized figure.
    pub value: f64,
    /// The total miss of the constraints, relative to their sizes: 0 if all are satisfied.
    pub missed: f64,
    /// The number of generations.
    pub generations: u32,
    /// `true` if the last generation converged to one point.
    pub settled: bool,
    /// `true` if no small step that keeps the constraints improves the design, to first order. At a
    /// kink of the figure, the slopes from all sides decide.
    pub stationary: bool,
}

/// The progress of an optimization.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptimiseState {
    /// The number of generations so far.
    pub generations: u32,
    /// The value of the best design so far; `None` without a design.
    pub best: Option<f64>,
    /// The total miss of its constraints, relative to their sizes: 0 if all are satisfied. In early
    /// generations equality constraints are satisfied up to 0.001.
    pub missed: f64,
}

/// A design of a generation.
#[derive(Clone, Debug)]
struct TrialDesign {
    numbers: Vec<f64>,
    score: DesignScore,
    /// Approximate derivatives of the slacks of the equality constraints.
    slopes: Option<DMatrix<f64>>,
    /// The places of all figures in this design, or in the one that it was made from.
    places: Option<Arc<[PlacedFigure]>>,
}

impl AsRef<[f64]> for TrialDesign {
    fn as_ref(&self) -> &[f64] {
        &self.numbers
    }
}

/// Maximum number of generations without an improvement.
const MAX_REST: u32 = 60;

impl BestDesign {
    /// Finds the best design. The first of `figures` is optimized; the others are those of
    /// `constraints`, in their order. `watch` receives the progress and stops the search by
    /// returning `false`; the best design so far is then returned. Returns `None` if no design was
    /// valid.
    pub fn find(
        figures: &DesignFigures,
        constraints: &[Goal],
        axes: &[PlanAxis],
        order: OptimiseOrder,
        watch: &mut dyn FnMut(OptimiseState) -> bool,
    ) -> Option<BestDesign> {
        BestDesign::find_from(&[], figures, constraints, axes, order, watch)
    }

    /// Finds the best design as [`BestDesign::find`] does. The search starts from `known` designs
    /// too; those outside the bounds are ignored. The result is never worse than one of them.
    pub fn find_from(
        known: &[Vec<f64>],
        figures: &DesignFigures,
        constraints: &[Goal],
        axes: &[PlanAxis],
        order: OptimiseOrder,
        watch: &mut dyn FnMut(OptimiseState) -> bool,
    ) -> Option<BestDesign> {
        let judge = DesignEvaluator::new(figures, constraints, axes, order.greatest);
        let mut is_stopped = false;
        let mut go_on = |generations, best: DesignScore| {
            let value = if order.greatest { -best.1 } else { best.1 };
            let state = OptimiseState {
                generations,
                best: Some(value).filter(|value| value.is_finite()),
                missed: best.0,
            };
            is_stopped = is_stopped || !watch(state);
            !is_stopped
        };
        let mut search = DesignEvolution::new(judge, order);
        search.first_generation(axes, known, &mut |_| go_on(0, NONE))?;
        let mut made = 0;
        let mut is_together = false;
        let (mut last, mut stays) = (NONE, 0);
        while made < order.generations && !is_together && stays < MAX_REST {
            let best = search.best_score();
            if !go_on(made, best) || !search.advance(&mut |_| go_on(made, best)) {
                break;
            }
            made += 1;
            let now = search.best_score();
            // The best value of a generation at a loose tolerance may be worse at the next one.
            let is_same = now.0 == last.0 && (now.1 - last.1).abs() <= SAME * last.1.abs();
            if is_same {
                stays += 1;
            } else {
                (last, stays) = (now, 0);
            }
            let spread = search.spread();
            is_together = spread <= CONVERGED_SPREAD;
            if !search.tighten(spread, &mut |_| go_on(made, now)) {
                break;
            }
        }
        let best = search.best()?.clone();
        let mut judge = search.judge;
        let mut polish = |judge: &mut DesignEvaluator, design| {
            polished(judge, design, order.threads, &mut || {
                go_on(made, best.score)
            })
        };
        let design = judge.evaluate(best.numbers)?;
        let mut polished = polish(&mut judge, design);
        // A design that was better only at a loose tolerance may have replaced a known one.
        for numbers in search.started {
            if let Some(design) = judge.evaluate(numbers)
                && design.score < polished.design.score
            {
                polished = polish(&mut judge, design);
            }
        }
        let Polished {
            design,
            is_stationary,
        } = polished;
        let (missed, value) = design.score;
        Some(BestDesign {
            numbers: design.numbers,
            value: if order.greatest { -value } else { value },
            missed,
            generations: made,
            settled: is_together,
            stationary: is_stationary,
        })
    }
}

/// A generation that evolves.
struct DesignEvolution {
    judge: DesignEvaluator,
    threads: usize,
    seed: u64,
    rng: SeededRng,
    /// The tolerance of equality constraints.
    tolerance: f64,
    bounds: Vec<Option<[f64; 2]>>,
    /// The given design and the known ones within the bounds.
    started: Vec<Vec<f64>>,
    generation: Vec<TrialDesign>,
}

/// A function that receives the completed part of a step and stops it by returning `false`.
type PartWatch<'w> = &'w mut dyn FnMut(f64) -> bool;

impl DesignEvolution {
    fn new(judge: DesignEvaluator, order: OptimiseOrder) -> DesignEvolution {
        DesignEvolution {
            threads: order.threads,
            seed: order.seed,
            rng: SeededRng::new(order.seed ^ 0x5bd1_e995),
            tolerance: if judge.has_equalities() { LOOSE } else { TIGHT },
            bounds: judge.ends.iter().copied().map(Some).collect(),
            started: Vec::new(),
            generation: Vec::new(),
            judge,
        }
    }

    /// Evaluates the first generation: a Latin hypercube, and the given design and the known ones if
    /// they are within the bounds.
    fn first_generation(
        &mut self,
        axes: &[PlanAxis],
        known: &[Vec<f64>],
        watch: PartWatch<'_>,
    ) -> Option<()> {
        let given = self.judge.figures.space().given();
        let count = (FOR_EACH * axes.len()).max(MIN_COUNT);
        let plan = DesignPlan::latin(axes, &given, u32::try_from(count).ok()?, self.seed);
        let started = (0..plan.count()).map(|k| TrialDesign::new(plan.numbers(k)));
        let mut started: Vec<TrialDesign> = started.collect();
        let is_within = |numbers: &&Vec<f64>| {
            let mut ends = numbers.iter().zip(&self.judge.ends);
            ends.all(|(v, [low, high])| low <= v && v <= high)
        };
        let all = std::iter::once(&given).chain(known);
        let own: Vec<Vec<f64>> = all.filter(is_within).cloned().collect();
        for (start, numbers) in started.iter_mut().zip(&own) {
            *start = TrialDesign::new(numbers.clone());
        }
        self.started = own;
        self.generation = self.settled(&started, watch);
        Some(())
    }

    /// Replaces each design by a trial that is at least as good. Returns `false` if the step was
    /// stopped.
    fn advance(&mut self, watch: PartWatch<'_>) -> bool {
        let best = self.best().map(|best| best.numbers.clone());
        let mut trials = Vec::with_capacity(self.generation.len());
        for own in &self.generation {
            let mut trial = own.clone();
            let base = mutate(
                &mut trial.numbers,
                &self.generation,
                best.as_deref(),
                &self.bounds,
                &mut self.rng,
            );
            trial.slopes.clone_from(&self.generation[base].slopes);
            trial.places.clone_from(&self.generation[base].places);
            trials.push(trial);
        }
        let found = self.settled(&trials, watch);
        if found.len() < trials.len() {
            self.generation.extend(found);
            return false;
        }
        for (own, trial) in self.generation.iter_mut().zip(found) {
            if trial.score <= own.score {
                *own = trial;
            }
        }
        true
    }

    /// Reduces the tolerance of equality constraints if the generation is narrow. Returns `false`
    /// if the step was stopped.
    fn tighten(&mut self, spread: f64, watch: PartWatch<'_>) -> bool {
        if spread >= WIDE * self.tolerance || self.tolerance <= TIGHT {
            return true;
        }
        self.tolerance = (TIGHTER * self.tolerance).max(TIGHT);
        let all = self.generation.iter().map(|own| TrialDesign {
            score: NONE,
            ..own.clone()
        });
        let all: Vec<TrialDesign> = all.collect();
        let found = self.settled(&all, watch);
        let is_whole = found.len() == all.len();
        if is_whole {
            self.generation = found;
        }
        is_whole
    }

    /// Projects candidates onto the equality constraints and evaluates them, on several threads. If
    /// it is stopped, returns those finished until then.
    fn settled(&self, candidates: &[TrialDesign], watch: PartWatch<'_>) -> Vec<TrialDesign> {
        let settle = |judge: &mut DesignEvaluator, i: usize| {
            let candidate = candidates[i].clone();
            candidate.settled(judge, self.tolerance)
        };
        let room = || self.judge.clone();
        parallel::each(candidates.len(), self.threads, room, settle, watch)
    }

    /// Returns the best design, the first of several.
    fn best(&self) -> Option<&TrialDesign> {
        let by_worth = |a: &&TrialDesign, b: &&TrialDesign| {
            let order = a.score.partial_cmp(&b.score);
            order.unwrap_or(std::cmp::Ordering::Equal)
        };
        self.generation.iter().min_by(by_worth)
    }

    fn best_score(&self) -> DesignScore {
        self.best().map_or(NONE, |best| best.score)
    }

    /// Returns the largest range of a number in the generation, relative to its bounds and its
    /// size.
    fn spread(&self) -> f64 {
        let spreads = self.judge.ends.iter().enumerate().map(|(i, [from, to])| {
            let numbers = self.generation.iter().map(|design| design.numbers[i]);
            let ends = numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
                [low.min(v), high.max(v)]
            });
            let [low, high] = ends;
            let size = (to - from).max(low.abs().max(high.abs()));
            if high > low { (high - low) / size } else { 0.0 }
        });
        spreads.fold(0.0, f64::max)
    }
}

impl TrialDesign {
    /// Creates a candidate that is as bad as any.
    fn new(numbers: Vec<f64>) -> TrialDesign {
        TrialDesign {
            numbers,
            score: NONE,
            slopes: None,
            places: None,
        }
    }

    /// Projects the candidate onto the equality constraints, and evaluates it. First it follows the
    /// places of the design that it was made from, which takes a few states per step. If these places
    /// or the equality constraints alone make it worse than its present score, nothing else is
    /// evaluated.
    fn settled(self, judge: &mut DesignEvaluator, tolerance: f64) -> TrialDesign {
        let TrialDesign {
            mut numbers,
            score,
            mut slopes,
            places,
        } = self;
        let worse = |numbers: Vec<f64>, missed: f64, slopes, places| TrialDesign {
            numbers,
            score: (missed, f64::INFINITY),
            slopes,
            places,
        };
        if let Some(places) = &places {
            let mut is_near = !judge.has_equalities();
            if let Some(start) = judge.evaluate_locally(numbers.clone(), places) {
                let onto = DesignProjection::locally(LOCAL_PART * tolerance);
                let near = judge.onto(start, &mut None, onto);
                is_near = judge.score(&near, tolerance).0 == 0.0;
                numbers = near.numbers;
            }
            if judge.is_worse_at(places, &numbers, score) {
                return worse(numbers, f64::INFINITY, slopes, Some(Arc::clone(places)));
            }
            // A design that satisfies the equality constraints at all places needs no other steps.
            if is_near && let Some(design) = judge.evaluate(numbers.clone()) {
                let found = judge.score(&design, tolerance);
                if found.0 == 0.0 || !judge.has_equalities() {
                    return TrialDesign {
                        numbers,
                        score: found,
                        slopes,
                        places: design.places.map(Arc::from),
                    };
                }
            }
        }
        if judge.has_equalities() {
            let Some(start) = judge.evaluate_equalities(numbers.clone()) else {
                return TrialDesign::new(numbers);
            };
            let onto = DesignProjection::onto_equalities(tolerance);
            let near = judge.onto(start, &mut slopes, onto);
            numbers.clone_from(&near.numbers);
            let missed = judge.score(&near, tolerance).0;
            if missed > score.0 {
                return worse(numbers, missed, slopes, places);
            }
        }
        match judge.evaluate(numbers.clone()) {
            Some(design) => TrialDesign {
                numbers,
                score: judge.score(&design, tolerance),
                slopes,
                places: design.places.map(Arc::from),
            },
            None => TrialDesign::new(numbers),
        }
    }
}
