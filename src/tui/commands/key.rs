//! Keys, as named in the table of actions.

use std::fmt;
use std::str::FromStr;

/// A key with its relevant modifiers.
///
/// Shift is part of a character and ignored elsewhere. A key with Alt is not supported, since a
/// slow line turns Esc and the next key into one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Key {
    /// A printable character.
    Char(char),
    /// A character with the control key, in lower case.
    Ctrl(char),
    /// A function key, from 1.
    Function(u8),
    /// Enter.
    Enter,
    /// Escape.
    Escape,
    /// The tabulator.
    Tab,
    /// Shift and the tabulator.
    BackTab,
    /// Backspace.
    Backspace,
    /// The left arrow key.
    Left,
    /// The right arrow key.
    Right,
    /// The up arrow key.
    Up,
    /// The down arrow key.
    Down,
    /// Home.
    Home,
    /// End.
    End,
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self {
            Key::Char(' ') => "space",
            Key::Char(c) => return write!(f, "{c}"),
            Key::Ctrl(c) => return write!(f, "Ctrl-{}", c.to_ascii_uppercase()),
            Key::Function(n) => return write!(f, "F{n}"),
            Key::Enter => "Enter",
            Key::Escape => "Esc",
            Key::Tab => "Tab",
            Key::BackTab => "Shift-Tab",
            Key::Backspace => "Backspace",
            Key::Left => "Left",
            Key::Right => "Right",
            Key::Up => "Up",
            Key::Down => "Down",
            Key::Home => "Home",
            Key::End => "End",
            Key::PageUp => "PgUp",
            Key::PageDown => "PgDn",
        };
        f.write_str(name)
    }
}

/// The error of a text that names no key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoKey;

impl FromStr for Key {
    type Err = NoKey;

    /// Parses a key in its displayed form.
    fn from_str(text: &str) -> Result<Self, NoKey> {
        let mut chars = text.chars();
        if let (Some(c @ ' '..='~'), None) = (chars.next(), chars.next()) {
            return Ok(Key::Char(c));
        }
        let named = named().find(|key| key.to_string() == text);
        named.ok_or(NoKey)
    }
}

impl Key {
    /// Returns the key that terminals send in its place, because they cannot distinguish the two.
    pub(crate) fn sent_as(self) -> Option<Key> {
        match self {
            Key::Ctrl('h') => Some(Key::Backspace),
            Key::Ctrl('i') => Some(Key::Tab),
            Key::Ctrl('j' | 'm') => Some(Key::Enter),
            _ => None,
        }
    }
}

/// Returns all keys that are not characters.
fn named() -> impl Iterator<Item = Key> {
    let functions = (1..=24).map(Key::Function);
    let controls = ('a'..='z').map(Key::Ctrl);
    NAMED.into_iter().chain(functions).chain(controls)
}

/// Returns the names of all keys that are not characters.
pub(crate) fn names() -> Vec<String> {
    named().map(|key| key.to_string()).collect()
}

/// The keys with names of their own.
const NAMED: [Key; 14] = [
    Key::Char(' '),
    Key::Enter,
    Key::Escape,
    Key::Tab,
    Key::BackTab,
    Key::Backspace,
    Key::Left,
    Key::Right,
    Key::Up,
    Key::Down,
    Key::Home,
    Key::End,
    Key::PageUp,
    Key::PageDown,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_round_trip_through_text() {
        let others = [Key::Char('?'), Key::Ctrl('c'), Key::Function(1)];
        for key in NAMED.into_iter().chain(others) {
            assert_eq!(key.to_string().parse(), Ok(key));
        }
        for text in [
            "nothing", "", "F0", "F25", "Ctrl-", "Ctrl-1", "\u{e4}", "\t",
        ] {
            assert_eq!(text.parse::<Key>(), Err(NoKey), "{text:?}");
        }
    }
}
