//! Evaluates and plots the structural error of a function-generating linkage over its whole range.

use crate::drawing::Glyphs;
use crate::drawing::plot::{Plot, PlotStyle};
use crate::synthesis::functions::FunctionRun;
use crate::synthesis::{Candidate, FunctionTask, Task, TaskKind};
use crate::wording::words;

const COLUMNS: u16 = 76;
const ROWS: u16 = 12;
const ASPECT: f64 = 2.0;

/// The structural error where the function is known: over the range of a formula, or else at the
/// pairs.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::report) struct StructuralError {
    xs: Vec<f64>,
    /// The errors in degrees, or in the task's unit of length; `None` where the linkage does not
    /// close.
    errors: Vec<Option<f64>>,
    /// Whether the function is also known between the pairs.
    is_dense: bool,
}

impl StructuralError {
    /// Computes the error of a candidate; returns `None` for other tasks, and for a candidate that
    /// cannot be opened.
    pub(in crate::report) fn of(task: &Task, candidate: &Candidate) -> Option<StructuralError> {
        let TaskKind::Function(function) = &task.kind else {
            return None;
        };
        let FunctionTask { pairs, between, .. } = function;
        let run = FunctionRun::of(function, &candidate.proposal)?;
        let is_dense = !between.is_empty();
        let range = if is_dense { between } else { pairs };
        Some(StructuralError {
            xs: range.iter().map(|[x, _]| *x).collect(),
            errors: range.iter().map(|[x, y]| run.error(*x, *y)).collect(),
            is_dense,
        })
    }

    /// Returns x and the error, for programs.
    pub(in crate::report) fn pairs(&self) -> Vec<(f64, Option<f64>)> {
        let errors = self.errors.iter().copied();
        self.xs.iter().copied().zip(errors).collect()
    }

    /// Returns the plot as text lines, in the unit of the error; `None` if only the pairs are
    /// known.
    pub(in crate::report) fn plot(&self, unit: &str) -> Option<Vec<String>> {
        let figures = [([words().structural_error(), unit], self.errors.clone())];
        let plot = Plot::over(["x", ""], &self.xs, &figures);
        let style = PlotStyle {
            cols: COLUMNS,
            rows: ROWS.max(plot.min_rows()),
            glyphs: Glyphs::Ascii,
            aspect: ASPECT,
            extrema: false,
            first: 0,
        };
        let is_shown = self.is_dense && plot.has_values() && plot.fits(&style);
        is_shown.then(|| {
            let text = plot.render(&style, None).text();
            text.lines().map(str::to_owned).collect()
        })
    }
}
