//! Evaluates designs in an optimization, and projects designs onto constraints.

use super::evaluation::FigureSet;
use super::goal::MET;
use super::{DesignFigures, Goal, GoalSense, PlanAxis};
use crate::study::excursion::{EvaluatedFigures, FigurePieces, PlacedBound, PlacedFigure};
use nalgebra::{DMatrix, DVector};

/// Step of differences for derivatives, relative to the range between the bounds.
pub(super) const DIFFERENCE: f64 = 1e-5;
/// Number of steps onto the constraints, and maximum halvings of a step that does not improve.
const STEPS: usize = 12;
const HALVINGS: u32 = 6;
/// Part of the misses that a step may leave before the derivatives are computed again.
const MAX_REMAINING_MISS: f64 = 0.3;
/// The slack below which a constraint is met up to rounding error, relative to its size; and the
/// slack at which a failed step may be due to rounding.
const NOUGHT: f64 = 1e-13;
const ROUNDING_TOLERANCE: f64 = 1e-11;
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
    /// The indices of all constraints.
    all: Vec<usize>,
    /// The indices of the equality constraints, and their figures.
    equal: (Vec<usize>, FigureSet),
    /// The bounds of each number.
    pub(super) ends: Vec<[f64; 2]>,
    pub(super) greatest: bool,
}

/// Selects which figures of a design are evaluated.
#[derive(Clone, Copy, Debug)]
enum EvaluatedPart {
    /// Only equality constraints. The design's value and all other slacks are 0.
    Equalities,
    /// Only equality constraints, at places that are followed from a nearby design. Whether there
    /// are other extrema is not known.
    Locally,
    /// All figures.
    Whole,
}

/// The evaluation of a design.
#[derive(Clone, Debug)]
pub(super) struct EvaluatedDesign {
    pub(super) numbers: Vec<f64>,
    /// The value to minimize: the figure, or its negative for a maximum.
    pub(super) value: f64,
    /// The slack of each constraint; see [`Goal::slack`].
    pub(super) slacks: DVector<f64>,
    pub(super) score: DesignScore,
    /// The places of the evaluated figures; `None` if there are none, or if the design was not
    /// changed in place.
    pub(super) places: Option<Vec<PlacedFigure>>,
}

/// The derivatives of a design's evaluation by its numbers, each relative to the range between its
/// bounds.
#[derive(Clone, Debug)]
pub(super) struct DesignSlopes {
    pub(super) value: DVector<f64>,
    /// One row per constraint.
    pub(super) slacks: DMatrix<f64>,
}

/// The constraints onto which a design is projected.
#[derive(Clone, Copy, Debug)]
pub(super) struct DesignProjection<'a> {
    part: EvaluatedPart,
    /// Inequalities to include in addition to the missed ones; `None` to include no inequality.
    held: Option<&'a [usize]>,
    /// The miss at which the projection ends, relative to the constraints' sizes.
    tolerance: f64,
}

impl DesignProjection<'_> {
    /// Creates a projection onto the equality constraints alone.
    pub(super) fn onto_equalities(tolerance: f64) -> DesignProjection<'static> {
        DesignProjection {
            part: EvaluatedPart::Equalities,
            held: None,
            tolerance,
        }
    }

    /// Creates a projection onto the equality constraints at followed places.
    pub(super) fn locally(tolerance: f64) -> DesignProjection<'static> {
        DesignProjection {
            part: EvaluatedPart::Locally,
            ..DesignProjection::onto_equalities(tolerance)
        }
    }

    /// Creates a projection onto the equality constraints, some inequalities and all missed ones.
    pub(super) fn onto_all(held: &[usize]) -> DesignProjection<'_> {
        DesignProjection {
            part: EvaluatedPart::Whole,
            held: Some(held),
            tolerance: NOUGHT,
        }
    }
}

