//! Round numbers for calculations by hand.

use crate::scene::figure;

/// The number of two digits from which on the second digit is 0 or 5.
const LARGE: u32 = 50;

/// Returns the nearest round number as it is written in a scene: two digits, the second 0 or 5 from
/// 50 on (12, 45, 60, 85, 270). Zero and the sign are kept. Returns `None` if the value is not
/// finite or underflows.
pub(super) fn agreeable(value: f64) -> Option<String> {
    if value == 0.0 {
        return Some("0".into());
    }
    let written = format!("{:.1e}", value.abs());
    let (mantissa, exponent) = written.split_once('e')?;
    let digits: u32 = mantissa.replace('.', "").parse().ok()?;
    let exponent: i32 = exponent.parse().ok()?;
    let digits = match digits {
        LARGE.. => (digits + 2) / 5 * 5,
        _ => digits,
    };
    let size: f64 = format!("{digits}e{}", exponent - 1).parse().ok()?;
    (size > 0.0 && size.is_finite()).then(|| figure(size.copysign(value)))
}

/// Formats a number with six digits, or in full if they do not represent it.
pub(super) fn exactly(value: f64) -> String {
    let short = figure(value);
    let is_same = short
        .parse::<f64>()
        .is_ok_and(|read| (read - value).abs() <= 1e-12 * value.abs());
    if is_same { short } else { format!("{value:?}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agreeable_rounds_to_two_digits() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (123.4, "120"),
            (99.6, "100"),
            (97.4, "95"),
            (12.4, "12"),
            (52.4, "50"),
            (52.6, "55"),
            (-278.0, "-280"),
            (0.274, "0.27"),
            (7.26, "7.5"),
            (1.0e7, "10000000"),
        ] {
            assert_eq!(agreeable(value).as_deref(), Some(text), "{value}");
        }
        assert_eq!(agreeable(f64::NAN), None);
        assert_eq!(agreeable(f64::INFINITY), None);
    }

    #[test]
    fn exactly_keeps_all_digits() {
        assert_eq!(exactly(41.5 * 0.8), "33.2");
        let long = 40.014_978_806_706_2;
        assert_eq!(exactly(long).parse(), Ok(long));
    }
}
