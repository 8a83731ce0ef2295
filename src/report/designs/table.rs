//! The table of designs: varied numbers, values, and the state with reasons for missing values.

use crate::report::cycle::figure_reason;
use crate::report::text::rows::{CellKind, JsonStyle, RowCell, RowColumn, RowFormat, RowTable};
use crate::study::{DesignFigures, DesignRow};
use crate::wording::words;

/// A table with a row for each design: its numbers, its values, its state, and the reasons for
/// missing values.
#[derive(Clone, Debug)]
pub struct DesignTable {
    scene: String,
    driver: String,
    table: RowTable,
    /// The number of columns with varied numbers.
    varied: usize,
    /// The number of columns with values.
    figures: usize,
    units: bool,
}

impl DesignTable {
    /// Creates a table of values of designs; `driver` is the unit of the driver's coordinate.
    #[must_use]
    pub fn new(
        figures: &DesignFigures,
        driver: &str,
        format: RowFormat,
        units: bool,
    ) -> DesignTable {
        let space = figures.space();
        let values = space.values().iter();
        let values = values.map(|v| RowColumn::new(v.dotted(), &v.shown_unit(), units));
        let found = figures.figures().iter();
        let found = found.map(|figure| RowColumn::new(figure.name(), figure.unit(), units));
        let reason = RowColumn::of_kind("reason", CellKind::Remark);
        let columns = values.chain(found).chain([RowColumn::state(), reason]);
        DesignTable {
            scene: space.scene().name.clone(),
            driver: driver.to_owned(),
            table: RowTable::new(columns.collect(), format, JsonStyle::Spaced),
            varied: space.values().len(),
            figures: figures.figures().len(),
            units,
        }
    }

    /// Returns the columns of varied numbers, and those of values.
    #[must_use]
    pub fn columns(&self) -> (&[RowColumn], &[RowColumn]) {
        self.table.columns[..self.varied + self.figures].split_at(self.varied)
    }

    /// Returns the text before the rows.
    #[must_use]
    pub fn head(&self) -> String {
        self.table.head(&self.scene, "designs", self.units)
    }

    /// Formats a row; `is_first` for the first one.
    #[must_use]
    pub fn line(&self, row: &DesignRow, is_first: bool) -> String {
        let numbers = row.numbers.iter().copied().map(Some);
        let figures = (0..self.figures).map(|index| row.figure(index));
        let words = [row.state.word().into(), self.reason(row).into()];
        let cells = numbers.chain(figures).map(RowCell::Number);
        let mut line = String::new();
        self.table
            .push(cells.chain(words.map(RowCell::Word)), is_first, &mut line);
        line
    }

    /// Returns the text after the rows.
    #[must_use]
    pub fn foot(&self) -> &'static str {
        self.table.foot()
    }

    /// Returns the reasons for missing values in a row, in one line.
    #[must_use]
    pub fn reason(&self, row: &DesignRow) -> String {
        let (_, columns) = self.columns();
        let missing = columns
            .iter()
            .zip(&row.figures)
            .filter_map(|(column, figure)| {
                let why = figure_reason(figure.err()?, &self.driver, words());
                Some(format!("{}: {why}", column.name))
            });
        let own = Some(row.reason.clone()).filter(|reason| !reason.is_empty());
        let all: Vec<String> = own.into_iter().chain(missing).collect();
        all.join("; ").replace(['\n', '\r'], " ")
    }
}
