//! The TOML of a document, and TOML's own faults in a person's words.

use super::diagnostic::Diagnostic;
use super::lenient::Lenient;
use super::reader::{ByteSpan, Reader, quoted};
use crate::wording::words;
use serde::Deserialize;
use toml::de::{DeTable, DeValue, Deserializer, Error};

/// What a person mostly meant, by the text, the parser's message and the place that it points at.
pub(crate) type Mend = fn(&str, &str, &ByteSpan) -> Option<String>;

/// Reads the text into a derived type, lenient in each of its values; `None` if the text cannot be gone on with.
pub(crate) fn parse<'t, T: Deserialize<'t>>(
    reader: &mut Reader<'t>,
    mend: Mend,
) -> Option<Lenient<T>> {
    let (root, errors) = DeTable::parse_recoverable(reader.text());
    if !is_whole(reader, mend, root.get_ref(), &errors) {
        return None;
    }
    Lenient::deserialize(Deserializer::from(root)).ok()
}

/// Whether a key stands at the root of a text, as far as that is TOML.
pub(crate) fn has_key(text: &str, key: &str) -> bool {
    let (root, _) = DeTable::parse_recoverable(text);
    root.get_ref().keys().any(|own| own.get_ref() == key)
}

/// Reports what is not TOML; false if too little is left to go on with.
fn is_whole(reader: &mut Reader<'_>, mend: Mend, root: &DeTable<'_>, errors: &[Error]) -> bool {
    let text = reader.text();
    let mut last_line = None;
    let mut whole = true;
    for error in errors {
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
            return false;
        }
        let twice = error.message().starts_with("duplicate key");
        // A section that stands twice has lost what its second half names.
        whole &= twice && !text[line.map_or(0, |l| l + 1)..].starts_with('[');
        let too_deep = error.message().starts_with("cannot recurse");
        reader.report(if twice {
            duplicate(text, root, span)
        } else {
            fault(text, error, span, mend)
        });
        // Every bracket left open would be another fault.
        if too_deep {
            return false;
        }
    }
    whole
}

fn fault(text: &str, error: &Error, span: ByteSpan, mend: Mend) -> Diagnostic {
    let message = error.message();
    let help = mend(text, message, &span);
    Diagnostic::new(words().not_valid_toml(message))
        .at(span, "")
        .maybe_help(help)
}

/// A key that stands twice in its table.
fn duplicate(text: &str, root: &DeTable<'_>, span: ByteSpan) -> Diagnostic {
    let key = text.get(span.clone()).unwrap_or("");
    let key = key.trim_matches(['"', '\'']);
    let mut first: Option<ByteSpan> = None;
    // The recovered table keeps the first one; the nearest before is in the same table.
    each_key(root, &mut |other: &str, place| {
        let nearer = first.as_ref().is_none_or(|f| f.start < place.start);
        if other == key && place.start < span.start && nearer {
            first = Some(place);
        }
    });
    let fault = Diagnostic::new(words().given_twice(&quoted(key)))
        .at(span, words().the_second_time())
        .help(words().take_one_out());
    match first {
        Some(place) => fault.and(place, words().the_first_time()),
        None => fault,
    }
}

/// Visits every key of a table and of the tables in it. As deep as TOML's own limit of nesting.
fn each_key(table: &DeTable<'_>, visit: &mut dyn FnMut(&str, ByteSpan)) {
    for (key, value) in table {
        visit(key.get_ref(), key.span());
        each_key_of(value.get_ref(), visit);
    }
}

fn each_key_of(value: &DeValue<'_>, visit: &mut dyn FnMut(&str, ByteSpan)) {
    if let Some(table) = value.as_table() {
        each_key(table, visit);
    }
    for item in value.as_array().into_iter().flatten() {
        each_key_of(item.get_ref(), visit);
    }
}
