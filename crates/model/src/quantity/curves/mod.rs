//! Samples quantities over the motion for plots, with gaps, jumps and extrema.

mod extrema;
mod probe;
mod span;
#[cfg(test)]
mod tests;

use super::clock::{Clock, paced};
use super::withheld::Hidden;
use super::{Catalogue, Quantity};
use crate::angle::unwrap_near;
use crate::scene::Scene;
use crate::solver::{Condition, Range, Solver, State};
use crate::wording::words;
pub use extrema::Extremum;
use probe::Probe;
use span::{NEAR, shown};
use thiserror::Error;

/// The quantity along the x axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Abscissa {
    /// The driver's coordinate.
    #[default]
    Driver,
    /// Time in seconds, 0 at the scene's start: see [`Clock`].
    Time,
    /// Another quantity.
    Figure(Quantity),
}

/// The reason why curves over time are impossible.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum TimeError {
    /// The driver's speed is 0.
    #[error("{}", words().no_time_passes())]
    StandsStill,
    /// The driver reverses before it reaches a requested coordinate.
    #[error("{}", words().driver_turns_back(*.0))]
    TurnsBack(f64),
}

/// Samples of some quantities over the motion, or over a part of it.
#[derive(Clone, Debug)]
pub struct Curves {
    /// The quantity along the x axis.
    pub abscissa: Abscissa,
    /// The name and unit of the x axis: `driver.angle`, `deg`; `time`, `s`.
    pub title: [String; 2],
    /// The driver's coordinate as a quantity.
    pub driver: Quantity,
    /// The driver's coordinate at each sample, in degrees or in the scene's length unit.
    pub at: Vec<f64>,
    /// The abscissa of each sample.
    pub along: Vec<Option<f64>>,
    /// The condition of each state.
    pub conditions: Vec<Condition>,
    /// The curves, in the order of the requested quantities.
    pub curves: Vec<Curve>,
    /// The reason why existing values are not shown, at the first sample where some are not.
    pub hidden: Option<Hidden>,
    /// Whether the abscissa jumps behind each sample.
    breaks: Vec<bool>,
    clock: Option<Clock>,
    /// The period of the samples, if they repeat.
    period: Option<f64>,
    /// The period of the linkage in the driver's coordinate, for a driver of varying speed.
    turn: Option<f64>,
}

/// The samples of a quantity.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The sampled quantity.
    pub quantity: Quantity,
    /// The value at each sample; `None` if it does not exist.
    pub values: Vec<Option<f64>>,
    /// The extrema.
    pub extrema: Vec<Extremum>,
    /// Whether the curve jumps behind each sample, as a direction does from 360 to 0 degrees.
    breaks: Vec<bool>,
    /// The constant value, if it changes by no more than its own error bound.
    level: Option<f64>,
}

/// The values in one state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StateValues {
    /// The abscissa; `None` outside of the sampled range.
    pub along: Option<f64>,
    /// The value of each curve.
    pub values: Vec<Option<f64>>,
}

/// Number of samples for scenes of usual size, and for scenes with so many points and links that
/// more samples would cause a noticeable delay.
const SAMPLES: usize = 720;
const MIN_SAMPLES: usize = 180;
/// Tolerance for the end of a period, as a fraction of it: closer positions count as the beginning
/// of the next period.
const SEAM: f64 = 1e-9;
/// The columns that are examined with one solver. A smaller solver for few columns solves only what
/// they depend on, but takes time to create.
const BLOCK: usize = 64;
/// Maximum number of points and links in all samples together.
const MAX_ROWS: usize = 400_000;

