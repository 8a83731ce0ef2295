//! Evaluates designs in an optimization, and projects designs onto constraints.

use super::{DesignFigures, Goal, GoalSense, PlanAxis};
use nalgebra::{DMatrix, DVector};

/// Step of differences for derivatives, relative to the range between the bounds.
pub(super) const DIFFERENCE: f64 = 1e-5;
/// Number of Newton steps onto the constraints, and maximum halvings of a step that does not
/// improve.
const STEPS: usize = 12;
const HALVINGS: u32 = 6;
/// The slack below which a constraint is met up to rounding error, relative to its size.
const NOUGHT: f64 = 1e-13;
/// The relative size below which a singular value counts as zero.
const SINGULAR: f64 = 1e-9;

/// The score of a design, smaller is better: its total miss, then its value. Infinite without a
/// design.
pub(super) type DesignScore = (f64, f64);

pub(super) const NONE: DesignScore = (f64::INFINITY, f64::INFINITY);

/// Evaluates designs. The first figure is optimized, the others belong to the constraints.
#[derive(Clone, Debug)]
pub(super) struct DesignEvaluator {
    pub(super) figures: DesignFigures,
    pub(super) constraints: Vec<Goal>,
    /// The bounds of each number.
    pub(super) ends: Vec<[f64; 2]>,
    pub(super) greatest: bool,
}

/// The evaluation of a design.
#[derive(Clone, Debug)]
pub(super) struct JudgedDesign {
    pub(super) numbers: Vec<f64>,
    /// The value to minimize: the figure, or its negative for a maximum.
    pub(super) value: f64,
    /// The slack of each constraint; see [`Goal::slack`].
    pub(super) slacks: DVector<f64>,
    pub(super) worth: DesignScore,
}

/// The derivatives of a design's evaluation by its numbers, each relative to the range between its
/// bounds.
#[derive(Clone, Debug)]
pub(super) struct DesignSlopes {
    pub(super) value: DVector<f64>,
    /// One row per constraint.
    pub(super) slacks: DMatrix<f64>,
}

impl DesignEvaluator {
    /// Creates an evaluator of designs between the axes' bounds. The misses of each constraint are
    /// scaled by the required change.
    pub(super) fn new(
        figures: &DesignFigures,
        constraints: &[Goal],
        axes: &[PlanAxis],
        greatest: bool,
    ) -> DesignEvaluator {
        let given = figures.space().given();
        let mut figures = figures.clone();
        let values = figures.of(&given).unwrap_or_default();
        let kept = values.into_iter().skip(1).map(Result::ok);
        let pairs = constraints.iter().cloned();
        let pairs = pairs.zip(kept.chain(std::iter::repeat(None)));
        let ends = axes.iter().zip(&given).map(|(axis, given)| {
            let [low, high] = axis.ends.unwrap_or([*given; 2]);
            [low.min(high), low.max(high)]
        });
        DesignEvaluator {
            constraints: pairs.map(|(goal, value)| goal.from(value)).collect(),
            ends: ends.collect(),
            figures,
            greatest,
        }
    }

    /// Evaluates a design; `None` if there is no such design, or if a figure is missing.
    pub(super) fn judge(&mut self, numbers: Vec<f64>) -> Option<JudgedDesign> {
        let found = self.figures.of(&numbers).ok()?;
        let (value, kept) = found.split_first()?;
        let value = value.ok().filter(|value| value.is_finite())?;
        let value = if self.greatest { -value } else { value };
        let (mut missed, mut slacks) = (0.0, Vec::with_capacity(kept.len()));
        for (goal, kept) in self.constraints.iter().zip(kept) {
            let kept = kept.ok().filter(|kept| kept.is_finite())?;
            if !goal.is_met(kept) {
                missed += goal.part(kept).abs();
            }
            slacks.push(goal.slack(kept));
        }
        Some(JudgedDesign {
            numbers,
            value,
            slacks: DVector::from_vec(slacks),
            worth: (missed, value),
        })
    }

    /// Projects a design onto the equality constraints as far as possible; returns it with its
    /// score.
    pub(super) fn settled(&mut self, numbers: Vec<f64>) -> (Vec<f64>, DesignScore) {
        match self.judge(numbers.clone()) {
            Some(design) => {
                let design = self.onto(design, None);
                (design.numbers, design.worth)
            }
            None => (numbers, NONE),
        }
    }

    /// Projects a design onto the equality constraints by Newton steps, each the shortest possible
    /// within the bounds. With `held`, these inequalities and the missed ones are included.
    pub(super) fn onto(
        &mut self,
        mut design: JudgedDesign,
        held: Option<&[usize]>,
    ) -> JudgedDesign {
        for _ in 0..STEPS {
            let rows = self.missed_by(&design, held);
            let missed = norm(&design, &rows);
            if rows.is_empty() || missed <= NOUGHT {
                break;
            }
            let better = self.slopes(&design, DIFFERENCE, false).and_then(|slopes| {
                let way = self.way_onto(&design, &slopes, &rows)?;
                (0..=HALVINGS).find_map(|k| {
                    let part = 0.5_f64.powi(i32::try_from(k).unwrap_or(0));
                    let there = self.judge(self.moved(&design.numbers, &(&way * part)))?;
                    (norm(&there, &rows) < missed).then_some(there)
                })
            });
            match better {
                Some(better) => design = better,
                None => break,
            }
        }
        design
    }

