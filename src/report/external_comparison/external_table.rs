//! Reads a table from another program or from notes, and recognizes the values that krank knows.

use crate::document::quoted;
use crate::quantity::{Catalogue, Quantity, unit_factor};
use crate::report::text::cells::ReadCells;
use crate::report::text::encoding::TextEncoding;
use crate::study::WrittenFigure;
use crate::wording::words;

/// Maximum number of rows.
const MAX_ROWS: usize = 100_000;

/// Values from notes or from another program. The table is a list with a row for each value
/// (`figure, unit, value`, the unit optional), or a table over the driver's coordinate as
/// `krank sweep` writes.
#[derive(Clone, Debug, PartialEq)]
pub struct ForeignFigures {
    name: String,
    rows: Vec<Vec<String>>,
    /// The line of the file on which each row begins.
    lines: Vec<u64>,
    encoding: TextEncoding,
}

/// The reason why a file has no usable values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFigures {
    /// Every row lacks a name or a number after it.
    Nothing,
    /// The table has too many rows or columns.
    TooLong,
}

/// The interpretation of a table.
pub(super) enum ForeignTable {
    List(Vec<ForeignRow>),
    CyclePath(ForeignCurves),
}

/// A value of a list.
pub(super) struct ForeignRow {
    /// The name as written.
    pub(super) name: String,
    /// The value as written.
    pub(super) written: String,
    /// The corresponding quantity, and the value in krank's unit; `None` if krank has no quantity
    /// of this name, or the unit does not fit.
    pub(super) figure: Option<(Quantity, ForeignValue)>,
}

/// A value in krank's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ForeignValue {
    pub(super) value: f64,
    /// Half a unit of the last written digit.
    pub(super) rounding: f64,
    /// The factor of the value if its decimal mark in fact separates thousands.
    thousands: Option<f64>,
}

/// Columns over the driver's coordinate.
pub(super) struct ForeignCurves {
    pub(super) driver: Quantity,
    pub(super) columns: Vec<Quantity>,
    /// The coordinate, and the value in each column, if any.
    pub(super) rows: Vec<(f64, Vec<Option<ForeignValue>>)>,
    /// Headers that are not columns of krank.
    pub(super) unknown_names: Vec<String>,
    /// Cells that should contain a number but do not: line, column and text.
    pub(super) unread: Vec<(u64, String, String)>,
}

/// Maximum number of cells listed in a message.
const MAX_LISTED: usize = 5;

impl ForeignCurves {
    /// Returns a sentence about the omitted cells, if any.
    pub(super) fn left_out(&self) -> Option<String> {
        let listed: Vec<_> = (self.unread.iter().take(MAX_LISTED))
            .map(|(line, column, cell)| (*line, column.as_str(), quoted(cell)))
            .collect();
        let more = self.unread.len() - listed.len();
        (!listed.is_empty()).then(|| words().cells_left_out(&listed, more))
    }

    /// Removes the columns for which `wanted` returns `false`.
    pub(super) fn keep(&mut self, wanted: impl Fn(&Quantity) -> bool) {
        let kept: Vec<bool> = self.columns.iter().map(wanted).collect();
        let mut marks = kept.iter();
        self.columns
            .retain(|_| marks.next().is_some_and(|&kept| kept));
        let (driver, columns) = (&self.driver, &self.columns);
        let left = [driver].into_iter().chain(columns);
        self.unread
            .retain(|(_, column, _)| left.clone().any(|quantity| quantity.name == *column));
        for (_, values) in &mut self.rows {
            let mut marks = kept.iter();
            values.retain(|_| marks.next().is_some_and(|&kept| kept));
        }
    }
}

