//! Translates the messages of the command-line parser and of the system, part by part.

use super::translations::{OF_PARSER, OF_SYSTEM};
use std::fmt::Display;

/// Translates a message of the command-line parser.
pub(super) fn translate_message(text: &str) -> String {
    OF_PARSER
        .iter()
        .fold(text.to_owned(), |text, (english, turkish)| {
            replaced(&text, english, turkish)
        })
}

/// Replaces every occurrence of a part in the text. If the parser has broken a line inside a part, the line break
/// moves before the part.
fn replaced(text: &str, part: &str, by: &str) -> String {
    let mut message = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((at, length)) = found(rest, part) {
        let there = &rest[at..at + length];
        message.push_str(&rest[..at]);
        match there.trim_end().find('\n') {
            None => message.push_str(by),
            Some(end) => {
                let after = &there[end..];
                let blanks = after.len() - after.trim_start().len();
                message.truncate(message.trim_end_matches(' ').len());
                message.push_str(&after[..blanks]);
                message.push_str(by);
            }
        }
        rest = &rest[at + length..];
    }
    message + rest
}

/// Returns the position of a part and its length there: a blank in it may match a line break and an indent.
fn found(text: &str, part: &str) -> Option<(usize, usize)> {
    let mut places = text.char_indices();
    places.find_map(|(at, _)| Some((at, length_of(&text[at..], part)?)))
}

/// Returns the length of the part at the start of the text, or `None` if the text starts differently.
fn length_of(text: &str, part: &str) -> Option<usize> {
    let mut rest = text;
    for (at, c) in part.char_indices() {
        rest = match rest.strip_prefix(c) {
            Some(after) => after,
            None if c == ' ' && !part[..at].trim().is_empty() => {
                rest.strip_prefix('\n')?.trim_start_matches(' ')
            }
            None => return None,
        };
    }
    Some(text.len() - rest.len())
}

/// Translates an error message of the system.
pub(super) fn of_system(why: &dyn Display) -> String {
    let why = why.to_string();
    let known = OF_SYSTEM
        .iter()
        .find(|(english, _)| why.starts_with(english));
    let Some((english, turkish)) = known else {
        return why;
    };
    let rest = &why[english.len()..];
    format!("{turkish}{}", rest.replace("(os error ", "(hata "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_is_translated_and_wrapped_parts_are_rejoined() {
        assert_eq!(
            translate_message(
                "  --language  Dil [default: auto] [possible\n      values: tr, en]\n"
            ),
            "  --language  Dil [yoksa: auto]\n      [değerler: tr, en]\n"
        );
        assert_eq!(
            translate_message("x\n\n  tip: ş is not in 1"),
            "x\n\n  ipucu: ş şu aralıkta değil: 1"
        );
        assert_eq!(translate_message("Print help\n"), "Yardımı yazın\n");
        assert_eq!(
            translate_message("Usage: x\n\nOptions:\n  -h"),
            "Kullanım: x\n\nSeçenekler:\n  -h"
        );
    }

    #[test]
    fn system_errors_are_translated_with_their_number() {
        let missing = std::io::Error::from_raw_os_error(2);
        assert_eq!(
            of_system(&missing),
            "böyle bir dosya ya da klasör yok (hata 2)"
        );
        assert_eq!(of_system(&"no matter"), "no matter");
    }
}