impl DesignEvaluator {
    /// Creates an evaluator of designs between the axes' bounds. The misses of each constraint are
    /// scaled by the required change.
    pub(super) fn new(
        figures: &DesignFigures,
        constraints: &[Goal],
        axes: &[PlanAxis],
        maximum: bool,
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
        let is_equal = |&i: &usize| constraints[i].sense == GoalSense::Equal;
        let equal: Vec<usize> = (0..constraints.len()).filter(is_equal).collect();
        // The first figure is optimized.
        let of: Vec<usize> = equal.iter().map(|i| i + 1).collect();
        DesignEvaluator {
            constraints: pairs.map(|(goal, value)| goal.from(value)).collect(),
            ends: ends.collect(),
            all: (0..constraints.len()).collect(),
            equal: (equal, figures.set().subset(&of)),
            figures,
            greatest: maximum,
        }
    }

    /// Returns `true` if there are equality constraints.
    pub(super) fn has_equalities(&self) -> bool {
        !self.equal.0.is_empty()
    }

    /// Evaluates a design; `None` if there is no such design, or if a figure is missing.
    pub(super) fn evaluate(&mut self, numbers: Vec<f64>) -> Option<EvaluatedDesign> {
        self.evaluate_part(numbers, EvaluatedPart::Whole)
    }

    /// Evaluates a design by its equality constraints alone.
    pub(super) fn evaluate_equalities(&mut self, numbers: Vec<f64>) -> Option<EvaluatedDesign> {
        self.evaluate_part(numbers, EvaluatedPart::Equalities)
    }

    /// Evaluates the equality constraints of a design at places followed from a nearby one, whose
    /// places of all figures are given. Returns `None` without equality constraints.
    pub(super) fn evaluate_locally(
        &mut self,
        numbers: Vec<f64>,
        places: &[PlacedFigure],
    ) -> Option<EvaluatedDesign> {
        if !self.has_equalities() {
            return None;
        }
        let of = self.equal.0.iter().map(|i| places.get(i + 1).cloned());
        self.evaluate_followed(numbers, of.collect::<Option<_>>()?)
    }

    /// Evaluates the equality constraints at followed places.
    fn evaluate_followed(
        &mut self,
        numbers: Vec<f64>,
        mut places: Vec<PlacedFigure>,
    ) -> Option<EvaluatedDesign> {
        let values = self.figures.follow_places(&mut places, &numbers)?;
        let mut slacks = DVector::zeros(self.constraints.len());
        for (&i, value) in self.equal.0.iter().zip(values) {
            slacks[i] = self.constraints[i].slack(value);
        }
        let mut design = EvaluatedDesign {
            numbers,
            value: 0.0,
            slacks,
            score: NONE,
            places: Some(places),
        };
        design.score = self.score(&design, 0.0);
        Some(design)
    }

    /// Returns `true` if values at some places prove that a design is worse than a score.
    pub(super) fn is_worse_at(
        &mut self,
        places: &[PlacedFigure],
        numbers: &[f64],
        (missed, value): DesignScore,
    ) -> bool {
        let Some(found) = self.figures.placed_values(places, numbers) else {
            return false;
        };
        let proves = |bound: PlacedBound, is_greater_better: bool| match bound {
            PlacedBound::Exact => true,
            PlacedBound::Unknown => false,
            PlacedBound::AtMost => is_greater_better,
            PlacedBound::AtLeast => !is_greater_better,
        };
        let mut known = found.iter().zip(places);
        let best = known
            .next()
            .filter(|(_, placed)| proves(placed.bound, self.greatest));
        let best = best.map_or(f64::NEG_INFINITY, |(best, _)| match self.greatest {
            true => -best,
            false => *best,
        });
        let misses = self.constraints.iter().zip(known);
        let misses = misses.map(|(goal, (value, placed))| match goal.sense {
            GoalSense::Equal => 0.0,
            sense if proves(placed.bound, sense == GoalSense::AtLeast) => {
                (-goal.slack(*value) - MET).max(0.0)
            }
            GoalSense::AtLeast | GoalSense::AtMost => 0.0,
        });
        let misses: f64 = misses.sum();
        let is_worse = misses > missed || (misses == missed && best > value);
        is_worse && self.figures.is_in_place(numbers)
    }

