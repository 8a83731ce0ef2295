//! Draws the help: a list of the keys by purpose in the middle of the view, or a topic of the manual.
//!
//! ```text
//! +- Help ------------------------+
//! | The motion                    |
//! | space        play or pause    |
//! ```

pub(crate) mod keys;
mod page;
mod search;
pub(crate) mod text;

use super::popup::{self, BORDER};
use super::table::UNPROVED_DIGIT;
use super::{columns, cut, print, print_line, print_right, split_columns};
use crate::capability::Colours;
use crate::manual::{SearchWords, TOPICS};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, entries};
use crate::tui::figures::sheet::COMPUTED_MARK;
use crate::tui::views::help::text::{Help, HelpLine};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Width of the keys, in columns.
const KEYS: u16 = 13;
/// Blanks between two columns of lines.
const GAP: u16 = 2;
/// Maximum number of columns of lines; more would be harder to read.
const MAX_COLUMNS: u16 = 3;

/// Returns the lines for a search without a result; they name topics of the manual that have the words.
fn nothing(query: &str) -> Vec<String> {
    let topics = SearchWords::new(query).best_topics().into_iter();
    let topics: Vec<&str> = topics.map(|at| TOPICS[at].called()).collect();
    let text = match topics.is_empty() {
        true => String::new(),
        false => words().manual_tells_of_it(&topics.join(", ")),
    };
    let [none, all] = [words().no_key_does_that(), words().esc_shows_all_keys()];
    vec![none.to_owned(), text, all.to_owned()]
}

/// Number of lines for a search without a result.
const NOTHING: usize = 3;

/// Returns the width of a line: the keys and the longest description.
fn line_columns() -> u16 {
    let help = entries().map(|entry| columns((entry.help)(words())));
    KEYS + help.max().unwrap_or(0)
}

pub(super) fn render(app: &App, help: &Help, area: Rect, buffer: &mut Buffer) {
    if let Some(topic) = help.topic() {
        return page::render(help, topic, area, buffer);
    }
    let lines = lines(app, help);
    let place = popup::centred(area, width(area), height(area, lines.len()));
    let end = popup::frame(app.glyphs(), place, words().help_title(), buffer);
    match help.words() {
        Some(query) => searched(query, help.is_typing(), end, place, buffer),
        None => manual_behind(app, place, buffer),
    }
    footer(app, help, lines.len(), place, buffer);
    let inner = popup::within(place);
    if lines.is_empty() {
        let lines = nothing(help.words().unwrap_or_default());
        for (row, text) in inner.rows().zip(lines) {
            print_line(buffer, row, &text, ScreenPart::Text);
        }
    }
    let per_column = usize::from(inner.height).max(1);
    let seen = lines.get(help.scroll..).unwrap_or_default();
    let xs = (inner.x..).step_by((line_columns() + GAP).into());
    for (x, lines) in xs.zip(seen.chunks(per_column)).take(count(area).into()) {
        for (y, line) in (inner.y..).zip(lines) {
            show(line, x, y, buffer);
        }
    }
}

fn lines(app: &App, help: &Help) -> Vec<HelpLine> {
    let has_drawing = app.visible_views().contains(&View::Motion);
    help.lines(app.view(), has_drawing, app.keymap())
}

fn show(line: &HelpLine, x: u16, y: u16, buffer: &mut Buffer) {
    let (keys, after) = split_columns(Rect::new(x, y, line_columns(), 1), KEYS);
    // Bold keys would account for a third of the bytes that the help sends over a slow line.
    let (of, help, part) = match line {
        HelpLine::Blank => return,
        HelpLine::Title(title) => {
            return print_line(buffer, keys.union(after), title, ScreenPart::Title);
        }
        HelpLine::Keys(of, help) => (of, help, ScreenPart::Text),
        HelpLine::KeysElsewhere(of, help) => (of, help, ScreenPart::Quiet),
    };
    print_line(buffer, keys, &cut(of, usize::from(KEYS) - 1), part);
    print_line(buffer, after, help, part);
}

