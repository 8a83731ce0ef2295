//! A table of cells that somebody else wrote: what of it are figures that krank knows.

use crate::quantity::{Catalogue, Quantity};
use crate::report::cells::ReadCells;
use crate::scene::Unit;
use crate::study::WrittenFigure;

/// What is read at the most.
const MOST_ROWS: usize = 100_000;

/// Figures of notes or of another program: a row for each (`figure, unit, value`, the unit may be missing), or a
/// table over the driver's coordinate as `krank sweep` writes one.
#[derive(Clone, Debug, PartialEq)]
pub struct ForeignFigures {
    name: String,
    rows: Vec<Vec<String>>,
}

/// Why a file holds no figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoFigures {
    /// No row has a name and a number beside it.
    Nothing,
    /// It has too many rows or columns.
    TooLong,
}

/// What was made of it.
pub(super) enum ForeignTable {
    List(Vec<ForeignRow>),
    Course(ForeignCourse),
}

/// A figure of a list.
pub(super) struct ForeignRow {
    /// As it stands there.
    pub(super) name: String,
    /// As it stands there.
    pub(super) written: String,
    /// Which that is, and its value in krank's unit; `None` where krank has none of that name, or in no such unit.
    pub(super) figure: Option<(Quantity, ForeignValue)>,
}

/// A figure in krank's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ForeignValue {
    pub(super) value: f64,
    /// Half a unit of its last digit.
    pub(super) rounding: f64,
}

/// Columns over the driver's coordinate.
pub(super) struct ForeignCourse {
    pub(super) driver: Quantity,
    pub(super) columns: Vec<Quantity>,
    /// The coordinate, and the value in each column, if there is one.
    pub(super) rows: Vec<(f64, Vec<Option<ForeignValue>>)>,
    /// Heads that are no columns of krank's.
    pub(super) strangers: Vec<String>,
}

impl ForeignFigures {
    /// Reads a file of this name: cells between commas, semicolons or tabs.
    ///
    /// # Errors
    /// Where no row has a name with a number beside it, or a number at all; or where there are too many.
    pub fn read(name: &str, bytes: &[u8]) -> Result<ForeignFigures, NoFigures> {
        let ReadCells { rows, .. } = ReadCells::read(bytes, MOST_ROWS).ok_or(NoFigures::TooLong)?;
        let is_figure = |cells: &Vec<String>| cells.iter().any(|cell| number(cell).is_some());
        match rows.iter().any(is_figure) && rows.iter().any(|cells| cells.len() > 1) {
            true => Ok(ForeignFigures {
                name: name.to_owned(),
                rows,
            }),
            false => Err(NoFigures::Nothing),
        }
    }

