//! Finds the place of the largest absolute rate.

use super::sampler::{MotionSampler, SampledFigure, SlopeSource};
use super::{FigurePlace, NoFigure};
use crate::Input;
use crate::numeric::{MinimumError, lowest, root};
use crate::solver::Range;

/// The fraction of the highest sample from which on a peak is examined closely.
const EXAMINED_FRACTION: f64 = 0.95;
/// The distance at which two methods have found the same place, relative to the interval of two
/// samples.
const NEAR: f64 = 1e-4;

/// Relative tolerances for rates. A rate that changes less over the motion is constant. A
/// second-order rate is zero if it is smaller, relative to the largest first slope per radian or
/// over a slide's travel. The rest is rounding error, which a second slope has about a thousand
/// times as much of as the quantity.
const LEVEL: f64 = 1e-9;

/// Bisections of the sampling step, down to which a peak next to a near miss is searched.
const MIN_WIDTH: i32 = 34;

/// A rate as a linear combination of the first and the second slope.
#[derive(Clone, Copy)]
struct RateSum {
    first: f64,
    second: f64,
}

impl RateSum {
    fn of(self, first: f64, second: f64) -> f64 {
        // A slope with factor 0 may not exist.
        let of = |factor: f64, slope: f64| if factor == 0.0 { 0.0 } else { factor * slope };
        of(self.first, first) + of(self.second, second)
    }

    /// Returns the number of slopes needed.
    fn degree(self) -> usize {
        if self.second == 0.0 { 1 } else { 2 }
    }
}

impl MotionSampler {
    /// Finds the largest rate of a column: f' w, with the driver's speed w.
    pub(super) fn fastest(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
        is_level: bool,
    ) -> Result<FigurePlace, NoFigure> {
        let driver = *self.driver();
        let is_unsteady = self.source() == SlopeSource::Steady && driver.acceleration != 0.0;
        if is_unsteady {
            return Err(NoFigure::NoRate);
        }
        let rate = RateSum {
            first: driver.speed * self.unit_of_slope(column),
            second: 0.0,
        };
        self.largest(column, sampled, rate, is_level)
    }

    /// Finds the largest rate of the rate: f'' w^2 + f' a, with the driver's acceleration a.
    pub(super) fn hardest(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
        is_level: bool,
    ) -> Result<FigurePlace, NoFigure> {
        let driver = *self.driver();
        let unit = self.unit_of_slope(column);
        let per_speed = self.coordinate_of_speed();
        let rate = RateSum {
            first: driver.acceleration * unit,
            second: driver.speed * driver.speed * unit * per_speed,
        };
        match self.source() {
            SlopeSource::Geometry => self.largest(column, sampled, rate, is_level),
            SlopeSource::Steady | SlopeSource::Nothing => Err(NoFigure::NoRate),
        }
    }

    fn largest(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
        rate: RateSum,
        is_level: bool,
    ) -> Result<FigurePlace, NoFigure> {
        if self.driver().speed == 0.0 {
            return Err(NoFigure::DriverStands);
        }
        if sampled.by_degree.len() <= rate.degree() {
            return Err(NoFigure::NoRate);
        }
        let last = sampled.at.len() - 1;
        let second = |k: usize| sampled.by_degree.get(2).map_or(0.0, |slopes| slopes[k]);
        let sizes = (0..=last).map(|k| rate.of(sampled.by_degree[1][k], second(k)).abs());
        let sizes: Vec<f64> = sizes.collect();
        if let Some(k) = [0, last].into_iter().find(|&k| !sizes[k].is_finite()) {
            return Err(NoFigure::Unbounded(sampled.at[k]));
        }
        // Between the ends a formula may have a kink exactly there.
        let sizes: Vec<f64> = sizes
            .iter()
            .map(|size| if size.is_finite() { *size } else { 0.0 })
            .collect();
        let highest = sizes
            .iter()
            .fold(0.0_f64, |maximum, &size| maximum.max(size));
        let first = (sampled.at[0], sizes[0]);
        let noise = LEVEL * self.rate_of_steady(sampled, rate);
        let is_nought = is_level || highest <= noise;
        let lowest_size = sizes
            .iter()
            .fold(f64::INFINITY, |minimum, &size| minimum.min(size));
        let is_steady = is_nought || highest - lowest_size <= LEVEL * highest;
        // A near miss may have an arbitrarily narrow peak.
        if is_steady && self.near_misses().is_empty() {
            let size = if is_nought { 0.0 } else { first.1 };
            return Ok(place((first.0, size)));
        }
        let is_periodic = matches!(self.range(), Range::Full { .. });
        let mut best = first;
        for k in (0..=last).filter(|&k| sizes[k] >= EXAMINED_FRACTION * highest) {
            let lower = |other: Option<usize>| other.is_none_or(|i| sizes[i] <= sizes[k]);
            let is_peak = lower(k.checked_sub(1)) && lower((k < last).then_some(k + 1));
            if !is_peak {
                continue;
            }
            let after = match k.checked_sub(1) {
                Some(k) => sampled.at[k],
                None if is_periodic => sampled.before_first(),
                None => sampled.at[0],
            };
            let ahead = sampled.at.get(k + 1).copied().unwrap_or(sampled.at[last]);
            let f = |at| self.size_below(column, rate, at);
            let from = (sampled.at[k], -sizes[k]);
            let found = lowest(f, [after, ahead], from).unwrap_or_else(MinimumError::best);
            let found = match rate.degree() {
                1 => self.settled(column, [after, ahead], found),
                _ => found,
            };
            if -found.1 > best.1 {
                best = (found.0, -found.1);
            }
        }
        for at in self.near_misses() {
            let found = self.largest_rate_near_miss(column, at, sampled.step(), rate);
            best = if found.1 > best.1 { found } else { best };
        }
        Ok(place(best))
    }

