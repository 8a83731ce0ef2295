//! Reads numbers and pairs of a scene, and reports invalid ones.

use super::numeral::{is_rounded, number_length};
use crate::Vec2;
use crate::arithmetic::Decimal;
pub(super) use crate::document::{ByteSpan, Name, Reader, quoted};
use crate::document::{Diagnostic, Entries, Lenient, Misplaced, has_decimal_comma};
use crate::expression;
use crate::wording::words;

/// A pair of coordinates as written.
pub(super) type CoordinatePair = Lenient<Vec<Lenient<f64>>>;
/// Points by their names.
pub(super) type Points = Lenient<Entries<CoordinatePair>>;

/// Maximum absolute value of a coordinate or length. Squares of scaled values must stay finite, and
/// no real mechanism comes near.
pub(super) const MAX_SIZE: f64 = 1e300;
/// Minimum length, for the same reason.
pub(super) const MIN_LENGTH: f64 = 1e-300;

/// Maximum relative rounding error of a formula in double-double, with a margin.
const TWICE_ROUNDED: f64 = 1e-29;

impl Reader<'_> {
    /// Reads a finite number of permitted size.
    pub fn number(&mut self, what: &str, value: &Lenient<f64>) -> Option<f64> {
        let number = match number_of(self.text(), value) {
            Ok(number) => {
                let written = self.text().get(value.span.clone()).unwrap_or("");
                self.has_rounded |= is_rounded(written, number);
                number
            }
            Err(Misplaced::Text(formula)) => {
                let worth = self.worked_out(what, formula, &value.span)?;
                let number = worth.nearest();
                let decimal = Decimal::of(number);
                let apart = (decimal.value - worth.value.twice()).hi.abs();
                self.has_rounded |= !decimal.is_long && apart > TWICE_ROUNDED * number.abs();
                number
            }
            Err(found) => {
                let fault = self.wrong_type(what, words().a_number(), found, &value.span);
                self.report(fault);
                return None;
            }
        };
        let literal = self.literal(&value.span);
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
                .at(value.span.clone(), label)
                .help(help),
        );
        None
    }

    /// Reads an optional number that must not be negative; returns 0 if it is missing or invalid.
    /// `unit` is appended to its name in messages.
    pub(super) fn not_negative(
        &mut self,
        of: &str,
        key: &str,
        unit: &str,
        value: Option<&Lenient<f64>>,
    ) -> f64 {
        let Some(value) = value else {
            return 0.0;
        };
        let what = words().key_of(key, of) + unit;
        let number = self.number(&what, value);
        if number.is_some_and(|n| n < 0.0) {
            let literal = self.literal(&value.span);
            self.report(
                Diagnostic::new(words().must_not_be_less_than_zero(&what, &literal))
                    .at(value.span.clone(), words().is_negative())
                    .help(words().leave_it_out(key)),
            );
        }
        number.unwrap_or(0.0).max(0.0)
    }

    /// Reads a pair `[x, y]`.
    pub(super) fn pair(&mut self, what: &str, value: &CoordinatePair) -> Option<Vec2> {
        let items = self.two(what, "[x, y]", "[12.5, 0]", value)?;
        self.coordinates(what, items)
    }

    /// Reads a pair `[x, y]` from the items of a list.
    pub(super) fn pair_of(
        &mut self,
        what: &str,
        items: &[Lenient<f64>],
        span: &ByteSpan,
    ) -> Option<Vec2> {
        let items = self.two_of(what, ("[x, y]", "[12.5, 0]"), items, span)?;
        self.coordinates(what, items)
    }

    fn coordinates(&mut self, what: &str, [x, y]: [&Lenient<f64>; 2]) -> Option<Vec2> {
        let x = self.number(&words().part_of("x", what), x);
        let y = self.number(&words().part_of("y", what), y);
        Some(Vec2::new(x?, y?))
    }

    /// Reads a list of exactly two values.
    pub(super) fn two<'v, T>(
        &mut self,
        what: &str,
        form: &str,
        example: &str,
        value: &'v Lenient<Vec<T>>,
    ) -> Option<[&'v T; 2]> {
        let found = match &value.read {
            Ok(items) => return self.two_of(what, (form, example), items, &value.span),
            Err(found) => found,
        };
        let fault = self.wrong_type(what, &words().a_pair(form), found, &value.span);
        self.report(fault.help(words().for_example(example)));
        None
    }

    /// Returns the two values of a list. Reports a list of another length, and returns `None`.
    pub(super) fn two_of<'v, T>(
        &mut self,
        what: &str,
        (form, example): (&str, &str),
        items: &'v [T],
        span: &ByteSpan,
    ) -> Option<[&'v T; 2]> {
        if let [one, other] = items {
            return Some([one, other]);
        }
        let count = items.len();
        let typed = self.text().get(span.clone()).unwrap_or("");
        let help = match count > 2 && has_decimal_comma(typed) {
            true => words().decimals_have_a_point("0.5"),
            false => words().for_example(example),
        };
        self.report(
            Diagnostic::new(words().must_be_a_pair(what, form, count))
                .at(span.clone(), words().expected_two(count))
                .help(help),
        );
        None
    }

    /// Reads an optional text.
    pub(super) fn text_of<'v>(
        &mut self,
        key: &str,
        of: &str,
        value: Option<&'v Lenient<String>>,
    ) -> Option<Name<'v>> {
        self.string(&words().key_of(key, of), value?)
    }
}

/// Returns the hint for a number written as text, possibly followed by something that is not a
/// unit; `None` for other texts.
pub(super) fn bare_number(text: &str) -> Option<String> {
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

/// Returns the nearest double of the digits in the text, infinite on overflow. TOML's own parser
/// has no negative zero among integers, and is limited to 128 bits.
pub(super) fn number_of<'v>(text: &str, value: &'v Lenient<f64>) -> Result<f64, &'v Misplaced> {
    let number = match &value.read {
        Ok(number) => *number,
        Err(Misplaced::Unheld) => f64::INFINITY,
        Err(found) => return Err(found),
    };
    let digits = text.get(value.span.clone()).unwrap_or("").replace('_', "");
    // Numbers that begin with 0x, 0o or 0b do not parse as f64.
    Ok(digits.parse().unwrap_or(number))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;
    use toml::de::ValueDeserializer;

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
            let value = Lenient::deserialize(ValueDeserializer::parse(text).unwrap()).unwrap();
            let found = number_of(text, &value).unwrap();
            assert_eq!(found.to_bits(), expected.to_bits(), "{text}: {found}");
        }
    }
}
