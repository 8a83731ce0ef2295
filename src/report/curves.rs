//! Writes plotted curves as comma separated values.

use super::csv_dialect::{CsvDialect, CsvSheet};
use super::number::shortest;
use crate::quantity::{Abscissa, Curves, state_word};
use std::io;

/// Returns the samples of a plot, one per row, in the format of `krank sweep`: the driver's
/// coordinate, time or the value on the x axis, the curves, and the state. A missing value is an
/// empty cell.
///
/// # Errors
/// Never fails except for lack of memory.
pub fn curves_csv(curves: &Curves, dialect: CsvDialect) -> io::Result<String> {
    let mut bytes = Vec::new();
    let mut csv = CsvSheet::new(dialect, &mut bytes);
    let [name, unit] = &curves.title;
    let along = match curves.abscissa {
        Abscissa::Driver => None,
        Abscissa::Time | Abscissa::Figure(_) => Some(format!("{name} [{unit}]")),
    };
    let figures = curves.curves.iter().map(|curve| curve.quantity.header());
    let headers = [curves.driver.header()].into_iter().chain(along.clone());
    let headers = headers.chain(figures).chain(["state".into()]);
    csv.record(headers)?;
    let cell = |value: Option<f64>| {
        let mut text = String::new();
        if let Some(value) = value {
            shortest(value, &mut text);
        }
        text
    };
    let rows = curves.at.iter().zip(&curves.along).zip(&curves.conditions);
    for (i, ((&at, &x), &condition)) in rows.enumerate() {
        let mut row = vec![cell(Some(at))];
        row.extend(along.is_some().then(|| cell(x)));
        let value = |curve: &crate::quantity::Curve| curve.values.get(i).copied().flatten();
        row.extend(curves.curves.iter().map(|curve| cell(value(curve))));
        row.push(state_word(condition).to_owned());
        csv.record(row)?;
    }
    csv.finish()?;
    String::from_utf8(bytes).map_err(io::Error::other)
}
