//! Formats values as text for other programs: full digits, so that each value parses to the same
//! double, in cells separated by tabs below a heading.

use crate::quantity::{Abscissa, Curves, StateValues};
use crate::report::{Entry, Forces, Tables, shortest};
use crate::tui::figures::cursor::Cursor;
use crate::tui::figures::sheet::{Sheet, SheetPart};
use crate::wording::words;

/// Formats a value with full digits; empty for `None`.
fn number(value: Option<f64>) -> String {
    let mut text = String::new();
    if let Some(value) = value {
        shortest(value, &mut text);
    }
    text
}

fn cell(entry: Option<Entry>) -> String {
    number(entry.and_then(|entry| entry.value))
}

/// Formats the plotted values at the driver's position, below their names.
pub(crate) fn plotted(curves: &Curves, at: f64, here: Option<StateValues>) -> String {
    let here = here.unwrap_or_default();
    let [name, unit] = &curves.title;
    let along = match curves.abscissa {
        Abscissa::Driver => None,
        Abscissa::Time | Abscissa::Figure(_) => Some((format!("{name} [{unit}]"), here.along)),
    };
    let figures = curves.curves.iter().map(|curve| curve.quantity.header());
    let driver = (curves.driver.header(), Some(at));
    let columns = std::iter::once(driver).chain(along);
    let (names, values): (Vec<_>, Vec<_>) = columns.chain(figures.zip(here.values)).unzip();
    line(names.into_iter()) + &line(values.into_iter().map(number))
}

/// Formats all forces, one value per line.
pub(crate) fn balanced(forces: &Forces) -> String {
    let figures = forces.figures().into_iter();
    figures
        .map(|(name, unit, entry)| {
            line([format!("{name} [{unit}]"), number(entry.value)].into_iter())
        })
        .collect()
}

/// The tables as shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShownTables<'a> {
    pub(crate) sheet: &'a Sheet,
    pub(crate) tables: &'a Tables,
    /// Whether they are differences from another scene.
    pub(crate) differences: bool,
}

impl ShownTables<'_> {
    /// Formats the selected value alone; `None` if there is none.
    pub(crate) fn value(self, cursor: Cursor) -> Option<String> {
        let entries = self.sheet.entries(self.tables, cursor.part, cursor.row);
        let text = cell(entries.get(cursor.column).copied().flatten());
        (!text.is_empty()).then_some(text)
    }

    /// Formats the selected row with all its values, below their names.
    pub(crate) fn row(self, cursor: Cursor) -> String {
        self.heading(cursor.part) + &self.figures(cursor.part, cursor.row)
    }

    /// Formats all rows of a part, below the names of the values.
    pub(crate) fn table(self, part: SheetPart) -> String {
        let rows = 0..self.sheet.row_count(part);
        let rows = rows.map(|row| self.figures(part, row));
        self.heading(part) + &rows.collect::<String>()
    }

    /// Formats both parts, separated by an empty line.
    pub(crate) fn tables(self) -> String {
        let parts = [SheetPart::Vectors, SheetPart::Points].into_iter();
        let parts = parts.filter(|&part| self.sheet.row_count(part) > 0);
        let parts: Vec<String> = parts.map(|part| self.table(part)).collect();
        parts.join("\n")
    }

    fn heading(self, part: SheetPart) -> String {
        let title = match self.differences {
            true => words().difference_of(part.title()),
            false => part.title().to_owned(),
        };
        line(std::iter::once(title).chain(self.sheet.headers(part)))
    }

    fn figures(self, part: SheetPart, row: usize) -> String {
        let entries = self.sheet.entries(self.tables, part, row).into_iter();
        let name = part.name(self.tables, row).to_owned();
        line(std::iter::once(name).chain(entries.map(cell)))
    }
}

fn line(cells: impl Iterator<Item = String>) -> String {
    cells.collect::<Vec<_>>().join("\t") + "\n"
}
