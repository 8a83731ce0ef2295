//! A topic of the manual, in the place of the view.
//!
//! ```text
//!  Help: scene  2/11  /slot        what is shown, and what is searched for
//!  The scene file
//!  ...
//! ```

use super::text::{Help, finds, key_rows};
use super::{print, print_right, searched};
use crate::manual::{Kind, Line, TOPICS, Topic, lines};
use crate::tui::appearance::theme::{self, Part};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Lines longer than this are no pleasure to read.
const WIDEST: u16 = 100;
/// What is said where no topic has the words.
const NOWHERE: &str = " nowhere ";
/// Rows of the heading.
const HEADING: u16 = 1;

pub(super) fn render(help: &Help, topic: &Topic, area: Rect, buffer: &mut Buffer) {
    for position in area.positions() {
        buffer[position].reset();
    }
    let heading = format!(" Help: {}  {}/{} ", topic.name, help.page(), TOPICS.len());
    let style = theme::part(Part::Title);
    let end = print(buffer, area.x, area.y, area.width, &heading, style);
    if let Some(words) = help.words() {
        searched(words, help.is_typing(), end, area, buffer);
    }
    let found = help.found(area.width);
    if help.is_nowhere() {
        let style = theme::part(Part::Warning);
        print_right(buffer, area.right(), area.y, NOWHERE, style);
    }
    let seen = shown(topic, area.width).into_iter().enumerate();
    let rows = (area.y + HEADING)..area.bottom();
    for (y, (number, line)) in rows.zip(seen.skip(help.scroll)) {
        let part = match line.kind {
            _ if found == Some(number) => Part::Cursor,
            Kind::Title => Part::Title,
            Kind::Words | Kind::Code => Part::Text,
        };
        print(buffer, area.x, y, area.width, &line.text, theme::part(part));
    }
}

/// Lines of a topic, and how many are seen.
pub(super) fn extent(topic: &Topic, area: Rect) -> (usize, usize) {
    let rows = area.height.saturating_sub(HEADING);
    (shown(topic, area.width).len(), rows.into())
}

/// The next line with these words, as its topic's number in the manual and its own: behind a line of a topic, then
/// in the topics that follow, round to the line itself.
pub(super) fn next(
    words: &str,
    from: (usize, Option<usize>),
    width: u16,
) -> Option<(usize, usize)> {
    let (page, line) = from;
    let wanted = words.to_ascii_lowercase();
    let first = line.map_or(0, |line| line + 1);
    (0..=TOPICS.len()).find_map(|step| {
        let page = (page + step) % TOPICS.len();
        let skipped = if step == 0 { first } else { 0 };
        let lines = shown(&TOPICS[page], width).into_iter().enumerate();
        let mut behind = lines.skip(skipped);
        let found = behind.find(|(_, line)| finds(&wanted, &[&line.text]));
        found.map(|(number, _)| (page, number))
    })
}

fn shown(topic: &Topic, width: u16) -> Vec<Line> {
    lines(&topic.text(&key_rows()), width.min(WIDEST).into())
}
