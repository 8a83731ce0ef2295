//! Finds places where a quantity is discontinuous: it jumps because a direction in it passes a full
//! turn, or it grows without bound.

use super::sampler::{JUMP_DISTANCE, MotionSampler, SampledFigure};
use super::{NoFigure, first_period};
use crate::expression::DirectionCut;
use crate::solver::Range;

/// Bisections of a stretch towards a possible pole, and those after which most non-poles are
/// recognized.
const POLE_BISECTIONS: u32 = 32;
const EARLY_BISECTIONS: u32 = 12;
/// Minimum growth of a quantity over these bisections at a pole; even an inverse square root grows
/// more.
const MIN_POLE_GROWTH: f64 = 4096.0;
const MIN_EARLY_GROWTH: f64 = 8.0;
/// Bisection depths near a place; at a pole the quantity grows by a minimum factor from each to the
/// next.
const NEARER: [i32; 3] = [10, 20, 27];
/// The factors by which a quantity exceeds the largest sample on the way to a pole, and on that
/// through a pole. Rounding errors do not grow this much.
const POLE_APPROACH_FACTOR: f64 = 2.0;
const POLE_FACTOR: f64 = 512.0;
/// The divisor of the number of samples that limits sign changes: with more, they are rounding
/// errors.
const OFTEN: usize = 8;
/// The ratio to a more distant sample from which on a place may be a pole.
const HIGH: f64 = 256.0;

/// The change below which a quantity does not jump, relative to its size.
const LEVEL: f64 = 1e-9;
/// Bisections of a stretch; a change that has not decreased by then is a jump.
const HALVINGS: u32 = 60;

impl MotionSampler {
    /// Returns an error if a quantity passes through infinity between samples: it has no maximum
    /// then.
    pub(super) fn check_for_poles(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<(), NoFigure> {
        // A direction is bounded.
        if self.cut(column) == DirectionCut::ByTurns {
            return Ok(());
        }
        // Rounding errors differ between places: a change as small as that of the quantity's size
        // is not a pole.
        let farther = (POLE_FACTOR * sampled.max_abs()).max(LEVEL * self.size(column));
        let changes = |k: &usize| {
            let [a, b] = [k - 1, *k].map(|k| sampled.by_degree[0][k]);
            (a < 0.0) != (b < 0.0)
        };
        let changes: Vec<usize> = (1..sampled.at.len()).filter(changes).collect();
        // This many sign changes are caused by rounding errors.
        if changes.len() > sampled.at.len() / OFTEN {
            return Ok(());
        }
        for k in changes {
            let ends = [k - 1, k].map(|k| (sampled.at[k], sampled.by_degree[0][k]));
            if let Some(at) = self.pole_between(column, ends, farther) {
                return Err(NoFigure::Unbounded(first_period(at, self.range())));
            }
        }
        Ok(())
    }

    /// Returns the place of a pole in an interval: a sign change at which the quantity grows beyond
    /// all samples on both sides.
    fn pole_between(
        &mut self,
        column: usize,
        [mut a, mut b]: [(f64, f64); 2],
        farther: f64,
    ) -> Option<f64> {
        let nearer = |a: (f64, f64), b: (f64, f64)| a.1.abs().min(b.1.abs());
        let first = nearer(a, b);
        for halving in 1..=POLE_BISECTIONS {
            let at = 0.5 * (a.0 + b.0);
            let Some(value) = self.value(column, at) else {
                let is_pole = nearer(a, b) > (MIN_EARLY_GROWTH * first).max(farther);
                return is_pole.then_some(at);
            };
            match (value < 0.0) == (a.1 < 0.0) {
                true => a = (at, value),
                false => b = (at, value),
            }
            if halving == EARLY_BISECTIONS && nearer(a, b) <= MIN_EARLY_GROWTH * first {
                return None;
            }
        }
        let is_pole = nearer(a, b) > (MIN_POLE_GROWTH * first).max(farther);
        is_pole.then_some(0.5 * (a.0 + b.0))
    }

    /// Returns `true` if a quantity grows without bound, and beyond all samples, towards a place
    /// from either side; it may have no value there.
    pub(super) fn is_pole(&mut self, column: usize, at: f64, sampled: &SampledFigure) -> bool {
        let (step, maximum) = (sampled.step(), sampled.max_abs());
        if self.cut(column) == DirectionCut::ByTurns {
            return false;
        }
        let mut size = |at: f64| self.value(column, at).map(f64::abs);
        let here = size(at).unwrap_or(f64::INFINITY);
        [-step, step].into_iter().any(|side| {
            let mut nearby = |halvings: i32| size(at + side * f64::from(-halvings).exp2());
            let Some(far) = nearby(0).filter(|far| here > HIGH * far) else {
                return false;
            };
            let nearer = NEARER.map(|halvings| nearby(halvings).unwrap_or(0.0));
            let sizes = [far].into_iter().chain(nearer);
            let mut steps = sizes.clone().zip(sizes.skip(1));
            nearer[nearer.len() - 1] > POLE_APPROACH_FACTOR * maximum
                && steps.all(|(far, near)| near > MIN_EARLY_GROWTH * far)
        })
    }

    /// Returns an error if a quantity jumps by anything but full turns: its stroke without the jump
    /// is undefined.
    pub(super) fn check_for_jumps(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<(), NoFigure> {
        if self.cut(column) != DirectionCut::Otherwise {
            return Ok(());
        }
        let values = &sampled.by_degree[0];
        let size = values
            .iter()
            .fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
        let last = sampled.at.len() - 1;
        let mut jump = None;
        // Both sides of a load's jump are at most this far apart.
        let sides = 4.0 * JUMP_DISTANCE * (sampled.at[last] - sampled.at[0]);
        for k in (1..=last).filter(|&k| sampled.at[k] - sampled.at[k - 1] > sides) {
            let ends = [k - 1, k].map(|k| (sampled.at[k], values[k]));
            jump = jump.or_else(|| self.jump_between(column, ends, LEVEL * size));
        }
        // A quantity that counts the driver's turns changes over a period.
        let continues = (values[last] - values[0]).abs() > LEVEL * size;
        let jump = jump.or(match self.range() {
            Range::Full { period } if continues => Some(period),
            Range::Full { .. } | Range::Limited { .. } => None,
        });
        let range = self.range();
        jump.map_or(Ok(()), |at| Err(NoFigure::Jumps(first_period(at, range))))
    }

    /// Returns a place at which a quantity changes by more than `level` from one double to the
    /// next.
    fn jump_between(
        &mut self,
        column: usize,
        [mut a, mut b]: [(f64, f64); 2],
        level: f64,
    ) -> Option<f64> {
        let change = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1).abs();
        let mut maximum = change(a, b);
        for _ in 0..HALVINGS {
            let at = 0.5 * (a.0 + b.0);
            if at <= a.0 || at >= b.0 {
                break;
            }
            let middle = (at, self.value(column, at)?);
            match change(a, middle) > change(middle, b) {
                true => b = middle,
                false => a = middle,
            }
            maximum = maximum.max(change(a, b));
            if change(a, b) <= (0.5 * maximum).max(level) {
                return None;
            }
        }
        Some(b.0)
    }
}
