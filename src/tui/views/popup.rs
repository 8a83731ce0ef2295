//! Popups over the view.

use super::print;
use crate::drawing::Glyphs;
use crate::tui::appearance::theme::{self, ScreenPart};
use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use ratatui::symbols::border::{self, Set};
use ratatui::widgets::{Block, Clear, Widget};

/// Columns and rows taken by the border: a line and a blank on both sides, a line above and below.
pub(super) const BORDER: (u16, u16) = (4, 2);

/// Returns the frame of a popup with `columns` by `rows` of content, centred in `area` and cut to
/// it.
pub(super) fn centred(area: Rect, columns: u16, rows: u16) -> Rect {
    let width = columns.saturating_add(BORDER.0).min(area.width);
    let height = rows.saturating_add(BORDER.1).min(area.height);
    Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    }
}

/// Returns the area inside the border.
pub(super) fn within(frame: Rect) -> Rect {
    frame.inner(Margin::new(BORDER.0 / 2, BORDER.1 / 2))
}

/// Border characters in 7-bit ASCII.
const ASCII: Set<'static> = Set {
    top_left: "+",
    top_right: "+",
    bottom_left: "+",
    bottom_right: "+",
    vertical_left: "|",
    vertical_right: "|",
    horizontal_top: "-",
    horizontal_bottom: "-",
};

/// Clears the frame and draws its border with the title. Returns the column after the title.
pub(super) fn frame(glyphs: Glyphs, frame: Rect, title: &str, buffer: &mut Buffer) -> u16 {
    let lines = match glyphs {
        Glyphs::Ascii => ASCII,
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => border::PLAIN,
    };
    Clear.render(frame, buffer);
    Block::bordered().border_set(lines).render(frame, buffer);
    let (style, title) = (theme::part(ScreenPart::Title), format!(" {title} "));
    let space = frame.width.saturating_sub(BORDER.0);
    print(buffer, frame.x + 2, frame.y, space, &title, style)
}
