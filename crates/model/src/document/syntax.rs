//! Parses the TOML of a document, and explains its syntax errors.

use super::balance::imbalance;
use super::diagnostic::Diagnostic;
use super::reader::{ByteSpan, DocumentKind, Reader, quoted};
use crate::wording::words;
use toml::de::{DeTable, DeValue, Error};

/// A function that suggests a fix from the text, the parser's message and the place of the error.
pub(crate) type SyntaxHint = fn(&str, &str, &ByteSpan) -> Option<String>;

/// Parses the text; returns `None` if the syntax errors leave nothing usable.
pub fn parse<'t>(reader: &mut Reader<'t>, fix: SyntaxHint) -> Option<DeTable<'t>> {
    if let Some(message) = foreign(reader.text()) {
        let help = match reader.kind {
            DocumentKind::Scene => words().krank_reads_toml(),
            DocumentKind::Task => words().tasks_are_toml(),
            DocumentKind::Configuration => words().configurations_are_toml(),
        };
        reader.report(Diagnostic::new(message).help(help));
        return None;
    }
    let (root, errors) = DeTable::parse_recoverable(reader.text());
    let is_whole = is_usable(reader, fix, root.get_ref(), &errors);
    is_whole.then(|| root.into_inner())
}

/// Returns `true` if the root table of a text has a key, as far as the text is TOML.
pub fn has_key(text: &str, key: &str) -> bool {
    let (root, _) = DeTable::parse_recoverable(text);
    root.get_ref().keys().any(|own| own.get_ref() == key)
}

/// Reports syntax errors; returns `false` if they leave nothing usable.
fn is_usable(
    reader: &mut Reader<'_>,
    fix: SyntaxHint,
    root: &DeTable<'_>,
    errors: &[Error],
) -> bool {
    let text = reader.text();
    let mut last_line = None;
    let mut is_whole = true;
    let imbalance = (!errors.is_empty()).then(|| imbalance(text)).flatten();
    let span_of = |error: &Error| error.span().unwrap_or(text.len()..text.len());
    let line_of = |error: &Error| {
        let before = &text.as_bytes()[..span_of(error).start.min(text.len())];
        before.iter().rposition(|&b| b == b'\n')
    };
    // The parser reports unreadable values last. In a line, its first error is the best.
    let mut errors: Vec<&Error> = errors.iter().collect();
    errors.sort_by_key(|error| line_of(error));
    for error in errors {
        let (span, line) = (span_of(error), line_of(error));
        // Further errors in one line mostly follow from the first.
        if last_line == Some(line) {
            continue;
        }
        last_line = Some(line);
        if reader.is_full() {
            return false;
        }
        // An unclosed bracket makes every line after it an error.
        if let Some(fault) = imbalance.as_ref().and_then(|i| i.fault(error, &span)) {
            reader.report(fault);
            return false;
        }
        let twice = error.message().starts_with("duplicate key");
        // After a duplicate section, the names of its second half are lost.
        is_whole &= twice && !text[line.map_or(0, |l| l + 1)..].starts_with('[');
        let too_deep = error.message().starts_with("cannot recurse");
        reader.report(if twice {
            duplicate(text, root, span)
        } else {
            fault(text, error, span, fix)
        });
        // Every unclosed bracket would be another error.
        if too_deep {
            return false;
        }
    }
    is_whole
}

fn fault(text: &str, error: &Error, span: ByteSpan, fix: SyntaxHint) -> Diagnostic {
    if let Some(fault) = decimal_comma(text, span.start) {
        return fault;
    }
    let message = error.message();
    let help = fix(text, message, &span);
    Diagnostic::new(words().not_valid_toml(message))
        .at(span, "")
        .maybe_help(help)
}

/// Recognizes text in another format, an address, JSON or a CSV table, and returns its description.
pub fn foreign(text: &str) -> Option<&'static str> {
    let text = text.trim_start();
    let is_of_pmks = || text.to_ascii_lowercase().contains("pmks");
    if text.starts_with("http://") || text.starts_with("https://") {
        return Some(match is_of_pmks() {
            true => words().is_a_pmks_address(),
            false => words().is_an_address(),
        });
    }
    let first = text.lines().next().unwrap_or("");
    if first.contains([',', ';', '\t']) && !first.contains(['=', '[', '{', '#', '"']) {
        return Some(words().is_a_table());
    }
    is_json(text).then(|| match is_of_pmks() {
        true => words().is_json_of_pmks(),
        false => words().is_json(),
    })
}

