//! Analyses a quantity over the whole motion: stroke or swing, extrema, time ratio, dwells and
//! largest rates.
//!
//! ```text
//! sampler             quantities and their slopes by the driver's coordinate, anywhere in the motion
//! discontinuities     jumps where a direction passes a full turn, and places of unbounded growth
//! extrema             the roots of the slope, without losing any between two samples
//! plateau             the intervals in which a quantity keeps its extreme value
//! largest_rate        the place of the largest rate
//! strokes             time ratios and dwells, computed from the extrema
//! cycle_figure        names of these results in goals and columns: `C.x.stroke`, `swing.ratio`
//! evaluated           the values for these names, of many mechanisms of one kind
//! periodic_reference  reference values for directions, so that none jumps at a full turn
//! ```
//!
//! A slope by the coordinate is the rate at a driver speed of 1, so extrema are as accurate as the
//! coordinate itself. The motion is sampled degree by degree, or at 360 places of a range. Between
//! two samples a quantity counts as monotonic if the cubic through both values and slopes is
//! monotonic with a margin. If it is not, the stretch is bisected, down to a thousandth.

#[cfg(test)]
mod break_tests;
mod cycle_figure;
mod discontinuities;
mod evaluated;
mod extrema;
mod largest_rate;
mod periodic_reference;
mod plateau;
mod sampler;
mod strokes;
#[cfg(test)]
mod tests;

pub use cycle_figure::{CycleFigure, UnknownCycleFigure};
pub use evaluated::CycleFigures;
pub(crate) use evaluated::{
    EvaluatedFigures, FigurePieces, PieceKind, PlacedBound, PlacedFigure, PlacedValue,
};
pub(crate) use periodic_reference::FigureSeams;
pub use strokes::{DwellStretch, TimeRatio};

use crate::angle::TURN;
use crate::expression::DirectionCut;
use crate::parallel;
use crate::quantity::{Quantity, Subject};
use crate::solver::{Range, Solver};
use crate::{Mechanism, PointId};
use extrema::ExtremaSet;
use sampler::{MotionSampler, SampledFigure, SlopeSource};

/// A place and the value of a quantity there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigurePlace {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The quantity's value.
    pub value: f64,
}

/// An extremum of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtremumPlace {
    /// `true` for a maximum.
    pub is_peak: bool,
    /// The place and the value.
    pub place: FigurePlace,
    /// The coordinate at the end of a plateau, if the quantity stays at that value; it reverses
    /// after that.
    pub until: Option<f64>,
    /// `true` if the quantity reverses because the driver does, at an end of the range.
    pub is_limit: bool,
}

/// The reason why a cycle figure does not exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoFigure {
    /// The quantity has no value at this coordinate.
    Gap(f64),
    /// The direction makes full turns with the driver and has no stroke.
    TurnsRound,
    /// The quantity never reverses.
    NeverTurns,
    /// The quantity is constant.
    Stands,
    /// The quantity jumps from one extreme to the other.
    Leaps,
    /// The quantity stays at an extreme for a while, so the instant of its reversal is undefined.
    Rests,
    /// The driver moves to and fro along the same path, so both directions take equal times.
    ThereAndBack,
    /// The driver's speed is zero, so rates do not exist.
    DriverStands,
    /// The driver turns back before a full cycle.
    DriverTurnsBack,
    /// The rate is not a quantity of a state.
    NoRate,
    /// The quantity grows without bound towards this coordinate: a quotient with a zero divisor, or
    /// a rate at a dead point.
    Unbounded(f64),
    /// The quantity jumps at this coordinate, where a direction in its formula passes a full turn.
    Jumps(f64),
    /// The driver turns fully, so there is no limit.
    NoLimit,
    /// There is no dyad with a transmission angle, or none of this name.
    NoDyad,
    /// There is no group solved by iteration, or none of this name.
    NoCoupledGroup,
    /// The motion does not reach the coordinate.
    OutOfReach(f64),
}

/// The optional parts of an analysis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExcursionOptions {
    /// `true` to find the largest rate and the largest rate of the rate.
    pub rates: bool,
    /// `true` to find dwells.
    pub dwells: bool,
    /// The tolerance of dwells, in the quantity's own unit; the default is [`DEFAULT_DWELL`] of the
    /// stroke.
    pub tolerance: Option<f64>,
}

/// The relative change below which a quantity counts as constant: rounding error.
const LEVEL: f64 = 1e-11;
/// The columns that are followed with one solver. A smaller solver for few columns solves only what
/// they depend on, but takes time to create.
const BLOCK: usize = 64;
/// The default tolerance of dwells, as a fraction of the stroke.
pub const DEFAULT_DWELL: f64 = 0.01;

