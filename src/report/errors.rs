//! A row of a sweep with what is known of the errors of its figures: far from the speed of figures
//! alone, and apart from their way.

use super::columns::{CellSource, Columns};
use super::entry::{seen, seen_bound};
use crate::quantity::{Derivatives, Quantity, Sensitivity};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State, Workspace};
use crate::{Ball, DriverMoment};

/// Fills the cells of rows.
pub(super) struct ErrorCells<'a> {
    columns: &'a Columns,
    /// What rounding may have left of a zero is shown as zero: for text, which people read.
    rounded: bool,
    enclosure: Workspace<Ball>,
    sensitivity: Option<Sensitivity>,
    /// Figures that exist, and of these how many have no bound.
    figures: u64,
    unproved: u64,
    /// Rows in which the figures have no derivatives by the lengths.
    unanswered: u64,
    /// Figures that exist in the other rows, and of these how many have none.
    asked: u64,
    lacking: u64,
}

impl<'a> ErrorCells<'a> {
    /// For a sweep with this solver, which solves what the columns need.
    pub(super) fn new(
        columns: &'a Columns,
        scene: &Scene,
        whole: &Solver,
        solver: &Solver,
        rounded: bool,
    ) -> Self {
        let asked = columns.beside.sensitivity;
        ErrorCells {
            columns,
            rounded,
            enclosure: solver.enclosure(),
            sensitivity: asked.then(|| Sensitivity::new(scene, whole, &columns.figures)),
            figures: 0,
            unproved: 0,
            unanswered: 0,
            asked: 0,
            lacking: 0,
        }
    }

    /// The driver passes the next row as it does at a moment.
    pub(super) fn drive(&mut self, solver: &Solver, moment: &DriverMoment) {
        solver.drive(&mut self.enclosure, moment);
    }

    /// The cells of a row in which this state was solved.
    pub(super) fn fill(
        &mut self,
        solver: &Solver,
        order: Order,
        state: &mut Workspace,
        cells: &mut Vec<Option<f64>>,
    ) {
        solver.enclose(state, order, &mut self.enclosure);
        let derivatives = self.sensitivity.as_mut().and_then(|s| s.at(state.at()));
        let missing = self.sensitivity.is_some() && derivatives.is_none();
        self.unanswered += u64::from(missing && state.condition() != Condition::NoAssembly);
        if let Some(found) = &derivatives {
            self.count(found);
        }
        let columns = self.columns;
        for (quantity, source) in columns.quantities.iter().zip(&columns.sources) {
            cells.push(match source {
                CellSource::Figure => self.figure(quantity, state),
                CellSource::Bound => self.bound(quantity, state),
                CellSource::Sensitivity(figure) => {
                    derivatives.as_ref().and_then(|d| d.worst(*figure))
                }
                // Measurements have rows of their own.
                CellSource::Difference => None,
            });
        }
    }

    /// Counts the figures whose derivatives were asked for.
    fn count(&mut self, found: &Derivatives) {
        for (number, figure) in self.columns.figures.iter().enumerate() {
            let lacks = found.lacks(number);
            let counts = !figure.is_driver() && (lacks || found.of(number).is_some());
            self.asked += u64::from(counts);
            self.lacking += u64::from(counts && lacks);
        }
    }

    fn bound(&self, quantity: &Quantity, state: &State) -> Option<f64> {
        let bound = quantity.bound(state, &self.enclosure);
        match quantity.value(state) {
            Some(value) if self.rounded && !quantity.is_driver() => seen_bound(value, bound),
            _ => bound,
        }
    }

    fn figure(&mut self, quantity: &Quantity, state: &State) -> Option<f64> {
        let value = quantity.value(state)?;
        if quantity.is_driver() {
            return Some(value);
        }
        let bound = quantity.bound(state, &self.enclosure);
        self.figures += 1;
        self.unproved += u64::from(bound.is_none());
        Some(if self.rounded {
            seen(value, bound)
        } else {
            value
        })
    }

    /// The figures that exist, of these how many have no bound, and the rows without derivatives.
    pub(super) fn missing(&self) -> Missing {
        Missing {
            figures: self.figures,
            unproved: if self.columns.beside.bounds {
                self.unproved
            } else {
                0
            },
            unanswered: self.unanswered,
            asked: self.asked,
            lacking: self.lacking,
        }
    }
}

/// What could not be said beside the figures of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Missing {
    /// Figures that exist.
    pub figures: u64,
    /// Of these, figures that were to have a bound and have none.
    pub unproved: u64,
    /// Rows that were to have derivatives by the lengths and have none, though they have values.
    pub unanswered: u64,
    /// Figures that exist in the other rows and were to have derivatives.
    pub asked: u64,
    /// Of these, figures that have none.
    pub lacking: u64,
}
