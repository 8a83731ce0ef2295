//! Writes the effect of tolerances on values over the motion, row by row.

use super::csv_dialect::{CsvDialect, CsvSheet};
use super::number::significant;
use super::steps::Steps;
use super::tables_data::{cell, number};
use super::tolerance_page::{bounded, closes_word, worst_word};
use crate::page::with_unit;
use crate::quantity::{Catalogue, Quantity, state_word};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver};
use crate::study::{SampleOrder, ToleranceStudy};
use serde_json::{Map, Value};
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
    pub format: ToleranceFormat,
}

/// The output format of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToleranceFormat {
    /// Aligned columns.
    Text,
    /// Comma separated values with a header.
    Csv(CsvDialect),
    /// One object: the scene, the units, and an object per row.
    Json,
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

/// A cell with a number or a word.
enum ToleranceCell {
    Number(Option<f64>),
    Word(&'static str),
}

/// Significant digits of text, and the other characters of a number.
const DIGITS: usize = 6;
const BESIDE_DIGITS: usize = 7;

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
        let mut outcome = ToleranceOutcome::default();
        let mut state = self.solver.state();
        let mut rows = self.steps.iter().map(|at| {
            let condition = self.solver.solve(at, Order::Position, &mut state);
            let row = self.row(study, at, condition, &mut outcome);
            watch(outcome.rows);
            row
        });
        match self.format {
            ToleranceFormat::Csv(dialect) => {
                let mut csv = CsvSheet::new(dialect, to);
                csv.record(columns.iter().map(header))?;
                for row in rows {
                    csv.record(row.iter().map(ToleranceCell::written))?;
                }
                csv.finish()?;
            }
            ToleranceFormat::Json => self.write_json(&columns, &mut rows, to)?,
            ToleranceFormat::Text => {
                let headers: Vec<String> = columns.iter().map(header).collect();
                let wide = |header: &String| header.len().max(DIGITS + BESIDE_DIGITS);
                let widths: Vec<usize> = headers.iter().map(wide).collect();
                write_line(to, headers.iter().map(String::as_str), &widths)?;
                for row in rows {
                    let cells: Vec<String> = row.iter().map(ToleranceCell::shown).collect();
                    write_line(to, cells.iter().map(String::as_str), &widths)?;
                }
            }
        }
        Ok(outcome)
    }

    fn write_json(
        &self,
        columns: &[(String, String)],
        rows: &mut dyn Iterator<Item = Vec<ToleranceCell>>,
        to: &mut dyn Write,
    ) -> io::Result<()> {
        let scene = Value::from(self.scene.name.as_str());
        let units = columns.iter().filter(|(_, unit)| !unit.is_empty());
        let units = units.map(|(name, unit)| (name.clone(), unit.as_str().into()));
        let units = Value::Object(units.collect());
        write!(to, "{{\n\"scene\": {scene},\n")?;
        writeln!(to, "\"units\": {units},")?;
        write!(to, "\"rows\": [")?;
        let mut before = "\n";
        for row in rows {
            let cells = columns.iter().zip(&row);
            let cells = cells.map(|((name, _), cell)| (name.clone(), cell.json()));
            let row = Value::Object(cells.collect::<Map<_, _>>());
            write!(to, "{before}{row}")?;
            before = ",\n";
        }
        to.write_all(b"\n]\n}\n")
    }

    /// Returns the names of the columns, and their units.
    fn columns(&self, figures: &[Quantity]) -> Vec<(String, String)> {
        let driver = Catalogue::new(self.scene).driver().clone();
        let mut columns = vec![(driver.name, driver.unit)];
        for figure in figures {
            let mut add = |part: &str, unit: &str| {
                columns.push((format!("{}.{part}", figure.name), unit.to_owned()));
            };
            for part in [
                "nominal",
                "worst.low",
                "worst.high",
                "reached.low",
                "reached.high",
            ] {
                add(part, &figure.unit);
            }
            add("worst.by", "");
            add("closes", "");
            add("rss", &figure.unit);
            if self.samples.is_some() {
                add("p0.135", &figure.unit);
                add("p99.865", &figure.unit);
            }
        }
        if self.samples.is_some() {
            columns.push(("samples.open".into(), String::new()));
        }
        columns.push(("state".into(), String::new()));
        columns
    }

    fn row(
        &self,
        study: &mut ToleranceStudy,
        at: f64,
        condition: Condition,
        outcome: &mut ToleranceOutcome,
    ) -> Vec<ToleranceCell> {
        use ToleranceCell::{Number, Word};
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
            let found = found.as_ref();
            let worst = found.map(|found| found.worst);
            row.extend([
                Number(found.map(|found| found.nominal)),
                Number(worst.and_then(|worst| bounded(worst.low))),
                Number(worst.and_then(|worst| bounded(worst.high))),
                Number(worst.map(|worst| worst.reached[0])),
                Number(worst.map(|worst| worst.reached[1])),
                Word(worst.map_or("", |worst| worst_word(worst.kind))),
                Word(worst.as_ref().map_or("", closes_word)),
                Number(found.and_then(|found| found.root_sum_square)),
            ]);
            if let Some(samples) = &samples {
                let of = samples.figures.get(i).copied().flatten();
                row.extend([Number(of.map(|of| of.low)), Number(of.map(|of| of.high))]);
            }
        }
        row.extend(samples.map(|samples| Number(Some(samples.open))));
        row.push(Word(state_word(condition)));
        row
    }
}

impl ToleranceCell {
    fn written(&self) -> String {
        match self {
            ToleranceCell::Number(value) => cell(*value),
            ToleranceCell::Word(word) => (*word).to_owned(),
        }
    }

    fn shown(&self) -> String {
        match self {
            ToleranceCell::Number(Some(value)) => significant(*value, DIGITS),
            ToleranceCell::Number(None) | ToleranceCell::Word("") => "-".into(),
            ToleranceCell::Word(word) => (*word).to_owned(),
        }
    }

    fn json(&self) -> Value {
        match self {
            ToleranceCell::Number(value) => number(*value),
            ToleranceCell::Word("") => Value::Null,
            ToleranceCell::Word(word) => (*word).into(),
        }
    }
}

fn header((name, unit): &(String, String)) -> String {
    with_unit(name, unit)
}

fn write_line<'c>(
    to: &mut dyn Write,
    cells: impl Iterator<Item = &'c str>,
    widths: &[usize],
) -> io::Result<()> {
    let cells = cells
        .zip(widths)
        .map(|(cell, &width)| format!("{cell:>width$}"));
    let line = cells.collect::<Vec<_>>().join("  ");
    writeln!(to, "{}", line.trim_end())
}
