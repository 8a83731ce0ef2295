//! An input line.

use crate::document::{ascii_letter, is_harmful};
use crate::expression;
use crate::scene::with_point;
use crate::tui::commands::key::Key;
use crate::wording::words;

/// Maximum length of a number, in bytes; longer ones have no meaning.
const MAX_NUMBER_LEN: usize = 24;
/// Maximum length of the name of a link or a slide.
const MAX_NAME_OF_ELEMENT: usize = 64;
/// Maximum length of goals and guesses, in bytes.
const MAX_GOAL_LEN: usize = 4000;
/// Maximum length of a path, which is the system's limit.
const MAX_NAME_LEN: usize = 4095;
/// Maximum length of a name to search for, in bytes.
const MAX_SEARCH_TEXT: usize = 40;

/// Maximum length of searched words, in bytes.
const MAX_WORDS_LEN: usize = 60;

/// A line of text, edited at its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct EditLine {
    text: String,
    /// Maximum length in bytes.
    longest: usize,
    takes: AcceptedCharacters,
    /// `true` if the text is a proposal, which the first typed character replaces.
    is_proposal: bool,
    /// The first reason for a rejected character since the last report.
    rejection: Option<RefusedKey>,
}

/// The reason why a character is rejected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum RefusedKey {
    /// The line does not accept such characters.
    Character(char),
    /// The line has this maximum length.
    Length(usize),
}

/// The characters that a line accepts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AcceptedCharacters {
    /// ASCII characters.
    Plain,
    /// ASCII characters; Turkish letters are replaced by similar ones, as in the searched texts.
    Words,
    /// All printable characters, as in file names.
    Any,
}

impl EditLine {
    /// Creates an empty line for a number.
    pub(crate) fn for_number() -> EditLine {
        EditLine {
            text: String::new(),
            longest: MAX_NUMBER_LEN,
            takes: AcceptedCharacters::Plain,
            is_proposal: false,
            rejection: None,
        }
    }

    /// Creates an empty line for a coordinate, which may follow the name of an input.
    pub(crate) fn for_coordinate() -> EditLine {
        EditLine {
            longest: MAX_NAME_OF_ELEMENT + 1 + MAX_NUMBER_LEN,
            ..EditLine::for_number()
        }
    }

    /// Creates an empty line for a number or a formula.
    pub(crate) fn for_value() -> EditLine {
        EditLine {
            longest: expression::MAX_LEN,
            ..EditLine::for_number()
        }
    }

    /// Creates an empty line for words to search for.
    pub(crate) fn for_words() -> EditLine {
        EditLine {
            longest: MAX_WORDS_LEN,
            takes: AcceptedCharacters::Words,
            ..EditLine::for_number()
        }
    }

    /// Creates a line for goals and the values to be varied, with the text typed before.
    pub(crate) fn for_goal(typed: &str) -> EditLine {
        let mut line = EditLine {
            longest: MAX_GOAL_LEN,
            ..EditLine::for_number()
        };
        typed.chars().for_each(|c| line.push(c));
        line
    }

    /// Creates a line for guesses, with the current ones.
    pub(crate) fn for_guess(guess: &str) -> EditLine {
        EditLine::for_goal(guess)
    }

    /// Creates a line for a file name, with a proposal.
    pub(crate) fn for_file(proposal: &str) -> EditLine {
        let mut line = EditLine::for_command();
        proposal.chars().for_each(|c| line.push(c));
        line.is_proposal = true;
        line
    }

    /// Creates an empty line for a command, which may contain a file name.
    pub(crate) fn for_command() -> EditLine {
        EditLine {
            longest: MAX_NAME_LEN,
            takes: AcceptedCharacters::Any,
            ..EditLine::for_number()
        }
    }

    /// Creates an empty line for the name or title of a scene.
    pub(crate) fn for_scene() -> EditLine {
        EditLine {
            takes: AcceptedCharacters::Any,
            ..EditLine::for_search()
        }
    }

    /// Creates an empty line for a name to search for.
    pub(crate) fn for_search() -> EditLine {
        EditLine {
            longest: MAX_SEARCH_TEXT,
            ..EditLine::for_number()
        }
    }

    pub(crate) fn text(&self) -> &str {
        &self.text
    }

    /// Appends a character. A rejected or excess character is left out and recorded; control
    /// characters are left out silently.
    pub(crate) fn push(&mut self, c: char) {
        let c = match self.takes {
            AcceptedCharacters::Words => ascii_letter(c).unwrap_or_else(|| ascii_sign(c)),
            AcceptedCharacters::Plain => ascii_sign(c),
            AcceptedCharacters::Any => c,
        };
        if is_harmful(c) {
            return;
        }
        let is_taken = match self.takes {
            AcceptedCharacters::Plain | AcceptedCharacters::Words => {
                c == ' ' || c.is_ascii_graphic()
            }
            AcceptedCharacters::Any => true,
        };
        if !is_taken {
            self.refuse(RefusedKey::Character(c));
        } else if self.text.len() + c.len_utf8() > self.longest {
            self.refuse(RefusedKey::Length(self.longest));
        } else {
            self.text.push(c);
        }
    }

