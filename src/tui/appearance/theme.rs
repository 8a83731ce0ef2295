//! What each part of the screen looks like. Colours are names that the palette makes something of, one for
//! each hue. None carries a meaning alone.

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
        ScreenPart::Warning => style.fg(Color::Yellow).add_modifier(Modifier::BOLD),
    }
}

/// The hues of links, by their numbers: no neighbour of another is like it, and none like the driver's.
const LINKS: [Color; 5] = [
    Color::Blue,
    Color::Green,
    Color::LightBlue,
    Color::LightRed,
    Color::LightCyan,
];

/// The look of a part of the drawing.
pub(crate) fn role(role: Role) -> Style {
    let style = Style::new();
    match role {
        Role::Empty | Role::Guide | Role::Label | Role::Datum => style,
        Role::Link(hue) | Role::Plate(hue) => style.fg(LINKS[usize::from(hue) % LINKS.len()]),
        Role::Ground | Role::Ghost | Role::Echo | Role::Axis => style.add_modifier(Modifier::DIM),
        // Faint where there is no colour for it: a trace is as thin as a ghost, and no bar.
        Role::Trace => style.fg(Color::LightGreen).add_modifier(Modifier::DIM),
        Role::Driver | Role::Second => style.fg(Color::Red),
        Role::Velocity => style.fg(Color::Cyan).add_modifier(Modifier::BOLD),
        Role::Acceleration => style.fg(Color::Magenta),
        Role::Spring => style.fg(Color::Yellow),
        Role::Joint | Role::GroundPin | Role::Slider | Role::Front => {
            style.add_modifier(Modifier::BOLD)
        }
        Role::Rider | Role::CentreOfMass => style.add_modifier(Modifier::BOLD),
        Role::Third => style.fg(Color::Magenta),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::LINK_HUES;

    /// Links differ from each other and from the driver, arrows and traces from each other, and a notice is
    /// never red.
    #[test]
    fn roles_have_hues_of_their_own() {
        assert_eq!(usize::from(LINK_HUES), LINKS.len());
        let hue = |r: Role| role(r).fg;
        let mut links: Vec<_> = (0..LINK_HUES).map(|k| hue(Role::Link(k))).collect();
        links.push(hue(Role::Driver));
        let others = [Role::Velocity, Role::Acceleration, Role::Trace, Role::Ghost].map(hue);
        for set in [&links[..], &others[..]] {
            for (k, one) in set.iter().enumerate() {
                assert!(!set[k + 1..].contains(one), "{one:?}");
            }
        }
        assert!(links.iter().all(|link| !others.contains(link)));
        assert_ne!(part(ScreenPart::Warning).fg, Some(Color::Red));
    }
}
