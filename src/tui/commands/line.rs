//! A line that is typed.

use crate::document::{ascii_letter, is_harmful};
use crate::scene::with_point;
use crate::tui::commands::key::Key;

/// Longer than any number that means something.
const LONGEST_NUMBER: usize = 24;
/// Longer than any formula that is typed for a value.
const LONGEST_FORMULA: usize = 200;
/// The longest path that the system takes.
const LONGEST_NAME: usize = 4095;
/// Longer than what anybody types to find a name.
const LONGEST_SOUGHT: usize = 40;

/// More words than this nobody searches for.
const LONGEST_WORDS: usize = 60;

/// A line of text, edited at its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct EditLine {
    text: String,
    /// In bytes.
    longest: usize,
    takes: Takes,
}

/// What may be typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Takes {
    /// Characters of seven bits.
    Plain,
    /// The same, and for letters of Turkish those that they look like: what is searched is compared so.
    Words,
    /// Whatever can be seen: names of files have it.
    Any,
}

impl EditLine {
    /// An empty line for a number.
    pub(crate) fn for_number() -> EditLine {
        EditLine {
            text: String::new(),
            longest: LONGEST_NUMBER,
            takes: Takes::Plain,
        }
    }

    /// An empty line for a number or a formula.
    pub(crate) fn for_value() -> EditLine {
        EditLine {
            longest: LONGEST_FORMULA,
            ..EditLine::for_number()
        }
    }

    /// An empty line for words that are searched for.
    pub(crate) fn for_words() -> EditLine {
        EditLine {
            text: String::new(),
            longest: LONGEST_WORDS,
            takes: Takes::Words,
        }
    }

    /// A line for guesses, with those in it that hold.
    pub(crate) fn for_guess(guess: &str) -> EditLine {
        let mut line = EditLine::for_words();
        guess.chars().for_each(|c| line.push(c));
        line
    }

    /// A line for the name of a file, with a proposal in it.
    pub(crate) fn for_file(proposal: &str) -> EditLine {
        let mut line = EditLine {
            text: String::new(),
            longest: LONGEST_NAME,
            takes: Takes::Any,
        };
        proposal.chars().for_each(|c| line.push(c));
        line
    }

    /// An empty line for a name that is sought.
    pub(crate) fn for_search() -> EditLine {
        EditLine {
            text: String::new(),
            longest: LONGEST_SOUGHT,
            takes: Takes::Plain,
        }
    }

    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Appends a character; what is not printable or no longer fits is left out.
    pub(crate) fn push(&mut self, c: char) {
        let c = match self.takes {
            Takes::Words => ascii_letter(c).unwrap_or(c),
            Takes::Plain | Takes::Any => c,
        };
        let is_seen = match self.takes {
            Takes::Plain | Takes::Words => c == ' ' || c.is_ascii_graphic(),
            Takes::Any => !is_harmful(c),
        };
        if is_seen && self.text.len() + c.len_utf8() <= self.longest {
            self.text.push(c);
        }
    }

    /// Takes a key that edits the line; false for every other.
    pub(crate) fn edit(&mut self, key: Key) -> bool {
        match key {
            Key::Char(c) => self.push(c),
            Key::Backspace => {
                self.text.pop();
            }
            Key::Ctrl('u') => self.text.clear(),
            _ => return false,
        }
        true
    }

    pub(crate) fn clear(&mut self) {
        self.text.clear();
    }

    /// The number that was typed, its unit allowed behind it, a comma taken for the point where it can be
    /// nothing else.
    pub(crate) fn number(&self, unit: &str) -> Option<f64> {
        let text = self.text.trim();
        let text = text.strip_suffix(unit).unwrap_or(text).trim_end();
        let number: f64 = with_point(text)?.parse().ok()?;
        number.is_finite().then_some(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Option<f64> {
        let mut line = EditLine::for_number();
        text.chars().for_each(|c| line.push(c));
        line.number("deg")
    }

    #[test]
    fn numbers_are_read_as_people_type_them() {
        assert_eq!(number("60"), Some(60.0));
        assert_eq!(number(" -12,5 deg"), Some(-12.5));
        assert_eq!(number("1e2deg"), Some(100.0));
        for wrong in ["", "deg", "1 2", "nan", "inf", "1,2,3", "1,500", "60 mm"] {
            assert_eq!(number(wrong), None, "{wrong:?}");
        }
    }

    #[test]
    fn nothing_unprintable_gets_in_and_nothing_endless() {
        let mut line = EditLine::for_number();
        "\u{1b}1\u{e4}2\n".chars().for_each(|c| line.push(c));
        assert_eq!(line.text(), "12");
        (0..1000).for_each(|_| line.push('9'));
        assert_eq!(line.text().len(), LONGEST_NUMBER);
    }
}
