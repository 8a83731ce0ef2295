//! Number formats with a fixed number of decimals per column, chosen over the whole motion, so that
//! a changing value does not move its neighbours.

use crate::page::{Cell, UnprovedDigits};
use crate::report::{Entry, fixed};

/// Significant digits of a value of typical magnitude.
const DIGITS: i32 = 6;
/// Maximum number of decimals; smaller values are written with an exponent.
const MAX_DECIMALS: i32 = 7;

/// Zero with [`MAX_DECIMALS`] decimals.
const NOUGHT: &str = "0.0000000";

/// The number format of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Format {
    /// Number of decimals; `None` for a format with an exponent.
    decimals: Option<usize>,
    width: usize,
}

impl Format {
    /// Directions from 0.000 to 359.999 deg.
    pub(crate) const ANGLE: Format = Format {
        decimals: Some(3),
        width: 7,
    };

    /// Differences of directions from -179.999 to 180.000 deg.
    pub(crate) const SIGNED_ANGLE: Format = Format {
        decimals: Some(3),
        width: 8,
    };

    /// Values that are always 0.
    const NOUGHT: Format = Format {
        decimals: Some(0),
        width: 7,
    };

    /// Returns the format for values with these magnitudes over the motion; infinite and NaN ones
    /// are ignored.
    ///
    /// Near a dead point rates grow without bound, so the decimals are based on the upper quartile
    /// of the magnitudes. The few values that do not fit are written with an exponent.
    pub(crate) fn of_sizes(mut sizes: Vec<f64>) -> Format {
        sizes.retain(|size| size.is_finite());
        sizes.sort_by(f64::total_cmp);
        let usual = sizes.get(sizes.len() * 3 / 4).copied().unwrap_or(0.0);
        let largest = sizes.last().copied().unwrap_or(0.0);
        match (usual > 0.0, largest > 0.0) {
            (true, _) => Format::of_size(usual),
            (false, true) => Format::of_size(largest),
            (false, false) => Format::NOUGHT,
        }
    }

    fn of_size(usual: f64) -> Format {
        // Digits before the decimal point.
        let digits = exponent(usual) + 1;
        let integer = digits.max(1);
        let decimals = DIGITS - digits;
        if decimals > MAX_DECIMALS || integer > 2 * DIGITS {
            return Format {
                decimals: None,
                width: 11,
            };
        }
        let decimals = decimals.max(0);
        // Sign, whole digits and a spare one, point, decimals.
        let width = 2 + integer + i32::from(decimals > 0) + decimals;
        Format {
            decimals: usize::try_from(decimals).ok(),
            width: usize::try_from(width).unwrap_or(0),
        }
    }

    /// Returns the width of a value in columns.
    pub(crate) fn width(self) -> usize {
        self.width
    }

    /// Formats a value and determines its unproved digits; writes `-` for a value that does not
    /// exist.
    ///
    /// The text is zero only if the value may be entirely error, or if its error is unknown and the
    /// value rounds to zero.
    pub(crate) fn write(self, entry: &Entry) -> Cell {
        let Some(value) = entry.display_value().filter(|v| v.is_finite()) else {
            return Cell::proved("-");
        };
        let text = self.text(value, entry.bound.is_some());
        let unsure = match entry.bound {
            // A bare zero among values with exponents represents all decimals that it does not
            // show.
            Some(bound) if self.decimals.is_none() && text == "0" => match unsure(NOUGHT, bound) {
                UnprovedDigits::Nothing => UnprovedDigits::Nothing,
                UnprovedDigits::Last(_) | UnprovedDigits::Everything => {
                    UnprovedDigits::Last(0..text.len())
                }
            },
            Some(bound) => unsure(&text, bound),
            None => UnprovedDigits::Everything,
        };
        Cell {
            text,
            unproved: unsure,
            formula: None,
        }
    }

    fn text(self, value: f64, proved: bool) -> String {
        let plain = self.decimals.map(|decimals| fixed(value, decimals));
        let hidden = |text: &String| proved && value != 0.0 && !has_digits(text);
        match plain {
            Some(text) if text.len() <= self.width && !hidden(&text) => text,
            // Zero has no exponent.
            _ if value == 0.0 => "0".into(),
            _ => scientific(value, self.width),
        }
    }

    /// Formats a direction in degrees; one that rounds to 360 becomes 0.
    pub(crate) fn write_angle(self, entry: &Entry) -> Cell {
        let written = self.write(entry);
        if written.text == "360.000" {
            let value = Some(0.0);
            self.write(&Entry { value, ..*entry })
        } else {
            written
        }
    }
}

