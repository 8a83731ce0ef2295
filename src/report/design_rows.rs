//! Formats rows of designs as CSV, JSON or aligned columns.

use super::csv_dialect::{CsvDialect, CsvSheet};
use super::cycle_report::figure_reason;
use super::number::{shortest, significant};
use crate::page::with_unit;
use crate::study::{DesignFigures, DesignRow};
use crate::wording::words;
use std::fmt::Write;
use std::io;

/// The output format of designs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DesignFormat {
    /// Comma separated values.
    Csv(CsvDialect),
    /// One object: the scene, the units, and an object for each design.
    Json,
    /// Columns of a fixed width.
    Text {
        /// Significant digits.
        digits: usize,
    },
}

/// A column of the table of designs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DesignColumn {
    /// The name, such as `r3.length` or `F.stroke`.
    pub name: String,
    /// The unit; empty for a plain number.
    pub unit: String,
}

/// A table with a row for each design: its numbers, its values, its state, and the reasons for
/// missing values.
#[derive(Clone, Debug)]
pub struct DesignTable {
    scene: String,
    driver: String,
    columns: Vec<DesignColumn>,
    /// The number of columns with varied numbers.
    varied: usize,
    format: DesignFormat,
    units: bool,
}

/// The last columns.
const STATE: [&str; 2] = ["state", "reason"];
/// Characters of a number besides its digits: sign, point, and an exponent such as `e-300`.
const BESIDE_DIGITS: usize = 7;

impl DesignColumn {
    fn header(&self, units: bool) -> String {
        with_unit(&self.name, if units { &self.unit } else { "" })
    }

    /// Formats a value with its unit for people.
    pub(super) fn text(&self, value: f64, digits: usize) -> String {
        let number = significant(value, digits);
        match self.unit.is_empty() {
            true => number,
            false => format!("{number} {}", self.unit),
        }
    }
}

impl DesignTable {
    /// Creates a table of values of designs; `driver` is the unit of the driver's coordinate.
    #[must_use]
    pub fn new(
        figures: &DesignFigures,
        driver: &str,
        format: DesignFormat,
        units: bool,
    ) -> DesignTable {
        let space = figures.space();
        let column = |name: String, unit: &str| DesignColumn {
            name,
            unit: unit.to_owned(),
        };
        let values = space.values().iter();
        let values = values.map(|value| column(value.dotted(), &value.shown_unit()));
        let found = figures.figures().iter();
        let found = found.map(|figure| column(figure.name().to_owned(), figure.unit()));
        DesignTable {
            scene: space.scene().name.clone(),
            driver: driver.to_owned(),
            columns: values.chain(found).collect(),
            varied: space.values().len(),
            format,
            units,
        }
    }

    /// Returns the columns of varied numbers, and those of values.
    #[must_use]
    pub fn columns(&self) -> (&[DesignColumn], &[DesignColumn]) {
        self.columns.split_at(self.varied)
    }

    /// Returns the text before the rows.
    ///
    /// # Errors
    /// Never fails in practice, because the output is a string.
    pub fn head(&self) -> io::Result<String> {
        let headers = self.columns.iter().map(|column| column.header(self.units));
        match self.format {
            DesignFormat::Csv(dialect) => {
                let mut bytes = Vec::new();
                let mut sheet = CsvSheet::new(dialect, &mut bytes);
                sheet.record(headers.chain(STATE.map(str::to_owned)))?;
                sheet.finish()?;
                Ok(String::from_utf8_lossy(&bytes).into_owned())
            }
            DesignFormat::Json => self.head_of_json(),
            DesignFormat::Text { digits } => {
                let cell = |(column, header): (&DesignColumn, String)| {
                    format!("{header:>width$}  ", width = self.width(column, digits))
                };
                let cells: String = self.columns.iter().zip(headers).map(cell).collect();
                Ok(format!("{cells}{}\n", STATE[0]))
            }
        }
    }

    fn head_of_json(&self) -> io::Result<String> {
        let scene = serde_json::to_string(&self.scene)?;
        let mut head = format!("{{\n\"scene\": {scene},\n");
        if self.units {
            let units = self.columns.iter();
            let units = units.map(|c| (c.name.clone(), c.unit.clone().into()));
            let units = serde_json::Value::Object(units.collect());
            head += &format!("\"units\": {units},\n");
        }
        Ok(head + "\"designs\": [")
    }

