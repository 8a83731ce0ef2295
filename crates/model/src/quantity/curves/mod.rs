//! Quantities over the motion: samples to draw, the gaps between them, and where they turn.

mod extrema;
mod probe;
mod span;
#[cfg(test)]
mod tests;

use super::clock::{Clock, paced};
use super::hidden::Hidden;
use super::{Catalogue, Quantity};
use crate::angle::beside;
use crate::scene::Scene;
use crate::solver::{Condition, Range, Solver, State};
use crate::wording::words;
pub use extrema::Extremum;
use probe::Probe;
use span::{NEAR, shown};
use thiserror::Error;

/// What stands along x.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Abscissa {
    /// The driver's coordinate.
    #[default]
    Driver,
    /// Time in seconds, 0 where the scene opens: see [`Clock`].
    Time,
    /// Another quantity.
    Figure(Quantity),
}

/// Why nothing can be drawn over time.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum NoTime {
    /// The driver stands still.
    #[error("{}", words().no_time_passes())]
    StandsStill,
    /// The driver turns back before it comes to a coordinate that was asked for.
    #[error("{}", words().driver_turns_back(*.0))]
    TurnsBack(f64),
}

/// Samples of some quantities over the motion, or over a part of it.
#[derive(Clone, Debug)]
pub struct Curves {
    /// What stands along x.
    pub abscissa: Abscissa,
    /// Its name and unit: `driver.angle`, `deg`; `time`, `s`.
    pub title: [String; 2],
    /// The quantity that is the driver's coordinate.
    pub driver: Quantity,
    /// The driver's coordinate of each sample, in degrees or in the scene's length unit.
    pub at: Vec<f64>,
    /// What stands along x at each sample.
    pub along: Vec<Option<f64>>,
    /// What each state is.
    pub conditions: Vec<Condition>,
    /// The quantities, in the order in which they were asked for.
    pub curves: Vec<Curve>,
    /// Why figures that exist are not shown, at the first sample where that is so.
    pub hidden: Option<Hidden>,
    /// Between which samples what stands along x jumps.
    breaks: Vec<bool>,
    clock: Option<Clock>,
    /// The period after which the samples repeat.
    period: Option<f64>,
    /// Of a driver that does not keep its speed: after how many degrees the linkage is where it was.
    turn: Option<f64>,
}

/// The samples of a quantity.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What was sampled.
    pub quantity: Quantity,
    /// Its value at each sample; `None` where none exists.
    pub values: Vec<Option<f64>>,
    /// Where it turns.
    pub extrema: Vec<Extremum>,
    /// Between which samples it jumps, as a direction does from 360 to 0 deg: behind the first of the
    /// two.
    breaks: Vec<bool>,
    /// Where it stays, if it does not change by more than what its own error may be.
    level: Option<f64>,
}

/// The quantities in one state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Here {
    /// What stands along x; `None` outside of what was sampled.
    pub along: Option<f64>,
    /// The value of each curve.
    pub values: Vec<Option<f64>>,
}

/// Samples of the usual scene over its motion, and of one with so many points and links that this
/// would be seen as a delay.
const SAMPLES: usize = 720;
const FEWEST_SAMPLES: usize = 180;
/// This near to the end of a period, as a part of it, is where the next one begins.
const SEAM: f64 = 1e-9;
/// Points and links of all samples together.
const MOST_ROWS: usize = 400_000;

