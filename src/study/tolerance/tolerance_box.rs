//! The box of all that may be off, as numbers: lengths one by one, and then two for each pin.

use super::contributions::ToleranceOf;
use super::samples::Distribution;
use crate::numeric::SeededChance;
use crate::{CoordinateAxis, Length, Tolerances};

/// Everything that may be off.
#[derive(Clone, Debug)]
pub(super) struct ToleranceBox {
    /// What each number makes longer.
    pub(super) given: Vec<Length>,
    /// How far each may be off.
    pub(super) limits: Vec<f64>,
    /// How many of them are lengths.
    pub(super) lengths: usize,
    pub(super) of: Vec<ToleranceOf>,
}

impl ToleranceBox {
    /// `None` where everything is exact.
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

    /// Everything as it was given.
    pub(super) fn nothing(&self) -> Vec<f64> {
        vec![0.0; self.limits.len()]
    }

    pub(super) fn has_pins(&self) -> bool {
        self.lengths < self.limits.len()
    }

    /// Makes lengths off by so many parts of their tolerances.
    pub(super) fn put(&self, lengths: &[usize], parts: &[f64], by: &mut [f64]) {
        for (&length, part) in lengths.iter().zip(parts) {
            by[length] = part * self.limits[length];
        }
    }

    /// The corner that derivatives point to: pins on the circles that they can be on.
    pub(super) fn way(&self, slopes: &[f64], acting: &[usize]) -> Vec<f64> {
        let mut way = self.nothing();
        for &length in acting {
            way[length] = self.limits[length].copysign(slopes[length]);
        }
        for pin in (self.lengths..self.limits.len()).step_by(2) {
            let [x, y] = [slopes[pin], slopes[pin + 1]];
            let size = x.hypot(y);
            if size > 0.0 {
                way[pin] = self.limits[pin] * x / size;
                way[pin + 1] = self.limits[pin] * y / size;
            }
        }
        way
    }

    /// Draws what is off.
    pub(super) fn draw(
        &self,
        distribution: Distribution,
        chance: &mut SeededChance,
        by: &mut [f64],
    ) {
        let (lengths, pins) = by.split_at_mut(self.lengths);
        let (limits, of_pins) = self.limits.split_at(self.lengths);
        let two = |chance: &mut SeededChance| match distribution {
            Distribution::Normal => chance.normal().map(|v| v / 3.0),
            Distribution::Even => [chance.even(), chance.even()],
        };
        for (by, limits) in lengths.chunks_mut(2).zip(limits.chunks(2)) {
            let drawn = two(chance);
            for ((by, limit), part) in by.iter_mut().zip(limits).zip(drawn) {
                *by = limit * part;
            }
        }
        for (by, limits) in pins.chunks_exact_mut(2).zip(of_pins.chunks_exact(2)) {
            let drawn = match distribution {
                Distribution::Normal => two(chance),
                Distribution::Even => chance.in_disc().0,
            };
            by.copy_from_slice(&drawn.map(|part| limits[0] * part));
        }
    }
}
