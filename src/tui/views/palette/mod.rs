//! Renders the list of all commands over the view: typing filters it, and Enter runs the selected
//! command.
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

/// Maximum size of the list in columns and rows, which does not change while it is filtered.
const COLUMNS: u16 = 42;
const ROWS: u16 = 14;

/// Returns the area of the popup.
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

/// Renders a command with its keys at the right, or a topic of the manual.
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

/// Returns the first visible row, such that the cursor is centred if possible.
fn first_seen(palette: &CommandList, height: usize) -> usize {
    let most = palette.count().saturating_sub(height);
    palette.cursor().saturating_sub(height / 2).min(most)
}

/// Returns the number of rows and the number of visible ones.
pub(super) fn extent(palette: &CommandList, area: Rect) -> (usize, usize) {
    (palette.count(), popup::within(placed(area)).height.into())
}
