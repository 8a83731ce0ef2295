//! A task of this room in its own units: radians, and lengths as parts of the task's size.

use crate::angle::radians;
use crate::synthesis::{FunctionTask, Given, Output};
use std::f64::consts::TAU;

/// The crank at `crank[0] + crank[1] x`, the output at `output[0] + output[1] y`: in radians, of a slide in cranks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FunctionLaw {
    pub(super) crank: [f64; 2],
    pub(super) output: [f64; 2],
}

/// What is wanted: pairs, and which of the four numbers of the [`FunctionLaw`] are given.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct WantedFunction {
    pub(super) output: Output,
    pub(super) pairs: Vec<[f64; 2]>,
    /// Crank datum, crank scale, output datum, output scale.
    pub(super) given: [Option<f64>; 4],
}

impl WantedFunction {
    /// `None` where a number of the task is none, where the size is not positive, or a scale is 0.
    pub(super) fn of(task: &FunctionTask) -> Option<WantedFunction> {
        let of = |given: Given, unit: f64| match given {
            Given::Value(value) => Some(value * unit),
            Given::Free => None,
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
        is_sound.then(|| WantedFunction {
            output: task.output,
            pairs: task.pairs.clone(),
            given,
        })
    }

    /// How many numbers are free: as many pairs can be met.
    pub(super) fn unknowns(&self) -> usize {
        let lengths = match self.output {
            Output::Angle => 3,
            Output::Slide => 2,
        };
        lengths + self.given.iter().filter(|given| given.is_none()).count()
    }

    /// The same with one of the four numbers given.
    pub(super) fn with(&self, index: usize, value: f64) -> WantedFunction {
        let mut with = self.clone();
        with.given[index] = Some(value);
        with
    }

    /// The same of fewer pairs.
    pub(super) fn at(&self, indices: &[usize]) -> WantedFunction {
        WantedFunction {
            pairs: indices.iter().map(|&i| self.pairs[i]).collect(),
            ..*self
        }
    }

    /// How far x (0) or y (1) ranges over the pairs; 1 where it does not.
    pub(super) fn span(&self, column: usize) -> f64 {
        let values = self.pairs.iter().map(|pair| pair[column]);
        let high = values.clone().fold(f64::NEG_INFINITY, f64::max);
        let span = high - values.fold(f64::INFINITY, f64::min);
        if span > 0.0 { span } else { 1.0 }
    }
}

/// An angle in radians, from -pi to pi.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