    /// Formats a row; `is_first` for the first one.
    ///
    /// # Errors
    /// Never fails in practice, because the output is a string.
    pub fn line(&self, row: &DesignRow, is_first: bool) -> io::Result<String> {
        match self.format {
            DesignFormat::Csv(dialect) => Ok(self.line_of_csv(row, dialect)),
            DesignFormat::Json => self.line_of_json(row, is_first),
            DesignFormat::Text { digits } => Ok(self.line_of_text(row, digits)),
        }
    }

    /// Returns the text after the rows.
    #[must_use]
    pub fn foot(&self) -> &'static str {
        match self.format {
            DesignFormat::Json => "\n]\n}\n",
            DesignFormat::Csv(_) | DesignFormat::Text { .. } => "",
        }
    }

    /// Returns the numbers, then the values.
    fn cells<'r>(&self, row: &'r DesignRow) -> impl Iterator<Item = Option<f64>> + use<'r> {
        let figures = self.columns.len() - self.varied;
        let numbers = row.numbers.iter().copied().map(Some);
        numbers.chain((0..figures).map(|figure| row.figure(figure)))
    }

    fn line_of_csv(&self, row: &DesignRow, dialect: CsvDialect) -> String {
        let mut line = String::new();
        for cell in self.cells(row) {
            if let Some(value) = cell {
                dialect.push(value, &mut line);
            }
            line.push(dialect.separator());
        }
        line.push_str(row.state.word());
        line.push(dialect.separator());
        line.push_str(&quoted(&self.reason(row), dialect.separator()));
        line.push('\n');
        line
    }

    fn line_of_json(&self, row: &DesignRow, is_first: bool) -> io::Result<String> {
        let mut line = if is_first { "\n{" } else { ",\n{" }.to_owned();
        for (column, cell) in self.columns.iter().zip(self.cells(row)) {
            line += &serde_json::to_string(&column.name)?;
            line.push_str(": ");
            match cell {
                Some(value) => shortest(value, &mut line),
                None => line.push_str("null"),
            }
            line.push_str(", ");
        }
        let reason = self.reason(row);
        let reason = match reason.is_empty() {
            true => "null".to_owned(),
            false => serde_json::to_string(&reason)?,
        };
        let state = row.state.word();
        line += &format!("\"state\": \"{state}\", \"reason\": {reason}}}");
        Ok(line)
    }

    fn line_of_text(&self, row: &DesignRow, digits: usize) -> String {
        let mut line = String::new();
        for (column, cell) in self.columns.iter().zip(self.cells(row)) {
            let shown = cell.map_or_else(|| "-".into(), |value| significant(value, digits));
            // Writing to a string cannot fail.
            let _ = write!(
                line,
                "{shown:>width$}  ",
                width = self.width(column, digits)
            );
        }
        line.push_str(row.state.word());
        let reason = self.reason(row);
        if !reason.is_empty() {
            line += &format!(": {reason}");
        }
        line + "\n"
    }

    fn width(&self, column: &DesignColumn, digits: usize) -> usize {
        let header = column.header(self.units).chars().count();
        header.max(digits + BESIDE_DIGITS)
    }

    /// Returns the reasons for missing values in a row, in one line.
    #[must_use]
    pub fn reason(&self, row: &DesignRow) -> String {
        let (_, columns) = self.columns();
        let lacking = columns
            .iter()
            .zip(&row.figures)
            .filter_map(|(column, figure)| {
                let why = figure_reason(figure.err()?, &self.driver, words());
                Some(format!("{}: {why}", column.name))
            });
        let own = Some(row.reason.clone()).filter(|reason| !reason.is_empty());
        let all: Vec<String> = own.into_iter().chain(lacking).collect();
        all.join("; ").replace(['\n', '\r'], " ")
    }
}

/// Formats a cell of text, with quotes if needed.
fn quoted(text: &str, separator: char) -> String {
    match text.contains([separator, '"']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}
