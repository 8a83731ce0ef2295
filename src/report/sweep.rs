//! Rows of figures over the driver's coordinate: CSV, JSON or text, written as they are solved.
//!
//! One state and one buffer of text serve all rows: a sweep of a billion rows takes the memory of
//! one, and rows of CSV and JSON allocate nothing.

use super::number::{direction, shortest, significant};
use super::steps::Steps;
use crate::quantity::{self, Aspect, Quantity, Subject, demand, state_word};
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
    quantities: Vec<Quantity>,
    units: bool,
}

impl Columns {
    /// The driver's coordinate and these figures; the headers bear units if asked.
    #[must_use]
    pub fn new(driver: &Quantity, figures: &[Quantity], units: bool) -> Self {
        let figures = figures.iter().filter(|q| q.subject != Subject::Driver);
        let quantities = std::iter::once(driver).chain(figures).cloned().collect();
        Columns { quantities, units }
    }

    fn header(&self, quantity: &Quantity) -> String {
        if self.units {
            quantity.header()
        } else {
            quantity.name.clone()
        }
    }
}

/// Solves and writes all rows. Nothing is solved that the columns do not need.
///
/// # Errors
/// Those of the writer.
pub fn write_sweep(
    scene: &Scene,
    solver: &Solver,
    columns: &Columns,
    steps: &Steps,
    format: RowFormat,
    to: impl Write,
) -> io::Result<Outcome> {
    match format {
        RowFormat::Csv => run(solver, columns, steps, CsvRows::new(columns, to)?),
        RowFormat::Json => run(solver, columns, steps, JsonRows::new(scene, columns, to)?),
        RowFormat::Text { digits } => {
            run(solver, columns, steps, TextRows::new(columns, digits, to)?)
        }
    }
}

fn run(
    solver: &Solver,
    columns: &Columns,
    steps: &Steps,
    mut rows: impl Rows,
) -> io::Result<Outcome> {
    let (wanted, order) = demand(&columns.quantities);
    let solver = solver.only(&wanted);
    let mut state = solver.state();
    let mut outcome = Outcome::default();
    for at in steps.iter() {
        let condition = solver.solve(at, order, &mut state);
        outcome.rows += 1;
        outcome.valued += u64::from(condition != Condition::NoAssembly);
        for quantity in &columns.quantities {
            rows.value(quantity, quantity.value(&state))?;
        }
        rows.end(condition)?;
    }
    rows.finish()?;
    Ok(outcome)
}

/// One way to write rows: each value of a row, then its end.
trait Rows {
    fn value(&mut self, quantity: &Quantity, value: Option<f64>) -> io::Result<()>;
    fn end(&mut self, condition: Condition) -> io::Result<()>;
    fn finish(self) -> io::Result<()>;
}

/// Puts the shortest form of a value into `text`, nothing where none exists.
fn refill(text: &mut String, value: Option<f64>) {
    text.clear();
    if let Some(value) = value {
        shortest(value, text);
    }
}

