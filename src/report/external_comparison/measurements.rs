//! Compares measurements over the driver's coordinate with krank's values, row by row.

use super::external_table::{ForeignCurves, ForeignFigures, ForeignTable};
use super::list::value_difference;
use super::motion_difference;
use crate::page::{Page, TextStyle};
use crate::quantity::{Catalogue, Quantity};
use crate::report::sweep::SweepOutcome;
use crate::report::sweep::columns::{CellSource, Columns};
use crate::report::text::rows::{RowFormat, RowWriter};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};
use std::io::{self, Write};

/// Columns measured over the driver's coordinate.
pub struct Measured {
    file: String,
    course: ForeignCurves,
}

impl ForeignFigures {
    /// Interprets the file as measurements of the given values, or of all that krank knows. Returns
    /// `None` if it is not a table over the driver's coordinate, or has none of the values.
    #[must_use]
    pub fn measured(&self, catalogue: &Catalogue, of: Option<&[Quantity]>) -> Option<Measured> {
        let ForeignTable::CyclePath(mut course) = self.table(catalogue) else {
            return None;
        };
        if let Some(of) = of {
            course.keep(|quantity| of.contains(quantity));
        }
        let is_any = !(course.rows.is_empty() || course.columns.is_empty());
        is_any.then(|| Measured {
            file: self.name().to_owned(),
            course,
        })
    }
}

impl Measured {
    /// Returns the measured quantities.
    #[must_use]
    pub fn figures(&self) -> &[Quantity] {
        &self.course.columns
    }

    /// Returns headers that are not columns of krank, or whose unit does not fit.
    #[must_use]
    pub fn strangers(&self) -> &[String] {
        &self.course.unknown_names
    }

    /// Returns a sentence about cells that are not numbers and were omitted, with line and column;
    /// `None` if all cells were read.
    #[must_use]
    pub fn left_out(&self) -> Option<String> {
        self.course.left_out()
    }

    /// Returns the driver's coordinate and the value of every measurement of a quantity.
    #[must_use]
    pub fn points(&self, index: usize) -> Vec<(f64, f64)> {
        let rows = self.course.rows.iter();
        let value = |(at, values): &(f64, Vec<_>)| {
            let value: Option<super::external_table::ForeignValue> = *values.get(index)?;
            Some((*at, value?.value))
        };
        rows.filter_map(value).collect()
    }

    /// Writes a row for each row of the file: krank's value, the measured one and measured minus
    /// computed, for every quantity. Text ends with the root mean square and the maximum of the
    /// differences.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(
        &self,
        (scene, solver): (&Scene, &Solver),
        (format, units): (RowFormat, bool),
        ascii: bool,
        mut to: impl Write,
    ) -> io::Result<SweepOutcome> {
        let table = self.columns(units).table(format);
        let head = table.head(&scene.name, "rows", units);
        let outcome = self.rows(solver, RowWriter::new(table, &head, &mut to)?)?;
        if let RowFormat::Text { .. } = format {
            write!(to, "\n{}", self.summary(solver, ascii))?;
        }
        Ok(outcome)
    }

    /// Formats the root mean square and the maximum difference of each quantity.
    fn summary(&self, solver: &Solver, ascii: bool) -> String {
        let mut page = Page::default();
        motion_difference::add_table(&mut page, &self.file, &self.course, solver);
        page.to_text(TextStyle::plain(ascii))
    }

    fn columns(&self, units: bool) -> Columns {
        let mut columns = Columns::new(&self.course.driver, &[], units);
        for quantity in &self.course.columns {
            let named = |ending: &str| Quantity {
                name: format!("{}.{ending}", quantity.name),
                ..quantity.clone()
            };
            columns.quantities.push(quantity.clone());
            columns.sources.push(CellSource::Figure);
            columns.quantities.push(named("measured"));
            columns.sources.push(CellSource::Figure);
            columns.quantities.push(named("difference"));
            columns.sources.push(CellSource::Difference);
        }
        columns
    }

    fn rows(&self, solver: &Solver, mut rows: RowWriter<impl Write>) -> io::Result<SweepOutcome> {
        let order = self.course.columns.iter().map(Quantity::order).max();
        let mut state = solver.state();
        let mut outcome = SweepOutcome::default();
        for (at, values) in &self.course.rows {
            let condition = solver.solve(*at, order.unwrap_or(Order::Position), &mut state);
            let mut cells = vec![Some(*at)];
            for (quantity, value) in self.course.columns.iter().zip(values) {
                let own = quantity.value(&state);
                let measured = match (value, own) {
                    (Some(value), Some(own)) => {
                        Some(value.nearer(|v| value_difference(quantity, v, own)).value)
                    }
                    (value, None) => value.map(|value| value.value),
                    (None, Some(_)) => None,
                };
                let off = own
                    .zip(measured)
                    .map(|(own, it)| value_difference(quantity, it, own));
                cells.extend([own, measured, off]);
            }
            rows.state_row(&cells, condition)?;
            outcome.rows += 1;
            outcome.valued += u64::from(condition != Condition::NoAssembly);
        }
        rows.finish()?;
        Ok(outcome)
    }
}
