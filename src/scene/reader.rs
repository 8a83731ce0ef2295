//! Numbers and pairs of a scene; what does not fit becomes a diagnostic.

use super::rate;
use crate::Vec2;
use crate::document::Diagnostic;
pub(super) use crate::document::{Name, Reader, Span, Value, meant, quoted};
use toml::de::{DeArray, DeTable, DeValue};

/// No coordinate or length may be larger: squares of scaled values must stay finite, and nothing
/// that a person builds comes near.
pub(super) const LARGEST: f64 = 1e300;
/// No length may be smaller, for the same reason.
pub(super) const SMALLEST_LENGTH: f64 = 1e-300;
/// The mend for a number out of all proportion.
pub(super) const ORDINARY: &str = "choose a `unit` in which the dimensions are ordinary numbers";
impl Reader<'_> {
    /// A finite number that is not too large.
    pub(super) fn number(&mut self, what: &str, value: &Value<'_>) -> Option<f64> {
        let Some(number) = number_of(value.get_ref()) else {
            let fault = self.wrong_type(what, "a number", value);
            let help = value.get_ref().as_str().and_then(bare_number);
            self.report(fault.maybe_help(help));
            return None;
        };
        let literal = self.literal(&value.span());
        // Written so that NaN is refused too.
        if number.abs() <= LARGEST {
            return Some(number);
        }
        let (rule, label, help) = if number.is_nan() {
            (
                "a finite number",
                "not a number",
                "write a decimal number, such as 12.5",
            )
        } else if number.is_infinite() {
            (
                "a finite number",
                "not finite in double precision",
                "write a decimal number, such as 12.5",
            )
        } else {
            ("at most 1e300 in size", "too large", ORDINARY)
        };
        self.report(
            Diagnostic::new(format!("{what} must be {rule}, not {literal}"))
                .at(value.span(), label)
                .help(help),
        );
        None
    }

    /// A number of a table that may be left out, and is 0 then; `unit` is put behind its name.
    pub(super) fn not_negative(
        &mut self,
        of: &str,
        table: &DeTable<'_>,
        key: &str,
        unit: &str,
    ) -> f64 {
        let Some(value) = table.get(key) else {
            return 0.0;
        };
        let what = format!("`{key}` of {of}{unit}");
        let number = self.number(&what, value);
        if number.is_some_and(|n| n < 0.0) {
            let literal = self.literal(&value.span());
            self.report(
                Diagnostic::new(format!("{what} must not be negative, but is {literal}"))
                    .at(value.span(), "negative")
                    .help(format!("leave `{key}` out where it does not matter")),
            );
        }
        number.unwrap_or(0.0).max(0.0)
    }

    /// A pair `[x, y]`.
    pub(super) fn pair(&mut self, what: &str, value: &Value<'_>) -> Option<Vec2> {
        let items = self.two(what, "[x, y]", "[12.5, 0]", value)?;
        let x = self.number(&format!("x of {what}"), &items[0]);
        let y = self.number(&format!("y of {what}"), &items[1]);
        Some(Vec2::new(x?, y?))
    }

    /// A list of exactly two values.
    pub(super) fn two<'v>(
        &mut self,
        what: &str,
        form: &str,
        example: &str,
        value: &'v Value<'v>,
    ) -> Option<&'v DeArray<'v>> {
        let Some(items) = value.get_ref().as_array() else {
            let fault = self.wrong_type(what, &format!("a pair {form}"), value);
            self.report(fault.help(format!("for example: {example}")));
            return None;
        };
        if items.len() != 2 {
            let count = items.len();
            self.report(
                Diagnostic::new(format!("{what} must be a pair {form}, not {count} values"))
                    .at(value.span(), format!("expected 2 values, found {count}"))
                    .help(format!("for example: {example}")),
            );
            return None;
        }
        Some(items)
    }
}

/// The mend for a number that was written as a text.
fn bare_number(text: &str) -> Option<String> {
    let text = text.trim();
    let (number, rest) = text.split_at(rate::number_length(text));
    let help = match (number.is_empty(), rest.is_empty()) {
        (true, _) => return None,
        (false, true) => format!("write it without quotes: {number}"),
        (false, false) if rest.trim() == "%" => {
            // Exactly by text: two places further left.
            let part = number.parse::<f64>().ok()? / 100.0;
            format!("write it as a part of one: {part}")
        }
        (false, false) => format!(
            "write the number alone: {number}; lengths are in the scene's `unit`, angles in degrees"
        ),
    };
    Some(help)
}

/// The nearest double; infinite for a literal that overflows.
pub(super) fn number_of(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
        #[expect(clippy::cast_precision_loss, reason = "the nearest double is meant")]
        DeValue::Integer(integer) => {
            let whole = u128::from_str_radix(integer.as_str(), integer.radix());
            Some(whole.map_or(f64::INFINITY, |n| n as f64))
        }
        DeValue::String(_)
        | DeValue::Boolean(_)
        | DeValue::Datetime(_)
        | DeValue::Array(_)
        | DeValue::Table(_) => None,
    }
}