    /// Returns the second-order rate that would result if the largest first slope arose over a
    /// radian of the driver, or over its whole travel. Returns 0 for a rate without a second slope.
    fn rate_of_steady(&self, sampled: &SampledFigure, rate: RateSum) -> f64 {
        let slopes = sampled.by_degree[1].iter();
        let steepest = slopes
            .filter(|slope| slope.is_finite())
            .fold(0.0_f64, |maximum, slope| maximum.max(slope.abs()));
        let travel = match self.driver().input {
            Input::Turn(_) => 1.0_f64.to_degrees(),
            Input::Push(_) => sampled.at[sampled.at.len() - 1] - sampled.at[0],
        };
        (rate.second * steepest / travel).abs()
    }

    /// Returns the negative absolute value of a rate, so that its minimum is the largest rate.
    fn size_below(&mut self, column: usize, rate: RateSum, at: f64) -> Option<f64> {
        // The higher order first: its state serves both.
        let second = match rate.degree() {
            1 => 0.0,
            _ => self.degree(column, 2, at)?,
        };
        let slope = self.degree(column, 1, at)?;
        Some(-rate.of(slope, second).abs())
    }

    /// Finds the largest rate around a near miss; peaks are searched at every scale, however
    /// narrow.
    fn largest_rate_near_miss(
        &mut self,
        column: usize,
        at: f64,
        step: f64,
        rate: RateSum,
    ) -> (f64, f64) {
        let mut f = |at: f64| self.size_below(column, rate, at);
        let mut best = (at, -f(at).unwrap_or(0.0));
        for side in [-1.0, 1.0] {
            for k in 0..MIN_WIDTH {
                let off = |k: i32| at + side * step * f64::from(-k).exp2();
                let Some(here) = f(off(k)).filter(|here| -here > best.1) else {
                    continue;
                };
                let (one, other) = (off(k - 1), off(k + 1));
                let ends = [one.min(other), one.max(other)];
                let found = lowest(&mut f, ends, (off(k), here)).unwrap_or_else(MinimumError::best);
                best = (found.0, -found.1);
            }
        }
        best
    }
}

impl MotionSampler {
    /// Refines the place of the largest slope to full precision: the zero of the second slope, if
    /// known.
    fn settled(&mut self, column: usize, [low, high]: [f64; 2], found: (f64, f64)) -> (f64, f64) {
        let ends = [low, high].map(|at| Some((at, self.degree(column, 2, at)?)));
        let [Some(a), Some(b)] = ends else {
            return found;
        };
        let finest = f64::EPSILON * (high - low);
        let level = root(a, b, finest, |at| self.degree(column, 2, at)).ok();
        // Another stationary place may lie in the same interval.
        let is_near = |at: &f64| (at - found.0).abs() <= NEAR * (high - low);
        level.filter(is_near).map_or(found, |at| (at, found.1))
    }
}

fn place((at, value): (f64, f64)) -> FigurePlace {
    FigurePlace { at, value }
}