    /// Evaluates the part of a design that a projection needs; `from` is the design that a step
    /// starts from.
    fn evaluate_from(
        &mut self,
        from: &EvaluatedDesign,
        numbers: Vec<f64>,
        part: EvaluatedPart,
    ) -> Option<EvaluatedDesign> {
        match part {
            EvaluatedPart::Locally => self.evaluate_followed(numbers, from.places.clone()?),
            EvaluatedPart::Equalities | EvaluatedPart::Whole => self.evaluate_part(numbers, part),
        }
    }

    /// Evaluates some figures of a design.
    fn evaluate_part(&mut self, numbers: Vec<f64>, part: EvaluatedPart) -> Option<EvaluatedDesign> {
        let design = self.figures.open(&numbers).ok()?;
        let known = |value: Result<f64, _>| value.ok().filter(|value: &f64| value.is_finite());
        let mut slacks = DVector::zeros(self.constraints.len());
        let mut value = 0.0;
        let (of, set) = match part {
            EvaluatedPart::Equalities | EvaluatedPart::Locally => (&self.equal.0, &self.equal.1),
            EvaluatedPart::Whole => (&self.all, self.figures.set()),
        };
        let EvaluatedFigures { values, places } = set.evaluate(&design);
        let mut found = values.into_iter();
        if matches!(part, EvaluatedPart::Whole) {
            let first = known(found.next()?)?;
            value = if self.greatest { -first } else { first };
        }
        for (&i, found) in of.iter().zip(found) {
            slacks[i] = self.constraints[i].slack(known(found)?);
        }
        let mut design = EvaluatedDesign {
            numbers,
            value,
            slacks,
            score: NONE,
            places,
        };
        design.score = self.score(&design, 0.0);
        Some(design)
    }

    /// Returns the score of a design if equality constraints have a tolerance, relative to their
    /// sizes. Rounding errors never count.
    pub(super) fn score(&self, design: &EvaluatedDesign, tolerance: f64) -> DesignScore {
        let slacks = self.constraints.iter().zip(design.slacks.iter());
        let missed = slacks.map(|(goal, &slack)| match goal.sense {
            GoalSense::Equal if slack.abs() <= tolerance.max(MET) => 0.0,
            GoalSense::AtLeast | GoalSense::AtMost if slack >= -MET => 0.0,
            GoalSense::Equal | GoalSense::AtLeast | GoalSense::AtMost => slack.abs(),
        });
        (missed.sum(), design.value)
    }

    /// Projects a design onto constraints by Newton steps, each the shortest possible within the
    /// bounds.
    ///
    /// `slopes` are approximate derivatives of the slacks, if there are any. They are updated by
    /// Broyden's method, and computed again after a step that gains too little. Derivatives at fixed
    /// places are cheap and computed before each step. With new derivatives a step that does not
    /// improve is halved; the projection ends if this is in vain.
    pub(super) fn onto(
        &mut self,
        mut design: EvaluatedDesign,
        slopes: &mut Option<DMatrix<f64>>,
        onto: DesignProjection<'_>,
    ) -> EvaluatedDesign {
        let mut is_new = false;
        for _ in 0..STEPS {
            let rows = self.missed_by(&design, onto.held);
            let missed = norm(&design, &rows);
            if rows.is_empty() || missed <= onto.tolerance {
                break;
            }
            if slopes.is_none() || design.places.is_some() {
                let new = self.slopes_of_part(&design, DIFFERENCE, false, onto.part);
                *slopes = new.map(|new| new.slacks);
                is_new = true;
            }
            let Some(known) = slopes.as_mut() else {
                break;
            };
            let halvings = if is_new { HALVINGS } else { 0 };
            let travel = self.way_onto(&design, known, &rows);
            let better = travel.and_then(|travel| {
                (0..=halvings).find_map(|k| {
                    let part = 0.5_f64.powi(i32::try_from(k).unwrap_or(0));
                    let numbers = self.moved(&design.numbers, &(&travel * part));
                    let there = self.evaluate_from(&design, numbers, onto.part)?;
                    (norm(&there, &rows) < missed).then_some(there)
                })
            });
            let left = better.as_ref().map_or(missed, |there| norm(there, &rows));
            if let Some(there) = better {
                self.update(known, &design, &there);
                design = there;
            } else if is_new {
                break;
            }
            is_new = false;
            if left > MAX_REMAINING_MISS * missed {
                if left <= ROUNDING_TOLERANCE {
                    break;
                }
                *slopes = None;
            }
        }
        design
    }

