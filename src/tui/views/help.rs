//! The help overlay: the table of actions, over the middle of the view.
//!
//! ```text
//! +- Help ------------------------+
//! | space        play or pause    |
//! ```

use super::table::UNSURE;
use super::{print, print_right};
use crate::capability::Colours;
use crate::drawing::Glyphs;
use crate::tui::action::{ACTIONS, Action, entry_of};
use crate::tui::app::App;
use crate::tui::sheet::FOUND;
use crate::tui::theme::{self, Part};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns of the keys, and of what they do.
const KEYS: u16 = 13;
const HELP: u16 = 23;
/// Border and blanks at both sides, and between two columns.
const BORDER: u16 = 4;
const GAP: u16 = 1;

pub(super) fn render(app: &App, scroll: usize, area: Rect, buffer: &mut Buffer) {
    let frame = placed(area);
    border(app.glyphs(), frame, buffer);
    let inner = within(frame);
    let (lines, seen) = extent(area);
    if scroll + seen < lines {
        let more = format!(" {} for more ", entry_of(Action::LineDown).keys[0]);
        let style = theme::part(Part::Quiet);
        print_right(buffer, frame.right() - 2, frame.bottom() - 1, &more, style);
    }
    let style = theme::part(Part::Quiet);
    let legend = legend(app.colours(), columns(area) > 1);
    print(
        buffer,
        frame.x + 2,
        frame.bottom() - 1,
        frame.width - 4,
        &legend,
        style,
    );
    for (x, column) in (inner.left()..)
        .step_by((KEYS + HELP + GAP).into())
        .zip(ACTIONS.chunks(lines))
    {
        for (y, entry) in (inner.top()..inner.bottom()).zip(column.iter().skip(scroll)) {
            print(buffer, x, y, KEYS, &entry.keys(), theme::part(Part::Key));
            print(
                buffer,
                x + KEYS,
                y,
                HELP,
                entry.help,
                theme::part(Part::Text),
            );
        }
    }
}

/// What the marks beside figures mean; of digits only where there is room.
fn legend(colours: Colours, wide: bool) -> String {
    let digits = match (wide, colours) {
        (false, _) => String::new(),
        (true, Colours::None) => format!("; {UNSURE} for digits that are not proved"),
        (true, _) => "; dim digits are not proved".into(),
    };
    format!(" {FOUND} found, rest given{digits} ")
}

/// Lines of the help, and how many are seen.
pub(super) fn extent(area: Rect) -> (usize, usize) {
    let lines = ACTIONS.len().div_ceil(columns(area).into());
    (lines, within(placed(area)).height.into())
}

/// Two columns where there is room.
fn columns(area: Rect) -> u16 {
    if area.width >= 2 * (KEYS + HELP) + GAP + BORDER {
        2
    } else {
        1
    }
}

/// The frame in the middle of `area`, as large as it needs to be.
fn placed(area: Rect) -> Rect {
    let count = columns(area);
    let width = (count * (KEYS + HELP) + (count - 1) * GAP + BORDER).min(area.width);
    let lines = ACTIONS.len().div_ceil(count.into());
    let lines = u16::try_from(lines).unwrap_or(u16::MAX);
    let height = lines.saturating_add(2).min(area.height);
    Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    }
}

fn within(frame: Rect) -> Rect {
    Rect {
        x: frame.x + 2,
        y: frame.y + 1,
        width: frame.width.saturating_sub(4),
        height: frame.height.saturating_sub(2),
    }
}

fn border(glyphs: Glyphs, frame: Rect, buffer: &mut Buffer) {
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
        buffer[position]
            .set_char(glyph)
            .set_style(theme::part(Part::Quiet));
    }
    let title = theme::part(Part::Title);
    print(buffer, frame.x + 2, frame.y, frame.width, " Help ", title);
}
