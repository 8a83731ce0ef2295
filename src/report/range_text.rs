//! The range of the driver in words.

use super::number::{concise, upwards};
use crate::quantity::Quantity;
use crate::solver::Range;
use crate::wording::words;

/// Decimals of limits: as many as a double has at some hundred degrees.
pub(super) const DECIMALS: usize = 12;
/// Significant digits of the errors of ends.
const BOUND_DIGITS: usize = 2;

/// The range that the driver can cover, in words: limits with up to 12 decimals and their unit. `driver`
/// is the driver's coordinate.
#[must_use]
pub fn range_text(range: Range, driver: &Quantity) -> String {
    let unit = &driver.unit;
    match range {
        Range::Full { period } => words().range_full(&period, unit),
        Range::Limited { low, high } => {
            let [low, high] = [low, high].map(limit_text);
            words().range_limited(&low, &high, unit)
        }
    }
}

/// The errors of the ends of a limited range, in words.
pub(super) fn errors_text(bounds: [Option<f64>; 2], unit: &str) -> String {
    let [low, high] = bounds.map(|bound| match bound {
        Some(bound) => words().end_error(&upwards(bound, BOUND_DIGITS), unit),
        None => words().end_error_not_proved().to_owned(),
    });
    words().range_errors(&low, &high)
}

/// To 12 decimals, without noughts at the end.
pub(super) fn limit_text(limit: f64) -> String {
    let decimals = format!("{limit:.DECIMALS$}");
    let text = decimals.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

/// The range where it was left: limits as the doubles that they are, so that a coordinate just outside
/// does not read like one of them.
#[must_use]
pub fn limits_text(range: Range, driver: &Quantity) -> String {
    match range {
        Range::Full { .. } => range_text(range, driver),
        Range::Limited { low, high } => {
            let [low, high] = [low, high].map(|limit| concise(limit, usize::MAX));
            words().range_limited(&low, &high, &driver.unit)
        }
    }
}
