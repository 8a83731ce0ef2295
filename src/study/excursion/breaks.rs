//! Where a figure jumps because a direction in it passes a full turn.

use super::sampler::{MotionSampler, SampledFigure};
use super::{NoFigure, first_period};
use crate::expression::Cut;
use crate::solver::Range;

/// A change by less than this part of the figure's size is no jump.
const LEVEL: f64 = 1e-9;
/// Halvings of a stretch: what has not become less by then is a jump.
const HALVINGS: u32 = 60;

impl MotionSampler {
    /// What jumps by something else than full turns has no stroke: nobody can say what it would be without the jump.
    pub(super) fn check_for_jumps(
        &mut self,
        column: usize,
        sampled: &SampledFigure,
    ) -> Result<(), NoFigure> {
        if self.cut(column) != Cut::Otherwise {
            return Ok(());
        }
        let values = &sampled.by_degree[0];
        let size = values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let last = sampled.at.len() - 1;
        let mut jump = None;
        for k in 1..=last {
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