/// Returns the unproved last digits of a number: those with a place value less than twice the
/// bound. Up to the digit before them the number is correct within one unit, rounding included.
fn unsure(text: &str, bound: f64) -> UnprovedDigits {
    let (digits, exponent) = match text.split_once('e') {
        Some((digits, exponent)) => (digits, exponent.parse().unwrap_or(0)),
        None => (text, 0),
    };
    let decimals = digits
        .split_once('.')
        .map_or(0, |(_, decimals)| decimals.len());
    let last = exponent - i32::try_from(decimals).unwrap_or(0);
    let places = digits.char_indices().rev();
    let places = places.filter(|(_, c)| c.is_ascii_digit()).zip(last..);
    // Parsing a decimal yields the double nearest to the power of ten.
    let counts = |power: i32| format!("1e{power}").parse().unwrap_or(0.0);
    let unsure = places.take_while(|(_, power)| counts(*power) < 2.0 * bound);
    let from = unsure.last().map_or(digits.len(), |((at, _), _)| at);
    if from == digits.len() {
        UnprovedDigits::Nothing
    } else {
        UnprovedDigits::Last(from..digits.len())
    }
}

fn has_digits(text: &str) -> bool {
    text.bytes().any(|b| (b'1'..=b'9').contains(&b))
}

/// Formats a value with an exponent and as many digits as fit.
fn scientific(value: f64, width: usize) -> String {
    let longest = format!("{value:.*e}", width.saturating_sub(3));
    let excess = longest.len().saturating_sub(width);
    format!("{value:.*e}", width.saturating_sub(3 + excess))
}

/// Formats a derivative with three significant digits for reading by eye.
pub(crate) fn short(value: f64, width: usize) -> String {
    let plain = format!(
        "{value:.*}",
        usize::try_from(2 - exponent(value)).unwrap_or(0).min(5)
    );
    let fits = plain.len() <= width && (value == 0.0 || value.abs() >= 1e-3);
    match (value == 0.0, fits) {
        (true, _) => "0".into(),
        (false, true) => plain,
        (false, false) => format!("{value:.2e}"),
    }
}

/// Returns the decimal exponent of the first digit.
fn exponent(size: f64) -> i32 {
    let text = format!("{size:e}");
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok());
    exponent.unwrap_or(0)
}

/// Formats a coordinate with as few decimals as represent it exactly: at least `decimals`, at most
/// six more.
pub(crate) fn coordinate(value: f64, decimals: usize) -> String {
    let exact = (decimals..decimals + 6).find(|&d| rounded(value, d) == value);
    fixed(value, exact.unwrap_or(decimals + 6))
}

/// Maximum number of decimals of a coordinate.
pub(crate) const MAX_COORDINATE_DECIMALS: usize = 9;

