//! A function's task in internal units: radians, and lengths relative to the task's size.

use crate::{FunctionTask, GivenNumber, Output};
use kinematics::angle::radians;
use std::f64::consts::{PI, TAU};

/// The law of a function: the crank at `crank[0] + crank[1] x` and the output at `output[0] +
/// output[1] y`, in radians, or in crank lengths for a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FunctionLaw {
    pub(super) crank: [f64; 2],
    pub(super) output: [f64; 2],
}

impl FunctionLaw {
    /// Returns `true` if the pairs determine the crank's motion: over at most one turn, with less
    /// than half a turn between neighbours. A given scale always does.
    pub(super) fn is_determined_by(&self, target: &TargetFunction) -> bool {
        let mut xs: Vec<f64> = target.pairs.iter().map(|pair| pair[0]).collect();
        xs.sort_by(f64::total_cmp);
        let scale = self.crank[1].abs();
        let mut steps = xs.windows(2).map(|two| scale * (two[1] - two[0]));
        target.given[1].is_some() || (scale * target.span(0) <= TAU && steps.all(|step| step < PI))
    }
}

/// The wanted function: its pairs, and the given ones of the four numbers of the [`FunctionLaw`].
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TargetFunction {
    pub(super) output: Output,
    pub(super) pairs: Vec<[f64; 2]>,
    /// Crank datum, crank scale, output datum, output scale; `None` if free.
    pub(super) given: [Option<f64>; 4],
}

impl TargetFunction {
    /// Converts a task. Returns `None` if a number is not finite, if the size is not positive, or
    /// if a scale is 0.
    pub(super) fn of(task: &FunctionTask) -> Option<TargetFunction> {
        let of = |given: GivenNumber, unit: f64| match given {
            GivenNumber::Value(value) => Some(value * unit),
            GivenNumber::Free => None,
        };
        let turn = radians(1.0);
        let unit = match task.output {
            Output::Angle => turn,
            Output::Slide => 1.0 / task.size,
        };
        let given = [
            of(task.crank_datum, turn),
            of(task.crank_scale, turn),
            of(task.output_datum, unit),
            of(task.output_scale, unit),
        ];
        let numbers = task.pairs.iter().flatten().chain(given.iter().flatten());
        let is_sound = numbers.copied().all(f64::is_finite)
            && (task.size > 0.0 && task.size.is_finite())
            && given[1] != Some(0.0)
            && given[3] != Some(0.0);
        is_sound.then(|| TargetFunction {
            output: task.output,
            pairs: task.pairs.clone(),
            given,
        })
    }

    /// Returns the number of unknowns, which is the number of pairs that can be met.
    pub(super) fn unknowns(&self) -> usize {
        let lengths = match self.output {
            Output::Angle => 3,
            Output::Slide => 2,
        };
        lengths + self.given.iter().filter(|given| given.is_none()).count()
    }

    /// Returns a copy with one of the four numbers given.
    pub(super) fn with(&self, index: usize, value: f64) -> TargetFunction {
        let mut with = self.clone();
        with.given[index] = Some(value);
        with
    }

    /// Returns a copy with the pairs at these indices.
    pub(super) fn at(&self, indices: &[usize]) -> TargetFunction {
        TargetFunction {
            pairs: indices.iter().map(|&i| self.pairs[i]).collect(),
            ..*self
        }
    }

    /// Returns a copy with at most `most` pairs, spread evenly over their indices.
    pub(super) fn thinned(&self, maximum: usize) -> TargetFunction {
        let last = self.pairs.len().saturating_sub(1);
        if last < maximum {
            return self.clone();
        }
        let parts = maximum.saturating_sub(1).max(1);
        let indices: Vec<usize> = (0..maximum).map(|k| k * last / parts).collect();
        self.at(&indices)
    }

    /// Returns the range of x (0) or y (1) over the pairs, or 1 if all are equal.
    pub(super) fn span(&self, column: usize) -> f64 {
        let values = self.pairs.iter().map(|pair| pair[column]);
        let high = values.clone().fold(f64::NEG_INFINITY, f64::max);
        let span = high - values.fold(f64::INFINITY, f64::min);
        if span > 0.0 { span } else { 1.0 }
    }
}

/// Wraps an angle in radians to the range from -pi to pi.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
