//! Formats numbers: with a given number of digits, or so that they read back to the same double.

/// Minimum power of ten without an exponent: many leading zeros are hard to count.
const MIN_FIXED_EXPONENT: i32 = -5;
/// From this value on, the shortest form has an exponent, because doubles have no decimals there.
pub(in crate::report) const MAX_FIXED: f64 = 1e16;

/// Formats a value with `digits` significant digits, with trailing zeros; zero of either sign is
/// `0`.
///
/// Values with more integer digits than requested, and small ones, have an exponent: `2.40e4`.
pub(in crate::report) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.max(1);
    let mut scientific = format!("{value:.*e}", digits - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let wanted = i32::try_from(digits).unwrap_or(i32::MAX);
    match exponent.parse::<i32>() {
        Ok(exponent) if (MIN_FIXED_EXPONENT..wanted).contains(&exponent) => {
            let length = mantissa.len();
            scientific.truncate(length);
            move_point(&mut scientific, exponent);
            scientific
        }
        _ => scientific,
    }
}

/// Multiplies a mantissa by a power of ten. The power is less than the number of digits, so no
/// zeros are needed behind them.
fn move_point(mantissa: &mut String, exponent: i32) {
    if exponent == 0 {
        return;
    }
    let first = usize::from(mantissa.starts_with('-'));
    // A single digit has no point.
    if let Some(point) = mantissa.find('.') {
        mantissa.remove(point);
    }
    match usize::try_from(exponent) {
        Ok(exponent) if first + 1 + exponent < mantissa.len() => {
            mantissa.insert(first + 1 + exponent, '.');
        }
        Ok(_) => {}
        Err(_) => {
            let zeros = "0".repeat(exponent.unsigned_abs() as usize - 1);
            mantissa.insert_str(first, &format!("0.{zeros}"));
        }
    }
}

/// Returns the number of digits known of a value with an error bound, at most `digits`: the unit of
/// the last one is at least the bound. Returns at least one, and `digits` without a finite bound.
pub(in crate::report) fn known_digits(value: f64, bound: f64, digits: usize) -> usize {
    if bound == 0.0 || !bound.is_finite() {
        return digits;
    }
    let known = value.abs().log10().floor() - bound.log10().ceil() + 1.0;
    // A value within its bound has no known digits: the cast maps NaN and negative numbers to 0.
    digits.min(known as usize).max(1)
}

/// Formats a value with so many significant digits, without trailing zeros.
pub(in crate::report) fn trimmed(value: f64, digits: usize) -> String {
    without_noughts(significant(value, digits))
}

/// Removes trailing zeros of the decimals; a number with an exponent stays unchanged.
pub(in crate::report) fn without_noughts(text: String) -> String {
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// Formats a value with `decimals` decimals; one that rounds to zero has no sign.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = |digits: &str| digits.bytes().all(|b| matches!(b, b'0' | b'.'));
    match text.strip_prefix('-') {
        Some(digits) if is_zero(digits) => digits.to_owned(),
        _ => text,
    }
}