/// Returns the double nearest to the value rounded to `decimals` decimals.
pub(crate) fn rounded(value: f64, decimals: usize) -> f64 {
    let scale = 10.0_f64.powi(i32::try_from(decimals.min(MAX_COORDINATE_DECIMALS)).unwrap_or(0));
    let rounded = (value * scale).round() / scale;
    // If the product overflows, the value has no such decimals anyway.
    if rounded.is_finite() { rounded } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Returns a value with this error bound.
    fn proved(value: f64, bound: f64) -> Entry {
        Entry {
            value: Some(value),
            given: false,
            bound: Some(bound),
        }
    }

    fn unproved(value: f64) -> Entry {
        Entry {
            bound: None,
            ..proved(value, 0.0)
        }
    }

    fn column(sizes: &[f64], value: f64) -> String {
        let format = Format::of_sizes(sizes.to_vec());
        format.write(&unproved(value)).text
    }

    #[test]
    fn columns_choose_digits_by_size_of_values() {
        assert_eq!(column(&[400.0, 250.0, 300.0], 250.0), "250.000");
        assert_eq!(column(&[15.0, 3.9], -3.916_412_7), "-3.9164");
        assert_eq!(column(&[22500.0, 1500.0], 22500.0), "22500.0");
        assert_eq!(column(&[460_017.7], -460_017.673), "-460018");
        assert_eq!(column(&[0.012], 0.012_345_678), "0.0123457");
        assert_eq!(column(&[], 0.0), "0");
        assert_eq!(column(&[1e-9], 1.234_567_89e-9), "1.234568e-9");
        assert_eq!(column(&[1e-9], 0.0), "0");
    }

    #[test]
    fn zero_has_no_sign_and_missing_values_are_dashes() {
        let format = Format::of_sizes(vec![100.0]);
        let text = |entry: Entry| format.write(&entry).text;
        assert_eq!(text(unproved(-0.0)), "0.000");
        assert_eq!(text(unproved(-1e-9)), "0.000");
        assert_eq!(text(Entry::NONE), "-");
        assert_eq!(text(unproved(f64::NAN)), "-");
        let around = Format::ANGLE.write_angle(&unproved(359.9999));
        assert_eq!(around.text, "0.000");
    }

    #[test]
    fn zero_is_shown_only_within_error_bound() {
        let format = Format::of_sizes(vec![100.0]);
        assert_eq!(format.write(&proved(6e-15, 1e-14)), Cell::proved("0.000"));
        assert_eq!(format.write(&proved(6e-5, 1e-14)).text, "6.0000e-5");
        assert_eq!(format.write(&proved(-6e-14, 1e-14)).text, "-6.00e-14");
    }

    #[test]
    fn unproved_digits_are_marked() {
        let format = Format::of_sizes(vec![100.0]);
        let unsure = |bound| format.write(&proved(123.456, bound)).unproved;
        assert_eq!(unsure(1e-13), UnprovedDigits::Nothing);
        assert_eq!(unsure(0.0005), UnprovedDigits::Nothing);
        assert_eq!(unsure(0.0006), UnprovedDigits::Last(6..7));
        assert_eq!(unsure(0.3), UnprovedDigits::Last(4..7));
        assert_eq!(unsure(0.6), UnprovedDigits::Last(2..7));
        assert_eq!(unsure(100.0), UnprovedDigits::Last(0..7));
        assert_eq!(
            format.write(&unproved(1.0)).unproved,
            UnprovedDigits::Everything
        );
        let tiny = Format::of_sizes(vec![1e-12]);
        let unsure = |bound| tiny.write(&proved(1e-13, bound)).unproved;
        assert_eq!(
            (unsure(1e-12), unsure(0.07)),
            (UnprovedDigits::Nothing, UnprovedDigits::Last(0..1))
        );
        // In -1.234e8, mantissa digits count by their decimal place.
        let large = format.write(&proved(-123_456_789.0, 60_000.0));
        assert_eq!(
            (large.text.as_str(), large.unproved),
            ("-1.2346e8", UnprovedDigits::Last(5..7))
        );
    }

    #[test]
    fn oversized_values_use_exponent() {
        let format = Format::of_sizes(vec![10.0, 12.0, 14.0, 20.0]);
        assert_eq!(format.write(&unproved(14.0)).text, "14.0000");
        assert_eq!(format.write(&unproved(-123_456_789.0)).text, "-1.2346e8");
    }

    #[test]
    fn coordinates_show_two_to_eight_decimals() {
        assert_eq!(coordinate(60.0, 2), "60.00");
        assert_eq!(coordinate(13.897_841, 2), "13.897841");
        assert_eq!(coordinate(28.955_024_371_859, 2), "28.95502437");
        assert_eq!(coordinate(-0.0, 2), "0.00");
    }

    proptest! {
        #[test]
        fn values_fit_column_width(
            sizes in prop::collection::vec(any::<f64>().prop_map(f64::abs), 0..8),
            value: f64,
        ) {
            let format = Format::of_sizes(sizes);
            for entry in [unproved(value), proved(value, 0.0)] {
                prop_assert!(format.write(&entry).text.len() <= format.width(), "{format:?}");
            }
        }

        /// For any true value, bound and value within it: the value is correct within one unit of
        /// its last proved digit, and zero is shown only if it may be the true value.
        #[test]
        fn proved_digits_are_correct_within_one_unit(
            usual in -6..7,
            share in -1.0..1.0_f64,
            size in -17..2,
            off in -1.0..1.0_f64,
        ) {
            let scale = 10.0_f64.powi(usual);
            let format = Format::of_sizes(vec![scale]);
            let (truth, bound) = (share * scale, scale * 10.0_f64.powi(size));
            let value = truth + off * bound;
            let Cell { text, unproved: unsure, .. } = format.write(&proved(value, bound * (1.0 + 1e-9) + 1e-15 * scale));
            let sure = match unsure {
                UnprovedDigits::Nothing => text.clone(),
                UnprovedDigits::Last(digits) => {
                    let end = text.find('e').unwrap_or(text.len());
                    prop_assert_eq!(digits.end, end);
                    text[..digits.start].to_owned()
                }
                UnprovedDigits::Everything => unreachable!("there is a bound"),
            };
            if !has_digits(&text) {
                prop_assert!(value.abs() <= bound * 1.001 + 1e-15 * scale, "{text} for {value:e}");
            }
            if sure.bytes().any(|b| b.is_ascii_digit()) {
                let exponent: i32 = text.split_once('e').map_or(0, |(_, e)| e.parse().unwrap());
                let whole = sure.split_once('e').map_or(sure.as_str(), |(digits, _)| digits);
                // Proved digits after the point, or unproved digits before it.
                let point = text.find(['.', 'e']).unwrap_or(text.len());
                let place = if whole.len() > point {
                    exponent - i32::try_from(whole.len() - point - 1).unwrap()
                } else {
                    exponent + i32::try_from(point - whole.len()).unwrap()
                };
                let shown: f64 = text.parse().unwrap();
                let unit = 10.0_f64.powi(place);
                prop_assert!((shown - truth).abs() <= unit * (1.0 + 1e-6), "{text} for {truth}, {unit:e}");
            }
        }
    }
}
