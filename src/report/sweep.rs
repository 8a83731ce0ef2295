//! Rows of figures over the driver's coordinate: solved, read and written as they come.
//!
//! A few states and one line of text serve all rows: a sweep of a billion rows takes the memory of one.

use super::columns::{Beside, Columns};
use super::csv_dialect::CsvDialect;
use super::errors::{ErrorCells, Missing};
use super::rows::{CsvRows, JsonRows, RowWriter, TextRows};
use super::steps::Steps;
use crate::quantity::{Clock, Hidden, Quantity, demand};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::{LANES, Lanes};
use std::io::{self, Write};

/// How the rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFormat {
    /// Comma separated values with a header.
    Csv(CsvDialect),
    /// One object: the scene, the units, and an object per row.
    Json,
    /// Aligned columns, to this many significant digits.
    Text {
        /// Significant digits.
        digits: usize,
    },
}

/// What a sweep came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepOutcome {
    /// Rows written.
    pub rows: u64,
    /// Of these, rows in which the mechanism can be: the others have no values.
    pub valued: u64,
    /// What could not be said beside the figures.
    pub missing: Missing,
    /// Rows in which figures that exist are not shown, and why not in the first of them.
    pub hidden: u64,
    /// See there.
    pub first_hidden: Option<Hidden>,
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
    /// The driver's coordinate of each row, or its time.
    pub steps: &'a Steps,
    /// What leads from time to the driver: then time is the first column ([`Columns::over_time`]).
    pub clock: Option<&'a Clock>,
    /// How the rows are written.
    pub format: RowFormat,
}

/// So many rows are written between two reports of how far a sweep has come: about a millisecond.
const REPORTED: u64 = 1024;

impl<'a> Sweep<'a> {
    /// Solves and writes all rows; tells `watch` from time to time how many there are.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write(&self, to: impl Write, watch: &mut dyn FnMut(u64)) -> io::Result<SweepOutcome> {
        let columns = self.columns;
        match self.format {
            RowFormat::Csv(dialect) => self.run(CsvRows::new(columns, dialect, to)?, watch),
            RowFormat::Json => self.run(JsonRows::new(&self.scene.name, columns, to)?, watch),
            RowFormat::Text { digits } => self.run(TextRows::new(columns, digits, to)?, watch),
        }
    }

    fn run(
        &self,
        mut rows: impl RowWriter,
        watch: &mut dyn FnMut(u64),
    ) -> io::Result<SweepOutcome> {
        let mut reader = RowReader::new(self);
        let mut outcome = SweepOutcome::default();
        let mut steps = self.steps.iter();
        let mut block = Vec::with_capacity(LANES);
        let mut reported = 0;
        loop {
            block.clear();
            block.extend(steps.by_ref().take(LANES));
            if block.is_empty() {
                break;
            }
            outcome.valued += reader.hand_over(&block, &mut rows)?;
            outcome.rows += block.len() as u64;
            if outcome.rows - reported >= REPORTED {
                reported = outcome.rows;
                watch(reported);
            }
        }
        rows.finish()?;
        (outcome.hidden, outcome.first_hidden) = (reader.hidden, reader.first_hidden);
        let errors = reader.errors;
        outcome.missing = errors.map_or(Missing::default(), |errors| errors.missing());
        Ok(outcome)
    }

    /// What is known of errors, where it is asked for or shows in what is read: in text zero is what may
    /// be zero.
    fn errors(&self, solver: &Solver) -> Option<ErrorCells<'a>> {
        let rounded = matches!(self.format, RowFormat::Text { .. });
        let wanted = rounded || self.columns.beside != Beside::default();
        wanted.then(|| ErrorCells::new(self.columns, self.scene, self.solver, solver, rounded))
    }
}

