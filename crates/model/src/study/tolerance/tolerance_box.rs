//! The box of all deviations, as numbers: one per length, then two per pin.

use super::contributions::ToleranceOf;
use super::samples::Distribution;
use crate::numeric::SeededRng;
use crate::{CoordinateAxis, Length, Tolerances};

/// Number of multipliers to try, and their maximum, relative to the slopes' total.
const MULTIPLIERS: usize = 80;
const MAX_MULTIPLIER: f64 = 1e6;

/// The box of all deviations.
#[derive(Clone, Debug)]
pub(super) struct ToleranceBox {
    /// The length that each number changes.
    pub(super) given: Vec<Length>,
    /// The limit of each number.
    pub(super) limits: Vec<f64>,
    /// The number of lengths.
    pub(super) lengths: usize,
    pub(super) of: Vec<ToleranceOf>,
}

impl ToleranceBox {
    /// Creates the box; `None` if everything is exact.
    pub(super) fn new(tolerances: &Tolerances) -> Option<ToleranceBox> {
        let off = |&&(_, by): &&(Length, f64)| by > 0.0;
        let mut all: Vec<(Length, f64)> = tolerances.lengths.iter().filter(off).copied().collect();
        let lengths = all.len();
        let alone = all.iter().map(|&(length, _)| ToleranceOf::Length(length));
        let mut of: Vec<ToleranceOf> = alone.collect();
        for &(link, point, by) in tolerances.clearances.iter().filter(|(.., by)| *by > 0.0) {
            all.extend(CoordinateAxis::BOTH.map(|axis| (Length::Local(link, point, axis), by)));
            of.push(ToleranceOf::Pin(link, point));
        }
        let (given, limits): (Vec<Length>, Vec<f64>) = all.into_iter().unzip();
        (!given.is_empty()).then_some(ToleranceBox {
            given,
            limits,
            lengths,
            of,
        })
    }

    /// Returns the deviations of the nominal machine: zeros.
    pub(super) fn nothing(&self) -> Vec<f64> {
        vec![0.0; self.limits.len()]
    }

    pub(super) fn has_pins(&self) -> bool {
        self.lengths < self.limits.len()
    }

    /// Sets the deviations of lengths to fractions of their tolerances.
    pub(super) fn set_deviations(&self, lengths: &[usize], parts: &[f64], by: &mut [f64]) {
        for (&length, part) in lengths.iter().zip(parts) {
            by[length] = part * self.limits[length];
        }
    }

    /// Returns the machine of the box that is extreme along these slopes; deviations without slope
    /// stay as in `from`.
    pub(super) fn extreme_machine(&self, slopes: &[f64], from: &[f64]) -> Vec<f64> {
        let mut travel = from.to_vec();
        for (i, (travel, slope)) in travel.iter_mut().zip(slopes).enumerate().take(self.lengths) {
            if *slope != 0.0 {
                *travel = self.limits[i].copysign(*slope);
            }
        }
        for pin in (self.lengths..self.limits.len()).step_by(2) {
            let [x, y] = [slopes[pin], slopes[pin + 1]];
            let size = x.hypot(y);
            if size > 0.0 {
                travel[pin] = self.limits[pin] * x / size;
                travel[pin + 1] = self.limits[pin] * y / size;
            }
        }
        travel
    }

    /// Returns the extreme machine along slopes among those of the box with the same `level` as
    /// `from`, to first order. Uses the Lagrange multiplier of that condition.
    pub(super) fn extreme_at_level(&self, slopes: &[f64], level: &[f64], from: &[f64]) -> Vec<f64> {
        let size = |slopes: &[f64]| {
            let sizes = slopes
                .iter()
                .zip(&self.limits)
                .map(|(slope, by)| (slope * by).abs());
            sizes.sum::<f64>()
        };
        let scale = size(slopes) / size(level);
        if !scale.is_finite() {
            return self.extreme_machine(slopes, from);
        }
        let aim = |multiplier: f64| {
            let pairs = slopes.iter().zip(level);
            let both: Vec<f64> = pairs
                .map(|(slope, level)| slope + multiplier * level)
                .collect();
            self.extreme_machine(&both, from)
        };
        let raised = |machine: &[f64]| {
            let travels = machine.iter().zip(from).zip(level);
            travels
                .map(|((to, from), level)| (to - from) * level)
                .sum::<f64>()
        };
        // The level increases with the multiplier.
        let [mut low, mut high] = [-MAX_MULTIPLIER * scale, MAX_MULTIPLIER * scale];
        for _ in 0..MULTIPLIERS {
            let middle = f64::midpoint(low, high);
            *(match raised(&aim(middle)) < 0.0 {
                true => &mut low,
                false => &mut high,
            }) = middle;
        }
        let [below, above] = [low, high].map(aim);
        let [down, up] = [raised(&below), raised(&above)];
        let part = if up > down {
            (-down / (up - down)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let pairs = below.iter().zip(&above);
        pairs
            .map(|(below, above)| below + part * (above - below))
            .collect()
    }

    /// Draws random deviations.
    pub(super) fn draw(&self, distribution: Distribution, rng: &mut SeededRng, by: &mut [f64]) {
        let (lengths, pins) = by.split_at_mut(self.lengths);
        let (limits, of_pins) = self.limits.split_at(self.lengths);
        let two = |rng: &mut SeededRng| match distribution {
            Distribution::Normal => rng.normal().map(|v| v / 3.0),
            Distribution::Even => [rng.even(), rng.even()],
        };
        for (by, limits) in lengths.chunks_mut(2).zip(limits.chunks(2)) {
            let drawn = two(rng);
            for ((by, limit), part) in by.iter_mut().zip(limits).zip(drawn) {
                *by = limit * part;
            }
        }
        for (by, limits) in pins.chunks_exact_mut(2).zip(of_pins.chunks_exact(2)) {
            let drawn = match distribution {
                Distribution::Normal => two(rng),
                Distribution::Even => rng.in_disc().0,
            };
            by.copy_from_slice(&drawn.map(|part| limits[0] * part));
        }
    }
}
