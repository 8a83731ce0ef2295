//! Finds the extrema of a curve and refines them.

use super::Curve;
use super::probe::Probe;
use crate::numeric::{MinimumError, lowest, roots, turns};

/// A local extremum of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremum {
    /// `true` for a maximum, `false` for a minimum.
    pub is_peak: bool,
    /// The driver's coordinate at the extremum, in degrees or in the scene's length unit.
    pub at: f64,
    /// The abscissa at the extremum.
    pub along: f64,
    /// The value of the quantity.
    pub value: f64,
    /// `true` for the largest of the maxima and the smallest of the minima.
    pub is_extreme: bool,
}

/// Minimum height of an extremum, as a fraction of the curve's range.
pub(super) const MIN_TURN: f64 = 2e-3;

impl Probe {
    /// Finds the extrema of a curve. Their `at` is still the sampled place, and `along` is not yet
    /// known.
    pub(super) fn extrema(
        &mut self,
        column: usize,
        curve: &Curve,
        coordinates: &[f64],
        is_periodic: bool,
        ends_are_limits: bool,
    ) -> Vec<Extremum> {
        let size = curve.range().map_or(0.0, |(low, high)| high - low);
        if curve.is_level() || size <= 0.0 {
            return Vec::new();
        }
        let mut found = Vec::new();
        for piece in runs(&curve.values, &curve.breaks) {
            let values: Vec<f64> = curve.values[piece.clone()]
                .iter()
                .copied()
                .flatten()
                .collect();
            let is_periodic = is_periodic && values.len() == coordinates.len();
            for turn in turns(&values, MIN_TURN * size, is_periodic) {
                let sample = piece.start + turn.sample;
                let is_limit = ends_are_limits && (sample == 0 || sample + 1 == coordinates.len());
                if turn.is_end && !is_limit {
                    continue;
                }
                let (at, value) = if turn.is_end {
                    (coordinates[sample], values[turn.sample])
                } else {
                    self.refined(
                        column,
                        sample,
                        turn.is_peak,
                        values[turn.sample],
                        coordinates,
                    )
                };
                found.push(Extremum {
                    is_peak: turn.is_peak,
                    at,
                    along: f64::NAN,
                    value,
                    is_extreme: false,
                });
            }
        }
        mark_extremes(&mut found);
        found
    }

    /// Refines an extremum near a sample: by the zero of the slope if that is known, or else by
    /// minimization. Returns the place and the value.
    fn refined(
        &mut self,
        column: usize,
        sample: usize,
        is_peak: bool,
        value: f64,
        coordinates: &[f64],
    ) -> (f64, f64) {
        let step =
            (coordinates[coordinates.len() - 1] - coordinates[0]) / (coordinates.len() - 1) as f64;
        let here = coordinates[sample];
        let around = [here - step, here, here + step];
        let sense = if is_peak { -1.0 } else { 1.0 };
        let finest = f64::EPSILON * step.abs();
        let level = roots(around, finest, |place| self.slope(column, place));
        let level = level
            .into_iter()
            .filter_map(|place| Some((place, self.value(column, place)?)))
            .min_by(|a, b| (sense * a.1).total_cmp(&(sense * b.1)));
        if let Some(level) = level.filter(|level| sense * level.1 <= sense * value) {
            return level;
        }
        let f = |place| Some(sense * self.value(column, place)?);
        let found = lowest(f, [around[0], around[2]], (here, sense * value));
        // Next to a gap, the lowest point found is still a value of the quantity.
        let (place, value) = found.unwrap_or_else(MinimumError::best);
        (place, sense * value)
    }
}

/// Returns the ranges of connected samples.
fn runs(values: &[Option<f64>], breaks: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut runs = Vec::new();
    let mut start = None;
    for (i, value) in values.iter().enumerate() {
        if value.is_some() {
            start = start.or(Some(i));
        }
        let ends = value.is_none() || breaks.get(i).copied().unwrap_or(true);
        if ends && let Some(start) = start.take() {
            runs.push(start..i + usize::from(value.is_some()));
        }
    }
    runs
}

/// Marks the largest of the maxima and the smallest of the minima.
fn mark_extremes(extrema: &mut [Extremum]) {
    for is_peak in [true, false] {
        let sense = if is_peak { 1.0 } else { -1.0 };
        let all = extrema.iter_mut().filter(|e| e.is_peak == is_peak);
        // The first of several equal ones wins.
        let maximum = all.reduce(|best, e| {
            if sense * e.value > sense * best.value {
                e
            } else {
                best
            }
        });
        if let Some(maximum) = maximum {
            maximum.is_extreme = true;
        }
    }
}
