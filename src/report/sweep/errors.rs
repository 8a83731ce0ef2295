//! Computes rows of a sweep with error bounds and sensitivities. This is much slower than values
//! alone, and so a separate code path.

use crate::quantity::{Derivatives, Quantity, Sensitivity};
use crate::report::sweep::columns::{CellSource, Columns};
use crate::report::tables::entry::{display_bound, display_value};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State, Workspace};
use crate::{Ball, DriverMoment};

/// Computes the cells of rows.
pub(in crate::report) struct ErrorCells<'a> {
    columns: &'a Columns,
    /// Whether values within rounding errors of zero are shown as zero, as in text for people.
    rounded: bool,
    enclosure: Workspace<Ball>,
    sensitivity: Option<Sensitivity>,
    /// The number of values.
    figures: u64,
    /// The number of values without a bound.
    unproved: u64,
    /// The number of rows without derivatives by the lengths.
    rows_without_derivatives: u64,
    /// The number of values in the other rows.
    requested: u64,
    /// The number of values in the other rows without derivatives.
    missing_derivatives: u64,
}

impl<'a> ErrorCells<'a> {
    /// Creates the state of a sweep; `solver` computes only the prerequisites of the columns.
    pub(in crate::report) fn new(
        columns: &'a Columns,
        scene: &Scene,
        complete: &Solver,
        solver: &Solver,
        rounded: bool,
    ) -> Self {
        let is_requested = columns.extra.sensitivity;
        ErrorCells {
            columns,
            rounded,
            enclosure: solver.enclosure(),
            sensitivity: is_requested.then(|| Sensitivity::new(scene, complete, &columns.figures)),
            figures: 0,
            unproved: 0,
            rows_without_derivatives: 0,
            requested: 0,
            missing_derivatives: 0,
        }
    }

    /// Sets the driver's motion at a moment for the next row.
    pub(in crate::report) fn drive(&mut self, solver: &Solver, moment: &DriverMoment) {
        solver.drive(&mut self.enclosure, moment);
    }

    /// Appends the cells of a row for a solved state.
    pub(in crate::report) fn fill(
        &mut self,
        solver: &Solver,
        order: Order,
        state: &mut Workspace,
        cells: &mut Vec<Option<f64>>,
    ) {
        if self.needs_bounds() {
            solver.enclose(state, order, &mut self.enclosure);
        }
        let derivatives = self.sensitivity.as_mut().and_then(|s| s.at(state.at()));
        let missing = self.sensitivity.is_some() && derivatives.is_none();
        self.rows_without_derivatives +=
            u64::from(missing && state.condition() != Condition::NoAssembly);
        if let Some(found) = &derivatives {
            self.count(found);
        }
        let columns = self.columns;
        for (quantity, source) in columns.quantities.iter().zip(&columns.sources) {
            cells.push(match source {
                CellSource::Figure => self.figure(quantity, state),
                CellSource::Bound => self.bound(quantity, state),
                CellSource::Sensitivity(index) => {
                    derivatives.as_ref().and_then(|d| d.worst(*index))
                }
                // Rows of measurements are computed elsewhere.
                CellSource::Difference => None,
            });
        }
    }

    /// Counts the values for which derivatives were requested.
    fn count(&mut self, found: &Derivatives) {
        for (number, quantity) in self.columns.figures.iter().enumerate() {
            let missing = found.has_kink(number);
            let counts = !quantity.is_driver() && (missing || found.of(number).is_some());
            self.requested += u64::from(counts);
            self.missing_derivatives += u64::from(counts && missing);
        }
    }

    fn bound(&self, quantity: &Quantity, state: &State) -> Option<f64> {
        let bound = quantity.bound(state, &self.enclosure);
        match quantity.value(state) {
            Some(value) if self.rounded && !quantity.is_driver() => display_bound(value, bound),
            _ => bound,
        }
    }

    fn figure(&mut self, quantity: &Quantity, state: &State) -> Option<f64> {
        let value = quantity.value(state)?;
        if quantity.is_driver() {
            return Some(value);
        }
        self.figures += 1;
        if !self.needs_bounds() {
            return Some(value);
        }
        let bound = quantity.bound(state, &self.enclosure);
        self.unproved += u64::from(bound.is_none());
        Some(if self.rounded {
            display_value(value, bound)
        } else {
            value
        })
    }

    /// Returns `true` if bounds are written, or if values are shown as zero by them.
    fn needs_bounds(&self) -> bool {
        self.columns.extra.bounds || self.rounded
    }

    /// Returns the counts of missing bounds and derivatives.
    pub(in crate::report) fn missing(&self) -> Missing {
        Missing {
            figures: self.figures,
            unproved: if self.columns.extra.bounds {
                self.unproved
            } else {
                0
            },
            rows_without_derivatives: self.rows_without_derivatives,
            requested: self.requested,
            missing_derivatives: self.missing_derivatives,
        }
    }
}

/// Counts of missing extra columns of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Missing {
    /// The number of values.
    pub figures: u64,
    /// The number of values without the requested bound.
    pub unproved: u64,
    /// The number of rows that have values but not the requested derivatives.
    pub rows_without_derivatives: u64,
    /// The number of values in the other rows for which derivatives were requested.
    pub requested: u64,
    /// The number of values without derivatives.
    pub missing_derivatives: u64,
}