/// The writer's own error: the crate's conversion would hide that a pipe was closed.
pub(super) fn plain(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

struct CsvRows<W: Write> {
    csv: csv::Writer<W>,
    text: String,
}

impl<W: Write> CsvRows<W> {
    fn new(columns: &Columns, to: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(to);
        for quantity in &columns.quantities {
            csv.write_field(columns.header(quantity)).map_err(plain)?;
        }
        csv.write_field("state").map_err(plain)?;
        csv.write_record(None::<&[u8]>).map_err(plain)?;
        let text = String::with_capacity(32);
        Ok(CsvRows { csv, text })
    }
}

impl<W: Write> Rows for CsvRows<W> {
    fn value(&mut self, _: &Quantity, value: Option<f64>) -> io::Result<()> {
        refill(&mut self.text, value);
        self.csv.write_field(&self.text).map_err(plain)
    }

    fn end(&mut self, condition: Condition) -> io::Result<()> {
        let word = state_word(condition);
        self.csv.write_field(word).map_err(plain)?;
        self.csv.write_record(None::<&[u8]>).map_err(plain)
    }

    fn finish(mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

struct JsonRows<W: Write> {
    to: W,
    /// `"C.x": ` and so on, ready to be written.
    keys: Vec<String>,
    /// The column that comes next.
    next: usize,
    rows: u64,
    text: String,
}

impl<W: Write> JsonRows<W> {
    fn new(scene: &Scene, columns: &Columns, mut to: W) -> io::Result<Self> {
        let name = serde_json::to_string(&scene.name)?;
        write!(to, "{{\n\"scene\": {name},\n")?;
        if columns.units {
            let units = columns.quantities.iter();
            let units = units.map(|q| (q.name.clone(), q.unit.clone().into()));
            let units = serde_json::Value::Object(units.collect());
            writeln!(to, "\"units\": {units},")?;
        }
        write!(to, "\"rows\": [")?;
        let key = |q: &Quantity| Ok(format!("{}: ", serde_json::to_string(&q.name)?));
        Ok(JsonRows {
            to,
            keys: columns
                .quantities
                .iter()
                .map(key)
                .collect::<io::Result<_>>()?,
            next: 0,
            rows: 0,
            text: String::with_capacity(32),
        })
    }
}

impl<W: Write> Rows for JsonRows<W> {
    fn value(&mut self, _: &Quantity, value: Option<f64>) -> io::Result<()> {
        let before = match (self.next, self.rows) {
            (0, 0) => "\n{",
            (0, _) => ",\n{",
            _ => ", ",
        };
        self.to.write_all(before.as_bytes())?;
        self.to.write_all(self.keys[self.next].as_bytes())?;
        self.next += 1;
        refill(&mut self.text, value);
        let shown = value.map_or("null", |_| &self.text);
        self.to.write_all(shown.as_bytes())
    }

    fn end(&mut self, condition: Condition) -> io::Result<()> {
        self.next = 0;
        self.rows += 1;
        write!(self.to, ", \"state\": \"{}\"}}", state_word(condition))
    }

    fn finish(mut self) -> io::Result<()> {
        self.to.write_all(b"\n]\n}\n")?;
        self.to.flush()
    }
}

/// Columns of a fixed width, since the rows to come are not known.
struct TextRows<W: Write> {
    to: W,
    widths: Vec<usize>,
    next: usize,
    digits: usize,
}

/// Characters of a number beside its digits: sign, point, and an exponent such as `e-300`.
const BESIDE_DIGITS: usize = 7;

impl<W: Write> TextRows<W> {
    fn new(columns: &Columns, digits: usize, mut to: W) -> io::Result<Self> {
        let mut widths = Vec::with_capacity(columns.quantities.len());
        for quantity in &columns.quantities {
            let header = columns.header(quantity);
            let width = header.chars().count().max(digits + BESIDE_DIGITS);
            write!(to, "{header:>width$}  ")?;
            widths.push(width);
        }
        writeln!(to, "state")?;
        Ok(TextRows {
            to,
            widths,
            next: 0,
            digits,
        })
    }
}

impl<W: Write> Rows for TextRows<W> {
    fn value(&mut self, quantity: &Quantity, value: Option<f64>) -> io::Result<()> {
        let width = self.widths[self.next];
        self.next += 1;
        let shown = value.map_or_else(|| "-".into(), |v| in_text(quantity, v, self.digits));
        write!(self.to, "{shown:>width$}  ")
    }

    fn end(&mut self, condition: Condition) -> io::Result<()> {
        self.next = 0;
        writeln!(self.to, "{}", state_word(condition))
    }

    fn finish(mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// A figure in a text table; the driver's angle counts turns and is never taken for a direction.
fn in_text(quantity: &Quantity, value: f64, digits: usize) -> String {
    let turns = quantity.subject == quantity::Subject::Driver;
    if quantity.aspect == Aspect::Angle && !turns {
        direction(value, digits)
    } else {
        significant(value, digits)
    }
}
