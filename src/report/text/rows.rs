//! Tables written row by row, as CSV, JSON or aligned text.
//!
//! Rows of numbers and fixed words in CSV and JSON do not allocate: a line buffer serves all rows.

use crate::page::with_unit;
use crate::quantity::{Quantity, state_word};
use crate::report::text::csv_dialect::CsvDialect;
use crate::report::text::number::{direction, perpendicular_up, shortest, significant};
use crate::solver::Condition;
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::io::{self, Write};

/// The output format of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowFormat {
    /// Comma separated values with a header.
    Csv(CsvDialect),
    /// One object: the scene, the units, and an object per row.
    Json,
    /// Aligned columns.
    Text {
        /// Significant digits.
        digits: usize,
    },
}

/// A column of a table.
#[derive(Clone, Debug)]
pub struct RowColumn {
    /// The name, such as `r3.length` or `F.stroke`.
    pub name: String,
    /// The unit; empty for a plain number.
    pub unit: String,
    pub(in crate::report) kind: CellKind,
    /// The name, with the unit if it is shown.
    header: String,
}

/// The content of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum CellKind {
    /// Numbers.
    Number,
    /// Directions in degrees; 360 is shown as 0.
    Direction,
    /// Error bounds, shown as `+-2.1e-13`.
    Bound,
    /// Words.
    Word,
    /// Words at the end of a line, which are not aligned.
    LastWord,
    /// Remarks after the last word, without a header in text.
    Remark,
}

/// A cell of a row.
#[derive(Clone, Debug)]
pub(in crate::report) enum RowCell<'c> {
    /// A number; `None` if it does not exist.
    Number(Option<f64>),
    /// A word; empty if there is none.
    Word(Cow<'c, str>),
}

impl<'c> RowCell<'c> {
    pub(in crate::report) fn word(word: impl Into<Cow<'c, str>>) -> Self {
        RowCell::Word(word.into())
    }

    /// Appends the cell as JSON.
    fn push_json(&self, style: JsonStyle, line: &mut String) {
        match self {
            RowCell::Number(None) => line.push_str("null"),
            RowCell::Word(word) if word.is_empty() => line.push_str("null"),
            RowCell::Word(word) if word.contains(is_escaped) => {
                *line += &Value::from(&**word).to_string();
            }
            RowCell::Word(word) => line.extend(["\"", &**word, "\""]),
            RowCell::Number(Some(value)) => match style {
                JsonStyle::Spaced => shortest(*value, line),
                JsonStyle::Compact => *line += &Value::from(value + 0.0).to_string(),
            },
        }
    }
}

/// Returns `true` for a character that JSON escapes.
fn is_escaped(c: char) -> bool {
    c.is_control() || c == '"' || c == '\\'
}

impl RowColumn {
    /// Creates a column of numbers; `units` adds the unit to the header.
    pub(in crate::report) fn new(name: impl Into<String>, unit: &str, units: bool) -> RowColumn {
        let name = name.into();
        RowColumn {
            header: with_unit(&name, if units { unit } else { "" }),
            name,
            unit: unit.to_owned(),
            kind: CellKind::Number,
        }
    }

    /// Creates a column of words, or of another kind without a unit.
    pub(in crate::report) fn of_kind(name: impl Into<String>, kind: CellKind) -> RowColumn {
        RowColumn {
            kind,
            ..RowColumn::new(name, "", false)
        }
    }

    /// Creates a column of a quantity.
    pub(in crate::report) fn of(quantity: &Quantity, kind: CellKind, units: bool) -> RowColumn {
        let column = RowColumn::new(&quantity.name, &quantity.unit, units);
        RowColumn {
            header: match units {
                true => quantity.header(),
                false => column.header,
            },
            kind,
            ..column
        }
    }

    /// Creates the last column, the state.
    pub(in crate::report) fn state() -> RowColumn {
        RowColumn::of_kind("state", CellKind::LastWord)
    }

    /// Formats a value with its unit for people.
    pub(in crate::report) fn text(&self, value: f64, digits: usize) -> String {
        let number = significant(value, digits);
        match self.unit.is_empty() {
            true => number,
            false => format!("{number} {}", self.unit),
        }
    }

    fn is_number(&self) -> bool {
        match self.kind {
            CellKind::Number | CellKind::Direction | CellKind::Bound => true,
            CellKind::Word | CellKind::LastWord | CellKind::Remark => false,
        }
    }
}