/// Prints the searched words in the upper border. If they are too long, prints their end.
fn searched(query: &str, typing: bool, x: u16, area: Rect, buffer: &mut Buffer) {
    let space = area.right().saturating_sub(x + 5);
    let skipped = query.len().saturating_sub(space.into());
    let text = format!("/{}", query.get(skipped..).unwrap_or_default());
    let space = space + 1;
    let style = theme::part(ScreenPart::Text);
    let x = print(buffer, x, area.y, space, &text, style);
    let caret = if typing {
        ScreenPart::Caret
    } else {
        ScreenPart::Text
    };
    print(buffer, x, area.y, 1, " ", theme::part(caret));
}

/// Prints the key for the manual in the upper border if the help has a single column. The status line of such a
/// narrow screen has no space for it.
fn manual_behind(app: &App, area: Rect, buffer: &mut Buffer) {
    if count(area) == 1
        && let Some(key) = app.keymap().key(Action::NextView)
    {
        let style = theme::part(ScreenPart::Quiet);
        let manual = format!(" {} ", words().turns_to_manual(&key));
        print_right(buffer, area.right() - 2, area.y, &manual, style);
    }
}

/// Prints the meaning of the marks and, if lines are hidden, the key for scrolling, in the lower border.
fn footer(app: &App, help: &Help, lines: usize, area: Rect, buffer: &mut Buffer) {
    let (y, style) = (area.bottom() - 1, theme::part(ScreenPart::Quiet));
    let inner = popup::within(area);
    let seen = usize::from(inner.height) * usize::from(count(area));
    let legend = legend(app.colours(), inner.width > line_columns());
    print(buffer, area.x + 2, y, inner.width, &legend, style);
    if help.scroll + seen < lines
        && let Some(key) = app.keymap().key(Action::LineDown)
    {
        let more = format!(" {} ", words().shows_more(&key));
        print_right(buffer, area.right() - 2, y, &more, style);
    }
}

/// Returns the meaning of the marks next to values, and of marked digits if the border is wide.
fn legend(colours: Colours, wide: bool) -> String {
    let marks = match (wide, colours) {
        (false, _) => words().marks_of_figures(COMPUTED_MARK),
        (true, Colours::None) => words().marks_of_figures_and_digits(COMPUTED_MARK, UNPROVED_DIGIT),
        (true, _) => words().marks_of_figures_and_dim_digits(COMPUTED_MARK),
    };
    format!(" {marks} ")
}

/// Returns the area of the help on the screen.
pub(super) fn placed(app: &App, help: &Help, area: Rect) -> Rect {
    if help.topic().is_some() {
        return area;
    }
    let lines = lines(app, help).len();
    popup::centred(area, width(area), height(area, lines))
}

/// Returns the number of lines, and how many fit on the screen.
pub(super) fn extent(app: &App, help: &Help, area: Rect) -> (usize, usize) {
    if help.topic().is_some() {
        return page::extent(help, area);
    }
    let lines = lines(app, help).len();
    let rows = popup::within(placed(app, help, area)).height;
    (lines, usize::from(rows) * usize::from(count(area)))
}

/// Returns the number of columns of lines that fit into an area, at least 1.
fn count(area: Rect) -> u16 {
    let space = (area.width + GAP).saturating_sub(BORDER.0);
    (space / (line_columns() + GAP)).clamp(1, MAX_COLUMNS)
}

fn width(area: Rect) -> u16 {
    let count = count(area);
    count * line_columns() + (count - 1) * GAP
}

/// Returns the rows for so many lines. They always suffice for the text of a search without a result.
fn height(area: Rect, lines: usize) -> u16 {
    let rows = lines.div_ceil(count(area).into()).max(NOTHING);
    u16::try_from(rows).unwrap_or(u16::MAX)
}
