//! Draws a topic of the manual in place of the view.
//!
//! ```text
//!  Help: scene  2/11  /slot     ^v what is shown, what is searched for, where there is more
//!  The scene file
//!  ...
//! ```

use super::keys::rows_of;
use super::text::Help;
use super::{print, print_right, searched};
use crate::manual::{LineKind, ManualLine, TOPICS, Topic, folded, lines};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::keymap::Keymap;
use crate::tui::views::MIN_VALUE;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Rows of the heading.
const HEADING: u16 = 1;
/// Columns of the marks for hidden lines above and below. They are in the heading, because code may fill whole lines.
const MARKS: u16 = 2;

pub(super) fn render(help: &Help, topic: &Topic, area: Rect, buffer: &mut Buffer) {
    for position in area.positions() {
        buffer[position].reset();
    }
    heading(help, topic, area, buffer);
    let found = help.found(area.width);
    let seen = help.reading().iter().enumerate();
    let rows = (area.y + HEADING)..area.bottom();
    for (y, (number, line)) in rows.zip(seen.skip(help.scroll)) {
        let part = match line.kind {
            _ if found == Some(number) => ScreenPart::Cursor,
            LineKind::Title => ScreenPart::Title,
            LineKind::Words | LineKind::Code => ScreenPart::Text,
        };
        print(buffer, area.x, y, area.width, &line.text, theme::part(part));
    }
}

fn heading(help: &Help, topic: &Topic, area: Rect, buffer: &mut Buffer) {
    let text = words().help_topic(topic.called(), help.page(), TOPICS.len());
    let text = format!(" {text} ");
    let style = theme::part(ScreenPart::Title);
    let end = print(buffer, area.x, area.y, area.width, &text, style);
    let place = Rect {
        width: area.width.saturating_sub(MARKS),
        ..area
    };
    if let Some(words) = help.words() {
        searched(words, help.is_typing(), end, place, buffer);
    }
    if help.is_nowhere() {
        let style = theme::part(ScreenPart::Warning);
        let nowhere = format!(" {} ", words().nowhere());
        print_right(buffer, place.right(), area.y, &nowhere, style);
    }
    let (lines, rows) = extent(help, area);
    let marks = [("^", help.scroll > 0), ("v", help.scroll + rows < lines)];
    for (x, (mark, is_more)) in (place.right()..).zip(marks) {
        let mark = if is_more { mark } else { " " };
        print(buffer, x, area.y, 1, mark, theme::part(ScreenPart::Key));
    }
}

/// Returns the number of lines of the topic, and how many fit on the screen.
pub(super) fn extent(help: &Help, area: Rect) -> (usize, usize) {
    let rows = area.height.saturating_sub(HEADING);
    (help.reading().len(), rows.into())
}

/// Lays out a topic for a screen of so many columns. A screen too narrow for any content gets the layout of the
/// narrowest sufficient one.
pub(super) fn lines_of(topic: &Topic, columns: u16, keymap: &Keymap) -> Vec<ManualLine> {
    let columns = usize::from(columns.max(MIN_VALUE.width));
    let lines = lines(&topic.text(|| rows_of(keymap)), columns).into_iter();
    lines.flat_map(|line| folded(line, columns)).collect()
}
