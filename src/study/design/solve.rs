//! Numbers that meet goals: the method of Levenberg and Marquardt, from what is given and from many other starts.
//!
//! Residuals are the goals' misses in parts of their size, those of `>=` and `<=` nought where they are met. The
//! derivatives are differences of figures that are good to their last digits: a step of a hundred-thousandth leaves
//! them ten digits, with which the last steps are Newton's. A step is damped, so that of many solutions the one near to
//! its start is found.

use super::{DesignFigures, DesignPlan, Goal, NoDesign, PlanAxis};
use crate::study::NoFigure;
use nalgebra::{DMatrix, DVector};

/// Steps of one search at the most.
const STEPS: usize = 80;
/// Differences by which derivatives are taken, as a part of a number's size.
const DIFFERENCE: f64 = 1e-5;
/// Damping to begin with, by what it grows and shrinks, and beyond which a search is given up.
const DAMPING: f64 = 1e-3;
const GROWTH: f64 = 8.0;
const SHRINKING: f64 = 0.2;
const MOST_DAMPING: f64 = 1e12;
/// Solutions that differ by less than this part of each number are one.
const SAME: f64 = 1e-6;
/// Where no ends are given, numbers are looked for within this part of what is given to both sides.
const AROUND: f64 = 0.5;

/// A design that was found.
#[derive(Clone, Debug)]
pub struct FoundDesign {
    /// The numbers of the values that vary.
    pub numbers: Vec<f64>,
    /// Its figures, goal by goal.
    pub figures: Vec<Result<f64, NoFigure>>,
    /// How far it is from what is given: the root of the sum of squares, each in parts of its size.
    pub distance: f64,
}

/// What a search came to.
#[derive(Clone, Debug, Default)]
pub struct SearchOutcome {
    /// The designs that meet every goal, the nearest to what is given first.
    pub solutions: Vec<FoundDesign>,
    /// Where there is none, the design that misses least.
    pub nearest: Option<FoundDesign>,
    /// Why the given design cannot be told of, if it cannot.
    pub unopened: Option<NoDesign>,
    /// Starts from which was searched.
    pub starts: u32,
}

/// A search for numbers that meet goals.
#[derive(Clone, Debug)]
pub struct GoalSearch {
    figures: DesignFigures,
    goals: Vec<Goal>,
    ends: Vec<Option<[f64; 2]>>,
    sizes: Vec<f64>,
}

/// A place of a search.
struct Place {
    numbers: Vec<f64>,
    misses: DVector<f64>,
}

impl GoalSearch {
    /// In a space, for goals; `axes` say between which ends each value may be.
    #[must_use]
    pub fn new(figures: DesignFigures, goals: Vec<Goal>, axes: &[PlanAxis]) -> GoalSearch {
        let given = figures.space().given();
        let largest = given.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let size = |(v, axis): (&f64, &PlanAxis)| match axis.ends {
            Some([low, high]) if high != low => (high - low).abs(),
            _ if *v != 0.0 => v.abs(),
            _ if largest > 0.0 => largest,
            _ => 1.0,
        };
        let mut figures = figures;
        let values = figures.of(&given).unwrap_or_default();
        let values = values
            .into_iter()
            .map(Result::ok)
            .chain(std::iter::repeat(None));
        let goals = goals
            .into_iter()
            .zip(values)
            .map(|(goal, value)| goal.from(value));
        let goals: Vec<Goal> = goals.collect();
        GoalSearch {
            sizes: given.iter().zip(axes).map(size).collect(),
            ends: axes.iter().map(|axis| axis.ends).collect(),
            figures,
            goals,
        }
    }

    /// Searches from what is given, and from so many other starts by chance; tells `watch` after each and stops where
    /// that says so.
    pub fn run(
        &mut self,
        starts: u32,
        seed: u64,
        watch: &mut dyn FnMut(u32) -> bool,
    ) -> SearchOutcome {
        let given = self.figures.space().given();
        let mut outcome = SearchOutcome {
            unopened: self.figures.of(&given).err(),
            ..SearchOutcome::default()
        };
        let around = self.around(&given);
        let plan = DesignPlan::latin(&around, &given, starts, seed);
        let others = (0..u64::from(starts)).map(|k| plan.numbers(k));
        for mut start in std::iter::once(given.clone()).chain(others) {
            outcome.starts += 1;
            // What is given may lie outside of the ends.
            self.keep_within(&mut start);
            if let Some(place) = self.search(start) {
                self.note(place, &given, &mut outcome);
            }
            if !watch(outcome.starts) {
                break;
            }
        }
        outcome
            .solutions
            .sort_by(|a, b| a.distance.total_cmp(&b.distance));
        if !outcome.solutions.is_empty() {
            outcome.nearest = None;
        }
        outcome
    }

