//! Formats rows of a sweep: CSV, JSON or aligned columns.
//!
//! Each format reuses one line buffer: rows of CSV and JSON do not allocate.

use super::columns::{CellSource, Columns};
use super::csv_dialect::{CsvDialect, CsvSheet};
use super::number::{direction, shortest, significant, upwards};
use crate::quantity::{Quantity, state_word};
use crate::solver::Condition;
use std::fmt::Write as _;
use std::io::{self, Write};

/// A format of rows.
pub(super) trait RowWriter {
    /// Writes a row: a cell for every column, empty if the value does not exist, and the condition
    /// of the state.
    fn row(&mut self, cells: &[Option<f64>], condition: Condition) -> io::Result<()>;

    /// Ends the output after all rows.
    fn finish(self) -> io::Result<()>;
}

/// Unwraps the writer's own error: the conversion of the csv crate would hide a closed pipe.
pub(super) fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// Writes comma separated values.
pub(super) struct CsvRows<W: Write> {
    to: W,
    dialect: CsvDialect,
    line: String,
}

impl<W: Write> CsvRows<W> {
    pub(super) fn new(columns: &Columns, dialect: CsvDialect, mut to: W) -> io::Result<Self> {
        let mut header = CsvSheet::new(dialect, &mut to);
        header.record(columns.headers().chain(["state".into()]))?;
        header.finish()?;
        let line = String::new();
        Ok(CsvRows { to, dialect, line })
    }
}

impl<W: Write> RowWriter for CsvRows<W> {
    /// Writes a row without quotes, which numbers and state words never need.
    fn row(&mut self, cells: &[Option<f64>], condition: Condition) -> io::Result<()> {
        self.line.clear();
        for cell in cells {
            if let Some(value) = *cell {
                self.dialect.push(value, &mut self.line);
            }
            self.line.push(self.dialect.separator());
        }
        self.line.push_str(state_word(condition));
        self.line.push('\n');
        self.to.write_all(self.line.as_bytes())
    }

    fn finish(mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// Writes one object: the scene, the units, and an object per row.
pub(super) struct JsonRows<W: Write> {
    to: W,
    /// The keys with separator, such as `"C.x": `.
    keys: Vec<String>,
    line: String,
    /// The text before the next row.
    before: &'static str,
}

impl<W: Write> JsonRows<W> {
    pub(super) fn new(scene: &str, columns: &Columns, mut to: W) -> io::Result<Self> {
        let scene = serde_json::to_string(scene)?;
        write!(to, "{{\n\"scene\": {scene},\n")?;
        if columns.units {
            let units = columns.quantities.iter();
            let units = units.map(|q| (q.name.clone(), q.unit.clone().into()));
            let units = serde_json::Value::Object(units.collect());
            writeln!(to, "\"units\": {units},")?;
        }
        write!(to, "\"rows\": [")?;
        let key = |q: &Quantity| Ok(format!("{}: ", serde_json::to_string(&q.name)?));
        let keys = columns.quantities.iter().map(key);
        Ok(JsonRows {
            keys: keys.collect::<io::Result<_>>()?,
            to,
            line: String::new(),
            before: "\n{",
        })
    }
}

impl<W: Write> RowWriter for JsonRows<W> {
    fn row(&mut self, cells: &[Option<f64>], condition: Condition) -> io::Result<()> {
        self.line.clear();
        self.line.push_str(self.before);
        self.before = ",\n{";
        for (key, cell) in self.keys.iter().zip(cells) {
            self.line.push_str(key);
            match *cell {
                Some(value) => shortest(value, &mut self.line),
                None => self.line.push_str("null"),
            }
            self.line.push_str(", ");
        }
        self.line.push_str("\"state\": \"");
        self.line.push_str(state_word(condition));
        self.line.push_str("\"}");
        self.to.write_all(self.line.as_bytes())
    }

    fn finish(mut self) -> io::Result<()> {
        self.to.write_all(b"\n]\n}\n")?;
        self.to.flush()
    }
}

/// Writes columns of a fixed width, because later rows are not known.
pub(super) struct TextRows<'c, W: Write> {
    to: W,
    columns: &'c Columns,
    widths: Vec<usize>,
    digits: usize,
    line: String,
}

/// Characters of a number besides its digits: sign, point, and an exponent such as `e-300`.
const BESIDE_DIGITS: usize = 7;

impl<'c, W: Write> TextRows<'c, W> {
    pub(super) fn new(columns: &'c Columns, digits: usize, mut to: W) -> io::Result<Self> {
        let mut widths = Vec::with_capacity(columns.quantities.len());
        for header in columns.headers() {
            let width = header.chars().count().max(digits + BESIDE_DIGITS);
            write!(to, "{header:>width$}  ")?;
            widths.push(width);
        }
        writeln!(to, "state")?;
        Ok(TextRows {
            to,
            columns,
            widths,
            digits,
            line: String::new(),
        })
    }
}

impl<W: Write> RowWriter for TextRows<'_, W> {
    fn row(&mut self, cells: &[Option<f64>], condition: Condition) -> io::Result<()> {
        self.line.clear();
        let columns = self.columns.quantities.iter().zip(&self.columns.sources);
        for (((quantity, source), width), cell) in columns.zip(&self.widths).zip(cells) {
            let shown = cell.map_or_else(
                || "-".into(),
                |v| match source {
                    CellSource::Figure => in_text(quantity, v, self.digits),
                    CellSource::Bound => format!("+-{}", upwards(v, BOUND_DIGITS)),
                    CellSource::Sensitivity(_) | CellSource::Difference => {
                        significant(v, self.digits)
                    }
                },
            );
            write!(self.line, "{shown:>width$}  ").map_err(io::Error::other)?;
        }
        writeln!(self.to, "{}{}", self.line, state_word(condition))
    }

    fn finish(mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// Significant digits of a bound.
const BOUND_DIGITS: usize = 2;

/// Formats a value in a text table; the driver's angle counts turns and is not a direction.
fn in_text(quantity: &Quantity, value: f64, digits: usize) -> String {
    if quantity.is_direction() {
        direction(value, digits)
    } else {
        significant(value, digits)
    }
}
