//! Parses numbers as students write them: with a decimal comma or point, and with any number of
//! digits.

use crate::expression::DASHES;
use crate::scene::are_thousands;

/// Maximum length of a number's text.
const MAX_LEN: usize = 64;

/// A written number and its accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenFigure {
    /// The value.
    pub value: f64,
    /// The number of significant digits; zero has none.
    pub digits: i32,
    /// One unit of the last digit.
    last: f64,
    /// The number of trailing zeros of an integer that may be placeholders; at least three digits
    /// precede them.
    zeros: i32,
    /// `true` if the only separator may be a thousands separator.
    may_be_thousands: bool,
}

impl WrittenFigure {
    /// Parses a number and the unit after it: `29.38`, `29,38`, `1.234,5`, `-4.6e5 mm/s`; blanks
    /// between digits are allowed. If both a point and a comma occur, the last one is the decimal
    /// separator. The other one, or a repeated one, separates groups of three digits. Returns
    /// `None` for any other text.
    #[must_use]
    pub fn read(text: &str) -> Option<(WrittenFigure, String)> {
        let text = text.trim();
        if text.len() > MAX_LEN {
            return None;
        }
        let text = text.replace(DASHES, "-");
        let (number, unit) = text.split_at(unit_start(&text));
        let compact: String = number
            .chars()
            .filter(|c| !c.is_whitespace() && *c != '\'')
            .collect();
        let (typed, exponent) = match compact.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, Some(exponent.parse::<i32>().ok()?)),
            None => (compact.as_str(), None),
        };
        let mantissa = with_point(typed)?;
        let is_number = mantissa
            .trim_start_matches(['-', '+'])
            .starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let power = exponent.unwrap_or(0);
        let value: f64 = format!("{mantissa}e{power}").parse().ok()?;
        if !is_number || !value.is_finite() {
            return None;
        }
        let decimals = mantissa.split_once('.').map(|(_, decimals)| decimals);
        let places = i32::try_from(decimals.map_or(0, str::len)).ok()?;
        let plain: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let significant = plain.trim_start_matches('0');
        let digits = i32::try_from(significant.len()).ok()?;
        // A zero has no size, so a positive exponent does not change its accuracy.
        let power = if digits == 0 { power.min(0) } else { power };
        let is_whole = decimals.is_none() && exponent.is_none();
        let written = WrittenFigure {
            value,
            digits,
            last: ten_to(power.checked_sub(places)?),
            zeros: if is_whole {
                spare_zeros(significant)
            } else {
                0
            },
            may_be_thousands: exponent.is_none() && are_thousands(&typed.replace('.', ",")),
        };
        let unit = unit.trim().trim_matches(['[', ']', '(', ')']);
        Some((written, unit.trim().to_owned()))
    }

    /// Returns one unit of the last digit, with the number of digits limited to the range from
    /// `fewest` to `most`.
    #[must_use]
    pub fn unit_of(&self, fewest: i32, maximum: i32) -> f64 {
        self.last * ten_to(self.digits - self.digits.clamp(fewest, maximum))
    }

    /// Returns the number multiplied by a factor, as in a unit conversion.
    #[must_use]
    pub fn times(self, factor: f64) -> WrittenFigure {
        WrittenFigure {
            value: self.value * factor,
            last: self.last * factor,
            ..self
        }
    }

    /// Returns the number a thousand times as large if its only separator may be a thousands
    /// separator, as in `8,259`.
    #[must_use]
    pub fn with_thousands(self) -> Option<WrittenFigure> {
        self.may_be_thousands.then(|| {
            // Three decimals become an integer; rounding removes the error of the product.
            let value = (self.value * 1000.0).round();
            WrittenFigure {
                value,
                last: 1.0,
                zeros: spare_zeros(&format!("{}", value.abs())),
                may_be_thousands: false,
                ..self
            }
        })
    }

    /// Returns all interpretations: with thousands separators, and with trailing zeros as
    /// placeholders.
    pub(super) fn readings(self) -> impl Iterator<Item = WrittenFigure> {
        let both = [Some(self), self.with_thousands()];
        both.into_iter().flatten().flat_map(|one| {
            let rough = (one.zeros > 0).then(|| WrittenFigure {
                digits: one.digits - one.zeros,
                last: one.last * ten_to(one.zeros),
                zeros: 0,
                ..one
            });
            [Some(one), rough].into_iter().flatten()
        })
    }
}

/// Returns the position of the unit's first letter; the `e` of an exponent is not a letter.
fn unit_start(text: &str) -> usize {
    let is_exponent = |at: usize| {
        let before = text[..at].trim_start_matches(['-', '+']);
        let after = text[at + 1..].trim_start_matches(['-', '+']);
        let is_led = before.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',');
        is_led && after.starts_with(|c: char| c.is_ascii_digit())
    };
    let mut letters = text
        .char_indices()
        .filter(|(_, c)| c.is_alphabetic() || matches!(c, '°' | '˚' | '[' | '('));
    let first = letters.find(|(at, c)| !(matches!(c, 'e' | 'E') && is_exponent(*at)));
    first.map_or(text.len(), |(at, _)| at)
}

/// Returns the number of trailing zeros of these digits, leaving at least three digits.
fn spare_zeros(digits: &str) -> i32 {
    let zeros = digits.len() - digits.trim_end_matches('0').len();
    let spare = zeros.min(digits.len().saturating_sub(3));
    i32::try_from(spare).unwrap_or(0)
}

