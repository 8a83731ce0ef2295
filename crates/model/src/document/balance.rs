//! Finds brackets and quotes that are not closed.

use super::diagnostic::Diagnostic;
use super::reader::ByteSpan;
use crate::wording::words;
use toml::de::Error;

/// The first bracket or quote of a text that has no partner.
#[derive(Debug, PartialEq)]
pub(super) struct Imbalance {
    at: usize,
    kind: ImbalanceKind,
}

#[derive(Debug, PartialEq)]
enum ImbalanceKind {
    /// A quote without a second one in its line.
    Quote(char),
    /// A bracket that is open at the end of the text.
    Open(char),
    /// A bracket closed by one of the other kind, at this position.
    Crossed(char, usize),
}

impl Imbalance {
    /// Returns the diagnostic if a syntax error is a consequence of this imbalance.
    pub(super) fn fault(&self, error: &Error, span: &ByteSpan) -> Option<Diagnostic> {
        let is_cause = match self.kind {
            // An apostrophe after a number, or in a name, opens no text.
            ImbalanceKind::Quote(_) => {
                let message = error.message();
                message.starts_with("invalid basic string")
                    || message.starts_with("invalid literal string")
            }
            ImbalanceKind::Open(_) => true,
            ImbalanceKind::Crossed(_, closed) => span.start >= closed,
        };
        (is_cause && self.at <= span.start).then(|| self.diagnostic())
    }

    fn diagnostic(&self) -> Diagnostic {
        let words = words();
        let (message, help, at) = match self.kind {
            ImbalanceKind::Quote(quote) => (
                words.text_is_not_closed(quote),
                words.quote_both_ends(quote),
                self.at,
            ),
            ImbalanceKind::Open(bracket) => (
                words.bracket_is_not_closed(bracket),
                words.add_bracket(closing(bracket)),
                self.at,
            ),
            ImbalanceKind::Crossed(bracket, at) => (
                words.bracket_is_not_closed(bracket),
                words.close_with(closing(bracket)),
                at,
            ),
        };
        Diagnostic::new(message).at(at..at + 1, "").help(help)
    }
}

fn closing(bracket: char) -> char {
    match bracket {
        '[' => ']',
        _ => '}',
    }
}

/// Returns the first bracket or quote without a partner. Texts over several lines, comments and
/// closing brackets without an opening one are skipped.
pub(super) fn imbalance(text: &str) -> Option<Imbalance> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let next = match c {
            '#' => rest.find('\n').unwrap_or(rest.len()),
            '"' | '\'' => match text_length(rest, c) {
                Some(length) => length,
                None => {
                    let kind = ImbalanceKind::Quote(c);
                    return Some(Imbalance { at, kind });
                }
            },
            _ => c.len_utf8(),
        };
        match (c, open.last()) {
            ('[' | '{', _) => open.push((at, c)),
            (']' | '}', Some(&(begin, bracket))) => {
                if closing(bracket) != c {
                    let kind = ImbalanceKind::Crossed(bracket, at);
                    return Some(Imbalance { at: begin, kind });
                }
                open.pop();
            }
            _ => {}
        }
        at += next;
    }
    // The innermost one: after it, all brackets are in pairs.
    let (at, bracket) = open.pop()?;
    let kind = ImbalanceKind::Open(bracket);
    Some(Imbalance { at, kind })
}

/// Returns the length of the quoted text at the beginning, with its quotes; `None` if it is not
/// closed.
fn text_length(text: &str, quote: char) -> Option<usize> {
    let triple = [quote; 3].iter().collect::<String>();
    if text.starts_with(&triple) {
        return text[3..].find(&triple).map(|end| end + 6);
    }
    let mut chars = text.char_indices().skip(1);
    while let Some((at, c)) = chars.next() {
        match c {
            '\n' => return None,
            '\\' if quote == '"' => {
                chars.next();
            }
            _ if c == quote => return Some(at + 1),
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str) -> Option<usize> {
        imbalance(text).map(|i| i.at)
    }

    #[test]
    fn balanced_text_has_no_imbalance() {
        for text in [
            "",
            "a = [1, {b = \"]\"}] # [",
            "a = \"\\\"[\"",
            "a = '\\'",
            "a = \"\"\"[\n\"\"\"",
            "]",
        ] {
            assert_eq!(at(text), None, "{text}");
        }
    }

    #[test]
    fn unclosed_bracket_or_quote_is_found() {
        assert_eq!(at("a = [1, 2\nb = [3]\n"), Some(4));
        assert_eq!(at("a = {b = 1\n[c]\n"), Some(4));
        assert_eq!(at("a = [1}\nb = [3]\n"), Some(4));
        assert_eq!(at("a = \"x\nb = \"y\"\n"), Some(4));
        assert_eq!(at("a = 'x"), Some(4));
        assert_eq!(at("a = \"x\\"), Some(4));
    }
}
