//! Suggests fixes for common mistakes in the TOML syntax of a scene.

use super::numbers::numeral::number_length;
use crate::document::ByteSpan;
use crate::expression;
use crate::wording::words;

/// Returns the hint for a syntax error, from the parser's message and the text at the error; `None`
/// for an unfamiliar error.
pub fn fix(text: &str, message: &str, span: &ByteSpan) -> Option<String> {
    let words = words();
    let at = text.get(span.start..).unwrap_or("");
    let before = text.get(..span.start).unwrap_or("");
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[start..].lines().next().unwrap_or("").trim();
    if line.starts_with("//") {
        return Some(words.comments_begin_with().to_owned());
    }
    let starts_with = |prefixes: &[&str]| prefixes.iter().any(|prefix| message.starts_with(prefix));
    if starts_with(&["string values must be quoted"]) {
        let value = text.get(span.clone()).unwrap_or("");
        return Some(bare_value(value, line, is_angle(&text[start..span.start])));
    }
    if let Some(number) = number_before_quote(before, at) {
        return Some(match is_angle(&text[start..span.start]) {
            true => words.angle_alone(number),
            false => words.quote_after_number(number),
        });
    }
    if starts_with(&["missing opening quote"]) {
        let quote = if message.contains('"') { '"' } else { '\'' };
        return Some(words.quote_both_ends(quote));
    }
    let hint = if starts_with(&["invalid unquoted key"]) {
        match at.starts_with('\'') {
            true => words.quote_the_name(),
            false => words.names_are_made_of(),
        }
    } else if starts_with(&[
        "invalid fraction",
        "invalid mantissa",
        "invalid float",
        "invalid exponent",
        "unexpected leading zero",
        "redundant numeric sign",
        "`_` may only go between digits",
    ]) {
        words.numbers_such_as()
    } else if starts_with(&["missing assignment", "extra assignment"]) {
        words.one_equals_sign()
    } else if starts_with(&["key with no value", "unclosed table", "invalid key-value"]) {
        return Some(heading(line));
    } else if starts_with(&[
        "extra comma in inline table, expected `=`",
        "invalid literal string",
    ]) {
        words.lists_in_brackets()
    } else if starts_with(&["extra comma"]) {
        return Some(words.remove_mark(","));
    } else if starts_with(&["unexpected `=` in array"]) {
        words.tables_in_braces()
    } else if starts_with(&["missing comma"]) {
        match line.matches('"').count() % 2 {
            1 => return Some(words.quote_both_ends('"')),
            _ => words.commas_between(),
        }
    } else if starts_with(&["unexpected key or value"]) {
        return after_value(line, at);
    } else {
        return None;
    };
    Some(hint.to_owned())
}

/// Returns the hint for a line without a value: a heading with other marks, or a key.
fn heading(line: &str) -> String {
    let is_mark = |c: char| "[](){}<>: ".contains(c);
    let name = line.trim_matches(is_mark);
    if line.starts_with('[') {
        return words().names_are_made_of().to_owned();
    }
    let is_heading = line.len() > name.len() && !line.contains('=') && !name.contains(is_mark);
    match is_heading {
        true => words().write_heading(name),
        false => words().write_key_and_value().to_owned(),
    }
}

/// Returns the hint for a line in which something follows the value.
fn after_value(line: &str, at: &str) -> Option<String> {
    let words = words();
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    let rest = at.lines().next().unwrap_or("").trim();
    let mark = rest.chars().next()?;
    if rest.len() == mark.len_utf8() && !mark.is_alphanumeric() {
        let is_open = value.starts_with(['[', '{', '"', '\'']);
        if is_open || !value.contains(',') {
            return Some(words.remove_mark(rest));
        }
    }
    let is_number = value.starts_with(|c: char| c.is_ascii_digit() || "+-.(<".contains(c));
    Some(
        if value.contains('=') && !value.starts_with(['[', '{', '"']) {
            words.tables_in_braces().to_owned()
        } else if is_number && value.contains(',') {
            words.lists_in_brackets().to_owned()
        } else if value.starts_with('[') && expression::is_unit(rest) {
            words.unit_of_each(rest)
        } else {
            words.end_the_line().to_owned()
        },
    )
}