impl Curves {
    /// Solves for the quantities over the whole motion, or over a window of the driver's coordinate.
    ///
    /// # Errors
    /// Over time, where there is none.
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        quantities: &[Quantity],
        abscissa: Abscissa,
        window: Option<(f64, f64)>,
    ) -> Result<Curves, NoTime> {
        let clock = match abscissa {
            Abscissa::Time => Some(Clock::of(scene).ok_or(NoTime::StandsStill)?),
            Abscissa::Driver | Abscissa::Figure(_) => None,
        };
        let range = solver.motion().range;
        let (from, to) = stretch(range, clock.as_ref(), window)?;
        let driver = Catalogue::new(scene).driver().clone();
        let mut columns = quantities.to_vec();
        let title = match &abscissa {
            Abscissa::Driver => [driver.name.clone(), driver.unit.clone()],
            Abscissa::Time => ["time".into(), "s".into()],
            Abscissa::Figure(figure) => {
                columns.push(figure.clone());
                [figure.name.clone(), figure.unit.clone()]
            }
        };
        let mut probe = Probe::new(solver, &columns, range, clock.clone());
        let mechanism = &scene.mechanism;
        let rows = mechanism.points().len() + mechanism.links().len();
        let count = (MOST_ROWS / rows.max(1)).clamp(FEWEST_SAMPLES, SAMPLES);
        let share = |k: usize| k as f64 / count as f64;
        let places: Vec<f64> = (0..=count)
            .map(|k| {
                if k == count {
                    to
                } else {
                    from + (to - from) * share(k)
                }
            })
            .collect();
        let (mut values, conditions) = probe.sample(&places);
        let at: Vec<f64> = places.iter().map(|&p| probe.coordinate(p)).collect();
        let mut along_breaks = vec![false; count];
        let along = match &abscissa {
            Abscissa::Driver => at.iter().copied().map(Some).collect(),
            Abscissa::Time => places.iter().copied().map(Some).collect(),
            Abscissa::Figure(_) => {
                let along = values.pop().unwrap_or_default();
                along_breaks = probe.breaks(quantities.len(), &places, &along);
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
        for (i, (quantity, values)) in quantities.iter().zip(values).enumerate() {
            let level = probe.level(i, &places, &values, &conditions);
            let breaks = match level {
                Some(_) => vec![false; count],
                None => probe.breaks(i, &places, &values),
            };
            let mut curve = Curve {
                quantity: quantity.clone(),
                values,
                breaks,
                extrema: Vec::new(),
                level,
            };
            let goes_round = period.is_some();
            curve.extrema = probe.extrema(i, &curve, &places, goes_round, ends);
            curves.push(curve);
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

    /// Finds what stands along x at each extremum; one that lies beyond an end is one period before, and
    /// one where a period ends and begins is at the beginning.
    fn place_extrema(&mut self, probe: &mut Probe) {
        let (first, last) = (self.places(0), self.places(usize::MAX));
        let figure = self.curves.len();
        for curve in &mut self.curves {
            for extremum in &mut curve.extrema {
                // Until here, the place is that of the probe.
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
                    Abscissa::Figure(_) => probe.value(figure, place).unwrap_or(f64::NAN),
                };
            }
            curve.extrema.retain(|e| e.along.is_finite());
        }
    }

    /// The coordinate or the time of a sample; of the last one for any number beyond.
    fn places(&self, sample: usize) -> f64 {
        let sample = sample.min(self.at.len().saturating_sub(1));
        let place = match self.abscissa {
            Abscissa::Time => self.along.get(sample).copied().flatten(),
            Abscissa::Driver | Abscissa::Figure(_) => self.at.get(sample).copied(),
        };
        place.unwrap_or(0.0)
    }

    /// The parts of a curve that hang together: places of what stands along x and the value. Parts of
    /// one sample are possible, parts of none are not.
    #[must_use]
    pub fn pieces(&self, curve: usize) -> Vec<Vec<[f64; 2]>> {
        self.pieces_beside(curve, |_| Some(0.0))
    }

    /// The same of a curve beside it, as far above it at each sample as is told; a gap where nothing is.
    #[must_use]
    pub fn pieces_beside(
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

    /// From where to where x goes; of nothing at all, nothing.
    #[must_use]
    pub fn span(&self) -> Option<(f64, f64)> {
        shown(&self.along, &self.breaks)
    }

    /// What stands along x, and every curve, in a state of the whole solver.
    #[must_use]
    pub fn here(&self, state: &State) -> Here {
        let place = self.place_of(state.at());
        let pace = place.and_then(|time| self.clock.as_ref()?.pace(time));
        self.beside(place, |quantity| paced(quantity, state, pace))
    }

    /// The same of curves over time in a state whose driver passes as it does then, see [`DriverStand`].
    ///
    /// [`DriverStand`]: crate::quantity::DriverStand
    #[must_use]
    pub fn here_at(&self, time: f64, state: &State) -> Here {
        self.beside(self.within(time), |quantity| quantity.value(state))
    }

    fn beside(&self, place: Option<f64>, value: impl Fn(&Quantity) -> Option<f64>) -> Here {
        let along = match &self.abscissa {
            Abscissa::Driver | Abscissa::Time => place,
            Abscissa::Figure(figure) => place.and_then(|_| value(figure)),
        };
        let value = |curve: &Curve| {
            let value = value(&curve.quantity)?;
            Some(match curve.level {
                Some(level) if curve.quantity.is_direction() => beside(level, value),
                Some(_) | None => value,
            })
        };
        Here {
            along,
            values: self.curves.iter().map(value).collect(),
        }
    }

    /// Where among the samples the driver's coordinate lies, as a coordinate or a time.
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

    /// A coordinate or a time among the samples, or after whole periods.
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

    /// The coordinate on the way of a driver that does not keep its speed, at which the linkage is as at
    /// this one.
    fn reduced(&self, at: f64) -> f64 {
        let Some(turn) = self.turn else {
            return at;
        };
        let low = self.at.iter().copied().fold(f64::INFINITY, f64::min);
        low + (at - low).rem_euclid(turn)
    }
}

impl Curve {
    /// The range of values that is worth showing: all of them, but next to a gap, where a figure may
    /// grow beyond all bounds, not much more than where most of them are. What stays has its place alone.
    /// `None` where there is none.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        if let Some(level) = self.level {
            return Some((level, level));
        }
        let (low, high) = shown(&self.values, &self.breaks)?;
        // A curve turns between samples, and a little farther out.
        let near = NEAR * (high - low);
        let turns = self.extrema.iter().map(|e| e.value);
        let turns = turns.filter(|&v| low - near <= v && v <= high + near);
        Some(turns.fold((low, high), |(low, high), v| (low.min(v), high.max(v))))
    }

    /// Whether it does not change by more than its own error may be.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.level.is_some()
    }
}

/// From where to where, as coordinates or times.
fn stretch(
    range: Range,
    clock: Option<&Clock>,
    window: Option<(f64, f64)>,
) -> Result<(f64, f64), NoTime> {
    match (clock, window) {
        (None, Some((from, to))) => Ok((from.min(to), from.max(to))),
        (None, None) => Ok(range.ends()),
        (Some(clock), None) => Ok(clock.span(range)),
        (Some(clock), Some((from, to))) => {
            let time = |at| clock.time(at).ok_or(NoTime::TurnsBack(at));
            let (from, to) = (time(from)?, time(to)?);
            Ok((from.min(to), from.max(to)))
        }
    }
}

/// After what the samples repeat, where they cover just that: in degrees or seconds.
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
