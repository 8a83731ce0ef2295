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
use super::{columns, cut, first_row, print, print_line, print_right};
use crate::manual::TOPICS;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{self, entry_of};
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
    let title = format!(":{}", palette.line.text());
    let end = popup::frame(app.glyphs(), place, &title, buffer);
    if end > place.x && end < place.right() {
        let style = theme::part(ScreenPart::Caret);
        print(buffer, end - 1, place.y, 1, " ", style);
    }
    let inner = popup::within(place);
    let (count, _) = palette.list.count();
    if count == 0 {
        let text = words().no_command_is_that();
        print_line(buffer, inner, text, ScreenPart::Text);
        return;
    }
    let first = first_row(palette.list.cursor(), count, inner.height.into());
    let seen = palette.list.listed().enumerate().skip(first);
    for (line, (at, listed)) in inner.rows().zip(seen) {
        render_row(app, *listed, at == palette.list.cursor(), line, buffer);
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
        Listed::Command(action) => {
            let keys = action::listed(app.keymap().keys(action));
            ((entry_of(action).help)(words()).to_owned(), keys)
        }
        Listed::Topic(at) => {
            let topic = &TOPICS[at];
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

/// Returns the number of rows and the number of visible ones.
pub(super) fn extent(palette: &CommandList, area: Rect) -> (usize, usize) {
    let rows = popup::within(placed(area)).height;
    (palette.list.count().0, rows.into())
}
