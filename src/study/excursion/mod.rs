//! What a figure does over the whole motion: stroke or swing, where it turns, how long it goes each way, where it
//! rests, how fast it is.
//!
//! ```text
//! sampler       figures and their slopes by the driver's coordinate, anywhere and along the motion
//! breaks        where a figure jumps as a direction in it passes a full turn, or grows beyond all bounds
//! turning       where a figure turns: roots of its slope, and none of them between two samples is lost
//! plateau       from where to where it stays at the value at which it turns
//! quickest      where a rate is largest
//! strokes       from the turning places: which way takes how long, and where the figure stays
//! cycle_figure  the names of all that, as goals and columns have them: `C.x.stroke`, `swing.ratio`
//! evaluated     the figures of those names, of many mechanisms of one kind
//! seam          from where directions of these are counted, so that none of them jumps at a full turn
//! ```
//!
//! A slope by the coordinate is the rate at a driver's speed of 1, so that extrema are as good as the coordinate
//! itself. The motion is looked at degree by degree, or at 360 places of a range. Between two of these a figure is
//! taken to go one way where the cubic through both values and slopes does, with a margin; where that does not, the
//! stretch is halved, down to a thousandth.

#[cfg(test)]
mod break_tests;
mod breaks;
mod cycle_figure;
mod evaluated;
mod plateau;
mod quickest;
mod sampler;
mod seam;
mod strokes;
#[cfg(test)]
mod tests;
mod turning;

pub use cycle_figure::{CycleFigure, UnknownCycleFigure};
pub use evaluated::CycleFigures;
pub(crate) use seam::FigureSeams;
pub use strokes::{DwellStretch, TimeRatio};

use crate::angle::TURN;
use crate::expression::DirectionCut;
use crate::quantity::Quantity;
use crate::solver::{Range, Solver};
use sampler::{MotionSampler, SampledFigure, SlopeSource};
use turning::Turnings;

/// Where a figure has a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigurePlace {
    /// The driver's coordinate, in degrees or in the scene's length unit.
    pub at: f64,
    /// The figure there.
    pub value: f64,
}

/// A place at which a figure turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningPlace {
    /// Whether it comes from below and goes back there.
    pub is_peak: bool,
    /// Where, and at which value.
    pub place: FigurePlace,
    /// Until which coordinate it stays at that value, if it does: it turns behind that.
    pub until: Option<f64>,
    /// Whether it turns because the driver does, at an end of the range.
    pub is_limit: bool,
}

/// Why a figure of the cycle does not exist.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoFigure {
    /// It has no value at this coordinate.
    Gap(f64),
    /// It turns round with the driver: it has no stroke.
    TurnsRound,
    /// It never turns back.
    NeverTurns,
    /// It does not move.
    Stands,
    /// It jumps from one extreme to the other.
    Leaps,
    /// It stays at an extreme for a while: nobody can say when it turns.
    Rests,
    /// The driver goes there and back by the same way: both take as long.
    ThereAndBack,
    /// The driver stands still, so that nothing has a rate.
    DriverStands,
    /// The driver turns back before it has gone round.
    DriverTurnsBack,
    /// Its rate is no figure of a state.
    NoRate,
    /// It grows beyond all bounds towards this coordinate: a quotient where its divisor is 0, or a rate at a dead point.
    Unbounded(f64),
    /// It jumps at this coordinate, where a direction that its formula is made of passes a full turn.
    Jumps(f64),
    /// The driver turns fully: there is no limit.
    NoLimit,
    /// No dyad has a transmission angle, or none of this name.
    NoDyad,
    /// No group is solved by iteration, or none of this name.
    NoCoupledGroup,
    /// The motion does not come to the coordinate.
    OutOfReach(f64),
}

/// How far an excursion is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ExcursionWish {
    /// Whether the largest rate and that of the rate are asked for.
    pub rates: bool,
    /// Whether it is asked where the figure dwells.
    pub dwells: bool,
    /// Within which tolerance, in the figure's own unit; a part of the stroke if left out.
    pub tolerance: Option<f64>,
}

/// What a figure that moves by less than this part of its size does is rounding.
const LEVEL: f64 = 1e-11;
/// The part of its stroke within which a figure is said to stay.
pub const USUAL_DWELL: f64 = 0.01;

/// What a figure does over the whole motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Excursion {
    /// Its smallest value. A direction that comes back, and a sum of such, is counted without jumps by full turns, from
    /// its greatest value as it is in a state: the least of a direction may be negative.
    pub least: FigurePlace,
    /// Its greatest value.
    pub greatest: FigurePlace,
    /// How often a direction, or a sum of such, turns round in one period of the motion, with its sense; 0 where it comes back.
    pub revolutions: f64,
    /// Every place at which it turns, by the driver's coordinate: of a limited range the ends, too.
    pub turnings: Vec<TurningPlace>,
    /// How much longer the slow way between the extremes takes than the quick one.
    pub ratio: Result<TimeRatio, NoFigure>,
    /// The tolerance of its dwells, and these.
    pub dwells: Option<(f64, Vec<DwellStretch>)>,
    /// The largest size of its rate, at the driver's speed.
    pub fastest: Result<FigurePlace, NoFigure>,
    /// The largest size of the rate of its rate.
    pub hardest: Result<FigurePlace, NoFigure>,
}

