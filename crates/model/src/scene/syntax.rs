//! Suggests fixes for common mistakes in the TOML syntax of a scene.

use super::numbers::numeral::number_length;
use crate::document::ByteSpan;
use crate::expression;
use crate::wording::words;

/// Returns the hint for a syntax error, from the parser's message and the text at the error; `None`
/// for an unfamiliar error.
pub fn fix(text: &str, message: &str, span: &ByteSpan) -> Option<String> {
    let at = text.get(span.start..).unwrap_or("");
    let before = text.get(..span.start).unwrap_or("");
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[start..].lines().next().unwrap_or("").trim_start();
    if line.starts_with("//") {
        return Some(words().comments_begin_with().to_owned());
    }
    if message.starts_with("string values must be quoted") {
        return Some(bare_value(
            text.get(span.clone()).unwrap_or(""),
            is_angle(&text[start..span.start]),
        ));
    }
    if message.starts_with("invalid unquoted key") && at.starts_with('\'') {
        return Some(words().quote_the_name().to_owned());
    }
    let number = match at.starts_with('"') {
        true => number_at_end(before),
        // In a list, the parser reports the number itself.
        false => {
            let (number, rest) = at.split_at(number_length(at));
            (!number.is_empty() && rest.starts_with('"')).then_some(number)
        }
    };
    if let Some(number) = number {
        return Some(match is_angle(&text[start..span.start]) {
            true => words().angle_alone(number),
            false => words().quote_after_number(number),
        });
    }
    message
        .starts_with("key with no value")
        .then(|| words().write_key_and_value().to_owned())
}

/// Returns the number at the end of a text; `None` if there is none.
fn number_at_end(text: &str) -> Option<&str> {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | '_');
    let number = &text[text.trim_end_matches(is_of_number).len()..];
    (!number.is_empty() && number_length(number) == number.len()).then_some(number)
}

/// Returns `true` if the last key in front of a value is that of an angle.
fn is_angle(before: &str) -> bool {
    let key = before.rsplit_once('=').map_or("", |(key, _)| key);
    let key = key
        .rsplit(['{', ',', ' ', '.'])
        .find(|word| !word.is_empty());
    key == Some("angle")
}

/// Returns the hint for a value that is neither a number nor quoted; `is_angle` if it should be an
/// angle.
fn bare_value(value: &str, is_angle: bool) -> String {
    let (number, rest) = value.split_at(number_length(value));
    if number.is_empty() {
        return words().quote_texts_and_names().to_owned();
    }
    if number_length(rest.trim_start()) > 0 {
        return words().separate_by_commas().to_owned();
    }
    let unit = rest.trim();
    let formula = format!("{number} {unit}");
    let is_measured = expression::parse(&formula).is_ok_and(|tree| tree.is_number());
    let is_degree = unit.starts_with(['\u{b0}', '\u{ba}', '\u{2da}']);
    match is_measured || unit == "rpm" {
        _ if is_degree => words().angle_alone(number),
        true => words().quote_with_unit(number, unit),
        false if is_angle => words().angle_alone(number),
        false => words().number_alone_or_unit(number),
    }
}