impl ForeignFigures {
    /// Parses a file of this name, with cells separated by commas, semicolons or tabs.
    ///
    /// # Errors
    /// Returns an error if no row has a name followed by a number, or if there are too many rows.
    pub fn read(name: &str, bytes: &[u8]) -> Result<ForeignFigures, NoFigures> {
        let ReadCells {
            rows,
            lines,
            encoding,
            ..
        } = ReadCells::read(bytes, MAX_ROWS).ok_or(NoFigures::TooLong)?;
        let is_figure = |cells: &Vec<String>| cells.iter().any(|cell| number(cell).is_some());
        match rows.iter().any(is_figure) && rows.iter().any(|cells| cells.len() > 1) {
            true => Ok(ForeignFigures {
                name: name.to_owned(),
                rows,
                lines,
                encoding,
            }),
            false => Err(NoFigures::Nothing),
        }
    }

    /// Returns the encoding of the file.
    #[must_use]
    pub fn encoding(&self) -> TextEncoding {
        self.encoding
    }

    /// Returns the name of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Interprets the table: over the driver's coordinate if a header is the driver's, or else as a
    /// list.
    pub(super) fn table(&self, catalogue: &Catalogue) -> ForeignTable {
        let driver = catalogue.driver();
        let headers = self.rows.first().map_or(&[][..], Vec::as_slice);
        let headers: Vec<(String, String)> = headers.iter().map(|cell| head(cell)).collect();
        match headers.iter().position(|(name, _)| *name == driver.name) {
            Some(index) if self.rows.len() > 1 => {
                ForeignTable::CyclePath(self.course(catalogue, &headers, index))
            }
            _ => ForeignTable::List(
                self.rows
                    .iter()
                    .filter_map(|row| listed(catalogue, row))
                    .collect(),
            ),
        }
    }

    fn course(
        &self,
        catalogue: &Catalogue,
        headers: &[(String, String)],
        index: usize,
    ) -> ForeignCurves {
        let driver = catalogue.driver().clone();
        let mut columns = Vec::new();
        let mut strangers = Vec::new();
        for (k, (name, unit)) in headers.iter().enumerate().filter(|(k, _)| *k != index) {
            let found = catalogue.find(name);
            let factor = found
                .as_ref()
                .and_then(|quantity| unit_factor(unit, &quantity.unit));
            match (found, factor) {
                (Some(quantity), Some(factor)) => columns.push((k, factor, quantity)),
                // A column without numbers is not reported.
                _ if self
                    .rows
                    .iter()
                    .any(|row| row.get(k).is_some_and(|cell| number(cell).is_some())) =>
                {
                    strangers.push(name.clone());
                }
                _ => {}
            }
        }
        let turned = unit_factor(&headers[index].1, &driver.unit);
        if turned.is_none() {
            strangers.push(driver.name.clone());
        }
        let row = |cells: &Vec<String>| {
            let at = number(cells.get(index)?)?.value * turned?;
            let value = |(k, factor, _): &(usize, f64, Quantity)| {
                Some(number(cells.get(*k)?)?.times(*factor))
            };
            Some((at, columns.iter().map(value).collect()))
        };
        let mut unread = Vec::new();
        for (cells, line) in self.rows.iter().zip(&self.lines).skip(1) {
            let is_there = |k: usize| cells.get(k).is_some_and(|cell| !cell.is_empty());
            let is_row = turned.is_some() && (0..cells.len()).any(is_there);
            let read = |k: usize| cells.get(k).is_some_and(|cell| number(cell).is_some());
            let cell = |k: usize| cells.get(k).cloned().unwrap_or_default();
            // A row without a coordinate is not read.
            if is_row && !read(index) {
                unread.push((*line, driver.name.clone(), cell(index)));
                continue;
            }
            let bad = columns
                .iter()
                .filter(|(k, ..)| is_row && is_there(*k) && !read(*k));
            unread.extend(bad.map(|(k, _, quantity)| (*line, quantity.name.clone(), cell(*k))));
        }
        ForeignCurves {
            unread,
            rows: self.rows.iter().skip(1).filter_map(row).collect(),
            driver,
            columns: columns
                .into_iter()
                .map(|(_, _, quantity)| quantity)
                .collect(),
            unknown_names: strangers,
        }
    }
}