/// Formats a bound with so many significant digits, rounded up: `2.1e-13`; zero is `0`.
pub(crate) fn perpendicular_up(bound: f64, digits: usize) -> String {
    if bound == 0.0 || !bound.is_finite() {
        return significant(bound, digits);
    }
    // Adding half a unit of the last digit would suffice; with a whole one the nearest decimal is
    // not below the bound.
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

/// Formats a direction in degrees with `digits` significant digits; one that rounds to 360
/// becomes 0.
pub(in crate::report) fn direction(degrees: f64, digits: usize) -> String {
    let text = significant(degrees, digits);
    // With two digits, 355 and more round to it.
    if degrees >= 350.0 && text.parse() == Ok(crate::angle::TURN) {
        "0".into()
    } else {
        text
    }
}

/// Appends the shortest decimal that reads back to the same double, the nearest one of several: at
/// most 17 digits, with an exponent below 1e-5 and from 1e16 on.
///
/// A negative zero becomes `0`, because the sign has no meaning in tables. The value must be
/// finite; callers handle missing values.
pub(crate) fn shortest(value: f64, to: &mut String) {
    to.extend(shortest_with_plus(value, &mut zmij::Buffer::new()).split('+'));
}

/// Returns the text of [`shortest`], but with the plus sign of an exponent from [`MAX_FIXED`] on.
// Sweeps call it for every cell. The profile `release` would not inline it.
#[inline(always)]
pub(in crate::report) fn shortest_with_plus(value: f64, buffer: &mut zmij::Buffer) -> &str {
    debug_assert!(
        value.is_finite(),
        "only values that exist are written: {value}"
    );
    // Adding zero clears the sign of a negative one.
    let text = buffer.format_finite(value + 0.0);
    match text.as_bytes() {
        // `strip_suffix` calls `memcmp`, which took a sixth of a sweep.
        [integer @ .., b'.', b'0'] if value.abs() < MAX_FIXED => &text[..integer.len()],
        _ => text,
    }
}

/// Formats a value as the shortest decimal that reads back to the same double, or with `digits`
/// significant digits if that is shorter. For given values: `15` rather than `15.0000`.
pub(in crate::report) fn concise(value: f64, digits: usize) -> String {
    let mut exact = String::new();
    shortest(value, &mut exact);
    // Every double is determined by 17 digits.
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
    fn rounded_zero_has_no_sign() {
        for (value, text) in [(-0.0004, "0.000"), (-0.0, "0.000"), (-0.0006, "-0.001")] {
            assert_eq!(fixed(value, 3), text);
        }
    }

    #[test]
    fn significant_digits_start_at_first_nonzero_digit() {
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
    fn direction_that_rounds_to_full_turn_is_zero() {
        assert_eq!(direction(359.999_99, 6), "0");
        assert_eq!(direction(359.999_99, 8), "359.99999");
        assert_eq!(direction(360.0 - 1e-12, 12), "0");
    }

    #[test]
    fn shortest_form_has_no_redundant_digits() {
        assert_eq!(written(60.0), "60");
        assert_eq!(written(-0.0), "0");
        assert_eq!(written(0.1), "0.1");
        assert_eq!(written(1e-300), "1e-300");
        assert_eq!(written(-2.5e300), "-2.5e300");
        assert_eq!(written(1e16), "1e16");
        assert_eq!(written(0.000_01), "0.00001");
    }

    #[test]
    fn given_values_have_no_superfluous_digits() {
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
    fn known_digits_end_at_error_bound() {
        for (value, bound, known) in [
            (41.409_621_7, 2.1e-6, 7),
            (41.409_621_7, 1e-9, 9),
            (-135.584_691_4, 6e-8, 9),
            (1.5e-30, 1e-8, 1),
            (0.0, 1e-8, 1),
            (3.0, 0.0, 9),
            (3.0, f64::INFINITY, 9),
        ] {
            assert_eq!(known_digits(value, bound, 9), known, "{value} +- {bound}");
        }
        assert_eq!(
            significant(-41.409_621_7, known_digits(41.4, 2.1e-6, 9)),
            "-41.40962"
        );
    }

    #[test]
    fn error_bounds_are_rounded_up() {
        assert_eq!(perpendicular_up(2.01e-13, 2), "2.1e-13");
        assert_eq!(perpendicular_up(2.1e-13, 2), "2.1e-13");
        assert_eq!(perpendicular_up(9.91e-13, 2), "1.0e-12");
        assert_eq!(perpendicular_up(3.01e-13, 1), "4e-13");
        assert_eq!(perpendicular_up(9.1e-13, 1), "1e-12");
        assert_eq!(perpendicular_up(0.0, 2), "0");
    }

    /// Formats the shortest decimal by the standard library, which takes the larger of two equally
    /// near decimals.
    fn std_shortest(value: f64) -> String {
        let size = value.abs();
        if size == 0.0 || (1e-5..1e16).contains(&size) {
            format!("{}", value + 0.0)
        } else {
            format!("{value:e}")
        }
    }

    fn digits(text: &str) -> String {
        let mantissa = text.split('e').next().unwrap();
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        digits.trim_matches('0').into()
    }

    /// Returns `true` if a double is half way between two of its shortest decimals: its full
    /// decimal has just one more digit, a 5.
    fn is_midpoint(value: f64) -> bool {
        let all = digits(&format!("{value:.60e}"));
        all.len() == digits(&std_shortest(value)).len() + 1 && all.ends_with('5')
    }

    fn holds(value: f64) -> bool {
        written(value) == std_shortest(value) || is_midpoint(value)
    }

    fn written(value: f64) -> String {
        let mut text = String::new();
        shortest(value, &mut text);
        text
    }

    /// Powers of two and ten and their neighbours: here the spacing of doubles changes, two
    /// shortest decimals are equally near, or the notation changes.
    #[test]
    fn shortest_form_matches_std_at_edge_cases() {
        let twos = (0..2047_u64).map(|e| f64::from_bits(e << 52));
        let tens = (-323..309).map(|e| format!("1e{e}").parse::<f64>().unwrap());
        let smallest = (1..1000).map(f64::from_bits);
        for value in twos.chain(tens).chain(smallest) {
            for near in [value.next_down(), value, value.next_up()] {
                let sizes = [near, -near, 3.0 * near].into_iter();
                for v in sizes.filter(|v| v.is_finite()) {
                    assert!(holds(v), "{} but {}", written(v), std_shortest(v));
                }
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]
        #[test]
        fn shortest_form_of_any_double_matches_std(bits: u64, integer: i64, places in 0..12) {
            let decimal = integer as f64 / 10_f64.powi(places);
            for value in [f64::from_bits(bits), integer as f64, decimal, decimal / 1e12] {
                prop_assume!(value.is_finite());
                prop_assert!(holds(value), "{} but {}", written(value), std_shortest(value));
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]
        #[test]
        fn significant_digits_match_std(bits: u64, complete: i64, places in 0..16, digits in 1_usize..20) {
            let decimal = complete as f64 / 10_f64.powi(places);
            for value in [f64::from_bits(bits), decimal, decimal / 1e12, 1e6 - decimal / 1e18] {
                let text = significant(value, digits);
                let scientific = format!("{value:.*e}", digits - 1);
                if text == scientific || value == 0.0 {
                    continue;
                }
                let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
                prop_assert_eq!(&text, &format!("{value:.decimals$}"));
                let known = text.trim_start_matches(['-', '0', '.']);
                prop_assert_eq!(known.chars().filter(char::is_ascii_digit).count(), digits);
            }
        }
    }

    proptest! {
        #[test]
        fn rounded_bound_is_never_smaller(bound in prop::num::f64::POSITIVE, digits in 1_usize..4) {
            let written: f64 = perpendicular_up(bound, digits).parse().unwrap();
            prop_assert!(written >= bound, "{written:e} < {bound:e}");
            prop_assert!(written <= bound * 2.01 || bound < 1e-300, "{written:e} for {bound:e}");
        }

        #[test]
        fn every_double_round_trips(bits: u64) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite() && value.to_bits() != (-0.0_f64).to_bits());
            let text = written(value);
            prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), bits);
            prop_assert!(serde_json::from_str::<serde_json::Value>(&text).unwrap().is_number());
        }
    }
}
