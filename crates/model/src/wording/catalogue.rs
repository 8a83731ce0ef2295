//! Reads the messages of a language. `english.txt` describes their form.

use std::collections::BTreeSet;

/// A message of a language.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Message {
    pub(crate) name: String,
    /// The names and types of the arguments; `None` for a fixed text.
    pub(crate) arguments: Option<Vec<(String, String)>>,
    /// The text with its arguments in braces; `None` if a function writes it.
    pub(crate) text: Option<String>,
}

/// Reads the messages in a text.
///
/// # Errors
/// Returns the first error with its line.
pub(crate) fn messages(text: &str) -> Result<Vec<Message>, String> {
    let mut names = BTreeSet::new();
    let mut found = Vec::new();
    let mut lines = text.lines().enumerate().peekable();
    while let Some((number, line)) = lines.next() {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let fault = |what: &str| format!("line {}: {what}: {line}", number + 1);
        let (head, start) = match line.split_once(" =") {
            Some((head, text)) => (head, Some(text.strip_prefix(' ').unwrap_or(text))),
            None => (line, None),
        };
        let mut text = start.map(str::to_owned);
        while let Some((_, more)) = lines.next_if(|(_, line)| line.starts_with("    ")) {
            let text = text
                .as_mut()
                .ok_or_else(|| fault("no `=` before the text"))?;
            *text += if text.ends_with("\\n") { "" } else { " " };
            *text += &more[4..];
        }
        let (name, arguments) = match head.split_once('(') {
            None => (head, None),
            Some((name, rest)) => {
                let list = rest.strip_suffix(')').ok_or_else(|| fault("no `)`"))?;
                (name, Some(arguments(list)))
            }
        };
        let is_name = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        if name.is_empty() || !name.chars().all(is_name) {
            return Err(fault("not a name"));
        }
        if !names.insert(name) {
            return Err(fault("a second message of this name"));
        }
        found.push(Message {
            name: name.to_owned(),
            arguments,
            text: text.map(|text| unescaped(&text)),
        });
    }
    Ok(found)
}

/// A table of texts, each with its translation.
pub(crate) type Translations = Vec<(String, String)>;

/// Reads the tables of translations in a text, with their names.
///
/// # Errors
/// Returns the first line that is no pair of a table.
pub(crate) fn translations(text: &str) -> Result<Vec<(&str, Translations)>, String> {
    let mut tables: Vec<(&str, Translations)> = Vec::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("## ") {
            tables.push((name, Vec::new()));
        } else if !line.is_empty() && !line.starts_with('#') {
            let translation = lines.next().and_then(|line| line.strip_prefix("    "));
            let (Some((_, table)), Some(translation)) = (tables.last_mut(), translation) else {
                return Err(format!("no translation in a table: {line}"));
            };
            table.push((unescaped(line), unescaped(translation)));
        }
    }
    Ok(tables)
}

/// Splits a list of arguments at commas outside brackets.
fn arguments(list: &str) -> Vec<(String, String)> {
    let mut depth = 0;
    let parts = list.split(|c: char| {
        depth += i32::from("[(<".contains(c)) - i32::from("])>".contains(c));
        c == ',' && depth == 0
    });
    let argument = |part: &str| {
        let (name, kind) = part.split_once(':').unwrap_or((part, "&str"));
        (name.trim().to_owned(), kind.trim().to_owned())
    };
    parts.map(argument).collect()
}

/// Returns the text without quotes around it, with line breaks and backslashes.
fn unescaped(text: &str) -> String {
    let quoted = text
        .strip_prefix('"')
        .and_then(|text| text.strip_suffix('"'));
    let mut rest = quoted.unwrap_or(text);
    let mut plain = String::new();
    while let Some((before, after)) = rest.split_once('\\') {
        plain.push_str(before);
        let mut letters = after.chars();
        plain.push(match letters.next() {
            Some('n') => '\n',
            letter => letter.unwrap_or('\\'),
        });
        rest = letters.as_str();
    }
    plain + rest
}
