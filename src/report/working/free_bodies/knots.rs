//! Interpolates forces over a coordinate, linearly between two knots.

use crate::Profile;
use crate::page::{Formula, Symbol};
use crate::report::working::context::{Context, Draft};

/// Returns the two knots that enclose a coordinate; at a jump, those of the line after it. Returns
/// `None` beyond the knots.
pub(crate) fn line_at(curve: &Profile, at: f64) -> Option<[[f64; 2]; 2]> {
    let is_on = |pair: &&[[f64; 2]]| pair[0][0] <= at && at <= pair[1][0];
    let mut lines = curve.knots().windows(2);
    let line = lines.rfind(|pair| pair[0][0] < pair[1][0] && is_on(pair))?;
    Some([line[0], line[1]])
}

/// Writes the force p on the line between two knots, and returns it with the magnitude of its
/// terms. `symbol` is the coordinate's name, and its rounding error is that of values of the given
/// size.
pub(crate) fn on_line(
    context: &Context<'_>,
    draft: &mut Draft,
    symbol: &str,
    (at, size): (f64, f64),
    [[d1, p1], [d2, p2]]: [[f64; 2]; 2],
) -> (f64, f64) {
    let f = context.figures;
    let given =
        |letter: &str, index: &str, value: f64| f.as_given(Symbol::indexed(letter, index), value);
    let slope = (given("p", "2", p2) - given("p", "1", p1))
        / (given(symbol, "2", d2) - given(symbol, "1", d1));
    let at = f.rounded(symbol, at, size);
    let law = given("p", "1", p1) + slope * (at - given(symbol, "1", d1));
    let computed = draft.worked("p", &law, |p| Formula::measured(f.number(p), "N"));
    let steep = (p2 - p1).abs() / (d2 - d1) * size;
    (computed, p1.abs().max(p2.abs()) + steep)
}