/// Returns the number in front of the quote at a position, or at the position in a list.
fn number_before_quote<'t>(before: &'t str, at: &'t str) -> Option<&'t str> {
    if at.starts_with('"') {
        return number_at_end(before);
    }
    // In a list, the parser reports the number itself.
    let (number, rest) = at.split_at(number_length(at));
    (!number.is_empty() && rest.starts_with('"')).then_some(number)
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
fn bare_value(value: &str, line: &str, is_angle: bool) -> String {
    let words = words();
    let value = value.trim();
    let (number, rest) = value.split_at(number_length(value));
    let as_typed = plain(value);
    if is_number(&as_typed) && is_digits(value, line) {
        return words.write_the_number(&as_typed);
    }
    if value.starts_with(CURLY_QUOTES) {
        return words.straight_quotes(value.trim_matches(CURLY_QUOTES));
    }
    let formula = as_typed.trim_end_matches(';');
    let tree = expression::parse(formula).ok();
    if formula.contains(';') {
        return words.separate_by_commas().to_owned();
    }
    if tree.is_none() && value.starts_with(['(', '<']) {
        return words.lists_in_brackets().to_owned();
    }
    if value.ends_with(';') && is_number(formula) {
        return words.write_the_number(formula);
    }
    if number_length(rest.trim_start()) > 0 {
        return words.separate_by_commas().to_owned();
    }
    let unit = rest.trim();
    if unit.starts_with(['\u{b0}', '\u{ba}', '\u{2da}']) {
        return words.angle_alone(number);
    }
    let is_measured = !number.is_empty()
        && expression::parse(&format!("{number} {unit}")).is_ok_and(|tree| tree.is_number());
    if is_measured || !number.is_empty() && unit == "rpm" {
        return words.quote_with_unit(number, unit);
    }
    match unit.chars().next() {
        Some(c) if c.is_alphabetic() && !number.is_empty() => match is_angle {
            true => words.angle_alone(number),
            false => words.number_alone_or_unit(number),
        },
        _ if tree.is_none() && !formula.contains(char::is_alphabetic) => {
            words.numbers_such_as().to_owned()
        }
        _ => words.quote_texts_and_names(formula),
    }
}

/// Opening and closing quotes that word processors write.
const CURLY_QUOTES: [char; 9] = [
    '\u{201c}', '\u{201d}', '\u{201e}', '\u{201f}', '\u{2018}', '\u{2019}', '\u{201a}', '\u{ab}',
    '\u{bb}',
];

/// Returns a text with the minus sign of the keyboard, and with digits for the letters O and l.
fn plain(value: &str) -> String {
    let has_digit = value.contains(|c: char| c.is_ascii_digit());
    let letters_to_digits = |c: char| match c {
        'O' | 'o' => '0',
        'l' | 'I' => '1',
        _ => c,
    };
    let value = value.replace(expression::DASHES, "-");
    let digits: String = value.chars().map(letters_to_digits).collect();
    match is_number(&digits) && (has_digit || value.len() == 1) {
        true => digits,
        false => value,
    }
}

fn is_number(text: &str) -> bool {
    !text.is_empty()
        && number_length(text) == text.len()
        && text.ends_with(|c: char| c.is_ascii_digit())
}

/// Returns `true` if a value contains a digit, or is one letter in a list with a number.
fn is_digits(value: &str, line: &str) -> bool {
    let has_digit = |text: &str| text.contains(|c: char| c.is_ascii_digit());
    let list = line.split_once('=').map_or("", |(_, list)| list.trim());
    has_digit(value) || list.starts_with('[') && has_digit(list)
}

#[cfg(test)]
mod tests {
    use crate::scene::{Scene, presets};

    /// Returns the faults of the four-bar with one line replaced: their count and first hint.
    fn faults(line: &str, new: &str) -> (usize, String) {
        let text = presets::find("four-bar").unwrap().text;
        assert!(text.contains(line));
        let faults = Scene::parse(&text.replacen(line, new, 1), "x").unwrap_err();
        let hint = faults.items[0].suggestions.first();
        (faults.items.len(), hint.cloned().unwrap_or_default())
    }

    #[test]
    fn slips_in_numbers_have_one_hint_with_the_fix() {
        for (value, fix) in [
            ("a + 10", "in quotes: \"a + 10\""),
            ("2*50", "in quotes: \"2*50\""),
            ("1OO", "the number: 100"),
            ("−100", "the number: -100"),
            ("100;", "the number: 100"),
            ("“100”", "keyboard: \"100\""),
            ("1’000", "such as 300"),
            (".300", "such as 300"),
            ("300.", "such as 300"),
            ("= 100", "write one ="),
            ("\"100", "write \" before and after"),
            ("15 mm\"", "write \" before and after"),
            ("100,", "remove `,`"),
            ("100, com = 0, 0", "a list in brackets"),
        ] {
            let (count, hint) = faults("length = 100", &format!("length = {value}"));
            assert_eq!(count, 1, "{value}");
            assert!(hint.contains(fix), "{value}: {hint}");
        }
    }

    #[test]
    fn slips_in_lists_have_one_hint_with_the_fix() {
        for (value, fix) in [
            ("[O, 0]", "the number: 0"),
            ("[–60, 0]", "the number: -60"),
            ("[0; 0]", "by commas"),
            ("0, 0", "a list in brackets"),
            ("(0, 0)", "a list in brackets"),
            ("[0, 0];", "remove `;`"),
            ("[0, 0", "add `]`"),
            ("[[0, 0]", "add `]`"),
            ("[0, 0}", "close it with `]`"),
            ("[0, 0] mm", "[\"0 mm\", \"0 mm\"]"),
            ("[\"0, 0]", "write \" before and after"),
            ("[0, 0], B = [1, 1]", "end the line"),
        ] {
            let (count, hint) = faults("A = [0, 0]", &format!("A = {value}"));
            assert_eq!(count, 1, "{value}");
            assert!(hint.contains(fix), "{value}: {hint}");
        }
    }

    #[test]
    fn slips_in_tables_and_headings_have_one_hint_with_the_fix() {
        let link = "r2 = { from = \"A\", to = \"B\", length = 100, com = [0, 0] }";
        for (line, new, fix) in [
            (link, "r2 = { from = \"A\", to = \"B\"", "add `}`"),
            (link, "r2 = { from = \"A\" to = \"B\" }", "by commas"),
            (link, "r2 = { from: \"A\", to: \"B\" }", "write one ="),
            (link, "r2 = ( from = \"A\" )", "a table in braces"),
            (
                link,
                "r2 = { from = \"A, to = \"B\" }",
                "write \" before and after",
            ),
            (link, "rö2 = {}", "ASCII letters"),
            ("[driver]", "[driver", "add `]`"),
            ("[driver]", "driver:", "in brackets: [driver]"),
            ("[driver]", "(driver)", "in brackets: [driver]"),
            ("[driver]", "[dri ver]", "ASCII letters"),
            ("[driver]", "[driver]:", "remove `:`"),
        ] {
            let (count, hint) = faults(line, new);
            assert_eq!(count, 1, "{new}");
            assert!(hint.contains(fix), "{new}: {hint}");
        }
    }
}