/// The punctuation of rows in JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum JsonStyle {
    /// Blanks after colons and commas, the fewest digits, and units of all numbers.
    Spaced,
    /// No blanks, decimals in each number, and only units that are not empty.
    Compact,
}

/// The columns of a table and their format.
#[derive(Clone, Debug)]
pub(in crate::report) struct RowTable {
    pub(in crate::report) columns: Vec<RowColumn>,
    format: RowFormat,
    json: JsonStyle,
    /// The widths of columns in text.
    widths: Vec<usize>,
    /// The keys in JSON, with the colon.
    keys: Vec<String>,
}

/// Characters of a number besides its digits: sign, point, and an exponent such as `e-300`.
const EXTRA_CHARACTERS: usize = 7;
/// Significant digits of a bound.
const BOUND_DIGITS: usize = 2;

impl RowTable {
    pub(in crate::report) fn new(
        columns: Vec<RowColumn>,
        format: RowFormat,
        json: JsonStyle,
    ) -> RowTable {
        let digits = match format {
            RowFormat::Text { digits } => digits,
            RowFormat::Csv(_) | RowFormat::Json => 0,
        };
        let width = |c: &RowColumn| c.header.chars().count().max(digits + EXTRA_CHARACTERS);
        let key = |c: &RowColumn| match json {
            JsonStyle::Spaced => format!("{}: ", Value::from(&*c.name)),
            JsonStyle::Compact => format!("{}:", Value::from(&*c.name)),
        };
        RowTable {
            widths: columns.iter().map(width).collect(),
            keys: columns.iter().map(key).collect(),
            columns,
            format,
            json,
        }
    }

    /// Creates a table as CSV.
    pub(in crate::report) fn csv(columns: Vec<RowColumn>, dialect: CsvDialect) -> RowTable {
        RowTable::new(columns, RowFormat::Csv(dialect), JsonStyle::Spaced)
    }

    /// Returns the text before the rows. JSON has the name of a scene, the units if `units`, and
    /// the rows as a list of this name.
    pub(in crate::report) fn head(&self, scene: &str, list: &str, units: bool) -> String {
        let headers = self.columns.iter().map(|column| &*column.header);
        match self.format {
            RowFormat::Csv(dialect) => dialect.record(headers),
            RowFormat::Json => {
                let mut head = format!("{{\n\"scene\": {},\n", Value::from(scene));
                if units {
                    head += &format!("\"units\": {},\n", self.units());
                }
                head + &format!("\"{list}\": [")
            }
            RowFormat::Text { .. } => {
                let mut line = String::new();
                for ((column, header), width) in self.columns.iter().zip(headers).zip(&self.widths)
                {
                    push_aligned(&mut line, column.kind, header, *width);
                }
                ended(line)
            }
        }
    }

    fn units(&self) -> Value {
        let is_shown = |column: &&RowColumn| {
            column.is_number() && (self.json == JsonStyle::Spaced || !column.unit.is_empty())
        };
        let columns = self.columns.iter().filter(is_shown);
        let units = columns.map(|c| (c.name.clone(), c.unit.clone().into()));
        Value::Object(units.collect::<Map<_, _>>())
    }

