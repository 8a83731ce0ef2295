//! The columns of a sweep: values, each followed by columns on its errors.

use crate::quantity::Quantity;
use crate::report::tables::answers::per;
use crate::report::text::rows::{CellKind, JsonStyle, RowColumn, RowFormat, RowTable};

/// Extra columns for each value of a sweep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ExtraColumns {
    /// The proved error bound: `C.x.bound`.
    pub bounds: bool,
    /// The maximum change if every given length changes by at most one unit: `C.x.sensitivity`.
    pub sensitivity: bool,
}

/// The source of a column's cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum CellSource {
    /// The value itself.
    Figure,
    /// The proved error bound of the value.
    Bound,
    /// The sensitivity to the given lengths of the value with this index among the values of the
    /// sweep.
    Sensitivity(usize),
    /// Measured minus computed value.
    Difference,
}

/// The columns of a sweep: the driver's coordinate, the requested values with their extra columns,
/// and the state.
#[derive(Clone, Debug)]
pub struct Columns {
    /// The quantities of all columns, the driver's coordinate first. An extra column repeats its
    /// value under another name.
    pub(in crate::report) quantities: Vec<Quantity>,
    /// The source of each column's cells.
    pub(in crate::report) sources: Vec<CellSource>,
    /// The values alone, without the driver's coordinate.
    pub(in crate::report) figures: Vec<Quantity>,
    pub(in crate::report) extra: ExtraColumns,
    pub(in crate::report) units: bool,
}

impl Columns {
    /// Creates columns for the driver's coordinate and these values; `units` adds units to the
    /// headers.
    #[must_use]
    pub fn new(driver: &Quantity, columns: &[Quantity], units: bool) -> Self {
        let columns = columns.iter().filter(|q| !q.is_driver());
        let columns: Vec<Quantity> = columns.cloned().collect();
        let quantities: Vec<Quantity> = std::iter::once(driver).chain(&columns).cloned().collect();
        Columns {
            sources: vec![CellSource::Figure; quantities.len()],
            quantities,
            figures: columns,
            extra: ExtraColumns::default(),
            units,
        }
    }

    /// Adds extra columns to each value, except the driver's coordinate; `length` is the symbol of
    /// the unit of length.
    #[must_use]
    pub fn with(mut self, extra: ExtraColumns, length: &str) -> Self {
        self.extra = extra;
        self.quantities.truncate(1);
        self.sources.truncate(1);
        for (number, quantity) in self.figures.iter().enumerate() {
            let named = |ending: &str, unit: String| Quantity {
                name: format!("{}.{ending}", quantity.name),
                unit,
                ..quantity.clone()
            };
            self.quantities.push(quantity.clone());
            self.sources.push(CellSource::Figure);
            if extra.bounds {
                self.quantities.push(named("bound", quantity.unit.clone()));
                self.sources.push(CellSource::Bound);
            }
            if extra.sensitivity {
                let unit = per(&quantity.unit, length);
                self.quantities.push(named("sensitivity", unit));
                self.sources.push(CellSource::Sensitivity(number));
            }
        }
        self
    }

    /// Adds time as the first column.
    #[must_use]
    pub fn over_time(mut self) -> Self {
        let time = self.quantities.first().map(|driver| Quantity {
            name: "time".to_owned(),
            unit: "s".to_owned(),
            ..driver.clone()
        });
        self.quantities.splice(0..0, time);
        self.sources.insert(0, CellSource::Figure);
        self
    }

    /// Returns the table of these columns and the state.
    pub(in crate::report) fn table(&self, format: RowFormat) -> RowTable {
        let columns = self.quantities.iter().zip(&self.sources);
        let columns = columns.map(|(quantity, source)| {
            let kind = match source {
                CellSource::Figure if quantity.is_direction() => CellKind::Direction,
                CellSource::Figure | CellSource::Sensitivity(_) | CellSource::Difference => {
                    CellKind::Number
                }
                CellSource::Bound => CellKind::Bound,
            };
            RowColumn::of(quantity, kind, self.units)
        });
        let columns = columns.chain([RowColumn::state()]).collect();
        RowTable::new(columns, format, JsonStyle::Spaced)
    }
}
