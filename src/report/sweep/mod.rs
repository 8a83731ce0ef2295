//! Computes rows of values over the driver's coordinate, and writes them as they are solved.
//!
//! A few states and line buffers serve all rows: memory does not depend on the number of rows.

pub(in crate::report) mod columns;
pub(in crate::report) mod curves;
pub(in crate::report) mod errors;
pub(in crate::report) mod lead;
pub(in crate::report) mod path;
pub(in crate::report) mod steps;

use crate::quantity::{Clock, Hidden, Quantity, demand};
use crate::report::sweep::columns::{Columns, ExtraColumns};
use crate::report::sweep::errors::{ErrorCells, Missing};
use crate::report::sweep::steps::Steps;
use crate::report::text::rows::{RowFormat, RowWriter};
use crate::scene::Scene;
use crate::solver::{Condition, LeadSingularity, Order, Solver, Workspace};
use crate::{LANES, Lanes};
use std::io::{self, Write};

/// The outcome of a sweep.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepOutcome {
    /// The number of rows written.
    pub rows: u64,
    /// The number of rows in which the mechanism can be assembled; the others have no values.
    pub valued: u64,
    /// The counts of missing error columns.
    pub missing: Missing,
    /// The number of rows in which existing values are not shown.
    pub hidden: u64,
    /// The reason in the first of these rows.
    pub first_hidden: Option<Hidden>,
    /// The number of rows in a singular position of inputs that follow a point.
    pub singular: u64,
    /// The numbers of the first of these rows, counted from 1, with their singularities.
    pub first_singular: Vec<(u64, LeadSingularity)>,
}

/// The input of a sweep, and its output format.
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'a> {
    /// The scene, whose name JSON contains.
    pub scene: &'a Scene,
    /// The solver of the scene.
    pub solver: &'a Solver,
    /// The values of each row; the solver computes only their prerequisites.
    pub columns: &'a Columns,
    /// The driver's coordinate of each row, or its time.
    pub steps: &'a Steps,
    /// The conversion from time to the driver; then time is the first column
    /// ([`Columns::over_time`]).
    pub clock: Option<&'a Clock>,
    /// The output format.
    pub format: RowFormat,
}

/// Rows between two progress reports: about a millisecond.
const REPORTED: u64 = 1024;

impl<'a> Sweep<'a> {
    /// Solves and writes all rows; calls `watch` regularly with their number.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(&self, to: impl Write, watch: &mut dyn FnMut(u64)) -> io::Result<SweepOutcome> {
        let table = self.columns.table(self.format);
        let head = table.head(&self.scene.name, "rows", self.columns.units);
        let mut rows = RowWriter::new(table, &head, to)?;
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
            outcome.valued += reader.write_rows_at(&block, &mut rows)?;
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

    /// Returns the computation of error columns, if it is needed: for requested columns, and for
    /// text, which shows values within their error bounds as zero.
    fn errors(&self, solver: &Solver) -> Option<ErrorCells<'a>> {
        let rounded = matches!(self.format, RowFormat::Text { .. });
        let wanted = rounded || self.columns.extra != ExtraColumns::default();
        wanted.then(|| ErrorCells::new(self.columns, self.scene, self.solver, solver, rounded))
    }
}

/// Solves a few coordinates, in parallel lanes if possible, and evaluates the columns row by row.
struct RowReader<'a> {
    solver: Solver,
    quantities: &'a [Quantity],
    order: Order,
    clock: Option<&'a Clock>,
    /// The computation of error columns, if needed; then rows are evaluated one by one.
    errors: Option<ErrorCells<'a>>,
    state: Workspace,
    lanes: Workspace<Lanes>,
    /// The values from the lanes, column by column.
    columns: Vec<Lanes>,
    /// The current row.
    cells: Vec<Option<f64>>,
    /// The number of rows with values not shown, and the first reason.
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

    /// Passes on the rows at these coordinates, at most one per lane; returns the number of rows
    /// with values.
    fn write_rows_at(&mut self, at: &[f64], rows: &mut RowWriter<impl Write>) -> io::Result<u64> {
        if self.errors.is_none() && self.clock.is_none() && self.read_at_once(at) {
            for lane in 0..at.len() {
                self.cells.resize(self.columns.len(), None);
                for (cell, column) in self.cells.iter_mut().zip(&self.columns) {
                    *cell = Some(column.0[lane]);
                }
                rows.state_row(&self.cells, Condition::Ok)?;
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
            self.count_hidden();
            rows.state_row(&self.cells, condition)?;
            valued += u64::from(condition != Condition::NoAssembly);
        }
        Ok(valued)
    }

    /// Returns the driver's coordinate in a row, and sets its motion at that time.
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

    /// Counts the row if existing values are not shown in it.
    fn count_hidden(&mut self) {
        let cells = self.quantities.iter().zip(&self.cells);
        let empty = cells.filter(|(_, cell)| cell.is_none()).map(|(q, _)| q);
        if let Some(hidden) = Hidden::of(empty, &self.state) {
            self.hidden += 1;
            self.first_hidden.get_or_insert(hidden);
        }
    }

    /// Solves all coordinates in parallel lanes. Returns `true` if every value exists; then
    /// `columns` has them.
    fn read_at_once(&mut self, at: &[f64]) -> bool {
        let Some(&last) = at.last() else {
            return false;
        };
        // Unused lanes repeat the last coordinate.
        let mut lanes = [last; LANES];
        lanes[..at.len()].copy_from_slice(at);
        if !self.solver.solve_lanes(lanes, self.order, &mut self.lanes) {
            return false;
        }
        self.columns.clear();
        for quantity in self.quantities {
            let Some(column) = quantity.value(&self.lanes) else {
                return false;
            };
            self.columns.push(column);
        }
        true
    }
}
