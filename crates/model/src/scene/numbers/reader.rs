//! Reads numbers and pairs of a scene, and reports invalid ones.

use crate::arithmetic::Decimal;
pub(crate) use crate::document::{ByteSpan, Name, Reader, quoted};
use crate::document::{Diagnostic, WrittenValue, first_with_point, has_decimal_comma, number_of};
use crate::expression;
use crate::scene::numbers::numeral::{is_rounded, number_length};
use crate::wording::words;
use crate::{Double, Vec2};

/// Maximum absolute value of a coordinate or length. Squares of scaled values must stay finite, and
/// no real mechanism comes near.
pub(crate) const MAX_SIZE: f64 = 1e300;
/// Minimum length, for the same reason.
pub(crate) const MIN_LENGTH: f64 = 1e-300;

/// Maximum relative rounding error of a formula in double-double, with a margin.
const FORMULA_ERROR: f64 = 1e-29;

impl Reader<'_> {
    /// Reads a finite number of permitted size.
    pub fn number(&mut self, what: &str, value: &WrittenValue<'_>) -> Option<f64> {
        let span = value.span();
        let number = match (number_of(self.text(), value), value.get_ref().as_str()) {
            (Some(number), _) => {
                let written = self.text().get(span.clone()).unwrap_or("");
                self.has_rounded |= is_rounded(written, number);
                number
            }
            (None, Some(formula)) => {
                let result = self.worked_out(what, formula, &span)?;
                let number = result.nearest();
                self.note_rounding(number, result.value.twice());
                number
            }
            (None, None) => {
                let fault = self.mistyped(what, words().a_number(), value);
                self.report(fault);
                return None;
            }
        };
        let literal = self.literal(&span);
        // A comparison that also rejects NaN.
        if number.abs() <= MAX_SIZE {
            return Some(number);
        }
        let (rule, label, help) = if number.is_nan() {
            (
                words().a_finite_number(),
                words().is_not_a_number(),
                words().write_a_decimal(),
            )
        } else if number.is_infinite() {
            (
                words().a_finite_number(),
                words().is_not_finite(),
                words().write_a_decimal(),
            )
        } else {
            (
                words().at_most_in_size(),
                words().is_too_large(),
                words().choose_a_unit(),
            )
        };
        self.report(
            Diagnostic::new(words().must_be(what, rule, &literal))
                .at(span, label)
                .help(help),
        );
        None
    }

    /// Rounds a number computed from typed ones to the nearest double.
    pub(crate) fn rounded(&mut self, value: Double) -> f64 {
        self.note_rounding(value.hi, value);
        value.hi
    }

    /// Records a double that reads as another decimal than the number from which it was rounded.
    fn note_rounding(&mut self, number: f64, value: Double) {
        let decimal = Decimal::of(number);
        let distance = (decimal.value - value).hi.abs();
        self.has_rounded |= !decimal.is_long && distance > FORMULA_ERROR * number.abs();
    }

    /// Reads a pair `[x, y]`.
    pub(crate) fn pair(&mut self, what: &str, value: &WrittenValue<'_>) -> Option<Vec2> {
        let [x, y] = self.two(what, "[x, y]", "[12.5, 0]", value)?;
        let x = self.number(&words().part_of("x", what), x);
        let y = self.number(&words().part_of("y", what), y);
        Some(Vec2::new(x?, y?))
    }

    /// Reads a list of exactly two values.
    pub(crate) fn two<'v>(
        &mut self,
        what: &str,
        form: &str,
        example: &str,
        value: &'v WrittenValue<'v>,
    ) -> Option<[&'v WrittenValue<'v>; 2]> {
        let items = self.list(what, &words().a_pair(form), example, value)?;
        if let [one, other] = items {
            return Some([one, other]);
        }
        let count = items.len();
        let typed = self.text().get(value.span()).unwrap_or("");
        let help = match count > 2 && has_decimal_comma(typed) {
            true => {
                let number = first_with_point(typed);
                words().decimals_have_a_point(number.as_deref().unwrap_or("0.5"))
            }
            false => words().for_example(example),
        };
        self.report(
            Diagnostic::new(words().must_be_a_pair(what, form, count))
                .at(value.span(), words().expected_two(count))
                .help(help),
        );
        None
    }
}

/// Returns the hint for a number written as text, possibly followed by something that is not a
/// unit; `None` for other texts.
pub(crate) fn bare_number(text: &str) -> Option<String> {
    let text = text.trim();
    let (number, rest) = text.split_at(number_length(text));
    let help = match (number.is_empty(), rest.is_empty()) {
        (true, _) => return None,
        (false, true) => words().write_without_quotes(number),
        (false, false) if rest.trim() == "%" => {
            // Dividing the parsed number by 100 gives the nearest double of the shifted decimal.
            let part = number.parse::<f64>().ok()? / 100.0;
            words().write_as_a_part(part)
        }
        (false, false) if rest.trim().chars().all(char::is_alphabetic) => {
            words().is_no_unit(rest.trim(), &expression::UNITS.join(", "))
        }
        (false, false) => return None,
    };
    Some(help)
}

#[cfg(test)]
mod tests {
    use super::*;
    use toml::de::DeValue;

    /// Accepts what the former hand-written reader did: integers of any length, and the sign of
    /// zero.
    #[test]
    fn numbers_are_read_as_nearest_doubles() {
        let long = format!("1{}", "0".repeat(45));
        let longer = format!("-1{}", "0".repeat(400));
        let hex = format!("0x{}", "f".repeat(40));
        for (text, expected) in [
            ("-0", -0.0),
            ("+1_000", 1000.0),
            ("0x64", 100.0),
            ("0xffffffffffffffff", u64::MAX as f64),
            ("9007199254740993", 9_007_199_254_740_992.0),
            (&long, 1e45),
            (&longer, f64::NEG_INFINITY),
            (&hex, f64::INFINITY),
            ("-1e400", f64::NEG_INFINITY),
            ("inf", f64::INFINITY),
        ] {
            let value = DeValue::parse(text).unwrap();
            let found = number_of(text, &value).unwrap();
            assert_eq!(found.to_bits(), expected.to_bits(), "{text}: {found}");
        }
    }
}
