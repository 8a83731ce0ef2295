//! How numbers are written: to as many digits as asked, or so that they read back to the same double.

use std::fmt::{self, Write};

/// Below this power of ten a number is written with an exponent: leading zeros are hard to count.
const SMALLEST_FIXED: i32 = -5;
/// From here on the shortest form takes an exponent: an f64 has no digits left behind the point.
const LARGEST_FIXED: f64 = 1e16;

/// The value to `digits` significant digits, trailing zeros kept; `0` for zero of either sign.
///
/// Values that have more digits in front of the point than were asked for, and small ones, take an
/// exponent: `2.40e4`.
pub(super) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.max(1);
    let scientific = format!("{value:.*e}", digits - 1);
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, e)| e.parse::<i32>().ok());
    let wanted = i32::try_from(digits).unwrap_or(i32::MAX);
    match exponent {
        Some(exponent) if (SMALLEST_FIXED..wanted).contains(&exponent) => {
            let decimals = usize::try_from(wanted - 1 - exponent).unwrap_or(0);
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// A bound to two significant digits, never below itself: `2.1e-13`; `0` for none at all.
pub(crate) fn upwards(bound: f64, digits: usize) -> String {
    if bound == 0.0 || !bound.is_finite() {
        return significant(bound, digits);
    }
    // Half a unit of the last digit on top: the nearest decimal to that is no smaller than the bound.
    let unit = |text: &str| {
        let exponent = text.split_once('e').map_or("0", |(_, exponent)| exponent);
        let last = exponent.parse::<i32>().unwrap_or(0) - i32::try_from(digits).unwrap_or(1) + 1;
        format!("1e{last}").parse::<f64>().unwrap_or(0.0)
    };
    let nearest = format!("{bound:.*e}", digits - 1);
    let is_enough = nearest.parse().is_ok_and(|nearest: f64| nearest >= bound);
    let enough = if is_enough {
        bound
    } else {
        bound + unit(&nearest)
    };
    significant(enough, digits)
}

/// A direction in degrees to `digits` significant digits; one that rounds to 360 is written as 0.
pub(super) fn direction(degrees: f64, digits: usize) -> String {
    let text = significant(degrees, digits);
    if text.parse() == Ok(crate::angle::TURN) {
        "0".into()
    } else {
        text
    }
}

/// Writes the shortest decimal that reads back to the same double.
///
/// A negative zero is written as `0`: a direction of approach that no table means. The value must
/// be finite; what does not exist is no number and is never written by this function.
///
/// # Errors
/// Those of the writer.
pub(super) fn shortest(value: f64, to: &mut impl Write) -> fmt::Result {
    debug_assert!(
        value.is_finite(),
        "only values that exist are written: {value}"
    );
    // Clears the sign of a negative zero.
    let value = value + 0.0;
    let size = value.abs();
    if size == 0.0 || (1e-5..LARGEST_FIXED).contains(&size) {
        write!(to, "{value}")
    } else {
        write!(to, "{value:e}")
    }
}

/// The shortest decimal that reads back to the same double, or the value to `digits` significant
/// digits where that is shorter. For figures that somebody has given: `15` rather than `15.0000`.
pub(super) fn concise(value: f64, digits: usize) -> String {
    let mut exact = String::new();
    // Writing to a string does not fail.
    let written = shortest(value, &mut exact);
    debug_assert!(written.is_ok());
    // No double needs more than 17 digits.
    let rounded = significant(value, digits.min(17));
    if rounded.len() < exact.len() {
        rounded
    } else {
        exact
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn significant_digits_count_from_the_first_that_is_not_zero() {
        let cases = [
            (29.379_447_783_733_73, "29.3794"),
            (-3.916_412_730_164_438, "-3.91641"),
            (100.0, "100.000"),
            (-460_017.673, "-460018"),
            (999_999.7, "1.00000e6"),
            (0.000_012_345_678, "0.0000123457"),
            (0.000_001_234_567_8, "1.23457e-6"),
            (-0.0, "0"),
            (9.999_999_9, "10.0000"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value, 6), text);
        }
        assert_eq!(significant(23_995.093, 3), "2.40e4");
        assert_eq!(significant(0.1, 17), "0.10000000000000001");
    }

    #[test]
    fn a_direction_that_rounds_to_a_full_turn_is_0() {
        assert_eq!(direction(359.999_99, 6), "0");
        assert_eq!(direction(359.999_99, 8), "359.99999");
        assert_eq!(direction(360.0 - 1e-12, 12), "0");
    }

    #[test]
    fn the_shortest_form_stays_short() {
        let written = |value| {
            let mut text = String::new();
            shortest(value, &mut text).unwrap();
            text
        };
        assert_eq!(written(60.0), "60");
        assert_eq!(written(-0.0), "0");
        assert_eq!(written(0.1), "0.1");
        assert_eq!(written(1e-300), "1e-300");
        assert_eq!(written(-2.5e300), "-2.5e300");
        assert_eq!(written(1e16), "1e16");
        assert_eq!(written(0.000_01), "0.00001");
    }

    #[test]
    fn a_given_figure_has_no_more_digits_than_it_needs() {
        assert_eq!(concise(15.0, 6), "15");
        assert_eq!(concise(-0.0, 6), "0");
        assert_eq!(concise(0.523_598_775_598_298_8, 6), "0.523599");
        assert_eq!(concise(20.943_951_023_931_955, 6), "20.9440");
        assert_eq!(concise(77.7, usize::MAX), "77.7");
        assert_eq!(concise(1e300, usize::MAX), "1e300");
        let all = 36.869_897_645_844_02;
        assert_eq!(concise(all, usize::MAX), all.to_string());
    }

    #[test]
    fn a_bound_is_rounded_up() {
        assert_eq!(upwards(2.01e-13, 2), "2.1e-13");
        assert_eq!(upwards(2.1e-13, 2), "2.1e-13");
        assert_eq!(upwards(9.91e-13, 2), "1.0e-12");
        assert_eq!(upwards(3.01e-13, 1), "4e-13");
        assert_eq!(upwards(9.1e-13, 1), "1e-12");
        assert_eq!(upwards(0.0, 2), "0");
    }

    proptest! {
        #[test]
        fn a_written_bound_is_never_smaller(bound in prop::num::f64::POSITIVE, digits in 1_usize..4) {
            let written: f64 = upwards(bound, digits).parse().unwrap();
            prop_assert!(written >= bound, "{written:e} < {bound:e}");
            prop_assert!(written <= bound * 2.01 || bound < 1e-300, "{written:e} for {bound:e}");
        }

        #[test]
        fn every_double_reads_back(bits: u64) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite() && value.to_bits() != (-0.0_f64).to_bits());
            let mut text = String::new();
            shortest(value, &mut text).unwrap();
            prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), bits);
            prop_assert!(serde_json::from_str::<serde_json::Value>(&text).unwrap().is_number());
        }
    }
}
