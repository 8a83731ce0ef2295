//! What people mostly meant where a scene is not valid TOML.

use super::rate::number_length;
use crate::document::ByteSpan;

/// What was mostly meant, by the parser's message and what stands there.
pub(super) fn mend(text: &str, message: &str, span: &ByteSpan) -> Option<String> {
    let at = text.get(span.start..).unwrap_or("");
    let before = text.get(..span.start).unwrap_or("");
    let begin = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[begin..].lines().next().unwrap_or("").trim_start();
    if line.starts_with("//") {
        return Some("a comment begins with #".to_owned());
    }
    if message.starts_with("string values must be quoted") {
        return Some(bare_value(text.get(span.clone()).unwrap_or("")));
    }
    if message.starts_with("invalid unquoted key") && at.starts_with('\'') {
        return Some("a name with ' in it is quoted: \"B'\" = [0, 0]".to_owned());
    }
    let leftover = message.starts_with("invalid literal string");
    if leftover && line.as_bytes().windows(3).any(is_decimal_comma) {
        return Some("decimals are written with a point: 0.5".to_owned());
    }
    message
        .starts_with("key with no value")
        .then(|| "write key = value".to_owned())
}

/// The mend for a value that is neither a number nor quoted.
fn bare_value(value: &str) -> String {
    let (number, rest) = value.split_at(number_length(value));
    if number.is_empty() {
        return "texts and names are quoted: \"A\"".to_owned();
    }
    if number_length(rest.trim_start()) > 0 {
        return "the values of a list are separated by commas: [0, 0]".to_owned();
    }
    format!(
        "write the number alone: {number}; lengths are in the scene's `unit`, angles in degrees, \
         and a speed is a quoted text: \"15 rad/s\""
    )
}

fn is_decimal_comma(bytes: &[u8]) -> bool {
    matches!(bytes, [a, b',', c] if a.is_ascii_digit() && c.is_ascii_digit())
}
