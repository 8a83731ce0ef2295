//! Decimal numbers as people write them, with a point or a comma.

use std::borrow::Cow;

/// What is typed, with a point for the decimal comma of the number that it begins with; `None` where nobody knows
/// which mark is the decimal one, as in `1,500` and `1.234,5`.
pub(crate) fn with_point(text: &str) -> Option<Cow<'_, str>> {
    let text = text.trim();
    // As many bytes: what is found of the one is there in the other.
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

/// Whether the comma of a number may stand between thousands and hundreds.
pub(crate) fn are_thousands(number: &str) -> bool {
    let digits = number.trim_start_matches(['+', '-']);
    let whole = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    digits.split_once(',').is_some_and(|(thousands, hundreds)| {
        let is_led = (1..=3).contains(&thousands.len()) && !thousands.starts_with('0');
        is_led && whole(thousands) && hundreds.len() == 3 && whole(hundreds)
    })
}

/// The bytes of a decimal number at the beginning of a text.
pub(super) fn number_length(text: &str) -> usize {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_point_where_it_can_be_nothing_else() {
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
