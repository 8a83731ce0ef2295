//! Rows at given coordinates of all inputs, from a file.

use super::{Columns, SweepOutcome};
use crate::quantity::demand;
use crate::report::text::cells::ReadCells;
use crate::report::text::rows::{RowFormat, RowWriter};
use crate::scene::Scene;
use crate::solver::{Condition, Solver};
use crate::wording::words;
use std::io::{self, Write};

/// Maximum number of rows.
const MAX_ROWS: usize = 100_000;

/// The coordinates of all inputs row by row, the driver's first.
#[derive(Clone, Debug, PartialEq)]
pub struct InputPath {
    rows: Vec<Vec<f64>>,
}

impl InputPath {
    /// Parses a table with a column for each input, named after its link or slide. A driver
    /// without a column stays where the scene opens; any other input then follows the driver.
    ///
    /// # Errors
    /// Returns a message with the line of the first fault.
    pub fn read(scene: &Scene, bytes: &[u8]) -> Result<InputPath, String> {
        let ReadCells { rows, lines, .. } =
            ReadCells::read(bytes, MAX_ROWS + 1).ok_or_else(|| words().path_too_long(MAX_ROWS))?;
        let mechanism = &scene.mechanism;
        let opening = mechanism.driver().start;
        let at = mechanism
            .inputs()
            .map(|input| mechanism.input_coordinate(input, opening));
        let at: Vec<f64> = at.map(Option::unwrap_or_default).collect();
        let mut rows = rows.into_iter().zip(lines);
        let names = rows.next().map_or(Vec::new(), |(names, _)| names);
        let mut columns = Vec::with_capacity(names.len());
        for name in &names {
            let input = scene.input_named(name)?;
            let column = mechanism.inputs().position(|other| other == input);
            if columns.contains(&column) {
                return Err(words().path_names_twice(name));
            }
            columns.push(column);
        }
        let row = |(cells, line): (Vec<String>, u64)| {
            if cells.len() != names.len() {
                return Err(words().path_row_has_cells(line, cells.len(), names.len()));
            }
            let mut row = at.clone();
            for ((cell, column), name) in cells.iter().zip(&columns).zip(&names) {
                let number = cell.replace(',', ".").parse::<f64>().ok();
                let number = number.filter(|number| number.is_finite());
                let number = number.ok_or_else(|| words().path_cell(line, name, cell))?;
                if let Some(place) = column.and_then(|column| row.get_mut(column)) {
                    *place = number;
                }
            }
            let driven = row.first().copied().unwrap_or(opening);
            for ((number, input), place) in mechanism.inputs().enumerate().zip(&mut row) {
                if !columns.contains(&Some(number)) {
                    *place = mechanism.input_coordinate(input, driven).unwrap_or(*place);
                }
            }
            Ok(row)
        };
        let rows: Vec<Vec<f64>> = rows.map(row).collect::<Result<_, String>>()?;
        match rows.is_empty() {
            true => Err(words().path_is_empty().to_owned()),
            false => Ok(InputPath { rows }),
        }
    }

    /// Solves and writes all rows. Each row keeps the assembly of the previous one; a row that the
    /// inputs cannot reach has no values.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(
        &self,
        (scene, solver): (&Scene, &Solver),
        columns: &Columns,
        format: RowFormat,
        to: impl Write,
    ) -> io::Result<SweepOutcome> {
        let table = columns.table(format);
        let head = table.head(&scene.name, "rows", columns.units);
        let mut rows = RowWriter::new(table, &head, to)?;
        let (_, order) = demand(&columns.quantities);
        let mut outcome = SweepOutcome::default();
        let mut solver = solver.clone();
        let mut at = scene.mechanism.driver().start;
        for pose in &self.rows {
            let Some(&coordinate) = pose.first() else {
                continue;
            };
            let posed = scene.mechanism.posed(pose);
            let next = solver.with_dimensions_in_assembly(at, &posed);
            let mut cells = vec![Some(coordinate)];
            cells.resize(columns.quantities.len(), None);
            let mut condition = Condition::NoAssembly;
            if let Ok(next) = next {
                (solver, at) = (next, coordinate);
                let mut state = solver.state();
                condition = solver.solve(at, order, &mut state);
                cells = columns.quantities.iter().map(|q| q.value(&state)).collect();
                outcome.valued += u64::from(condition != Condition::NoAssembly);
            }
            rows.state_row(&cells, condition)?;
            outcome.rows += 1;
        }
        rows.finish()?;
        Ok(outcome)
    }
}
