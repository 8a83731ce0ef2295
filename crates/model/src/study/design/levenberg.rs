//! The Levenberg-Marquardt method: from one start to numbers with minimum misses.
//!
//! Residuals are the goals' misses relative to their sizes; those of met inequalities are zero.
//! Derivatives are the solver's own if figures are columns at some places and each number sets one
//! length. The others are differences of values that are accurate to their last digits. Steps of 1e-5 leave eight digits,
//! enough for Newton's convergence in the last steps. Damping keeps each step short, so that the
//! search finds a solution near its start.

use super::projection::is_finite;
use super::{GoalSearch, GoalSense};
use crate::numeric::DampedSearch;
use crate::study::NoFigure;
use crate::study::excursion::EvaluatedFigures;
use nalgebra::{DMatrix, DVector};

/// Step of differences for derivatives, relative to a number's size.
const DIFFERENCE: f64 = 1e-5;
/// The measure is the norm of the misses.
const SEARCH: DampedSearch = DampedSearch {
    steps: 80,
    growth: 8.0,
    max_damping: 1e12,
    min_gain: f64::EPSILON,
    level_steps: 1,
    ..DampedSearch::DEFAULT
};
/// The relative size below which a singular value counts as zero; differences are more accurate
/// than that.
const RANK: f64 = 1e-6;

/// A point of a search.
pub(super) struct Place {
    pub(super) numbers: Vec<f64>,
    pub(super) misses: DVector<f64>,
}

impl GoalSearch {
    fn misses_of(&self, figures: &[Result<f64, NoFigure>]) -> Option<DVector<f64>> {
        let all = self
            .goals
            .iter()
            .zip(figures)
            .map(|(goal, value)| Some(goal.part(value.ok()?)));
        let all: Option<Vec<f64>> = all.collect();
        all.map(DVector::from_vec)
    }

    fn misses(&mut self, numbers: &[f64]) -> Option<DVector<f64>> {
        let figures = self.figures.of(numbers).ok()?;
        self.misses_of(&figures)
    }

    /// Evaluates numbers; `None` if they are not a design, or lack a figure.
    pub(super) fn place(&mut self, numbers: Vec<f64>) -> Option<Place> {
        let misses = self.misses(&numbers)?;
        Some(Place { numbers, misses })
    }

    /// Searches from a start until no step improves.
    pub(super) fn search(&mut self, start: Vec<f64>) -> Option<Place> {
        let mut place = self.place(start)?;
        let mut slopes = None;
        SEARCH.run(place.misses.norm(), |damping| {
            let slopes_here = slopes.get_or_insert_with(|| self.slopes(&place));
            let better = self.step(&place, slopes_here.as_ref()?, damping)?;
            let norm = better.misses.norm();
            (norm < place.misses.norm()).then(|| {
                (place, slopes) = (better, None);
                norm
            })
        });
        Some(place)
    }

    /// Returns the place after a damped step.
    fn step(&mut self, place: &Place, slopes: &DMatrix<f64>, damping: f64) -> Option<Place> {
        let mut square = slopes.tr_mul(slopes);
        let pull = slopes.tr_mul(&place.misses);
        let size = square.diagonal().max().max(f64::MIN_POSITIVE);
        for i in 0..square.nrows() {
            square[(i, i)] += damping * size;
        }
        let travel = square.cholesky()?.solve(&pull);
        let moved = place.numbers.iter().zip(&self.sizes).zip(travel.iter());
        let mut numbers: Vec<f64> = moved.map(|((v, size), travel)| v - travel * size).collect();
        self.keep_within(&mut numbers);
        self.place(numbers)
    }

    pub(super) fn keep_within(&self, numbers: &mut [f64]) {
        for (number, ends) in numbers.iter_mut().zip(&self.ends) {
            if let Some([low, high]) = ends {
                *number = number.max(low.min(*high)).min(high.max(*low));
            }
        }
    }

    /// Returns the derivatives of the misses by the numbers relative to their sizes: those at fixed
    /// places if every figure has them, or else differences of whole designs.
    pub(super) fn slopes(&mut self, place: &Place) -> Option<DMatrix<f64>> {
        self.at_fixed_places(place)
            .or_else(|| self.differences(place))
    }

    /// Returns the derivatives at fixed places of the motion, if all figures have them.
    fn at_fixed_places(&mut self, place: &Place) -> Option<DMatrix<f64>> {
        let numbers = &place.numbers;
        let EvaluatedFigures { values, places } = self.figures.evaluate(numbers)?;
        let places = places?;
        let values: Option<Vec<f64>> = values.into_iter().map(Result::ok).collect();
        let values = values?;
        let slopes = self.figures.exact_slopes(&places, numbers).or_else(|| {
            let each = numbers.iter().zip(&self.sizes);
            let ends = each.map(|(number, size)| {
                let by = DIFFERENCE * size;
                [number - by, number + by]
            });
            let ends: Vec<[f64; 2]> = ends.collect();
            self.figures.placed_slopes(&places, numbers, &ends)
        })?;
        let slope = |goal: usize, i: usize| {
            let slope = slopes[goal][i] * self.sizes[i];
            self.goals[goal].slope_of_part(values[goal], slope)
        };
        let count = numbers.len();
        Some(DMatrix::from_fn(self.goals.len(), count, slope))
    }

    pub(super) fn differences(&mut self, place: &Place) -> Option<DMatrix<f64>> {
        let columns = (0..place.numbers.len()).map(|i| {
            let by = DIFFERENCE * self.sizes[i];
            let mut at = |by: f64| {
                let mut numbers = place.numbers.clone();
                numbers[i] += by;
                self.misses(&numbers)
            };
            match (at(by), at(-by)) {
                (Some(above), Some(below)) => Some((above - below) / (2.0 * DIFFERENCE)),
                (Some(above), None) => Some((above - &place.misses) / DIFFERENCE),
                (None, Some(below)) => Some((&place.misses - below) / DIFFERENCE),
                (None, None) => None,
            }
        });
        let columns: Option<Vec<DVector<f64>>> = columns.collect();
        Some(DMatrix::from_columns(&columns?))
    }

    /// Returns the number of degrees of freedom around a point: the numbers minus the rank of the
    /// equality goals' derivatives.
    pub(super) fn freedoms(&mut self, place: &Place) -> usize {
        let count = place.numbers.len();
        let equal = self.goals.iter().enumerate();
        let equal = equal.filter(|(_, goal)| goal.sense == GoalSense::Equal);
        let equal: Vec<usize> = equal.map(|(i, _)| i).collect();
        if equal.is_empty() {
            return count;
        }
        let own = self.slopes(place).map(|slopes| slopes.select_rows(&equal));
        let rank = own.filter(is_finite).map(|own| {
            let sizes = own.singular_values();
            sizes
                .iter()
                .filter(|size| **size > RANK * sizes.max())
                .count()
        });
        count.saturating_sub(rank.unwrap_or(count))
    }
}
