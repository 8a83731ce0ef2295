//! Rows of figures over the driver's coordinate: solved, read and written as they come.
//!
//! One state and one line of text serve all rows: a sweep of a billion rows takes the memory of one.

use super::columns::{Beside, Columns};
use super::errors::{Errors, Missing};
use super::rows::{CsvRows, JsonRows, Rows, TextRows};
use super::steps::Steps;
use crate::quantity::demand;
use crate::scene::Scene;
use crate::solver::{Condition, Solver};
use std::io::{self, Write};

/// How the rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFormat {
    /// Comma separated values with a header.
    Csv,
    /// One object: the scene, the units, and an object per row.
    Json,
    /// Aligned columns, to this many significant digits.
    Text {
        /// Significant digits.
        digits: usize,
    },
}

/// What a sweep came to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcome {
    /// Rows written.
    pub rows: u64,
    /// Of these, rows in which the mechanism can be: the others have no values.
    pub valued: u64,
    /// What could not be said beside the figures.
    pub missing: Missing,
}

/// What is swept, and how it is written.
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'a> {
    /// The scene, which JSON names.
    pub scene: &'a Scene,
    /// Its solver.
    pub solver: &'a Solver,
    /// The figures of each row. Nothing is solved that they do not need.
    pub columns: &'a Columns,
    /// The driver's coordinate of each row.
    pub steps: &'a Steps,
    /// How the rows are written.
    pub format: RowFormat,
}

/// So many rows are written between two reports of how far a sweep has come: about a millisecond.
const REPORTED: u64 = 1024;

impl Sweep<'_> {
    /// Solves and writes all rows; tells `watch` from time to time how many there are.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, to: impl Write, watch: &mut dyn FnMut(u64)) -> io::Result<Outcome> {
        let columns = self.columns;
        match self.format {
            RowFormat::Csv => self.run(CsvRows::new(columns, to)?, watch),
            RowFormat::Json => self.run(JsonRows::new(&self.scene.name, columns, to)?, watch),
            RowFormat::Text { digits } => self.run(TextRows::new(columns, digits, to)?, watch),
        }
    }

    fn run(&self, mut rows: impl Rows, watch: &mut dyn FnMut(u64)) -> io::Result<Outcome> {
        let quantities = &self.columns.quantities;
        let (wanted, order) = demand(quantities);
        let solver = self.solver.only(&wanted);
        let mut state = solver.state();
        let mut errors = self.errors(&solver);
        let mut cells = Vec::with_capacity(quantities.len());
        let mut outcome = Outcome::default();
        for at in self.steps.iter() {
            let condition = solver.solve(at, order, &mut state);
            cells.clear();
            match &mut errors {
                None => cells.extend(quantities.iter().map(|q| q.value(&state))),
                Some(errors) => errors.fill(&solver, order, &state, &mut cells),
            }
            rows.row(&cells, condition)?;
            outcome.rows += 1;
            outcome.valued += u64::from(condition != Condition::NoAssembly);
            if outcome.rows % REPORTED == 0 {
                watch(outcome.rows);
            }
        }
        rows.finish()?;
        outcome.missing = errors.map_or(Missing::default(), |errors| errors.missing());
        Ok(outcome)
    }

    /// What is known of errors, where it is asked for or shows in what is read: in text zero is what may
    /// be zero.
    fn errors(&self, solver: &Solver) -> Option<Errors<'_>> {
        let rounded = matches!(self.format, RowFormat::Text { .. });
        let wanted = rounded || self.columns.beside != Beside::default();
        wanted.then(|| Errors::new(self.columns, self.scene, self.solver, solver, rounded))
    }
}
