//! The structural error of a linkage that follows a function, over its whole range.

use crate::drawing::Glyphs;
use crate::drawing::plot::{Plot, PlotStyle};
use crate::synthesis::functions::FunctionRun;
use crate::synthesis::{Candidate, FunctionTask, Task, TaskKind};
use crate::wording::words;

const COLUMNS: u16 = 76;
const ROWS: u16 = 12;
const ASPECT: f64 = 2.0;

/// By how much an output misses its function where that is known: over the range of a formula, else at the pairs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct StructuralError {
    xs: Vec<f64>,
    /// In degrees, or in lengths of the task; `None` where the linkage does not close.
    errors: Vec<Option<f64>>,
    /// Whether what lies between is known, too.
    is_dense: bool,
}

impl StructuralError {
    /// Of a candidate; `None` of a task that is no function, and where nothing was opened.
    pub(super) fn of(task: &Task, candidate: &Candidate) -> Option<StructuralError> {
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

    /// x and the error, for programs.
    pub(super) fn pairs(&self) -> Vec<(f64, Option<f64>)> {
        let errors = self.errors.iter().copied();
        self.xs.iter().copied().zip(errors).collect()
    }

    /// The plot in characters, in the unit of misses; `None` where what lies between the pairs is not known.
    pub(super) fn plot(&self, unit: &str) -> Option<Vec<String>> {
        let figures = [([words().structural_error(), unit], self.errors.clone())];
        let plot = Plot::over(["x", ""], &self.xs, &figures);
        let style = PlotStyle {
            cols: COLUMNS,
            rows: ROWS.max(plot.least_rows()),
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
