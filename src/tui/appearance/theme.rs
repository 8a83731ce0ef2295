//! What each part of the screen looks like. Colours are names of the terminal's own palette, and only
//! the two that most palettes keep legible on dark and on light ground: red and magenta. None carries a
//! meaning alone.

use crate::drawing::Role;
use ratatui::style::{Color, Modifier, Style};

/// Parts of the screen beside the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ScreenPart {
    /// Ordinary text.
    Text,
    /// The scene's title.
    Title,
    /// Names of columns and of keys' purposes; rules.
    Quiet,
    /// The name of a row.
    Name,
    /// A key.
    Key,
    /// The mode, at the start of the last line.
    Mode,
    /// Digits that nothing proves.
    Unsure,
    /// Something that the reader should know.
    Warning,
    /// Where typed text goes on.
    Caret,
    /// What the cursor of a list or a table is on.
    Cursor,
}

/// The look of a part of the screen.
pub(crate) fn part(part: ScreenPart) -> Style {
    let style = Style::new();
    match part {
        ScreenPart::Text => style,
        ScreenPart::Title | ScreenPart::Key => style.add_modifier(Modifier::BOLD),
        ScreenPart::Quiet | ScreenPart::Unsure => style.add_modifier(Modifier::DIM),
        ScreenPart::Name => style.add_modifier(Modifier::BOLD),
        ScreenPart::Mode | ScreenPart::Caret | ScreenPart::Cursor => {
            style.add_modifier(Modifier::REVERSED)
        }
        ScreenPart::Warning => style.fg(Color::Red).add_modifier(Modifier::BOLD),
    }
}

/// The look of a part of the drawing.
pub(crate) fn role(role: Role) -> Style {
    let style = Style::new();
    match role {
        Role::Empty | Role::Link | Role::Guide | Role::Label | Role::Datum => style,
        Role::Ground | Role::Ghost | Role::Echo | Role::Trace | Role::Axis => {
            style.add_modifier(Modifier::DIM)
        }
        Role::Driver | Role::Second => style.fg(Color::Red),
        Role::Velocity => style.add_modifier(Modifier::BOLD),
        Role::Acceleration => style.fg(Color::Red),
        Role::Joint | Role::GroundPin | Role::Slider | Role::Front => {
            style.add_modifier(Modifier::BOLD)
        }
        Role::Rider | Role::CentreOfMass | Role::Third => style.fg(Color::Magenta),
    }
}
