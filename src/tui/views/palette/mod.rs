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
use crate::scene::presets;
use crate::task_file::ExampleTask;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{self, entry_of};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use list::{CommandList, ListEntry};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Maximum size of the list in columns and rows, which does not change while it is filtered.
const COLUMNS: u16 = 42;
const ROWS: u16 = 14;
/// The mark of the selected entry.
const MARK: &str = "> ";

/// Returns the area of the popup.
pub(super) fn placed(area: Rect) -> Rect {
    popup::centred(area, COLUMNS, ROWS)
}

pub(super) fn render(app: &App, palette: &CommandList, area: Rect, buffer: &mut Buffer) {
    let place = placed(area);
    let title = format!(":{}", shown(palette.line.text(), app.glyphs()));
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
        let (mut shown_text, mut keys) = (describe_entry(*listed, palette), String::new());
        if let ListEntry::Command(action) = listed {
            keys = action::listed(app.keymap().keys(*action));
        } else {
            let space = usize::from(line.width).saturating_sub(MARK.len());
            shown_text = cut(&shown(&shown_text, app.glyphs()), space);
        }
        render_row(
            (&shown_text, &keys),
            at == palette.list.cursor(),
            line,
            buffer,
        );
    }
}

/// Describes an entry.
fn describe_entry(listed: ListEntry, palette: &CommandList) -> String {
    match listed {
        ListEntry::Command(action) => (entry_of(action).help)(words()).to_owned(),
        ListEntry::Topic(at) => {
            let topic = &TOPICS[at];
            words().manual_of(topic.called(), (topic.about)(words()))
        }
        ListEntry::SaveAndQuit => words().save_and_quit().to_owned(),
        ListEntry::SaveTo => words().save_to(palette.argument()),
        ListEntry::OpenFile => words().open_named(palette.argument()),
        ListEntry::GoTo => words().go_to_coordinate(palette.line.text().trim()),
        ListEntry::Steps(count) => match count.signum() {
            -1 => words().steps_back(count.unsigned_abs()),
            _ => words().steps_forward(count.unsigned_abs()),
        },
        ListEntry::Theme(theme) => words().switch_theme(theme.shown_name()),
        ListEntry::Exercise(seed) => words().make_exercise(seed),
        ListEntry::Preset(at) => words().open_named(presets::all()[at].name),
        ListEntry::Task(at) => words().search_for_task(ExampleTask::all()[at].name),
    }
}

/// Renders an entry with its keys at the right.
fn render_row((text, keys): (&str, &str), is_chosen: bool, line: Rect, buffer: &mut Buffer) {
    let (mark, part) = match is_chosen {
        true => (MARK, ScreenPart::Key),
        false => ("  ", ScreenPart::Text),
    };
    let x = print(buffer, line.x, line.y, line.width, mark, theme::part(part));
    let space = line.right().saturating_sub(x);
    let end = print(buffer, x, line.y, space, text, theme::part(part));
    if end + 1 + columns(keys) <= line.right() {
        let style = theme::part(ScreenPart::Quiet);
        print_right(buffer, line.right(), line.y, keys, style);
    }
}

/// Returns the number of rows and the number of visible ones.
pub(super) fn extent(palette: &CommandList, area: Rect) -> (usize, usize) {
    let rows = popup::within(placed(area)).height;
    (palette.list.count().0, rows.into())
}
