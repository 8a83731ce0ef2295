//! Formats coordinates of the driver: places, limits and the range.

use crate::quantity::Quantity;
use crate::report::text::number::{concise, fixed, perpendicular_up, without_noughts};
use crate::solver::Range;
use crate::wording::words;

/// Decimals of limits: the precision of a double at some hundred degrees.
pub(in crate::report) const DECIMALS: usize = 12;
/// Maximum number of decimals of a place.
const PLACE_DECIMALS: usize = 6;
/// Significant digits of the errors of ends.
const BOUND_DIGITS: usize = 2;

/// Describes the driver's range: limits with up to 12 decimals and their unit. `driver` is the
/// driver's coordinate.
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

/// Describes the error bounds of the ends of a limited range.
pub(in crate::report) fn errors_text(bounds: [Option<f64>; 2], unit: &str) -> String {
    let [low, high] = bounds.map(|bound| match bound {
        Some(bound) => words().end_error(&perpendicular_up(bound, BOUND_DIGITS), unit),
        None => words().end_error_not_proved().to_owned(),
    });
    words().range_errors(&low, &high)
}

/// Formats a limit with up to 12 decimals, without trailing zeros.
pub(in crate::report) fn limit_text(limit: f64) -> String {
    short(limit, DECIMALS)
}

/// Formats a coordinate with its unit.
pub(in crate::report) fn place_text(at: f64, unit: &str) -> String {
    format!("{} {unit}", place(at))
}

/// Formats the place of an extremum with few digits; exact limits are shown elsewhere.
pub(in crate::report) fn place(at: f64) -> String {
    short(at, PLACE_DECIMALS)
}

/// Formats a coordinate with so many decimals, without trailing zeros.
fn short(at: f64, decimals: usize) -> String {
    without_noughts(fixed(at, decimals))
}

/// Describes the range for a coordinate outside of it, with exact limits: a coordinate just outside
/// must not read like one of them.
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