/// Reads a row of a list: a name, and the last number after it. Headers have no number and are
/// skipped.
fn listed(catalogue: &Catalogue, cells: &[String]) -> Option<ForeignRow> {
    let (name, unit) = head(cells.first()?);
    let rest = cells.get(1..)?;
    let index = rest.iter().rposition(|cell| number(cell).is_some())?;
    let unit = match rest[..index].iter().rfind(|cell| !cell.is_empty()) {
        Some(cell) => cell.clone(),
        None => unit,
    };
    let figure = catalogue.find(&name).and_then(|quantity| {
        let value = number(&rest[index])?.times(unit_factor(&unit, &quantity.unit)?);
        Some((quantity, value))
    });
    // A unit equal to krank's is already in the row's name; another one is shown with the value.
    let is_own = |(quantity, _): &(Quantity, ForeignValue)| unit == quantity.unit;
    let written = match unit.is_empty() || figure.as_ref().is_some_and(is_own) {
        true => rest[index].clone(),
        false => format!("{} {unit}", rest[index]),
    };
    (!name.is_empty()).then_some(ForeignRow {
        name,
        written,
        figure,
    })
}

/// Splits `C.v [mm/s]` into name and unit.
fn head(cell: &str) -> (String, String) {
    match cell.trim_end_matches(']').split_once('[') {
        Some((name, unit)) => (name.trim().to_owned(), unit.trim().to_owned()),
        None => (cell.trim().to_owned(), String::new()),
    }
}

/// Parses a number without a unit; a degree sign is accepted. Returns `None` for other cells.
fn number(cell: &str) -> Option<ForeignValue> {
    let (written, unit) = WrittenFigure::read(cell)?;
    let is_bare = unit.is_empty() || unit == "°";
    is_bare.then(|| ForeignValue {
        value: written.value,
        rounding: 0.5 * written.unit_of(0, 17),
        thousands: written.with_thousands().map(|_| THOUSAND),
    })
}

const THOUSAND: f64 = 1000.0;

impl ForeignValue {
    fn times(self, factor: f64) -> ForeignValue {
        ForeignValue {
            value: self.value * factor,
            rounding: self.rounding * factor,
            ..self
        }
    }

    /// Resolves an ambiguous mark, as in `8,259`: takes thousands if the result is closer to
    /// krank's value. `apart` computes the difference from it.
    pub(super) fn nearer(self, distance: impl Fn(f64) -> f64) -> ForeignValue {
        let integer = self.thousands.map(|factor| self.times(factor));
        let is_nearer =
            |integer: &ForeignValue| distance(integer.value).abs() < distance(self.value).abs();
        integer.filter(is_nearer).unwrap_or(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three decimals may also be a thousands group, and a zero is not accurate to a tenth of its
    /// last digit.
    #[test]
    fn ambiguous_number_is_read_as_nearer_value() {
        let hundreds = number("8,259").unwrap();
        assert_eq!(hundreds.nearer(|value| value - 8262.4).value, 8259.0);
        assert_eq!(hundreds.nearer(|value| value - 8.2624).value, 8.259);
        let metres = number("28,160").unwrap().times(1000.0);
        let near = metres.nearer(|value| value - 28_163.0);
        assert!((near.value - 28_160.0).abs() < 1e-9 && (near.rounding - 0.5).abs() < 1e-9);
        let zero = number("0.000").unwrap();
        assert!((zero.rounding - 0.0005).abs() < 1e-12, "{zero:?}");
        assert_eq!(number("1,2,3"), None);
    }

    #[test]
    fn file_without_values_is_rejected() {
        for text in ["", "figure,value\n", "a\nb\n", "7\n8\n"] {
            let read = ForeignFigures::read("x.csv", text.as_bytes());
            assert_eq!(read, Err(NoFigures::Nothing), "{text}");
        }
        let long = "a,1\n".repeat(MAX_ROWS + 1);
        assert_eq!(
            ForeignFigures::read("x.csv", long.as_bytes()),
            Err(NoFigures::TooLong)
        );
    }
}