impl Curves {
    /// Samples the quantities over the whole motion, or over a window of the driver's coordinate.
    ///
    /// # Errors
    /// For curves over time, if there is no time.
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        quantities: &[Quantity],
        abscissa: Abscissa,
        window: Option<(f64, f64)>,
    ) -> Result<Curves, TimeError> {
        let clock = match abscissa {
            Abscissa::Time => Some(Clock::of(scene).ok_or(TimeError::StandsStill)?),
            Abscissa::Driver | Abscissa::Figure(_) => None,
        };
        let range = solver.motion().range;
        let (from, to) = stretch(range, clock.as_ref(), window)?;
        let driver = Catalogue::new(scene).driver().clone();
        let mut columns = quantities.to_vec();
        let title = match &abscissa {
            Abscissa::Driver => [driver.name.clone(), driver.unit.clone()],
            Abscissa::Time => ["time".into(), "s".into()],
            Abscissa::Figure(column) => {
                columns.push(column.clone());
                [column.name.clone(), column.unit.clone()]
            }
        };
        let mut probe = Probe::new(solver, &columns, range, clock.clone());
        let mechanism = &scene.mechanism;
        let rows = mechanism.points().len() + mechanism.links().len();
        let count = (MAX_ROWS / rows.max(1)).clamp(MIN_SAMPLES, SAMPLES);
        let share = |k: usize| k as f64 / count as f64;
        let coordinates: Vec<f64> = (0..=count)
            .map(|k| {
                if k == count {
                    to
                } else {
                    from + (to - from) * share(k)
                }
            })
            .collect();
        let (mut values, conditions) = probe.sample(&coordinates);
        let at: Vec<f64> = coordinates.iter().map(|&p| probe.coordinate(p)).collect();
        let mut along_breaks = vec![false; count];
        let along = match &abscissa {
            Abscissa::Driver => at.iter().copied().map(Some).collect(),
            Abscissa::Time => coordinates.iter().copied().map(Some).collect(),
            Abscissa::Figure(_) => {
                let along = values.pop().unwrap_or_default();
                along_breaks = probe.breaks(quantities.len(), &coordinates, &along);
                along
            }
        };
        let period = period(range, clock.as_ref(), window);
        let turn = match range {
            Range::Full { period: turn } => {
                let uneven = clock.as_ref().is_some_and(|clock| !clock.is_even());
                (uneven && window.is_none()).then_some(turn)
            }
            Range::Limited { .. } => None,
        };
        let ends = match range {
            Range::Limited { .. } => window.is_none() && period.is_none(),
            Range::Full { .. } => false,
        };
        let mut curves = Vec::with_capacity(quantities.len());
        let is_periodic = period.is_some();
        let mut values = values.into_iter();
        for (number, block) in quantities.chunks(BLOCK).enumerate() {
            let first = number * BLOCK;
            let mut part =
                (quantities.len() > BLOCK).then(|| probe.of_columns(first..first + block.len()));
            for ((i, quantity), values) in block.iter().enumerate().zip(values.by_ref()) {
                let level = probe.level(first + i, &coordinates, &values, &conditions);
                let probe = part.as_mut().unwrap_or(&mut probe);
                let breaks = match level {
                    Some(_) => vec![false; count],
                    None => probe.breaks(i, &coordinates, &values),
                };
                let mut curve = Curve {
                    quantity: quantity.clone(),
                    values,
                    breaks,
                    extrema: Vec::new(),
                    level,
                };
                curve.extrema = probe.extrema(i, &curve, &coordinates, is_periodic, ends);
                curves.push(curve);
            }
        }
        let mut all = Curves {
            abscissa,
            title,
            driver,
            at,
            along,
            conditions,
            curves,
            hidden: probe.hidden.take(),
            breaks: along_breaks,
            clock,
            period,
            turn,
        };
        all.place_extrema(&mut probe);
        Ok(all)
    }

    /// Divides the curves into groups of at most `count`, each with all samples.
    #[must_use]
    pub fn in_groups(mut self, count: usize) -> Vec<Curves> {
        let curves = std::mem::take(&mut self.curves);
        let groups = curves.chunks(count.max(1)).map(|curves| Curves {
            curves: curves.to_vec(),
            ..self.clone()
        });
        groups.collect()
    }

    /// Computes the abscissa of each extremum. One beyond an end is moved by a period, and one at
    /// the seam of two periods is moved to the beginning.
    fn place_extrema(&mut self, probe: &mut Probe) {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let index = self.curves.len();
        for curve in &mut self.curves {
            for extremum in &mut curve.extrema {
                // So far, `at` holds the probe's place.
                let mut place = extremum.at;
                if let Some(period) = self.period {
                    let seam = SEAM * period;
                    if place < first - seam {
                        place += period;
                    } else if place > last - seam {
                        place -= period;
                    }
                    place = place.max(first);
                }
                extremum.at = probe.coordinate(place);
                extremum.along = match self.abscissa {
                    Abscissa::Driver => extremum.at,
                    Abscissa::Time => place,
                    Abscissa::Figure(_) => probe.value(index, place).unwrap_or(f64::NAN),
                };
            }
            curve.extrema.retain(|e| e.along.is_finite());
        }
    }

    /// Returns the coordinate or the time of a sample; the last one for larger indices.
    fn places(&self, sample: usize) -> f64 {
        let sample = sample.min(self.at.len().saturating_sub(1));
        let place = match self.abscissa {
            Abscissa::Time => self.along.get(sample).copied().flatten(),
            Abscissa::Driver | Abscissa::Figure(_) => self.at.get(sample).copied(),
        };
        place.unwrap_or(0.0)
    }

    /// Returns the connected pieces of a curve as points of abscissa and value. A piece can consist
    /// of one sample, but is never empty.
    #[must_use]
    pub fn pieces(&self, curve: usize) -> Vec<Vec<[f64; 2]>> {
        self.shifted_pieces(curve, |_| Some(0.0))
    }

    /// Returns the pieces of the curve shifted by `above` at each sample, with a gap where that is
    /// `None`.
    #[must_use]
    pub fn shifted_pieces(
        &self,
        curve: usize,
        above: impl Fn(usize) -> Option<f64>,
    ) -> Vec<Vec<[f64; 2]>> {
        let Some(curve) = self.curves.get(curve) else {
            return Vec::new();
        };
        let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut hangs_on = false;
        for (i, (x, y)) in self.along.iter().zip(&curve.values).enumerate() {
            let (Some(x), Some(y), Some(above)) = (*x, *y, above(i)) else {
                hangs_on = false;
                continue;
            };
            let y = curve.level.unwrap_or(y) + above;
            match pieces.last_mut() {
                Some(piece) if hangs_on => piece.push([x, y]),
                _ => pieces.push(vec![[x, y]]),
            }
            let breaks = [&self.breaks, &curve.breaks];
            hangs_on = !breaks.iter().any(|b| b.get(i).copied().unwrap_or(false));
        }
        pieces
    }

    /// Returns the displayed range of the abscissa; `None` without values.
    #[must_use]
    pub fn span(&self) -> Option<(f64, f64)> {
        shown(&self.along, &self.breaks)
    }

    /// Returns the abscissa and the value of every curve in a state of the complete solver.
    #[must_use]
    pub fn here(&self, state: &State) -> StateValues {
        let place = self.place_of(state.at());
        let pace = place.and_then(|time| self.clock.as_ref()?.pace(time));
        self.values_at(place, |quantity| paced(quantity, state, pace))
    }

    /// Returns the abscissa and the value of every curve over time, in a state whose driver has the
    /// rates of that time, see [`DriverState`].
    ///
    /// [`DriverState`]: crate::quantity::DriverState
    #[must_use]
    pub fn here_at(&self, time: f64, state: &State) -> StateValues {
        self.values_at(self.within(time), |quantity| quantity.value(state))
    }

    fn values_at(
        &self,
        place: Option<f64>,
        value: impl Fn(&Quantity) -> Option<f64>,
    ) -> StateValues {
        let along = match &self.abscissa {
            Abscissa::Driver | Abscissa::Time => place,
            Abscissa::Figure(quantity) => place.and_then(|_| value(quantity)),
        };
        let value = |curve: &Curve| {
            let value = value(&curve.quantity)?;
            Some(match curve.level {
                Some(level) if curve.quantity.is_direction() => unwrap_near(level, value),
                Some(_) | None => value,
            })
        };
        StateValues {
            along,
            values: self.curves.iter().map(value).collect(),
        }
    }

    /// Returns the place of the driver's coordinate among the samples, as a coordinate or a time.
    fn place_of(&self, at: f64) -> Option<f64> {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let (low, high) = (first.min(last), first.max(last));
        self.within(match (&self.clock, self.period) {
            (None, _) => at,
            (Some(clock), Some(_)) if clock.is_even() => clock.time(at)?,
            (Some(clock), _) => {
                let comes_by = |at| clock.time_between(at, low, high);
                comes_by(at).or_else(|| comes_by(self.reduced(at)))?
            }
        })
    }

    /// Shifts a coordinate or a time by whole periods into the sampled range; `None` if it is
    /// outside.
    fn within(&self, place: f64) -> Option<f64> {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let (low, high) = (first.min(last), first.max(last));
        let place = match self.period {
            Some(_) if (low..=high).contains(&place) => place,
            Some(period) => low + (place - low).rem_euclid(period),
            None => place,
        };
        (low..=high).contains(&place).then_some(place)
    }

    /// Returns the equivalent coordinate within the samples, for a driver of varying speed.
    fn reduced(&self, at: f64) -> f64 {
        let Some(turn) = self.turn else {
            return at;
        };
        let low = self.at.iter().copied().fold(f64::INFINITY, f64::min);
        low + (at - low).rem_euclid(turn)
    }
}

