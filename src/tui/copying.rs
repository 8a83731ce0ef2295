//! Figures as text for other programs: full digits, so that each reads back to the same double, cells
//! between tabs, and above them what they are.

use super::cursor::Cursor;
use super::sheet::{Part, Sheet};
use crate::report::{Entry, Tables, shortest};

/// Full digits; nothing where no value exists.
fn cell(entry: Option<Entry>) -> String {
    let mut text = String::new();
    if let Some(value) = entry.and_then(|entry| entry.value) {
        shortest(value, &mut text);
    }
    text
}

/// The figure under the cursor, alone; `None` where there is none.
pub(crate) fn value(sheet: &Sheet, tables: &Tables, cursor: Cursor) -> Option<String> {
    let entries = sheet.entries(tables, cursor.part, cursor.row);
    let text = cell(entries.get(cursor.column).copied().flatten());
    (!text.is_empty()).then_some(text)
}

/// The row under the cursor with all its figures, below their names.
pub(crate) fn row(sheet: &Sheet, tables: &Tables, cursor: Cursor) -> String {
    let part = cursor.part;
    heading(sheet, part) + &figures(sheet, tables, part, cursor.row)
}

/// All rows of a part, below the names of the figures.
pub(crate) fn table(sheet: &Sheet, tables: &Tables, part: Part) -> String {
    let rows = 0..sheet.row_count(part);
    let rows = rows.map(|row| figures(sheet, tables, part, row));
    heading(sheet, part) + &rows.collect::<String>()
}

/// Both parts, an empty line between them.
pub(crate) fn tables(sheet: &Sheet, tables: &Tables) -> String {
    let parts = [Part::Vectors, Part::Points].into_iter();
    let parts = parts.filter(|&part| sheet.row_count(part) > 0);
    let parts: Vec<String> = parts.map(|part| table(sheet, tables, part)).collect();
    parts.join("\n")
}

fn heading(sheet: &Sheet, part: Part) -> String {
    let headers = sheet.headers(part);
    let cells = std::iter::once(part.title().to_owned()).chain(headers);
    line(cells)
}

fn figures(sheet: &Sheet, tables: &Tables, part: Part, row: usize) -> String {
    let entries = sheet.entries(tables, part, row).into_iter();
    let name = part.name(tables, row).to_owned();
    line(std::iter::once(name).chain(entries.map(cell)))
}

fn line(cells: impl Iterator<Item = String>) -> String {
    cells.collect::<Vec<_>>().join("\t") + "\n"
}
