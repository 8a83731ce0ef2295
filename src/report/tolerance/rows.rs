//! Writes the effect of tolerances on values over the motion, row by row.

use crate::quantity::{Catalogue, Quantity, state_word};
use crate::report::sweep::steps::Steps;
use crate::report::text::rows::{
    CellKind, JsonStyle, RowCell, RowColumn, RowFormat, RowTable, RowWriter,
};
use crate::report::tolerance::report::results;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};
use crate::study::{SampleOrder, ToleranceStudy};
use std::io::{self, Write};

/// The input of a study over the motion, and its output format.
#[derive(Clone, Copy, Debug)]
pub struct ToleranceRows<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The solver of the scene, with nominal lengths.
    pub solver: &'a Solver,
    /// The driver's coordinate of each row.
    pub steps: &'a Steps,
    /// The samples of each row, if requested.
    pub samples: Option<SampleOrder>,
    /// The output format.
    pub format: RowFormat,
}

/// The outcome of a study over the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ToleranceOutcome {
    /// The number of rows written.
    pub rows: u64,
    /// The number of rows in which the nominal mechanism closes.
    pub valued: u64,
    /// The number of rows in which a worst case is only an estimate.
    pub estimated: u64,
    /// The number of rows in which some mechanism within the tolerances is known not to close.
    pub fails: u64,
}

impl ToleranceRows<'_> {
    /// Solves and writes all rows; calls `watch` with their number.
    ///
    /// # Errors
    /// Returns the errors of the writer.
    pub fn write(
        &self,
        study: &mut ToleranceStudy,
        to: &mut dyn Write,
        watch: &mut dyn FnMut(u64),
    ) -> io::Result<ToleranceOutcome> {
        let columns = self.columns(study.figures());
        let table = RowTable::new(columns, self.format, JsonStyle::Compact);
        let head = table.head(&self.scene.name, "rows", true);
        let mut rows = RowWriter::new(table, &head, to)?;
        let mut outcome = ToleranceOutcome::default();
        let mut state = self.solver.state();
        for at in self.steps.iter() {
            let condition = self.solver.solve(at, Order::Position, &mut state);
            rows.row(self.row(study, at, condition, &mut outcome))?;
            watch(outcome.rows);
        }
        rows.finish()?;
        Ok(outcome)
    }

    fn columns(&self, quantities: &[Quantity]) -> Vec<RowColumn> {
        let driver = Catalogue::new(self.scene).driver().clone();
        let mut columns = vec![RowColumn::new(driver.name, &driver.unit, true)];
        for quantity in quantities {
            let name = |part| format!("{}.{part}", quantity.name);
            let number = |part| RowColumn::new(name(part), &quantity.unit, true);
            columns.extend(results(None).map(|(part, cell)| match cell {
                RowCell::Number(_) => number(part),
                RowCell::Word(_) => RowColumn::of_kind(name(part), CellKind::Word),
            }));
            if self.samples.is_some() {
                columns.extend(["p0.135", "p99.865"].map(number));
            }
        }
        let open = RowColumn::new("samples.open", "", true);
        columns.extend(self.samples.map(|_| open));
        columns.push(RowColumn::of_kind("state", CellKind::Word));
        columns
    }

    fn row(
        &self,
        study: &mut ToleranceStudy,
        at: f64,
        condition: Condition,
        outcome: &mut ToleranceOutcome,
    ) -> Vec<RowCell<'static>> {
        use RowCell::Number;
        let mut found = study.at(at);
        let samples = self.samples.map(|order| study.sampled(at, order));
        if let (Some(order), Some(samples)) = (self.samples, &samples) {
            for pair in found.iter_mut().zip(&samples.figures) {
                if let (Some(found), Some(percentiles)) = pair {
                    found.with_samples(order, percentiles);
                }
            }
        }
        outcome.rows += 1;
        outcome.valued += u64::from(condition != Condition::NoAssembly);
        let worsts = || found.iter().flatten().map(|found| found.worst);
        let is_estimated = worsts().any(|worst| worst.kind.is_estimate());
        outcome.estimated += u64::from(is_estimated);
        outcome.fails += u64::from(worsts().any(|worst| worst.fails));
        let mut row = vec![Number(Some(at))];
        for (i, found) in found.iter().enumerate() {
            row.extend(results(found.as_ref()).map(|(_, cell)| cell));
            if let Some(samples) = &samples {
                let of = samples.figures.get(i).copied().flatten();
                row.extend([Number(of.map(|of| of.low)), Number(of.map(|of| of.high))]);
            }
        }
        row.extend(samples.map(|samples| Number(Some(samples.open))));
        row.push(RowCell::word(state_word(condition)));
        row
    }
}
