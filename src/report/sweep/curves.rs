//! Writes plotted curves as comma separated values.

use crate::quantity::{Abscissa, Curve, Curves, state_word};
use crate::report::text::csv_dialect::{CsvDialect, cell};

/// Returns the samples of a plot, one per row, in the format of `krank sweep`: the driver's
/// coordinate, time or the value on the x axis, the curves, and the state. A missing value is an
/// empty cell.
#[must_use]
pub fn curves_csv(curves: &Curves, dialect: CsvDialect) -> String {
    let [name, unit] = &curves.title;
    let along = match curves.abscissa {
        Abscissa::Driver => None,
        Abscissa::Time | Abscissa::Figure(_) => Some(format!("{name} [{unit}]")),
    };
    let figures = curves.curves.iter().map(|curve| curve.quantity.header());
    let headers = [curves.driver.header()].into_iter().chain(along.clone());
    let mut text = dialect.record(headers.chain(figures).chain(["state".into()]));
    let rows = curves.at.iter().zip(&curves.along).zip(&curves.conditions);
    for (i, ((&at, &x), &condition)) in rows.enumerate() {
        let value = |curve: &Curve| cell(curve.values.get(i).copied().flatten());
        let along = along.as_ref().map(|_| cell(x));
        let cells = [cell(Some(at))].into_iter().chain(along);
        let cells = cells.chain(curves.curves.iter().map(value));
        text += &dialect.record(cells.chain([state_word(condition).to_owned()]));
    }
    text
}
