//! Searches numbers that meet goals, from the given numbers and from many other starts.

use super::{Design, DesignFigures, DesignPlan, Goal, NoDesign, PlanAxis};
use crate::parallel;
use crate::study::NoFigure;

/// The distance below which two solutions count as one, with each number relative to its size.
const EQUALITY_TOLERANCE: f64 = 1e-6;
/// Half the range of starts for a value without bounds, relative to its size.
const AROUND: f64 = 0.5;

/// The design at the end of a search.
#[derive(Clone, Debug)]
pub struct FoundDesign {
    /// The numbers of the variable values.
    pub numbers: Vec<f64>,
    /// The figures, goal by goal.
    pub figures: Vec<Result<f64, NoFigure>>,
    /// The distance from the given design: the root of the sum of squares, each relative to its
    /// size.
    pub distance: f64,
    /// Degrees of freedom that the equality goals leave. If positive, the design belongs to a
    /// family of designs that meet them.
    pub freedoms: usize,
    /// The design itself.
    pub design: Design,
    /// `true` if the motion is of the same kind as the given design's; a goal may be met by a crank
    /// that no longer turns fully.
    pub is_same_motion_kind: bool,
}

/// The result of a search.
#[derive(Clone, Debug, Default)]
pub struct SearchOutcome {
    /// The designs that meet every goal. Designs that move like the given one come first, in each
    /// group the nearest first.
    pub solutions: Vec<FoundDesign>,
    /// The design with minimum misses if no design meets every goal.
    pub nearest: Option<FoundDesign>,
    /// The reason why the given design cannot be opened, if it cannot.
    pub open_error: Option<NoDesign>,
    /// The number of starts.
    pub starts: u32,
}

impl SearchOutcome {
    /// Returns the degrees of freedom of the solutions' family; 0 for isolated solutions.
    #[must_use]
    pub fn freedoms(&self) -> usize {
        let each = self.solutions.iter().map(|found| found.freedoms);
        each.min().unwrap_or(0)
    }
}

/// A search for numbers that meet goals.
#[derive(Clone, Debug)]
pub struct GoalSearch {
    pub(super) figures: DesignFigures,
    pub(super) goals: Vec<Goal>,
    pub(super) ends: Vec<Option<[f64; 2]>>,
    pub(super) sizes: Vec<f64>,
}

/// The end of a search from one start.
struct SearchEnd {
    found: FoundDesign,
    /// `true` if the design meets every goal.
    is_met: bool,
    /// The norm of the misses, relative to the goals' sizes.
    missed: f64,
}

impl GoalSearch {
    /// Creates a search for goals in a space; `axes` hold the bounds of each value.
    #[must_use]
    pub fn new(figures: DesignFigures, goals: Vec<Goal>, axes: &[PlanAxis]) -> GoalSearch {
        let given = figures.space().given();
        let largest = given
            .iter()
            .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
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

    /// Searches from the given design and from `starts` random starts. The result does not depend
    /// on the number of threads. `watch` receives the completed fraction and stops the search by
    /// returning `false`.
    #[must_use]
    pub fn run(
        &self,
        starts: u32,
        seed: u64,
        threads: usize,
        watch: &mut dyn FnMut(f64) -> bool,
    ) -> SearchOutcome {
        let given = self.figures.space().given();
        let around = self.around(&given);
        let plan = DesignPlan::latin(&around, &given, starts, seed);
        let from = |search: &mut GoalSearch, k: usize| {
            // The first start is the given design.
            let start = k.checked_sub(1).map(|k| plan.numbers(k as u64));
            search.found_from(start.unwrap_or_else(|| given.clone()), &given)
        };
        let count = starts as usize + 1;
        let ends = parallel::each(count, threads, || self.clone(), from, watch);
        let mut outcome = SearchOutcome {
            open_error: self.figures.clone().of(&given).err(),
            starts: u32::try_from(ends.len()).unwrap_or(u32::MAX),
            ..SearchOutcome::default()
        };
        let mut minimum = f64::INFINITY;
        for end in ends.into_iter().flatten() {
            if end.is_met {
                let known = &mut outcome.solutions.iter();
                if !known.any(|other| {
                    self.design_distance(&other.numbers, &end.found.numbers) < EQUALITY_TOLERANCE
                }) {
                    outcome.solutions.push(end.found);
                }
            } else if end.missed < minimum {
                minimum = end.missed;
                outcome.nearest = Some(end.found);
            }
        }
        outcome.solutions.sort_by(|a, b| {
            let alike = b.is_same_motion_kind.cmp(&a.is_same_motion_kind);
            alike.then(a.distance.total_cmp(&b.distance))
        });
        if !outcome.solutions.is_empty() {
            outcome.nearest = None;
        }
        outcome
    }

    /// Returns the ranges of the starts.
    fn around(&self, given: &[f64]) -> Vec<PlanAxis> {
        let axes = self.ends.iter().zip(given).zip(&self.sizes);
        let axis = |((ends, given), size): ((&Option<[f64; 2]>, &f64), &f64)| PlanAxis {
            name: String::new(),
            ends: Some(ends.unwrap_or([given - AROUND * size, given + AROUND * size])),
            count: None,
        };
        axes.map(axis).collect()
    }

    /// Returns the distance of two designs: the root of the sum of squares, each number relative to
    /// its size.
    fn design_distance(&self, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other).zip(&self.sizes);
        let squares = pairs.map(|((a, b), size)| ((a - b) / size).powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// Searches from one start; `None` if it does not end at a design.
    fn found_from(&mut self, mut start: Vec<f64>, given: &[f64]) -> Option<SearchEnd> {
        // The given numbers may lie outside the bounds.
        self.keep_within(&mut start);
        let place = self.search(start)?;
        let figures = self.figures.of(&place.numbers).ok()?;
        let design = self.figures.space().open(&place.numbers).ok()?;
        let freedoms = self.freedoms(&place);
        let mut pairs = self.goals.iter().zip(&figures);
        let is_met = pairs.all(|(goal, value)| value.is_ok_and(|value| goal.is_met(value)));
        let found = FoundDesign {
            distance: self.design_distance(&place.numbers, given),
            is_same_motion_kind: design.moves_like(self.figures.space().solver()),
            numbers: place.numbers,
            figures,
            freedoms,
            design,
        };
        Some(SearchEnd {
            found,
            is_met,
            missed: place.misses.norm(),
        })
    }
}
