//! Where a figure breaks: it jumps because a direction in it passes a full turn, or it grows beyond all bounds.

use super::sampler::{BESIDE, MotionSampler, SampledFigure};
use super::{NoFigure, first_period};
use crate::expression::DirectionCut;
use crate::solver::Range;

/// Halvings of a stretch towards a place that may be a pole, and those after which it is seen that it is none.
const TOWARDS: u32 = 32;
const SEEN: u32 = 12;
/// By how much a figure grows on these halvings, at least, where it grows beyond all bounds: less than a root would.
const GROWN: f64 = 4096.0;
const GROWN_SOON: f64 = 8.0;
/// Halvings of the way to a place, from each of which to the next a figure grows by so much where it has a pole.
const NEARER: [i32; 3] = [10, 20, 27];
/// So many times the largest sample is passed on the way to a pole, and on that through one: rounding does not grow.
const BEYOND: f64 = 2.0;
const FARTHER: f64 = 512.0;
/// Of so many samples one may change the sign.
const OFTEN: usize = 8;
/// So much larger than a sample farther on is what may be a pole.
const HIGH: f64 = 256.0;

/// A change by less than this part of the figure's size is no jump.
const LEVEL: f64 = 1e-9;
/// Halvings of a stretch: what has not become less by then is a jump.
const HALVINGS: u32 = 60;

impl MotionSampler {
    /// A place between samples where a figure goes through infinity has no greatest value.
    pub(super) fn check_for_poles(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<(), NoFigure> {
        // A direction is bounded.
        if self.cut(column) == DirectionCut::ByTurns {
            return Ok(());
        }
        // Rounding is not the same in every place: what is no more than that of the figure's size is none of a pole.
        let farther = (FARTHER * sampled.most()).max(LEVEL * self.size(column));
        let changes = |k: &usize| {
            let [a, b] = [k - 1, *k].map(|k| sampled.by_degree[0][k]);
            (a < 0.0) != (b < 0.0)
        };
        let changes: Vec<usize> = (1..sampled.at.len()).filter(changes).collect();
        // So often rounding alone changes its sign.
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

    /// Where a figure changes its sign though it comes from far away and goes there: farther than all samples are.
    fn pole_between(
        &mut self,
        column: usize,
        [mut a, mut b]: [(f64, f64); 2],
        farther: f64,
    ) -> Option<f64> {
        let nearer = |a: (f64, f64), b: (f64, f64)| a.1.abs().min(b.1.abs());
        let first = nearer(a, b);
        for halving in 1..=TOWARDS {
            let at = 0.5 * (a.0 + b.0);
            let Some(value) = self.value(column, at) else {
                let is_pole = nearer(a, b) > (GROWN_SOON * first).max(farther);
                return is_pole.then_some(at);
            };
            match (value < 0.0) == (a.1 < 0.0) {
                true => a = (at, value),
                false => b = (at, value),
            }
            if halving == SEEN && nearer(a, b) <= GROWN_SOON * first {
                return None;
            }
        }
        let is_pole = nearer(a, b) > (GROWN * first).max(farther);
        is_pole.then_some(0.5 * (a.0 + b.0))
    }

    /// Whether a figure grows beyond all bounds, and beyond all samples, towards a place at which it may have no value,
    /// from either side.
    pub(super) fn is_pole(&mut self, column: usize, at: f64, sampled: &SampledFigure) -> bool {
        let (step, most) = (sampled.step(), sampled.most());
        if self.cut(column) == DirectionCut::ByTurns {
            return false;
        }
        let mut size = |at: f64| self.value(column, at).map(f64::abs);
        let here = size(at).unwrap_or(f64::INFINITY);
        [-step, step].into_iter().any(|side| {
            let mut beside = |halvings: i32| size(at + side * f64::from(-halvings).exp2());
            let Some(far) = beside(0).filter(|far| here > HIGH * far) else {
                return false;
            };
            let nearer = NEARER.map(|halvings| beside(halvings).unwrap_or(0.0));
            let sizes = [far].into_iter().chain(nearer);
            let mut steps = sizes.clone().zip(sizes.skip(1));
            nearer[nearer.len() - 1] > BEYOND * most
                && steps.all(|(far, near)| near > GROWN_SOON * far)
        })
    }

    /// What jumps by something else than full turns has no stroke: nobody can say what it would be without the jump.
    pub(super) fn check_for_jumps(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<(), NoFigure> {
        if self.cut(column) != DirectionCut::Otherwise {
            return Ok(());
        }
        let values = &sampled.by_degree[0];
        let size = values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let last = sampled.at.len() - 1;
        let mut jump = None;
        // Both sides of a load that jumps are no farther from each other.
        let sides = 4.0 * BESIDE * (sampled.at[last] - sampled.at[0]);
        for k in (1..=last).filter(|&k| sampled.at[k] - sampled.at[k - 1] > sides) {
            let ends = [k - 1, k].map(|k| (sampled.at[k], values[k]));
            jump = jump.or_else(|| self.jump_between(column, ends, LEVEL * size));
        }
        // What counts the driver's turns goes on where the motion repeats.
        let goes_on = (values[last] - values[0]).abs() > LEVEL * size;
        let jump = jump.or(match self.range() {
            Range::Full { period } if goes_on => Some(period),
            Range::Full { .. } | Range::Limited { .. } => None,
        });
        let range = self.range();
        jump.map_or(Ok(()), |at| Err(NoFigure::Jumps(first_period(at, range))))
    }

    /// A place at which a figure changes by more than `level` from one number to the next.
    fn jump_between(
        &mut self,
        column: usize,
        [mut a, mut b]: [(f64, f64); 2],
        level: f64,
    ) -> Option<f64> {
        let change = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1).abs();
        let mut most = change(a, b);
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
            most = most.max(change(a, b));
            if change(a, b) <= (0.5 * most).max(level) {
                return None;
            }
        }
        Some(b.0)
    }
}