/// Solves for a few coordinates, at once where that can be, and reads the columns row by row.
struct RowReader<'a> {
    solver: Solver,
    quantities: &'a [Quantity],
    order: Order,
    clock: Option<&'a Clock>,
    /// What is known of errors, if that is wanted: then rows are read one by one.
    errors: Option<ErrorCells<'a>>,
    state: Workspace,
    lanes: Workspace<Lanes>,
    /// What was read from the lanes, column by column.
    columns: Vec<Lanes>,
    /// The row that is being read.
    cells: Vec<Option<f64>>,
    /// Rows with figures that are not shown, and the first of them.
    hidden: u64,
    first_hidden: Option<Hidden>,
}

impl<'a> RowReader<'a> {
    fn new(sweep: &Sweep<'a>) -> Self {
        let quantities = &sweep.columns.quantities;
        let (wanted, order) = demand(quantities);
        let solver = sweep.solver.only(&wanted);
        RowReader {
            errors: sweep.errors(&solver),
            quantities,
            order,
            clock: sweep.clock,
            state: solver.state(),
            lanes: solver.lanes(),
            columns: Vec::with_capacity(quantities.len()),
            cells: Vec::with_capacity(quantities.len()),
            hidden: 0,
            first_hidden: None,
            solver,
        }
    }

    /// Hands over the rows at these coordinates, no more than there are lanes; gives the number of
    /// those that have values.
    fn hand_over(&mut self, at: &[f64], rows: &mut impl RowWriter) -> io::Result<u64> {
        if self.errors.is_none() && self.clock.is_none() && self.read_at_once(at) {
            for lane in 0..at.len() {
                self.cells.clear();
                let cells = self.columns.iter().map(|column| Some(column.0[lane]));
                self.cells.extend(cells);
                rows.row(&self.cells, Condition::Ok)?;
            }
            return Ok(at.len() as u64);
        }
        let mut valued = 0;
        for &row in at {
            let at = self.driven(row);
            let condition = self.solver.solve(at, self.order, &mut self.state);
            self.cells.clear();
            match &mut self.errors {
                None => {
                    let cells = self.quantities.iter().map(|q| q.value(&self.state));
                    self.cells.extend(cells);
                }
                Some(errors) => {
                    errors.fill(&self.solver, self.order, &mut self.state, &mut self.cells);
                }
            }
            if let (Some(_), Some(time)) = (self.clock, self.cells.first_mut()) {
                *time = Some(row);
            }
            self.look_for_hidden();
            rows.row(&self.cells, condition)?;
            valued += u64::from(condition != Condition::NoAssembly);
        }
        Ok(valued)
    }

    /// The driver's coordinate in a row, which it passes as it does then.
    fn driven(&mut self, row: f64) -> f64 {
        let Some(clock) = self.clock else {
            return row;
        };
        let moment = clock.moment(row, self.solver.motion().range);
        self.solver.drive(&mut self.state, &moment);
        if let Some(errors) = &mut self.errors {
            errors.drive(&self.solver, &moment);
        }
        moment.at
    }

    /// Counts the row if figures that exist are not shown in it.
    fn look_for_hidden(&mut self) {
        let cells = self.quantities.iter().zip(&self.cells);
        let empty = cells.filter(|(_, cell)| cell.is_none()).map(|(q, _)| q);
        if let Some(hidden) = Hidden::of(empty, &self.state) {
            self.hidden += 1;
            self.first_hidden.get_or_insert(hidden);
        }
    }

    /// Whether every figure exists at each coordinate; then they are in the columns.
    fn read_at_once(&mut self, at: &[f64]) -> bool {
        let Some(&last) = at.last() else {
            return false;
        };
        // Lanes that are not needed do what the last one does.
        let mut lanes = [last; LANES];
        lanes[..at.len()].copy_from_slice(at);
        if !self.solver.solve_lanes(lanes, self.order, &mut self.lanes) {
            return false;
        }
        let figures = self.quantities.iter().map_while(|q| q.value(&self.lanes));
        self.columns.clear();
        self.columns.extend(figures);
        self.columns.len() == self.quantities.len()
    }
}
