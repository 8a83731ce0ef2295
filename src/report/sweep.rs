//! Rows of figures over the driver's coordinate: solved, read and written as they come.
//!
//! One state and one line of text serve all rows: a sweep of a billion rows takes the memory of one.

use super::rows::{CsvRows, JsonRows, Rows, TextRows};
use super::steps::Steps;
use crate::quantity::{Quantity, Subject, demand};
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
}

/// The columns of a sweep: the driver's coordinate, the figures asked for, and the state.
#[derive(Clone, Debug)]
pub struct Columns {
    /// The driver's coordinate first.
    pub(super) quantities: Vec<Quantity>,
    pub(super) units: bool,
}

impl Columns {
    /// The driver's coordinate and these figures; the headers bear units if asked.
    #[must_use]
    pub fn new(driver: &Quantity, figures: &[Quantity], units: bool) -> Self {
        let figures = figures.iter().filter(|q| q.subject != Subject::Driver);
        let quantities = std::iter::once(driver).chain(figures).cloned().collect();
        Columns { quantities, units }
    }

    /// What stands above each column but the last, the state.
    pub(super) fn headers(&self) -> impl Iterator<Item = String> {
        let header = |q: &Quantity| match self.units {
            true => q.header(),
            false => q.name.clone(),
        };
        self.quantities.iter().map(header)
    }
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
        let mut cells = Vec::with_capacity(quantities.len());
        let mut outcome = Outcome::default();
        for at in self.steps.iter() {
            let condition = solver.solve(at, order, &mut state);
            cells.clear();
            cells.extend(quantities.iter().map(|q| q.value(&state)));
            rows.row(&cells, condition)?;
            outcome.rows += 1;
            outcome.valued += u64::from(condition != Condition::NoAssembly);
            if outcome.rows % REPORTED == 0 {
                watch(outcome.rows);
            }
        }
        rows.finish()?;
        Ok(outcome)
    }
}
