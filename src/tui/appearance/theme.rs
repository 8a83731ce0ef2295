//! The style of each part of the screen. Colours are names, one per hue, which the palette maps to
//! colours. A colour never carries a meaning alone.

use super::palette::INK;
use crate::drawing::{Hue, Role, is_bold};
use ratatui::style::{Color, Modifier, Style};

/// A part of the screen other than the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ScreenPart {
    /// Ordinary text.
    Text,
    /// The scene's title.
    Title,
    /// Names of columns, effects of keys, and lines.
    Quiet,
    /// The name of a row.
    Name,
    /// A key.
    Key,
    /// The mode, at the start of the status line.
    Mode,
    /// Unproved digits.
    UnprovedDigits,
    /// A warning.
    Warning,
    /// The caret behind typed text.
    Caret,
    /// The selected entry of a list or a table.
    Cursor,
}

/// Returns the style of a part of the screen.
pub(crate) fn part(part: ScreenPart) -> Style {
    let style = Style::new();
    match part {
        ScreenPart::Text => style,
        ScreenPart::Title | ScreenPart::Key => style.add_modifier(Modifier::BOLD),
        ScreenPart::Quiet | ScreenPart::UnprovedDigits => style.add_modifier(Modifier::DIM),
        ScreenPart::Name => style.add_modifier(Modifier::BOLD),
        ScreenPart::Mode | ScreenPart::Caret | ScreenPart::Cursor => {
            style.add_modifier(Modifier::REVERSED)
        }
        ScreenPart::Warning => style.fg(Color::Yellow).add_modifier(Modifier::BOLD),
    }
}

/// Returns the style of a part of the drawing.
pub(crate) fn role(role: Role) -> Style {
    // Highlighted parts have the style of the selected row.
    if role == Role::Lit {
        return part(ScreenPart::Key);
    }
    let style = match Hue::of(role) {
        // Pins and marks have the highest contrast.
        None if is_bold(role) => Style::new().fg(INK),
        None => Style::new(),
        Some(Hue::Grey) => Style::new().add_modifier(Modifier::DIM),
        // Faint if there is no colour for it, because a trace is as thin as a ghost and must not
        // look like a link.
        Some(Hue::Moss) => Style::new()
            .fg(Hue::Moss.named())
            .add_modifier(Modifier::DIM),
        Some(hue) => Style::new().fg(hue.named()),
    };
    match is_bold(role) {
        true => style.add_modifier(Modifier::BOLD),
        false => style,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Red is reserved for the driver.
    #[test]
    fn warnings_are_not_red() {
        assert_eq!(role(Role::Driver).fg, Some(Color::Red));
        assert_ne!(part(ScreenPart::Warning).fg, Some(Color::Red));
    }
}
