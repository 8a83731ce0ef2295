//! The list of all commands over the view: what is typed narrows it, and Enter does what the cursor is on.
//!
//! ```text
//! +- :zoom ---------------------------+
//! | > zoom in                       z |
//! |   zoom out                      Z |
//! ```

pub(crate) mod list;

use super::popup;
use super::{columns, cut, print, print_right};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action;
use crate::wording::words;
use list::{CommandList, Listed};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns and rows of the list, as far as there is room: they stay while it is narrowed.
const COLUMNS: u16 = 42;
const ROWS: u16 = 14;

/// Where the box is.
pub(super) fn placed(area: Rect) -> Rect {
    popup::centred(area, COLUMNS, ROWS)
}

pub(super) fn render(app: &App, palette: &CommandList, area: Rect, buffer: &mut Buffer) {
    let place = placed(area);
    let title = format!(":{}", palette.typed());
    let end = popup::frame(app.glyphs(), place, &title, buffer);
    if end > place.x && end < place.right() {
        print(
            buffer,
            end - 1,
            place.y,
            1,
            " ",
            theme::part(ScreenPart::Caret),
        );
    }
    let inner = popup::within(place);
    if palette.count() == 0 {
        let style = theme::part(ScreenPart::Text);
        print(
            buffer,
            inner.x,
            inner.y,
            inner.width,
            words().no_command_is_that(),
            style,
        );
        return;
    }
    let first = first_seen(palette, inner.height.into());
    let seen = palette.found().enumerate().skip(first);
    for (y, (at, row)) in (inner.top()..inner.bottom()).zip(seen) {
        let line = Rect {
            y,
            height: 1,
            ..inner
        };
        render_row(app, row, at == palette.cursor(), line, buffer);
    }
}

/// What a command does, and its keys at the right; or what a topic of the manual tells.
fn render_row(app: &App, listed: Listed, is_chosen: bool, line: Rect, buffer: &mut Buffer) {
    let (mark, part) = match is_chosen {
        true => ("> ", ScreenPart::Key),
        false => ("  ", ScreenPart::Text),
    };
    let x = print(buffer, line.x, line.y, line.width, mark, theme::part(part));
    let room = line.right().saturating_sub(x);
    let (told, keys) = match listed {
        Listed::Command(row) => {
            let keys = action::listed(app.keymap().keys(row.action));
            ((row.help)(words()).to_owned(), keys)
        }
        Listed::Topic(_, topic) => {
            let told = words().manual_of(topic.called(), (topic.about)(words()));
            (cut(&told, room.into()), String::new())
        }
    };
    let end = print(buffer, x, line.y, room, &told, theme::part(part));
    if end + 1 + columns(&keys) <= line.right() {
        let style = theme::part(ScreenPart::Quiet);
        print_right(buffer, line.right(), line.y, &keys, style);
    }
}

/// The cursor is seen, with rows above it where there are some.
fn first_seen(palette: &CommandList, height: usize) -> usize {
    let most = palette.count().saturating_sub(height);
    palette.cursor().saturating_sub(height / 2).min(most)
}

/// Lines of the list, and how many are seen.
pub(super) fn extent(palette: &CommandList, area: Rect) -> (usize, usize) {
    (palette.count(), popup::within(placed(area)).height.into())
}
