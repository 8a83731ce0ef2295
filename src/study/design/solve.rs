//! Numbers that meet goals, looked for from what is given and from many other starts.

use super::{Design, DesignFigures, DesignPlan, Goal, NoDesign, PlanAxis};
use crate::parallel;
use crate::study::NoFigure;

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
    /// How many of its values are left free by the goals that are equalities: where there are any, it is one of a family
    /// of designs that meet them.
    pub freedoms: usize,
    /// The design itself.
    pub design: Design,
    /// Whether its motion is of the kind of the given one: a goal may be met by a crank that turns no more.
    pub moves_as_given: bool,
}

/// What a search came to.
#[derive(Clone, Debug, Default)]
pub struct SearchOutcome {
    /// The designs that meet every goal: those that move as the given one does before others, of these the nearest to
    /// what is given first.
    pub solutions: Vec<FoundDesign>,
    /// Where there is none, the design that misses least.
    pub nearest: Option<FoundDesign>,
    /// Why the given design cannot be told of, if it cannot.
    pub unopened: Option<NoDesign>,
    /// Starts from which was searched.
    pub starts: u32,
}

impl SearchOutcome {
    /// How many freedoms the family has that the solutions belong to; 0 where they stand alone.
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

/// To which design a search from one start has come.
struct SearchEnd {
    found: FoundDesign,
    /// Whether it meets every goal.
    is_met: bool,
    /// By how much it misses them, in parts of their sizes.
    missed: f64,
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

    /// Searches from what is given, and from so many other starts by chance, by so many threads: what is found does not
    /// depend on their number. `watch` is told the part that is done, and stops the search by answering false.
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
            // The first is the given one.
            let start = k.checked_sub(1).map(|k| plan.numbers(k as u64));
            search.found_from(start.unwrap_or_else(|| given.clone()), &given)
        };
        let count = starts as usize + 1;
        let ends = parallel::each(count, threads, || self.clone(), from, watch);
        let mut outcome = SearchOutcome {
            unopened: self.figures.clone().of(&given).err(),
            starts: u32::try_from(ends.len()).unwrap_or(u32::MAX),
            ..SearchOutcome::default()
        };
        let mut least = f64::INFINITY;
        for end in ends.into_iter().flatten() {
            if end.is_met {
                let known = &mut outcome.solutions.iter();
                if !known.any(|other| self.apart(&other.numbers, &end.found.numbers) < SAME) {
                    outcome.solutions.push(end.found);
                }
            } else if end.missed < least {
                least = end.missed;
                outcome.nearest = Some(end.found);
            }
        }
        outcome.solutions.sort_by(|a, b| {
            let alike = b.moves_as_given.cmp(&a.moves_as_given);
            alike.then(a.distance.total_cmp(&b.distance))
        });
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

    /// How far two designs are from each other: the root of the sum of squares, each number in parts of its size.
    fn apart(&self, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other).zip(&self.sizes);
        let squares = pairs.map(|((a, b), size)| ((a - b) / size).powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// The design to which a search from one start comes; `None` where it comes to none.
    fn found_from(&mut self, mut start: Vec<f64>, given: &[f64]) -> Option<SearchEnd> {
        // What is given may lie outside of the ends.
        self.keep_within(&mut start);
        let place = self.search(start)?;
        let figures = self.figures.of(&place.numbers).ok()?;
        let design = self.figures.space().open(&place.numbers).ok()?;
        let freedoms = self.freedoms(&place);
        let mut pairs = self.goals.iter().zip(&figures);
        let is_met = pairs.all(|(goal, value)| value.is_ok_and(|value| goal.is_met(value)));
        let found = FoundDesign {
            distance: self.apart(&place.numbers, given),
            moves_as_given: design.moves_like(self.figures.space().solver()),
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
