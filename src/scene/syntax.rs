//! The TOML of a scene file, and TOML's own faults in a person's words.

use super::diagnostic::Diagnostic;
use super::rate::number_length;
use super::reader::{Reader, Span, quoted};
use toml::de::{DeTable, DeValue, Error};

/// Parses the text; `None` if it cannot be gone on with.
pub(super) fn document<'t>(reader: &mut Reader<'t>) -> Option<DeTable<'t>> {
    let text = reader.text();
    let (root, errors) = DeTable::parse_recoverable(text);
    let root = root.into_inner();
    let mut last_line = None;
    let mut whole = true;
    for error in &errors {
        let span = error.span().unwrap_or(text.len()..text.len());
        let line = text.as_bytes()[..span.start.min(text.len())]
            .iter()
            .rposition(|&b| b == b'\n');
        // What follows in the same line is mostly an echo.
        if last_line == Some(line) {
            continue;
        }
        last_line = Some(line);
        if reader.is_full() {
            return None;
        }
        let twice = error.message() == "duplicate key";
        // A section that stands twice has lost what its second half names.
        whole &= twice && !text[line.map_or(0, |l| l + 1)..].starts_with('[');
        let too_deep = error.message().starts_with("cannot recurse");
        reader.report(if twice {
            duplicate(text, &root, span)
        } else {
            fault(text, error, span)
        });
        // Every bracket left open would be another fault.
        if too_deep {
            return None;
        }
    }
    whole.then_some(root)
}

fn fault(text: &str, error: &Error, span: Span) -> Diagnostic {
    let message = error.message();
    let help = mend(text, message, &span);
    Diagnostic::new(format!("not valid TOML: {message}"))
        .at(span, "")
        .maybe_help(help)
}

/// What people mostly meant, by the parser's message and what stands there.
fn mend(text: &str, message: &str, span: &Span) -> Option<String> {
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

/// A key that stands twice in its table.
fn duplicate(text: &str, root: &DeTable<'_>, span: Span) -> Diagnostic {
    let key = text.get(span.clone()).unwrap_or("");
    let key = key.trim_matches(['"', '\'']);
    let mut first: Option<Span> = None;
    // The recovered table keeps the first one; the nearest before is in the same table.
    each_key(root, &mut |other: &str, place| {
        let nearer = first.as_ref().is_none_or(|f| f.start < place.start);
        if other == key && place.start < span.start && nearer {
            first = Some(place);
        }
    });
    let fault = Diagnostic::new(format!("{} is given twice", quoted(key)))
        .at(span, "the second time")
        .help("take one of them out, or rename it");
    match first {
        Some(place) => fault.and(place, "the first time"),
        None => fault,
    }
}

/// Visits every key of a table and of the tables in it. As deep as TOML's own limit of nesting.
fn each_key(table: &DeTable<'_>, visit: &mut dyn FnMut(&str, Span)) {
    for (key, value) in table {
        visit(key.get_ref(), key.span());
        each_key_of(value.get_ref(), visit);
    }
}

fn each_key_of(value: &DeValue<'_>, visit: &mut dyn FnMut(&str, Span)) {
    if let Some(table) = value.as_table() {
        each_key(table, visit);
    }
    for item in value.as_array().into_iter().flatten() {
        each_key_of(item.get_ref(), visit);
    }
}