/// The properties of a quantity over the whole motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Excursion {
    /// The minimum. An oscillating direction, or a sum of directions, is counted without jumps by
    /// full turns, from its maximum as it is in a state. Its minimum may therefore be negative.
    pub least: FigurePlace,
    /// The maximum.
    pub greatest: FigurePlace,
    /// The signed number of full turns of a direction, or of a sum of directions, in one period of
    /// the motion; 0 for an oscillation.
    pub revolutions: f64,
    /// All extrema, by the driver's coordinate; for a limited range including both ends.
    pub turnings: Vec<ExtremumPlace>,
    /// The ratio of the slow to the quick way between the extremes.
    pub ratio: Result<TimeRatio, NoFigure>,
    /// The tolerance of dwells, and the dwells.
    pub dwells: Option<(f64, Vec<DwellStretch>)>,
    /// The largest absolute rate, at the driver's speed.
    pub fastest: Result<FigurePlace, NoFigure>,
    /// The largest absolute rate of the rate.
    pub hardest: Result<FigurePlace, NoFigure>,
}

impl Excursion {
    /// Returns the stroke; for a direction the swing.
    ///
    /// # Errors
    /// Returns an error if a direction makes full turns.
    pub fn stroke(&self) -> Result<f64, NoFigure> {
        match self.revolutions == 0.0 {
            true => Ok(self.greatest.value - self.least.value),
            false => Err(NoFigure::TurnsRound),
        }
    }

    /// Returns the longest travel of the driver during a dwell.
    ///
    /// # Errors
    /// Returns the reason why there is none.
    pub fn longest_dwell(&self) -> Result<f64, NoFigure> {
        self.stroke()?;
        let dwells = self.dwells.iter().flat_map(|(_, dwells)| dwells);
        let travels = dwells.map(|dwell| dwell.travel);
        travels.max_by(f64::total_cmp).ok_or(NoFigure::NeverTurns)
    }

    /// Returns `true` if the quantity is constant.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.ratio == Err(NoFigure::Stands)
    }

    /// Analyses quantities over the motion; blocks of those with equal solver settings share the
    /// samples.
    #[must_use]
    pub fn of_all(
        solver: &Solver,
        quantities: &[Quantity],
        options: ExcursionOptions,
    ) -> Vec<Result<Excursion, NoFigure>> {
        let mut found = vec![Err(NoFigure::NoRate); quantities.len()];
        let groups = GroupNumbers::new(solver);
        for source in SlopeSource::ALL {
            let is_of = |quantity: &Quantity| SlopeSource::of(solver, quantity) == source;
            let own = (0..quantities.len()).filter(|&i| is_of(&quantities[i]));
            let mut own: Vec<usize> = own.collect();
            if own.is_empty() {
                continue;
            }
            own.sort_by_key(|&i| groups.of(&quantities[i]));
            let of = own.iter().map(|&i| &quantities[i]);
            let degree = if options.rates { 2 } else { 1 };
            let mut complete = MotionSampler::new(solver, source, of, degree);
            let follow = |sampler: &mut MotionSampler| {
                let sampled = sampler.sample_motion();
                let columns = sampled.iter().enumerate();
                let followed =
                    columns.map(|(column, of)| Self::follow(sampler, column, of, options));
                followed.collect::<Vec<Result<Excursion, NoFigure>>>()
            };
            let followed = match own.len().div_ceil(BLOCK) {
                1 => follow(&mut complete),
                blocks => {
                    let work = |(): &mut (), i: usize| {
                        let columns = i * BLOCK..own.len().min((i + 1) * BLOCK);
                        follow(&mut complete.of_columns(columns))
                    };
                    let threads = parallel::cores();
                    parallel::each(blocks, threads, || (), work, &mut |_| true).concat()
                }
            };
            for (i, excursion) in own.into_iter().zip(followed) {
                found[i] = excursion;
            }
        }
        found
    }

    fn follow(
        sampler: &mut MotionSampler,
        column: usize,
        sampled: &SampledFigure,
        options: ExcursionOptions,
    ) -> Result<Excursion, NoFigure> {
        let ExtremaSet {
            places,
            least: minimum,
            greatest: maximum,
        } = ExtremaSet::find(sampler, column, sampled)?;
        let range = sampler.range();
        let revolutions = sampled.revolutions(range, sampler.cut(column));
        let size = sampler
            .size(column)
            .max(maximum.value.abs().max(minimum.value.abs()));
        let is_level = maximum.value - minimum.value <= LEVEL * size;
        let mut excursion = Excursion {
            least: reduced(minimum, range),
            greatest: reduced(maximum, range),
            revolutions,
            turnings: if is_level { Vec::new() } else { places },
            ratio: Err(NoFigure::Stands),
            dwells: None,
            fastest: Err(NoFigure::NoRate),
            hardest: Err(NoFigure::NoRate),
        };
        if !is_level {
            excursion.ratio = excursion.time_ratio(sampler);
        }
        if options.dwells && !is_level && revolutions == 0.0 {
            let stroke = maximum.value - minimum.value;
            let tolerance = options.tolerance.unwrap_or(DEFAULT_DWELL * stroke);
            excursion.dwells = Some((
                tolerance,
                excursion.dwelling(sampler, (column, sampled), tolerance),
            ));
        }
        if options.rates {
            let within = |place| reduced(place, range);
            let fastest = sampler.fastest(column, sampled, is_level);
            excursion.fastest = fastest.map(within);
            let hardest = sampler.hardest(column, sampled, is_level);
            excursion.hardest = hardest.map(within);
        }
        if sampler.cut(column) == DirectionCut::ByTurns && revolutions == 0.0 {
            excursion.count_from_state(sampler.value(column, maximum.at));
        }
        for turning in &mut excursion.turnings {
            turning.place = reduced(turning.place, range);
            turning.until = turning.until.map(|at| first_period(at, range));
        }
        excursion
            .turnings
            .sort_by(|a, b| a.place.at.total_cmp(&b.place.at));
        Ok(excursion)
    }

    /// Shifts values by full turns so that the maximum equals the direction in a state.
    fn count_from_state(&mut self, maximum: Option<f64>) {
        let turns = (self.greatest.value - maximum.unwrap_or(0.0)) / TURN;
        let off = TURN * turns.round();
        let turnings = self.turnings.iter_mut().map(|turning| &mut turning.place);
        let dwells = self.dwells.iter_mut().flat_map(|(_, dwells)| dwells);
        let dwells = dwells.map(|dwell| &mut dwell.about.place);
        let ends = [&mut self.least, &mut self.greatest];
        for place in turnings.chain(dwells).chain(ends) {
            place.value -= off;
        }
    }
}

