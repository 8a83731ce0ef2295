//! Parses decimal numbers with a point or a comma.

use crate::Double;
use crate::arithmetic::Decimal;
use std::borrow::Cow;

/// Replaces the decimal comma of the number at the beginning of a text by a point. Returns `None`
/// if it is ambiguous which mark is the decimal one, as in `1,500` and `1.234,5`.
pub fn with_point(text: &str) -> Option<Cow<'_, str>> {
    let text = text.trim();
    // Replacing keeps the number of bytes, so the length applies to both texts.
    let length = number_length(&text.replace(',', "."));
    let (number, rest) = text.split_at(length);
    if are_thousands(number) || !number.is_empty() && rest.starts_with(['.', ',']) {
        return None;
    }
    Some(match number.contains(',') {
        true => (number.replace(',', ".") + rest).into(),
        false => text.into(),
    })
}

/// Splits a list at its commas, except at decimal commas: `a=1,5..2,5/3, b` has two entries. A
/// comma is a decimal one if a digit follows and a number after `=`, `@` or `..` precedes.
#[must_use]
pub fn entries_with_numbers(list: &str) -> Vec<String> {
    let mut entries: Vec<String> = Vec::new();
    for part in list.split(',') {
        match entries.last_mut() {
            Some(last) if ends_with_number(last) && continues_number(part) => {
                last.push(',');
                last.push_str(part);
            }
            _ => entries.push(part.to_owned()),
        }
    }
    entries
}

fn ends_with_number(entry: &str) -> bool {
    let head = entry.trim_end_matches(|c: char| c.is_ascii_digit());
    let head = head.strip_suffix(['+', '-']).unwrap_or(head).trim_end();
    head.ends_with(['=', '@']) || head.ends_with("..")
}

fn continues_number(part: &str) -> bool {
    let rest = part.trim_start_matches(|c: char| c.is_ascii_digit());
    let is_unit = || rest.trim().chars().all(|c| c.is_alphabetic() || c == '°');
    rest.len() < part.len() && (rest.starts_with("..") || rest.starts_with('/') || is_unit())
}

/// Returns `true` if the comma of a number could separate thousands.
pub fn are_thousands(number: &str) -> bool {
    let digits = number.trim_start_matches(['+', '-']);
    let integer = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    digits.split_once(',').is_some_and(|(thousands, hundreds)| {
        let is_led = (1..=3).contains(&thousands.len()) && !thousands.starts_with('0');
        is_led && integer(thousands) && hundreds.len() == 3 && integer(hundreds)
    })
}

/// Returns the length in bytes of the decimal number at the beginning of a text.
pub(crate) fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        at
    };
    let sign = |at: usize| at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let mut end = digits(sign(0));
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let first = sign(end + 1);
        let last = digits(first);
        if last > first {
            end = last;
        }
    }
    end
}

/// Maximum number of digits of an exact decimal; longer ones are assumed to be rounded.
const MAX_DIGITS: usize = 14;

/// Returns `true` if a text has more digits than an exact decimal, but reads as a decimal of few
/// digits.
pub(crate) fn is_rounded(text: &str, number: f64) -> bool {
    digits(text) > MAX_DIGITS && !Decimal::of(number).is_long
}

/// Parses a decimal of few digits as a double-double; returns `None` for more digits.
pub(crate) fn typed(text: &str) -> Option<Double> {
    let number: f64 = text.parse().ok()?;
    let decimal = Decimal::of(number);
    (digits(text) <= MAX_DIGITS).then_some(decimal.value)
}

/// Returns the number of digits of a decimal number, without leading and trailing zeros.
fn digits(text: &str) -> usize {
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_rounded_detects_digits_lost_in_a_double() {
        for rounded in [
            "0.10000000000000001",
            "250.00000000000001",
            "1.0000000000000000001e5",
        ] {
            assert!(is_rounded(rounded, rounded.parse().unwrap()), "{rounded}");
            assert_eq!(typed(rounded), None);
        }
        for exact in [
            "0.1",
            "0.100000000000000000000",
            "39.3",
            "100000000000000000000",
            "141.4213562373095",
        ] {
            assert!(!is_rounded(exact, exact.parse().unwrap()), "{exact}");
        }
        let tenth = typed("0.1").unwrap();
        assert!(tenth.hi == 0.1 && tenth.lo < 0.0);
        assert_eq!(typed("141.42135623730951"), None);
    }

    #[test]
    fn lists_are_split_at_commas_that_are_not_decimal() {
        for (list, entries) in [
            ("a=1,5..2,5/3, b", &["a=1,5..2,5/3", " b"][..]),
            ("a=-0,5..2,b=1..1,25", &["a=-0,5..2", "b=1..1,25"]),
            ("C.x@60,5,C.y@90", &["C.x@60,5", "C.y@90"]),
            ("r3=20,5 deg,r4=280", &["r3=20,5 deg", "r4=280"]),
            ("r3=20,4=280", &["r3=20", "4=280"]),
            ("a=1..2,4.length", &["a=1..2", "4.length"]),
            ("r2,3", &["r2", "3"]),
            ("a=1..2, 5", &["a=1..2", " 5"]),
            ("", &[""]),
        ] {
            assert_eq!(entries_with_numbers(list), entries, "{list}");
        }
    }

    #[test]
    fn comma_is_decimal_point_only_when_unambiguous() {
        for (typed, read) in [
            ("15,5", "15.5"),
            (" -0,5 ", "-0.5"),
            ("0,125", "0.125"),
            ("1500,25", "1500.25"),
            ("1,5e3", "1.5e3"),
            ("15,5 rad/s", "15.5 rad/s"),
            ("15.5", "15.5"),
            ("long", "long"),
            ("", ""),
        ] {
            assert_eq!(with_point(typed).as_deref(), Some(read), "{typed}");
        }
        for unclear in [
            "1,500", "-12,345", "1,500 mm", "1,234.5", "1.234,5", "1,2,3", "1.2.3",
        ] {
            assert_eq!(with_point(unclear), None, "{unclear}");
        }
    }
}
