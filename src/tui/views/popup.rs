//! A box over the view.

use super::print;
use crate::drawing::Glyphs;
use crate::tui::appearance::theme::{self, Part};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns and rows that the border takes: a line and a blank at both sides, a line above and below.
pub(super) const BORDER: (u16, u16) = (4, 2);

/// A box around so many columns and rows in the middle of `area`, as large as there is room.
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

/// What is within a box.
pub(super) fn within(frame: Rect) -> Rect {
    Rect {
        x: frame.x + BORDER.0 / 2,
        y: frame.y + BORDER.1 / 2,
        width: frame.width.saturating_sub(BORDER.0),
        height: frame.height.saturating_sub(BORDER.1),
    }
}

/// Clears a box and draws its border with a title. Says where the title ends.
pub(super) fn frame(glyphs: Glyphs, frame: Rect, title: &str, buffer: &mut Buffer) -> u16 {
    let [level, upright, corners @ ..] = match glyphs {
        Glyphs::Ascii => ['-', '|', '+', '+', '+', '+'],
        Glyphs::Line | Glyphs::Braille => [
            '\u{2500}', '\u{2502}', '\u{250c}', '\u{2510}', '\u{2514}', '\u{2518}',
        ],
    };
    let (right, bottom) = (frame.right() - 1, frame.bottom() - 1);
    for position in frame.positions() {
        let at_side = position.x == frame.x || position.x == right;
        let at_end = position.y == frame.y || position.y == bottom;
        let glyph = match (at_side, at_end) {
            (true, true) => {
                let corner =
                    usize::from(position.x == right) + 2 * usize::from(position.y == bottom);
                corners[corner]
            }
            (true, false) => upright,
            (false, true) => level,
            (false, false) => ' ',
        };
        buffer[position].reset();
        buffer[position].set_char(glyph);
    }
    let style = theme::part(Part::Title);
    let room = frame.width.saturating_sub(BORDER.0);
    print(
        buffer,
        frame.x + 2,
        frame.y,
        room,
        &format!(" {title} "),
        style,
    )
}