    /// Changes approximate derivatives of the slacks by as little as possible so that they explain
    /// the change from one design to another (Broyden, 1965).
    fn update(&self, slopes: &mut DMatrix<f64>, from: &EvaluatedDesign, to: &EvaluatedDesign) {
        let travel = self.way_between(&from.numbers, &to.numbers);
        let square = travel.norm_squared();
        if square > 0.0 {
            let unexplained = &to.slacks - &from.slacks - &*slopes * &travel;
            *slopes += unexplained * travel.transpose() / square;
        }
    }

    /// Returns the way from one design to another, relative to the ranges.
    pub(super) fn way_between(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        let each = self.ends.iter().zip(from.iter().zip(to));
        let each = each.map(|([low, high], (from, to))| match high > low {
            true => (to - from) / (high - low),
            false => 0.0,
        });
        DVector::from_iterator(from.len(), each)
    }

    /// Returns the constraints that a design is projected onto.
    fn missed_by(&self, design: &EvaluatedDesign, held: Option<&[usize]>) -> Vec<usize> {
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
        design: &EvaluatedDesign,
        slopes: &DMatrix<f64>,
        rows: &[usize],
    ) -> Option<DVector<f64>> {
        let count = self.ends.len();
        let missed = DVector::from_iterator(rows.len(), rows.iter().map(|&i| design.slacks[i]));
        let mut free = vec![true; count];
        loop {
            let slope = |row: usize, i: usize| match free[i] {
                true => slopes[(rows[row], i)],
                false => 0.0,
            };
            let matrix = DMatrix::from_fn(rows.len(), count, slope);
            if !is_finite(&matrix) {
                return None;
            }
            let parts = matrix.svd(true, true);
            let minimum = SINGULAR * parts.singular_values.max();
            if !(minimum > 0.0) {
                return None;
            }
            let travel = -parts.solve(&missed, minimum).ok()?;
            let leads_out = |&i: &usize| {
                let [low, high] = self.ends[i];
                free[i]
                    && ((design.numbers[i] <= low && travel[i] < 0.0)
                        || (design.numbers[i] >= high && travel[i] > 0.0))
            };
            match (0..count).find(leads_out) {
                Some(i) => free[i] = false,
                None => return Some(travel),
            }
        }
    }

    /// Returns the numbers moved by fractions of their ranges, limited to the bounds.
    pub(super) fn moved(&self, numbers: &[f64], travel: &DVector<f64>) -> Vec<f64> {
        let moved = numbers.iter().zip(&self.ends).zip(travel.iter());
        let moved =
            moved.map(|((v, &[low, high]), travel)| (v + travel * (high - low)).clamp(low, high));
        moved.collect()
    }

    /// Returns the pieces of all figures of a design, if they have any.
    pub(super) fn pieces(&mut self, numbers: &[f64]) -> Option<Vec<FigurePieces>> {
        let design = self.figures.open(numbers).ok()?;
        self.figures.set().pieces(&design)
    }

