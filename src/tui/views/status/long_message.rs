//! Shows a message that is too long for the status line in as many lines as it needs above that
//! line. It covers the verdict first, stays until the next key, and never covers a prompt.
//!
//! ```text
//!  r3 length = 2 * b: there is no parameter `b`; parameters: a, rod, stroke,
//!  width
//!  edit  r3 length [mm, cm, m, in]   Enter take  Esc cancel
//! ```

use crate::page::{truncate_lines, wrapped};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::tui::views::print;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Clear, Widget};

/// Blanks before and behind the lines.
const INDENT: u16 = 1;

/// The lines of a message above the status line, and their area.
pub(in crate::tui::views) struct MessageLines {
    lines: Vec<String>,
    pub(in crate::tui::views) place: Rect,
}

impl MessageLines {
    /// Arranges a message on a screen, whose first line stays visible.
    pub(super) fn of(message: &str, app: &App, screen: Rect) -> MessageLines {
        let width = usize::from(screen.width.saturating_sub(2 * INDENT)).max(1);
        let mut lines = broken(&shown(message, app.glyphs()), width);
        let maximum = usize::from(screen.height.saturating_sub(2));
        truncate_lines(&mut lines, maximum, width);
        let height = u16::try_from(lines.len()).unwrap_or(u16::MAX);
        let area = Rect {
            y: screen.bottom().saturating_sub(1 + height),
            height,
            ..screen
        };
        MessageLines { lines, place: area }
    }

    pub(in crate::tui::views) fn render(&self, buffer: &mut Buffer) {
        Clear.render(self.place, buffer);
        for (y, line) in (self.place.top()..).zip(&self.lines) {
            let (x, space) = (self.place.x + INDENT, self.place.width - INDENT);
            print(buffer, x, y, space, line, theme::part(ScreenPart::Warning));
        }
    }
}

/// Wraps a text; a word longer than a line, such as a path, is split.
pub(in crate::tui::views) fn broken(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for line in wrapped(text, width) {
        let all: Vec<char> = line.chars().collect();
        lines.extend(all.chunks(width.max(1)).map(String::from_iter));
    }
    lines
}