    /// Where starts are drawn from.
    fn around(&self, given: &[f64]) -> Vec<PlanAxis> {
        let axes = self.ends.iter().zip(given).zip(&self.sizes);
        let axis = |((ends, given), size): ((&Option<[f64; 2]>, &f64), &f64)| PlanAxis {
            name: String::new(),
            ends: Some(ends.unwrap_or([given - AROUND * size, given + AROUND * size])),
            count: None,
        };
        axes.map(axis).collect()
    }

    /// Keeps a place that meets the goals, unless it is known; of others the one that misses least.
    fn note(&mut self, place: Place, given: &[f64], outcome: &mut SearchOutcome) {
        let Ok(figures) = self.figures.of(&place.numbers) else {
            return;
        };
        let apart = |other: &[f64]| -> f64 {
            let pairs = place.numbers.iter().zip(other).zip(&self.sizes);
            pairs
                .map(|((a, b), size)| ((a - b) / size).powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let met = self
            .goals
            .iter()
            .zip(&figures)
            .all(|(goal, value)| value.is_ok_and(|value| goal.is_met(value)));
        let is_known = outcome
            .solutions
            .iter()
            .any(|other| apart(&other.numbers) < SAME);
        let found = FoundDesign {
            distance: apart(given),
            numbers: place.numbers.clone(),
            figures,
        };
        if met && !is_known {
            outcome.solutions.push(found);
        } else if !met {
            let before = outcome
                .nearest
                .as_ref()
                .and_then(|other| self.misses_of(&other.figures));
            if before.is_none_or(|before| place.misses.norm() < before.norm()) {
                outcome.nearest = Some(found);
            }
        }
    }

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

    /// From one start, to where no step is better.
    fn search(&mut self, start: Vec<f64>) -> Option<Place> {
        let misses = self.misses(&start)?;
        let mut place = Place {
            numbers: start,
            misses,
        };
        let mut damping = DAMPING;
        for _ in 0..STEPS {
            if place.misses.norm() == 0.0 {
                break;
            }
            let Some(slopes) = self.slopes(&place) else {
                break;
            };
            let Some(better) = self.step(&place, &slopes, &mut damping) else {
                break;
            };
            let gain = 1.0 - better.misses.norm() / place.misses.norm();
            place = better;
            if gain < f64::EPSILON {
                break;
            }
        }
        Some(place)
    }

    /// A step that is better, with as much damping as that takes.
    fn step(&mut self, place: &Place, slopes: &DMatrix<f64>, damping: &mut f64) -> Option<Place> {
        let square = slopes.tr_mul(slopes);
        let pull = slopes.tr_mul(&place.misses);
        let size = square.diagonal().max().max(f64::MIN_POSITIVE);
        while *damping < MOST_DAMPING {
            let damped =
                &square + DMatrix::identity(square.nrows(), square.ncols()) * (*damping * size);
            let way = damped.cholesky()?.solve(&pull);
            let moved = place.numbers.iter().zip(&self.sizes).zip(way.iter());
            let mut numbers: Vec<f64> = moved.map(|((v, size), way)| v - way * size).collect();
            self.keep_within(&mut numbers);
            match self.misses(&numbers) {
                Some(misses) if misses.norm() < place.misses.norm() => {
                    *damping *= SHRINKING;
                    return Some(Place { numbers, misses });
                }
                _ => *damping *= GROWTH,
            }
        }
        None
    }

    fn keep_within(&self, numbers: &mut [f64]) {
        for (number, ends) in numbers.iter_mut().zip(&self.ends) {
            if let Some([low, high]) = ends {
                *number = number.max(low.min(*high)).min(high.max(*low));
            }
        }
    }

    /// The derivatives of the misses by the numbers in parts of their sizes.
    fn slopes(&mut self, place: &Place) -> Option<DMatrix<f64>> {
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
}
