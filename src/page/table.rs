//! Represents tables of values as data.

use super::line::TextRole;
use super::math::Formula;
use super::words::length;
use std::ops::Range;

/// Rows under a head: names on the left, values on the right.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The title of the name column.
    pub title: String,
    /// The columns.
    pub heads: Vec<Head>,
    /// The rows, none with more cells than there are columns.
    pub rows: Vec<Row>,
    /// The layout settings.
    pub setting: Setting,
}

/// The head of a column: its name and its unit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// The name of the column.
    pub name: String,
    /// The unit; empty if there is none, or if the name includes it.
    pub unit: String,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// A subheading for the rows below.
    Part(String),
    /// A row of values.
    Figures {
        /// The mark before the name: the letter of a chart.
        mark: String,
        /// The name of the row.
        name: String,
        /// A longer name, used if there is enough space.
        more: Option<String>,
        /// The values; `None` if the row has no such value.
        cells: Vec<Option<Cell>>,
    },
    /// A row with words instead of values.
    Told {
        /// The mark before the name.
        mark: String,
        /// The name of the row.
        name: String,
        /// The words.
        words: String,
    },
}

/// A formatted value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The characters of the cell.
    pub text: String,
    /// The digits that no error bound proves.
    pub unproved: UnprovedDigits,
    /// The equation of a result or of an unknown, which is highlighted.
    pub formula: Option<Formula>,
}

/// The digits of a value that its error bound does not prove.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UnprovedDigits {
    /// All digits are proved.
    Nothing,
    /// The digits at these positions of the text.
    Last(Range<usize>),
    /// All digits: there is no bound.
    Everything,
}

/// The layout settings of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The number of blanks before the names.
    pub(crate) indent: usize,
    /// The minimum width of the names in characters, limited to a third of the width. The longest
    /// name can require more.
    pub(crate) names: usize,
    /// The minimum widths of the columns in characters; the last one applies to all further
    /// columns.
    pub(crate) least: Vec<usize>,
    /// The minimum number of blanks between two columns.
    pub(crate) gap: usize,
    /// The maximum number of additional blanks between columns.
    pub(crate) spread: usize,
    /// The position of the units.
    pub(crate) units: Units,
    /// The treatment of columns that do not fit next to the others.
    pub(crate) rest: Rest,
    /// The role of the row names: names of elements, or labels of descriptions.
    pub(crate) called: TextRole,
}

/// The position of the units of columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Behind the names: `r [mm]`.
    Behind,
    /// In a separate line.
    Below,
}

/// The treatment of columns that do not fit next to the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rest {
    /// The remaining columns follow below, with the same names.
    Below,
    /// The remaining columns are left out: the first columns are the most important.
    LeftOut,
}

impl Default for Setting {
    fn default() -> Self {
        Setting {
            indent: 0,
            names: 0,
            least: Vec::new(),
            gap: 2,
            spread: 0,
            units: Units::Behind,
            rest: Rest::Below,
            called: TextRole::Name,
        }
    }
}

impl Setting {
    /// Returns the width of a mark with the blanks between it and its name. The gap is narrower
    /// than between columns.
    pub(super) fn with_mark(&self, mark: &str) -> usize {
        match mark {
            "" => 0,
            mark => length(mark) + self.gap.saturating_sub(1),
        }
    }
}

impl Table {
    /// Creates a table whose columns have no units.
    pub(crate) fn new<H: Into<String>>(
        title: impl Into<String>,
        heads: impl IntoIterator<Item = H>,
    ) -> Table {
        let head = |name: H| Head {
            name: name.into(),
            unit: String::new(),
        };
        Table {
            title: title.into(),
            heads: heads.into_iter().map(head).collect(),
            ..Table::default()
        }
    }

    /// Sets the layout settings.
    pub(crate) fn set(mut self, setting: Setting) -> Table {
        self.setting = setting;
        self
    }

    /// Adds a row of values.
    pub(crate) fn row(
        &mut self,
        name: impl Into<String>,
        cells: impl IntoIterator<Item = impl Into<Cell>>,
    ) {
        self.rows.push(Row::Figures {
            mark: String::new(),
            name: name.into(),
            more: None,
            cells: cells.into_iter().map(|cell| Some(cell.into())).collect(),
        });
    }
}

impl Head {
    /// Creates a head from a name and a unit, which may be empty.
    pub(crate) fn of(name: &str, unit: &str) -> Head {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        Head { name, unit }
    }

    /// Returns the name with its unit on one line.
    pub(crate) fn one_line(&self) -> String {
        with_unit(&self.name, &self.unit)
    }
}

/// Returns a name with its unit in brackets, if it has one.
pub(crate) fn with_unit(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}

impl Row {
    /// Returns the mark and the name of the row; with `more`, the longer name.
    pub(super) fn label(&self, more: bool) -> (&str, &str) {
        match self {
            Row::Part(name) => ("", name),
            Row::Told { mark, name, .. } => (mark, name),
            Row::Figures {
                mark,
                name,
                more: longer,
                ..
            } => (mark, longer.as_ref().filter(|_| more).unwrap_or(name)),
        }
    }
}

impl Cell {
    /// Creates a cell whose digits are all proved.
    pub(crate) fn proved(text: impl Into<String>) -> Cell {
        Cell {
            text: text.into(),
            unproved: UnprovedDigits::Nothing,
            formula: None,
        }
    }

    /// Creates a cell with an equation.
    pub(crate) fn equation(formula: Formula) -> Cell {
        Cell {
            formula: Some(formula.clone()),
            ..Cell::proved(formula.to_string())
        }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell::proved(text)
    }
}
