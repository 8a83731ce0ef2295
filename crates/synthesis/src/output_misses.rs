//! Measures the error of a linkage's output against its function.

use super::FunctionTask;
use super::functions::{FunctionRun, MAX_RELATIVE_RMS};

/// Errors of an output, in degrees or in lengths of the task.
pub(super) struct OutputMisses {
    pub(super) worst: f64,
    pub(super) rms: f64,
    /// The range of the wanted output.
    swing: f64,
}

impl OutputMisses {
    /// Measures the errors over the function's whole range if it is known, or else at the pairs.
    /// Returns `None` if the linkage does not close.
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

    /// Returns `true` if the output still follows its function.
    pub(super) fn follows(&self) -> bool {
        self.rms <= MAX_RELATIVE_RMS * self.swing
    }
}