    /// The name of the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// A table over the driver where one of the heads is the driver's, else a list.
    pub(super) fn table(&self, catalogue: &Catalogue) -> ForeignTable {
        let driver = catalogue.driver();
        let heads = self.rows.first().map_or(&[][..], Vec::as_slice);
        let heads: Vec<(String, String)> = heads.iter().map(|cell| head(cell)).collect();
        match heads.iter().position(|(name, _)| *name == driver.name) {
            Some(place) if self.rows.len() > 1 => {
                ForeignTable::Course(self.course(catalogue, &heads, place))
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
        heads: &[(String, String)],
        place: usize,
    ) -> ForeignCourse {
        let driver = catalogue.driver().clone();
        let mut columns = Vec::new();
        let mut strangers = Vec::new();
        for (k, (name, unit)) in heads.iter().enumerate().filter(|(k, _)| *k != place) {
            let found = catalogue.find(name);
            let factor = found
                .as_ref()
                .and_then(|quantity| factor(unit, &quantity.unit));
            match (found, factor) {
                (Some(quantity), Some(factor)) => columns.push((k, factor, quantity)),
                // A column of words is none of figures.
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
        let turned = factor(&heads[place].1, &driver.unit).unwrap_or(1.0);
        let row = |cells: &Vec<String>| {
            let at = number(cells.get(place)?)?.value * turned;
            let value = |(k, factor, _): &(usize, f64, Quantity)| {
                Some(number(cells.get(*k)?)?.times(*factor))
            };
            Some((at, columns.iter().map(value).collect()))
        };
        ForeignCourse {
            rows: self.rows.iter().skip(1).filter_map(row).collect(),
            driver,
            columns: columns
                .into_iter()
                .map(|(_, _, quantity)| quantity)
                .collect(),
            strangers,
        }
    }
}

/// A row of a list: a name, and the last cell behind it that is a number. Heads have none, and are none.
fn listed(catalogue: &Catalogue, cells: &[String]) -> Option<ForeignRow> {
    let (name, unit) = head(cells.first()?);
    let rest = cells.get(1..)?;
    let place = rest.iter().rposition(|cell| number(cell).is_some())?;
    let unit = match rest[..place].iter().rfind(|cell| !cell.is_empty()) {
        Some(cell) => cell.clone(),
        None => unit,
    };
    let figure = catalogue.find(&name).and_then(|quantity| {
        let value = number(&rest[place])?.times(factor(&unit, &quantity.unit)?);
        Some((quantity, value))
    });
    (!name.is_empty()).then(|| ForeignRow {
        name,
        written: rest[place].clone(),
        figure,
    })
}

/// `C.v [mm/s]`: a name and its unit.
fn head(cell: &str) -> (String, String) {
    match cell.trim_end_matches(']').split_once('[') {
        Some((name, unit)) => (name.trim().to_owned(), unit.trim().to_owned()),
        None => (cell.trim().to_owned(), String::new()),
    }
}

fn number(cell: &str) -> Option<ForeignValue> {
    let written = WrittenFigure::read(cell, "")?;
    Some(ForeignValue {
        value: written.value,
        rounding: 0.5 * written.unit_of(1, 17),
    })
}

impl ForeignValue {
    fn times(self, factor: f64) -> ForeignValue {
        ForeignValue {
            value: self.value * factor,
            rounding: self.rounding * factor,
        }
    }
}

/// What a figure of one unit is multiplied by for another; `None` where they measure different things. Without a
/// unit it is taken for krank's.
fn factor(from: &str, to: &str) -> Option<f64> {
    let plain = from
        .replace('²', "^2")
        .replace("s2", "s^2")
        .replace('°', "deg");
    if plain.is_empty() || plain == to {
        return Some(1.0);
    }
    let (from, from_rate) = plain.split_once('/').unwrap_or((&plain, ""));
    let (to, to_rate) = to.split_once('/').unwrap_or((to, ""));
    let length = |symbol: &str| {
        let unit = Unit::ALL.into_iter().find(|unit| unit.symbol() == symbol);
        unit.map(Unit::metres)
    };
    let factor = match (from, to) {
        ("rad", "deg") => 1_f64.to_degrees(),
        ("deg", "rad") => 1_f64.to_radians(),
        ("rd", "rad") => 1.0,
        (from, to) if from == to => 1.0,
        (from, to) => length(from)? / length(to)?,
    };
    (from_rate == to_rate).then_some(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_turned_into_each_other_where_they_measure_the_same() {
        assert_eq!(factor("", "mm"), Some(1.0));
        assert_eq!(factor("cm/s2", "mm/s^2"), Some(10.0));
        assert_eq!(factor("m/s²", "mm/s^2"), Some(1000.0));
        assert_eq!(factor("rd/s", "rad/s"), Some(1.0));
        assert_eq!(factor("rad", "deg"), Some(1_f64.to_degrees()));
        assert_eq!(factor("mm", "mm/s"), None);
        assert_eq!(factor("deg", "mm"), None);
    }

    #[test]
    fn what_has_no_figure_is_refused() {
        for text in ["", "figure,value\n", "a\nb\n", "7\n8\n"] {
            let read = ForeignFigures::read("x.csv", text.as_bytes());
            assert_eq!(read, Err(NoFigures::Nothing), "{text}");
        }
        let long = "a,1\n".repeat(MOST_ROWS + 1);
        assert_eq!(
            ForeignFigures::read("x.csv", long.as_bytes()),
            Err(NoFigures::TooLong)
        );
    }
}
