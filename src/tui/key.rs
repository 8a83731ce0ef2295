//! Keys, as the table of actions names them.

use std::fmt;

/// A key, with the modifiers that matter.
///
/// Shift is part of a character and ignored elsewhere; a key with Alt is no key at all, since a
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
    /// Erases to the left.
    Backspace,
    /// An arrow key.
    Left,
    /// An arrow key.
    Right,
    /// An arrow key.
    Up,
    /// An arrow key.
    Down,
    /// Home.
    Home,
    /// End.
    End,
    /// A screen up.
    PageUp,
    /// A screen down.
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