    /// Returns the constraints that a design is projected onto.
    fn missed_by(&self, design: &JudgedDesign, held: Option<&[usize]>) -> Vec<usize> {
        let all = self.constraints.iter().enumerate();
        let is_missed = |i: usize, goal: &Goal| {
            let is_held = |held: &[usize]| design.slacks[i] < 0.0 || held.contains(&i);
            goal.sense == GoalSense::Equal || held.is_some_and(is_held)
        };
        let missed = all.filter(|(i, goal)| is_missed(*i, goal));
        missed.map(|(i, _)| i).collect()
    }

    /// Returns the shortest step that makes some slacks zero, without the numbers that it would
    /// move out of their bounds.
    fn way_onto(
        &self,
        design: &JudgedDesign,
        slopes: &DesignSlopes,
        rows: &[usize],
    ) -> Option<DVector<f64>> {
        let count = self.ends.len();
        let missed = DVector::from_iterator(rows.len(), rows.iter().map(|&i| design.slacks[i]));
        let mut free = vec![true; count];
        loop {
            let slope = |row: usize, i: usize| match free[i] {
                true => slopes.slacks[(rows[row], i)],
                false => 0.0,
            };
            let matrix = DMatrix::from_fn(rows.len(), count, slope);
            if !is_finite(&matrix) {
                return None;
            }
            let parts = matrix.svd(true, true);
            let least = SINGULAR * parts.singular_values.max();
            if !(least > 0.0) {
                return None;
            }
            let way = -parts.solve(&missed, least).ok()?;
            let leads_out = |&i: &usize| {
                let [low, high] = self.ends[i];
                free[i]
                    && ((design.numbers[i] <= low && way[i] < 0.0)
                        || (design.numbers[i] >= high && way[i] > 0.0))
            };
            match (0..count).find(leads_out) {
                Some(i) => free[i] = false,
                None => return Some(way),
            }
        }
    }

    /// Returns the numbers moved by fractions of their ranges, limited to the bounds.
    pub(super) fn moved(&self, numbers: &[f64], way: &DVector<f64>) -> Vec<f64> {
        let moved = numbers.iter().zip(&self.ends).zip(way.iter());
        let moved = moved.map(|((v, &[low, high]), way)| (v + way * (high - low)).clamp(low, high));
        moved.collect()
    }

    fn exact_ones(&mut self, design: &JudgedDesign) -> Option<DesignSlopes> {
        let slopes = self.figures.exact_slopes(&design.numbers)?;
        let size = |i: usize| self.ends[i][1] - self.ends[i][0];
        let (value, slacks) = slopes.split_first()?;
        let sense = if self.greatest { -1.0 } else { 1.0 };
        let count = self.ends.len();
        Some(DesignSlopes {
            value: DVector::from_fn(count, |i, _| sense * value[i] * size(i)),
            slacks: DMatrix::from_fn(self.constraints.len(), count, |k, i| {
                self.constraints[k].slope_of_slack(slacks[k][i] * size(i))
            }),
        })
    }

    /// Returns the derivatives at a design: the solver's own if every figure has them, or else
    /// differences with steps of `part` of the range. The differences are two-sided with `to_both`,
    /// or else one-sided if possible.
    pub(super) fn slopes(
        &mut self,
        design: &JudgedDesign,
        part: f64,
        to_both: bool,
    ) -> Option<DesignSlopes> {
        if let Some(slopes) = self.exact_ones(design) {
            return Some(slopes);
        }
        let count = self.ends.len();
        let mut slopes = DesignSlopes {
            value: DVector::zeros(count),
            slacks: DMatrix::zeros(self.constraints.len(), count),
        };
        for i in 0..count {
            let [low, high] = self.ends[i];
            let size = high - low;
            if size <= 0.0 {
                continue;
            }
            let mut beside = |by: f64| {
                let mut numbers = design.numbers.clone();
                numbers[i] += by * size;
                let is_within = low <= numbers[i] && numbers[i] <= high;
                is_within.then(|| self.judge(numbers)).flatten()
            };
            let above = beside(part);
            let below = match to_both || above.is_none() {
                true => beside(-part),
                false => None,
            };
            let (from, to) = match (&below, &above) {
                (Some(below), Some(above)) => (below, above),
                (None, Some(above)) => (design, above),
                (Some(below), None) => (below, design),
                (None, None) => return None,
            };
            let by = (to.numbers[i] - from.numbers[i]) / size;
            // Bounds this close leave nothing to vary.
            if by == 0.0 {
                continue;
            }
            slopes.value[i] = (to.value - from.value) / by;
            slopes
                .slacks
                .set_column(i, &((&to.slacks - &from.slacks) / by));
        }
        Some(slopes)
    }
}

/// Returns `true` if all elements are finite. The singular value decomposition never ends for other
/// matrices.
pub(super) fn is_finite(matrix: &DMatrix<f64>) -> bool {
    matrix.iter().all(|v| v.is_finite())
}

/// Returns the norm of some constraints' slacks.
fn norm(design: &JudgedDesign, rows: &[usize]) -> f64 {
    let squares = rows.iter().map(|&i| design.slacks[i].powi(2));
    squares.sum::<f64>().sqrt()
}