/// Returns `true` for JSON: an object, or a list that cannot be the header of a table in TOML.
fn is_json(text: &str) -> bool {
    let inner = text.trim_start_matches(['[', ' ', '\t', '\r', '\n']);
    let is_of_value = |c: char| c.is_ascii_digit() || c == '-' || c == '"';
    let first = inner.lines().next().unwrap_or("");
    let is_list = || {
        inner.starts_with(['{', ']'])
            || inner.starts_with(is_of_value) && first.split(']').next().unwrap_or("").contains(',')
    };
    text.starts_with('{') || text.starts_with('[') && is_list()
}

/// Returns the diagnostic of a line with a decimal comma, such as `length = 86,6`; `None` for other
/// lines.
fn decimal_comma(text: &str, at: usize) -> Option<Diagnostic> {
    let start = text.get(..at)?.rfind('\n').map_or(0, |newline| newline + 1);
    let line = text.get(start..)?.lines().next()?;
    let mut marks = line.match_indices('=').map(|(mark, _)| mark + 1);
    let typed = marks.find_map(|after| {
        let rest = line[after..].trim_start();
        let from = line.len() - rest.len();
        let is_quoted = line[..after].matches('"').count() % 2 == 1;
        let typed = number_with_comma(rest).filter(|_| !is_quoted)?;
        Some(from..from + typed.len())
    })?;
    let (whole, fraction) = line[typed.clone()].rsplit_once(',')?;
    let point = format!("{}.{fraction}", whole.replace(['.', ','], ""));
    let message = words().has_decimal_comma(&line[typed.clone()]);
    let fault = Diagnostic::new(message).at(start + typed.start..start + typed.end, "");
    Some(fault.help(words().decimals_have_a_point(&point)))
}

/// Returns the number with a decimal comma at the beginning of a text.
fn number_with_comma(text: &str) -> Option<&str> {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',');
    let end = text.find(|c| !is_of_number(c)).unwrap_or(text.len());
    let typed = text[..end].trim_end_matches([',', '.']);
    has_decimal_comma(typed).then_some(typed)
}

/// Returns `true` if a text has a comma between two digits, without a blank.
pub fn has_decimal_comma(text: &str) -> bool {
    text.as_bytes()
        .windows(3)
        .any(|bytes| matches!(bytes, [a, b',', c] if a.is_ascii_digit() && c.is_ascii_digit()))
}

/// Returns the first number of a list that has a decimal comma, with a point: `400.5` for
/// `[400,5, 0]`. `None` if the digits have several commas, so that their meaning is unclear.
pub fn first_with_point(list: &str) -> Option<String> {
    let is_of_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',');
    let mut numbers = list
        .split(|c| !is_of_number(c))
        .map(|n| n.trim_matches(','));
    let first = numbers.find(|number| has_decimal_comma(number))?;
    let is_clear = first.matches(',').count() == 1 && !first.contains('.');
    is_clear.then(|| first.replace(',', "."))
}

/// Returns the diagnostic of a duplicate key.
fn duplicate(text: &str, root: &DeTable<'_>, span: ByteSpan) -> Diagnostic {
    let key = text.get(span.clone()).unwrap_or("");
    let key = key.trim_matches(['"', '\'']);
    let mut first: Option<ByteSpan> = None;
    // The recovered table keeps the first key; the nearest one before is in the same table.
    each_key(root, &mut |other: &str, text_span| {
        let nearer = first.as_ref().is_none_or(|f| f.start < text_span.start);
        if other == key && text_span.start < span.start && nearer {
            first = Some(text_span);
        }
    });
    let fault = Diagnostic::new(words().given_twice(&quoted(key)))
        .at(span, words().the_second_time())
        .help(words().take_one_out());
    match first {
        Some(text_span) => fault.and(text_span, words().the_first_time()),
        None => fault,
    }
}

/// Visits every key of a table and of nested tables. The recursion is bounded by TOML's nesting
/// limit.
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