    /// Returns the derivatives of figures at fixed places by the numbers, relative to the ranges, by
    /// differences with steps of `step` of the range. Returns `None` if a value is missing.
    pub(super) fn slopes_at_places(
        &mut self,
        places: &[PlacedFigure],
        numbers: &[f64],
        step: f64,
    ) -> Option<Vec<Vec<f64>>> {
        let ends = self.difference_ends(numbers, step);
        let mut slopes = self.figures.placed_slopes(places, numbers, &ends)?;
        for slopes in &mut slopes {
            for (slope, [low, high]) in slopes.iter_mut().zip(&self.ends) {
                *slope *= high - low;
            }
        }
        Some(slopes)
    }

    /// Returns the numbers between which differences are taken.
    fn difference_ends(&self, numbers: &[f64], step: f64) -> Vec<[f64; 2]> {
        let ends = numbers.iter().zip(&self.ends);
        let ends = ends.map(|(number, [low, high])| {
            let by = step * (high - low);
            [number - by, number + by].map(|number| number.clamp(*low, *high))
        });
        ends.collect()
    }

    /// Returns the derivatives at fixed places of the motion, if all figures have them: the solver's
    /// own, or differences with steps of `step` of the range.
    fn at_fixed_places(
        &mut self,
        design: &EvaluatedDesign,
        step: f64,
        part: EvaluatedPart,
    ) -> Option<DesignSlopes> {
        let places = design.places.as_ref()?;
        let own = match part {
            // The projection needs no more digits than differences have.
            EvaluatedPart::Equalities | EvaluatedPart::Locally => None,
            EvaluatedPart::Whole => self.figures.exact_slopes(places, &design.numbers),
        };
        let found = own.or_else(|| {
            let ends = self.difference_ends(&design.numbers, step);
            self.figures.placed_slopes(places, &design.numbers, &ends)
        })?;
        let size = |i: usize| self.ends[i][1] - self.ends[i][0];
        let count = self.ends.len();
        let mut slopes = DesignSlopes {
            value: DVector::zeros(count),
            slacks: DMatrix::zeros(self.constraints.len(), count),
        };
        let mut found = found.iter();
        let rows = match part {
            EvaluatedPart::Equalities | EvaluatedPart::Locally => &self.equal.0,
            EvaluatedPart::Whole => {
                let sense = if self.greatest { -1.0 } else { 1.0 };
                let value = found.next()?;
                slopes.value = DVector::from_fn(count, |i, _| sense * value[i] * size(i));
                &self.all
            }
        };
        for (&row, found) in rows.iter().zip(found) {
            for (i, slope) in found.iter().enumerate().take(count) {
                slopes.slacks[(row, i)] = self.constraints[row].slope_of_slack(slope * size(i));
            }
        }
        Some(slopes)
    }

    /// Returns the derivatives at a design: those at fixed places of the motion if every figure has
    /// them, or else differences of whole designs with steps of `part` of the range. The latter are
    /// two-sided with `to_both`, or else one-sided if possible.
    pub(super) fn slopes(
        &mut self,
        design: &EvaluatedDesign,
        part: f64,
        to_both: bool,
    ) -> Option<DesignSlopes> {
        self.slopes_of_part(design, part, to_both, EvaluatedPart::Whole)
    }

    fn slopes_of_part(
        &mut self,
        design: &EvaluatedDesign,
        step: f64,
        to_both: bool,
        part: EvaluatedPart,
    ) -> Option<DesignSlopes> {
        if let Some(slopes) = self.at_fixed_places(design, step, part) {
            return Some(slopes);
        }
        if matches!(part, EvaluatedPart::Locally) {
            return None;
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
            let mut nearby = |by: f64| {
                let mut numbers = design.numbers.clone();
                numbers[i] += by * size;
                let is_within = low <= numbers[i] && numbers[i] <= high;
                is_within
                    .then(|| self.evaluate_part(numbers, part))
                    .flatten()
            };
            let above = nearby(step);
            let below = match to_both || above.is_none() {
                true => nearby(-step),
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
fn norm(design: &EvaluatedDesign, rows: &[usize]) -> f64 {
    let squares = rows.iter().map(|&i| design.slacks[i].powi(2));
    squares.sum::<f64>().sqrt()
}