/// The number of the group that places each point and each link, in the order of solution.
struct GroupNumbers<'a> {
    mechanism: &'a Mechanism,
    points: Vec<usize>,
    links: Vec<usize>,
}

impl GroupNumbers<'_> {
    fn new(solver: &Solver) -> GroupNumbers<'_> {
        let mechanism = solver.mechanism();
        let mut numbers = GroupNumbers {
            mechanism,
            points: vec![0; mechanism.points().len()],
            links: vec![0; mechanism.links().len()],
        };
        for (number, group) in solver.plan().groups.iter().enumerate() {
            for point in &group.points {
                numbers.points[point.index()] = number;
            }
            for link in &group.links {
                numbers.links[link.index()] = number;
            }
        }
        numbers
    }

    /// Returns the number of the last group on which a quantity depends. Blocks of columns in this
    /// order depend on few groups.
    fn of(&self, quantity: &Quantity) -> usize {
        let point = |point: PointId| self.points[point.index()];
        match quantity.subject() {
            Some(Subject::Point(id)) => point(id),
            Some(Subject::Between(tail, head)) => point(tail).max(point(head)),
            Some(Subject::Slide(id)) => point(self.mechanism.slide(id).slider.point()),
            Some(Subject::Link(id) | Subject::Joint(id, _)) => self.links[id.index()],
            Some(Subject::Driver) => 0,
            Some(Subject::Drive(_) | Subject::Frame | Subject::FrameResidual) | None => usize::MAX,
        }
    }
}

/// The relative change between a few places that proves that a quantity changes: over the whole
/// motion, the change is then above [`LEVEL`].
const CERTAIN: f64 = 1e-6;

/// Returns, for each quantity, `true` if it changes over the motion or has no value anywhere.
#[must_use]
pub fn changing(solver: &Solver, quantities: &[Quantity]) -> Vec<bool> {
    let mut sampler = MotionSampler::new(solver, SlopeSource::Nothing, quantities.iter(), 0);
    let sampled = sampler.sample_few_places();
    let sampled = sampled.iter().enumerate();
    // Directions are continued along the motion, which a few places cannot show.
    let changes = sampled.map(|(i, values)| {
        !quantities[i].is_direction() && sampler.changes(i, values, CERTAIN) == Some(true)
    });
    let mut changes: Vec<bool> = changes.collect();
    // The others need the whole motion.
    let open: Vec<usize> = (0..quantities.len()).filter(|&i| !changes[i]).collect();
    let others = open.iter().map(|&i| &quantities[i]);
    let mut sampler = MotionSampler::new(solver, SlopeSource::Nothing, others, 0);
    let sampled = sampler.sample_motion();
    for (column, (i, values)) in open.into_iter().zip(&sampled).enumerate() {
        changes[i] = sampler.changes(column, values, LEVEL) != Some(false);
    }
    changes
}

/// Returns a place reduced to the first period.
fn reduced(place: FigurePlace, range: Range) -> FigurePlace {
    FigurePlace {
        at: first_period(place.at, range),
        ..place
    }
}

/// Returns a coordinate reduced to the first period.
fn first_period(at: f64, range: Range) -> f64 {
    match range {
        Range::Full { period } => {
            let at = at.rem_euclid(period);
            // Coordinates up to a rounding error before the seam are at the seam.
            if period - at <= 1e-12 * period {
                0.0
            } else {
                at
            }
        }
        Range::Limited { .. } => at,
    }
}