    /// Records a reason for a rejection; the first one is kept.
    fn refuse(&mut self, why: RefusedKey) {
        self.rejection.get_or_insert(why);
    }

    /// Takes the recorded reason for a rejection, in words.
    pub(crate) fn take_refusal(&mut self) -> Option<String> {
        self.rejection.take().map(|why| match why {
            RefusedKey::Character(c) => words().character_not_taken(c),
            RefusedKey::Length(maximum) => words().no_more_characters(maximum),
        })
    }

    /// Returns `true` if the text is a proposal, which the first typed character replaces.
    pub(crate) fn is_proposal(&self) -> bool {
        self.is_proposal
    }

    /// Handles a key that edits the line; returns `false` for all others. The arrow to the right
    /// keeps a proposal, so that more can be typed behind it.
    pub(crate) fn edit(&mut self, key: Key) -> bool {
        let is_proposal = std::mem::take(&mut self.is_proposal);
        if is_proposal && matches!(key, Key::Char(_)) {
            self.text.clear();
        }
        match key {
            Key::Right | Key::End if is_proposal => {}
            Key::Char(c) => self.push(c),
            Key::Backspace => {
                self.text.pop();
            }
            Key::Ctrl('u') => self.text.clear(),
            _ => return false,
        }
        true
    }

    /// Handles a key that edits the line and returns whether the text changed; `None` for all other
    /// keys.
    pub(crate) fn change(&mut self, key: Key) -> Option<bool> {
        let before = self.text.clone();
        self.edit(key).then(|| self.text != before)
    }

    pub(crate) fn clear(&mut self) {
        self.text.clear();
    }
}

/// Parses a typed number. Its unit may follow, and a comma is a decimal point if it can be nothing
/// else.
pub(crate) fn number_of(typed: &str, unit: &str) -> Option<f64> {
    let text = typed.trim();
    let text = text.strip_suffix(unit).unwrap_or(text).trim_end();
    let number: f64 = with_point(text)?.parse().ok()?;
    number.is_finite().then_some(number)
}

/// Replaces arithmetic signs by those of formulas, and every blank by a plain one, because numbers
/// pasted from text often contain them.
fn ascii_sign(c: char) -> char {
    match c {
        '\u{2212}' | '\u{2013}' => '-',
        '\u{d7}' | '\u{22c5}' | '\u{b7}' => '*',
        '\u{f7}' => '/',
        c if c.is_whitespace() => ' ',
        c => c,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Option<f64> {
        let mut line = EditLine::for_number();
        text.chars().for_each(|c| line.push(c));
        number_of(line.text(), "deg")
    }

    #[test]
    fn number_input_accepts_decimal_comma_and_unit() {
        assert_eq!(number("60"), Some(60.0));
        assert_eq!(number(" -12,5 deg"), Some(-12.5));
        assert_eq!(number("1e2deg"), Some(100.0));
        for wrong in ["", "deg", "1 2", "nan", "inf", "1,2,3", "1,500", "60 mm"] {
            assert_eq!(number(wrong), None, "{wrong:?}");
        }
    }

    #[test]
    fn input_rejects_invalid_and_excess_characters() {
        let mut line = EditLine::for_number();
        "\u{1b}1\u{e4}2\u{fc}".chars().for_each(|c| line.push(c));
        assert_eq!(line.text(), "12");
        let text = line.take_refusal();
        assert_eq!(text.as_deref(), Some("\u{e4} (U+00E4) is not valid here"));
        assert_eq!(line.take_refusal(), None);
        (0..1000).for_each(|_| line.push('9'));
        assert_eq!(line.text().len(), MAX_NUMBER_LEN);
        let text = line.take_refusal();
        assert_eq!(
            text.as_deref(),
            Some("at most 24 characters are allowed here")
        );
    }

    /// Regression: typographic minus signs were dropped, which left the number without its sign.
    #[test]
    fn typographic_operators_become_ascii() {
        assert_eq!(number("\u{2212}5"), Some(-5.0));
        assert_eq!(number("\u{2013}5\u{a0}deg\n"), Some(-5.0));
        let mut line = EditLine::for_value();
        "5\u{d7}2 \u{f7} a".chars().for_each(|c| line.push(c));
        assert_eq!(line.text(), "5*2 / a");
        assert_eq!(line.take_refusal(), None);
    }

    #[test]
    fn goals_and_formulas_accept_maximum_length() {
        for (mut line, maximum) in [
            (EditLine::for_goal(""), 1000),
            (EditLine::for_guess(""), 1000),
            (EditLine::for_value(), expression::MAX_LEN),
        ] {
            (0..maximum).for_each(|_| line.push('1'));
            assert_eq!(line.text().len(), maximum);
            assert_eq!(line.take_refusal(), None);
        }
    }
}