impl Curve {
    /// Returns the displayed range of values; `None` without values. Usually it covers all values.
    /// Next to a gap, where a value may grow without bound, it ends not far beyond the usual
    /// values. A constant curve has only its value.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        if let Some(level) = self.level {
            return Some((level, level));
        }
        let (low, high) = shown(&self.values, &self.breaks)?;
        // Extrema lie between samples, slightly beyond their range.
        let near = NEAR * (high - low);
        let turns = self.extrema.iter().map(|e| e.value);
        let turns = turns.filter(|&v| low - near <= v && v <= high + near);
        Some(turns.fold((low, high), |(low, high), v| (low.min(v), high.max(v))))
    }

    /// Returns `true` if it changes by no more than its own error bound.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.level.is_some()
    }
}

/// Returns the ends of the sampled range, as coordinates or times.
fn stretch(
    range: Range,
    clock: Option<&Clock>,
    window: Option<(f64, f64)>,
) -> Result<(f64, f64), TimeError> {
    match (clock, window) {
        (None, Some((from, to))) => Ok((from.min(to), from.max(to))),
        (None, None) => Ok(range.ends()),
        (Some(clock), None) => Ok(clock.span(range)),
        (Some(clock), Some((from, to))) => {
            let time = |at| clock.time(at).ok_or(TimeError::TurnsBack(at));
            let (from, to) = (time(from)?, time(to)?);
            Ok((from.min(to), from.max(to)))
        }
    }
}

/// Returns the period of the samples, in degrees or seconds, if they cover exactly one.
fn period(range: Range, clock: Option<&Clock>, window: Option<(f64, f64)>) -> Option<f64> {
    let way = match range {
        Range::Full { period } => Some(period),
        Range::Limited { .. } => None,
    };
    let covers = window.is_none_or(|(from, to)| Some((to - from).abs()) == way);
    match clock {
        _ if !covers => None,
        None => way,
        Some(clock) => clock.period(range),
    }
}