    /// Appends a row; `is_first` for the first one.
    pub(in crate::report) fn push<'c>(
        &self,
        cells: impl IntoIterator<Item = RowCell<'c>>,
        is_first: bool,
        line: &mut String,
    ) {
        match self.format {
            RowFormat::Csv(dialect) => push_csv(cells, dialect, line),
            RowFormat::Json => self.push_json(cells, is_first, line),
            RowFormat::Text { digits } => self.push_text(cells, digits, line),
        }
    }

    fn push_json<'c>(
        &self,
        cells: impl IntoIterator<Item = RowCell<'c>>,
        is_first: bool,
        line: &mut String,
    ) {
        line.push_str(if is_first { "\n{" } else { ",\n{" });
        let comma = match self.json {
            JsonStyle::Spaced => ", ",
            JsonStyle::Compact => ",",
        };
        let mut before = "";
        for (key, cell) in self.keys.iter().zip(cells) {
            line.push_str(before);
            line.push_str(key);
            cell.push_json(self.json, line);
            before = comma;
        }
        line.push('}');
    }

    fn push_text<'c>(
        &self,
        cells: impl IntoIterator<Item = RowCell<'c>>,
        digits: usize,
        line: &mut String,
    ) {
        let mut text = String::new();
        for ((column, cell), width) in self.columns.iter().zip(cells).zip(&self.widths) {
            let shown = match (cell, column.kind) {
                (RowCell::Word(word), CellKind::Remark) => match &*word {
                    "" => word,
                    remark => format!(": {remark}").into(),
                },
                (RowCell::Word(word), _) if !word.is_empty() => word,
                (RowCell::Word(_) | RowCell::Number(None), _) => "-".into(),
                (RowCell::Number(Some(v)), CellKind::Direction) => direction(v, digits).into(),
                (RowCell::Number(Some(v)), CellKind::Bound) => {
                    format!("+-{}", perpendicular_up(v, BOUND_DIGITS)).into()
                }
                (RowCell::Number(Some(v)), _) => significant(v, digits).into(),
            };
            match column.kind {
                CellKind::Remark => text.push_str(&shown),
                kind => push_aligned(&mut text, kind, &shown, *width),
            }
        }
        *line += &ended(text);
    }

    /// Returns the text after the rows.
    pub(in crate::report) fn foot(&self) -> &'static str {
        match self.format {
            RowFormat::Json => "\n]\n}\n",
            RowFormat::Csv(_) | RowFormat::Text { .. } => "",
        }
    }
}

fn push_csv<'c>(
    cells: impl IntoIterator<Item = RowCell<'c>>,
    dialect: CsvDialect,
    line: &mut String,
) {
    let mut is_first = true;
    cells.into_iter().for_each(|cell| {
        if !std::mem::take(&mut is_first) {
            line.push(dialect.separator());
        }
        match cell {
            RowCell::Number(None) => {}
            RowCell::Number(Some(value)) => dialect.push(value, line),
            RowCell::Word(word) => dialect.push_word(&word, line),
        }
    });
    line.push('\n');
}

/// Appends a cell at the right of its column; the last word and remarks of a header are not aligned.
fn push_aligned(line: &mut String, kind: CellKind, text: &str, width: usize) {
    match kind {
        CellKind::LastWord => line.push_str(text),
        CellKind::Remark => {}
        _ => {
            let blanks = width.saturating_sub(text.chars().count());
            line.extend(std::iter::repeat_n(' ', blanks));
            line.push_str(text);
            line.push_str("  ");
        }
    }
}

/// Ends a line, without blanks at its end.
fn ended(mut line: String) -> String {
    line.truncate(line.trim_end_matches(' ').len());
    line + "\n"
}

/// Writes the rows of a table as they are computed.
pub(in crate::report) struct RowWriter<W: Write> {
    table: RowTable,
    to: W,
    line: String,
    /// The numbers of a line.
    numbers: Vec<u8>,
    is_first: bool,
}

impl<W: Write> RowWriter<W> {
    /// Writes the text before the rows.
    pub(in crate::report) fn new(table: RowTable, head: &str, mut to: W) -> io::Result<Self> {
        to.write_all(head.as_bytes())?;
        Ok(RowWriter {
            table,
            to,
            line: String::new(),
            numbers: Vec::new(),
            is_first: true,
        })
    }

    /// Writes a row.
    pub(in crate::report) fn row<'c>(
        &mut self,
        cells: impl IntoIterator<Item = RowCell<'c>>,
    ) -> io::Result<()> {
        self.line.clear();
        self.table.push(cells, self.is_first, &mut self.line);
        self.is_first = false;
        self.to.write_all(self.line.as_bytes())
    }

    /// Writes a row of numbers with the condition of the state.
    pub(in crate::report) fn state_row(
        &mut self,
        numbers: &[Option<f64>],
        condition: Condition,
    ) -> io::Result<()> {
        let state = state_word(condition);
        let RowFormat::Csv(dialect) = self.table.format else {
            let numbers = numbers.iter().copied().map(RowCell::Number);
            return self.row(numbers.chain([RowCell::word(state)]));
        };
        let end = dialect.fill(numbers, &mut self.numbers);
        self.line.clear();
        dialect.push_word(state, &mut self.line);
        self.line.push('\n');
        self.to.write_all(&self.numbers[..end])?;
        self.to.write_all(self.line.as_bytes())
    }

    /// Writes the text after the rows.
    pub(in crate::report) fn finish(mut self) -> io::Result<()> {
        self.to.write_all(self.table.foot().as_bytes())?;
        self.to.flush()
    }
}
