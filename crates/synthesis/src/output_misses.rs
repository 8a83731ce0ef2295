//! By how much the output of a linkage misses its function.

use super::FunctionTask;
use super::functions::{FunctionRun, USELESS};

/// By how much an output misses what is wanted of it, in degrees or in lengths of the task.
pub(super) struct OutputMisses {
    pub(super) worst: f64,
    pub(super) rms: f64,
    /// How far it is to go.
    swing: f64,
}

impl OutputMisses {
    /// Over the range where that is known, else at the pairs. `None` where it does not close.
    pub(super) fn of(task: &FunctionTask, run: &FunctionRun) -> Option<OutputMisses> {
        let mut worst = 0.0_f64;
        for [x, y] in &task.pairs {
            worst = worst.max(run.error(*x, *y)?.abs());
        }
        let range = match task.between.is_empty() {
            true => &task.pairs,
            false => &task.between,
        };
        let mut squares = 0.0;
        for [x, y] in range {
            let error = run.error(*x, *y)?;
            worst = worst.max(error.abs());
            squares += error * error;
        }
        Some(OutputMisses {
            worst,
            rms: (squares / range.len() as f64).sqrt(),
            swing: run.swing(task.pairs.iter().chain(&task.between)),
        })
    }

    /// Whether it still follows its function.
    pub(super) fn follows(&self) -> bool {
        self.rms <= USELESS * self.swing
    }
}
