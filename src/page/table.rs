//! Figures in columns, as data.

use super::line::TextRole;
use super::words::length;
use std::ops::Range;

/// Rows under a head: names to the left, figures to the right of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// What the rows are.
    pub title: String,
    /// The columns.
    pub heads: Vec<Head>,
    /// No more cells to a row than there are columns.
    pub rows: Vec<Row>,
    /// How it is set.
    pub setting: Setting,
}

/// A column: what it shows, and its unit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// Its name.
    pub name: String,
    /// Its unit; empty where it has none, or where the name has it already.
    pub unit: String,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub enum Row {
    /// What begins here: the rows below belong together.
    Part(String),
    /// Figures.
    Figures {
        /// Before the name: the letter of a chart.
        mark: String,
        /// What the row is about.
        name: String,
        /// The same with more to say, where there is room.
        more: Option<String>,
        /// The figures; `None` where the row has no such figure at all.
        cells: Vec<Option<Cell>>,
    },
    /// A row that has words in the place of figures.
    Told {
        /// Before the name.
        mark: String,
        /// What the row is about.
        name: String,
        /// What is told of it.
        words: String,
    },
}

/// A figure as it is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Its characters.
    pub text: String,
    /// Which of them nothing proves.
    pub unsure: Unsure,
}

/// Which digits of a figure its bound does not cover.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unsure {
    /// None: all of them are proved.
    Nothing,
    /// Those at these places of the text.
    Last(Range<usize>),
    /// All: there is no bound.
    Everything,
}

/// How a table is set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Blanks before the names.
    pub(crate) indent: usize,
    /// Characters of the names: so many, but no more than a third of the width, and as many as the longest takes.
    pub(crate) names: usize,
    /// Characters of the columns, at the least; the last one stands for all that follow.
    pub(crate) least: Vec<usize>,
    /// Blanks between two columns, at the least.
    pub(crate) gap: usize,
    /// By so many blanks more columns move apart where there is room.
    pub(crate) spread: usize,
    /// Where units stand.
    pub(crate) units: Units,
    /// What becomes of columns that do not fit beside the others.
    pub(crate) rest: Rest,
    /// What the rows are called by: names of things, or labels of what is told.
    pub(crate) called: TextRole,
}

/// Where the units of columns stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Behind the names: `r [mm]`.
    Behind,
    /// In a line of their own.
    Below,
}

/// What becomes of columns that do not fit beside the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rest {
    /// They follow below, under the same names.
    Below,
    /// They are left out: the first say most.
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
    /// Characters of a mark with the blanks between it and its name: it belongs to it more than a figure does.
    pub(super) fn with_mark(&self, mark: &str) -> usize {
        match mark {
            "" => 0,
            mark => length(mark) + self.gap.saturating_sub(1),
        }
    }
}

impl Table {
    /// A table whose columns need no units.
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

    /// The same, set in another way.
    pub(crate) fn set(mut self, setting: Setting) -> Table {
        self.setting = setting;
        self
    }

    /// A row of figures.
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
    /// Of a name and a unit, which may be empty.
    pub(crate) fn of(name: &str, unit: &str) -> Head {
        let (name, unit) = (name.to_owned(), unit.to_owned());
        Head { name, unit }
    }

    /// As the name of a column is written in one line.
    pub(crate) fn whole(&self) -> String {
        with_unit(&self.name, &self.unit)
    }
}

/// A name with its unit in brackets, if it has one.
pub(crate) fn with_unit(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}

impl Row {
    /// What stands to the left, with more to say or without, behind its mark.
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
    /// Text without a digit that might be wrong.
    pub(crate) fn sure(text: impl Into<String>) -> Cell {
        Cell {
            text: text.into(),
            unsure: Unsure::Nothing,
        }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell::sure(text)
    }
}