impl Excursion {
    /// How far it goes: of a direction its swing.
    ///
    /// # Errors
    /// Where it turns round.
    pub fn stroke(&self) -> Result<f64, NoFigure> {
        match self.revolutions == 0.0 {
            true => Ok(self.greatest.value - self.least.value),
            false => Err(NoFigure::TurnsRound),
        }
    }

    /// Whether it does not move.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.ratio == Err(NoFigure::Stands)
    }

    /// Follows figures over the motion; those that are solved alike share the way.
    #[must_use]
    pub fn of_all(
        solver: &Solver,
        figures: &[Quantity],
        wish: ExcursionWish,
    ) -> Vec<Result<Excursion, NoFigure>> {
        let mut found = vec![Err(NoFigure::NoRate); figures.len()];
        for source in SlopeSource::ALL {
            let is_of = |figure: &Quantity| SlopeSource::of(solver, figure) == source;
            let own = (0..figures.len()).filter(|&i| is_of(&figures[i]));
            let own: Vec<usize> = own.collect();
            if own.is_empty() {
                continue;
            }
            let of = own.iter().map(|&i| &figures[i]);
            let degree = if wish.rates { 2 } else { 1 };
            let mut sampler = MotionSampler::new(solver, source, of, degree);
            let sampled = sampler.along_motion();
            for (column, (&i, sampled)) in own.iter().zip(&sampled).enumerate() {
                found[i] = Excursion::follow(&mut sampler, column, sampled, wish);
            }
        }
        found
    }

    fn follow(
        sampler: &mut MotionSampler,
        column: usize,
        sampled: &SampledFigure,
        wish: ExcursionWish,
    ) -> Result<Excursion, NoFigure> {
        let Turnings {
            places,
            least,
            greatest,
        } = Turnings::find(sampler, column, sampled)?;
        let range = sampler.range();
        let revolutions = sampled.revolutions(range, sampler.cut(column));
        let size = sampler
            .size(column)
            .max(greatest.value.abs().max(least.value.abs()));
        let is_level = greatest.value - least.value <= LEVEL * size;
        let mut excursion = Excursion {
            least: reduced(least, range),
            greatest: reduced(greatest, range),
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
        if wish.dwells && !is_level && revolutions == 0.0 {
            let stroke = greatest.value - least.value;
            let tolerance = wish.tolerance.unwrap_or(USUAL_DWELL * stroke);
            excursion.dwells = Some((tolerance, excursion.dwelling(sampler, column, tolerance)));
        }
        if wish.rates {
            let within = |place| reduced(place, range);
            let fastest = sampler.fastest(column, sampled, is_level);
            excursion.fastest = fastest.map(within);
            let hardest = sampler.hardest(column, sampled, is_level);
            excursion.hardest = hardest.map(within);
        }
        if sampler.cut(column) == DirectionCut::ByTurns && revolutions == 0.0 {
            excursion.count_from_state(sampler.value(column, greatest.at));
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

    /// Counts what jumps by full turns so that it is at its greatest what it is in a state.
    fn count_from_state(&mut self, greatest: Option<f64>) {
        let turns = (self.greatest.value - greatest.unwrap_or(0.0)) / TURN;
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

/// Which of some figures change over the motion; what has no value anywhere counts among them.
#[must_use]
pub fn changing(solver: &Solver, figures: &[Quantity]) -> Vec<bool> {
    let mut sampler = MotionSampler::new(solver, SlopeSource::Nothing, figures.iter(), 0);
    let sampled = sampler.along_motion();
    let changes = |(column, sampled): (usize, &SampledFigure)| {
        let values = sampled.by_degree[0]
            .iter()
            .filter(|value| value.is_finite());
        let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        });
        let size = ends
            .iter()
            .fold(sampler.size(column), |most, end| most.max(end.abs()));
        !(ends[1] - ends[0]).is_finite() || ends[1] - ends[0] > LEVEL * size
    };
    sampled.iter().enumerate().map(changes).collect()
}

/// A place within the first period.
fn reduced(place: FigurePlace, range: Range) -> FigurePlace {
    FigurePlace {
        at: first_period(place.at, range),
        ..place
    }
}

/// A coordinate within the first period.
fn first_period(at: f64, range: Range) -> f64 {
    match range {
        Range::Full { period } => {
            let at = at.rem_euclid(period);
            // What is less than a rounding before the seam is at it.
            if period - at <= 1e-12 * period {
                0.0
            } else {
                at
            }
        }
        Range::Limited { .. } => at,
    }
}
