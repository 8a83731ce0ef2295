//! Finds the best design under constraints by differential evolution (Storn and Price, 1997), which
//! needs no derivatives.
//!
//! The better of two designs is, in this order, the valid one, the one with smaller misses of the
//! constraints, and the one with the better figure (Deb, 2000). Equality constraints define a set
//! without interior, which random designs do not hit, so every design is projected onto them before
//! its evaluation. The best design is polished. Equal seeds give equal designs, for any number of
//! cores.

use super::judge::{DesignEvaluator, DesignScore, NONE};
use super::polish::{Polished, polished};
use super::{DesignFigures, DesignPlan, Goal, PlanAxis};
use crate::numeric::SeededRng;
use crate::parallel;

/// Designs per generation for each variable value, and their minimum.
const FOR_EACH: usize = 12;
const MIN_COUNT: usize = 24;
/// The weight of the difference of two designs in a trial design, and the crossover probability of
/// each number.
const WEIGHT: f64 = 0.7;
const CROSSING: f64 = 0.9;
/// The spread of a generation, relative to the bounds, below which the search has converged.
const TOGETHER: f64 = 1e-10;

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
    /// The best value so far of a design that satisfies the constraints.
    pub best: Option<f64>,
}

/// Maximum number of generations without an improvement.
const MAX_REST: u32 = 60;

fn best_of(worths: &[DesignScore]) -> DesignScore {
    let better = |one, other| if other < one { other } else { one };
    worths.iter().copied().fold(NONE, better)
}

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
        let mut judge = DesignEvaluator::new(figures, constraints, axes, order.greatest);
        let given = figures.space().given();
        let count = (FOR_EACH * axes.len()).max(MIN_COUNT);
        let plan = DesignPlan::latin(axes, &given, u32::try_from(count).ok()?, order.seed);
        let begun: Vec<Vec<f64>> = (0..plan.count()).map(|k| plan.numbers(k)).collect();
        let mut is_stopped = false;
        let mut go_on = |generations, best: DesignScore| {
            let value = if order.greatest { -best.1 } else { best.1 };
            let best = (best.0 == 0.0).then_some(value);
            is_stopped = is_stopped || !watch(OptimiseState { generations, best });
            !is_stopped
        };
        let from_start = &mut |_| go_on(0, NONE);
        let (mut generation, mut worth) = settled_all(&judge, &begun, order.threads, from_start);
        let mut chance = SeededRng::new(order.seed ^ 0x5bd1_e995);
        let mut made = 0;
        let mut settled = false;
        let (mut last, mut stays) = (NONE, 0);
        while made < order.generations && !settled && go_on(made, best_of(&worth)) {
            let trials: Vec<Vec<f64>> = (0..generation.len())
                .map(|i| trial(&generation, i, axes, &mut chance))
                .collect();
            let best = best_of(&worth);
            let meanwhile = &mut |_| go_on(made, best);
            let (trials, found) = settled_all(&judge, &trials, order.threads, meanwhile);
            if found.len() < worth.len() {
                // The search was stopped within a generation.
                generation.extend(trials);
                worth.extend(found);
                break;
            }
            for ((design, worth), (trial, found)) in generation
                .iter_mut()
                .zip(&mut worth)
                .zip(trials.into_iter().zip(found))
            {
                if found <= *worth {
                    (*design, *worth) = (trial, found);
                }
            }
            settled = lie_together(&generation, axes);
            made += 1;
            let now = best_of(&worth);
            stays = if now == last { stays + 1 } else { 0 };
            last = now;
            if stays >= MAX_REST {
                break;
            }
        }
        let best = (0..worth.len()).min_by(|&a, &b| {
            worth[a]
                .partial_cmp(&worth[b])
                .unwrap_or(std::cmp::Ordering::Equal)
        })?;
        let so_far = worth[best];
        let design = judge.judge(generation.swap_remove(best))?;
        let Polished {
            design,
            is_stationary,
        } = polished(&mut judge, design, &mut || go_on(made, so_far));
        let (missed, value) = design.worth;
        Some(BestDesign {
            numbers: design.numbers,
            value: if order.greatest { -value } else { value },
            missed,
            generations: made,
            settled,
            stationary: is_stationary,
        })
    }
}

/// Projects every design onto the equality constraints, on several threads; returns the designs
/// with their scores. If `watch` returns `false`, returns those finished until then.
fn settled_all(
    judge: &DesignEvaluator,
    designs: &[Vec<f64>],
    threads: usize,
    watch: &mut dyn FnMut(f64) -> bool,
) -> (Vec<Vec<f64>>, Vec<DesignScore>) {
    let settle = |judge: &mut DesignEvaluator, i: usize| judge.settled(designs[i].clone());
    let room = || judge.clone();
    let found = parallel::each(designs.len(), threads, room, settle, watch);
    found.into_iter().unzip()
}

/// Returns a design from three others, crossed with the one that it may replace.
fn trial(
    generation: &[Vec<f64>],
    of: usize,
    axes: &[PlanAxis],
    chance: &mut SeededRng,
) -> Vec<f64> {
    let [a, b, c] = three_others(generation.len(), of, chance);
    let own = &generation[of];
    let last = u32::try_from(own.len().saturating_sub(1)).unwrap_or(0);
    let always = chance.between(0, last) as usize;
    (0..own.len())
        .map(|i| {
            let takes_part = i == always || 0.5 * (1.0 + chance.even()) < CROSSING;
            if !takes_part {
                return own[i];
            }
            let number = generation[a][i] + WEIGHT * (generation[b][i] - generation[c][i]);
            let [low, high] = axes[i].ends.unwrap_or([own[i], own[i]]);
            let (low, high) = (low.min(high), low.max(high));
            // Beyond a bound, halfway between the old number and the bound.
            if number < low {
                0.5 * (own[i] + low)
            } else if number > high {
                0.5 * (own[i] + high)
            } else {
                number
            }
        })
        .collect()
}

/// Returns three different numbers below a count of at least four, all different from `of`.
fn three_others(count: usize, of: usize, chance: &mut SeededRng) -> [usize; 3] {
    let last = u32::try_from(count - 1).unwrap_or(u32::MAX);
    let mut others = [of; 3];
    for i in 0..3 {
        loop {
            let other = chance.between(0, last) as usize;
            if other != of && !others[..i].contains(&other) {
                others[i] = other;
                break;
            }
        }
    }
    others
}

fn lie_together(generation: &[Vec<f64>], axes: &[PlanAxis]) -> bool {
    axes.iter().enumerate().all(|(i, axis)| {
        let numbers = generation.iter().map(|design| design[i]);
        let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
            (low.min(v), high.max(v))
        });
        let [from, to] = axis.ends.unwrap_or([low, high]);
        high - low <= TOGETHER * (to - from).abs().max(low.abs().max(high.abs()))
    })
}