/// Returns the text with a decimal point and without thousands separators; `None` if the separators
/// are inconsistent.
fn with_point(text: &str) -> Option<String> {
    let marks = |mark: char| text.matches(mark).count();
    let is_comma_last = text.rfind(',') > text.rfind('.');
    let (last, other) = if is_comma_last {
        (',', '.')
    } else {
        ('.', ',')
    };
    let (whole, decimals) = match (marks(last), marks(other)) {
        (0, _) => return Some(text.to_owned()),
        (1, _) => text.split_once(last)?,
        // Only thousands separators.
        (_, 0) => (text, ""),
        _ => return None,
    };
    let are_grouped = !whole.contains(['.', ',']) || are_groups(whole);
    let whole = whole.replace(['.', ','], "");
    are_grouped.then(|| match decimals {
        "" if marks(last) > 1 => whole,
        decimals => format!("{whole}.{decimals}"),
    })
}

/// Returns `true` if the separators delimit groups of three digits.
fn are_groups(text: &str) -> bool {
    let mut groups = text.trim_start_matches(['-', '+']).split(['.', ',']);
    let is_led = groups
        .next()
        .is_some_and(|first| (1..=3).contains(&first.len()));
    is_led && groups.all(|group| group.len() == 3)
}

fn ten_to(power: i32) -> f64 {
    10_f64.powi(power.clamp(-400, 400))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn figure(text: &str) -> (WrittenFigure, String) {
        WrittenFigure::read(text).unwrap_or_else(|| panic!("{text}"))
    }

    fn read(text: &str) -> (f64, i32, f64) {
        let (figure, _) = figure(text);
        (figure.value, figure.digits, figure.unit_of(0, 99))
    }

    #[test]
    fn read_accepts_decimal_and_thousands_separators() {
        for (text, expected) in [
            ("29.38", (29.38, 4, 0.01)),
            ("29,38", (29.38, 4, 0.01)),
            (" -14,47 mm", (-14.47, 4, 0.01)),
            ("345.5°", (345.5, 4, 0.1)),
            ("8259", (8259.0, 4, 1.0)),
            ("8.259,5", (8259.5, 5, 0.1)),
            ("-459.977,6", (-459_977.6, 7, 0.1)),
            ("1.234.567", (1_234_567.0, 7, 1.0)),
            ("22 500", (22500.0, 5, 1.0)),
            ("2.40e4", (24000.0, 3, 100.0)),
            ("\u{2212}0,0250", (-0.025, 3, 0.0001)),
            ("\u{2013}229.03", (-229.03, 5, 0.01)),
            ("0", (0.0, 0, 1.0)),
            ("0e9", (0.0, 0, 1.0)),
            ("-89.4427 rd/s", (-89.4427, 6, 1e-4)),
        ] {
            let (value, digits, last) = read(text);
            assert_eq!((value, digits), (expected.0, expected.1), "{text}");
            assert!((last / expected.2 - 1.0).abs() < 1e-12, "{text}: {last}");
        }
        for wrong in [
            "",
            "-",
            "x",
            "1.2.3,4,5",
            "1,2,3",
            "1.23,4",
            "1234.567,8",
            "1..2",
            "nan",
            "inf",
            "e5",
            "1e999",
            ".",
        ] {
            assert_eq!(WrittenFigure::read(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn unit_of_clamps_digits_to_3_and_6() {
        let (rough, _) = figure("28");
        assert!((rough.unit_of(3, 6) - 0.1).abs() < 1e-12);
        let (fine, _) = figure("28.02517077");
        assert!((fine.unit_of(3, 6) - 1e-4).abs() < 1e-12);
    }

    #[test]
    fn read_splits_off_trailing_unit() {
        for (text, unit) in [
            ("8262.36 rad/s²", "rad/s²"),
            ("345.5°", "°"),
            ("15°/s", "°/s"),
            ("2.4e4mm/s", "mm/s"),
            ("7 ein", "ein"),
            ("345,5 [derece]", "derece"),
            ("345.5 (ca.)", "ca."),
            ("1e", "e"),
            ("7", ""),
        ] {
            assert_eq!(figure(text).1, unit, "{text}");
        }
    }

    #[test]
    fn readings_include_ambiguous_separators_and_zeros() {
        let readings = |text| -> Vec<(f64, i32)> {
            let all = figure(text).0.readings();
            all.map(|one| (one.value, one.digits)).collect()
        };
        assert_eq!(readings("8,259"), [(8.259, 4), (8259.0, 4)]);
        assert_eq!(readings("-8.250"), [(-8.25, 4), (-8250.0, 4), (-8250.0, 3)]);
        assert_eq!(readings("10200"), [(10200.0, 5), (10200.0, 3)]);
        assert_eq!(readings("10000"), [(10000.0, 5), (10000.0, 3)]);
        for text in [
            "100",
            "0,259",
            "8.2590",
            "1.234,567",
            "8259.0",
            "1,5e3",
            "0",
        ] {
            assert_eq!(readings(text).len(), 1, "{text}");
        }
    }

    proptest! {
        #[test]
        fn readings_of_any_text_are_finite(text in ".{0,80}") {
            if let Some((written, _)) = WrittenFigure::read(&text) {
                prop_assert!(written.readings().all(|one| one.value.is_finite()));
            }
        }
    }
}
