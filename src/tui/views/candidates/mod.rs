//! Lists the linkages found for a task, with the moving candidate under the cursor next to the
//! list.
//!
//! ```text
//! Linkages for wiper                         6, 2 defective
//!      miss mm transm. crank  | wiper-1
//! > 1 1.2e-13    62.9  swings |        T2
//!   2 3.4e-14    58.1  turns  |    ___o---o
//!   defective                 | T1 o/      \
//!   3 branch: a dead point .. | point 1 of 3, crank at 43.2 deg
//! wiper-1      Enter take  space play  Left Right points
//! ```

pub(crate) mod curve_cursor;
mod curves;
mod display;
pub(crate) mod list;

use super::scene_picker::{PickerAreas, arrange, paragraph};
use super::{
    columns, cut, list_rows, middle, print, print_line, print_right, row, show_figure, split,
};
use crate::drawing::{self, Shape};
use crate::page::wrapped;
use crate::report::CandidateRow;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown as shown_text;
use crate::wording::words;
use display::ShownCandidate;
use list::{CandidateList, CandidatesPage};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect, Size};

/// Widths of the list, its margins included: with the values only, and with the unmet preferences
/// behind them.
const LIST: [u16; 2] = [34, 52];
/// Widths of a mark, of the miss at least, and of the gap between two columns.
const INDENT: u16 = 2;
const MIN_MISS: u16 = 8;
const GAP: u16 = 1;
/// Minimum height of the drawing, in lines.
const MIN_DRAWING_HEIGHT: u16 = 6;
/// Maximum height of the verdict on all candidates, in lines.
const MAX_VERDICT: usize = 4;

pub(super) fn render(app: &App, list: &CandidateList, screen: Rect, buffer: &mut Buffer) {
    title(app, list, row(screen, 0), buffer);
    match list.page() {
        CandidatesPage::List => {}
        CandidatesPage::Alone => return candidate(app, list, middle(screen), buffer),
        CandidatesPage::Curves(walk) => {
            return curves::render(app, list, walk, middle(screen), buffer);
        }
    }
    let arrangement = arrange(middle(screen), LIST);
    let PickerAreas {
        list: area,
        preview,
    } = arrangement;
    rows(app, list, area, buffer);
    if let Some((rule, area)) = preview {
        super::motion::rule(app.glyphs(), rule, buffer);
        candidate(app, list, area, buffer);
    }
}

/// Returns `true` if the screen has space for both the list and the selected candidate.
pub(crate) fn fits_both(size: Size) -> bool {
    let screen = Rect::from((Position::ORIGIN, size));
    arrange(middle(screen), LIST).preview.is_some()
}

/// Returns the number of lines of the list and how many of them fit.
pub(super) fn extent(list: &CandidateList, area: Rect) -> (usize, usize) {
    let height = arrange(area, LIST).list.height;
    (lines(list).len(), height.saturating_sub(1).into())
}

/// Renders the title line: the task's name and the number of candidates.
fn title(app: &App, list: &CandidateList, area: Rect, buffer: &mut Buffer) {
    let right = area.right().saturating_sub(1);
    let name = words().linkages_for(&list.order().name);
    let (good, defective) = list.count();
    let count = match list.percent() {
        Some(_) => String::new(),
        None => words().good_and_defective(good, defective),
    };
    let space = usize::from(right.saturating_sub(area.x + 1));
    let space = space.saturating_sub(usize::from(columns(&count)) + 1);
    let name = cut(&shown_text(&name, app.glyphs()), space);
    let style = theme::part(ScreenPart::Title);
    print(buffer, area.x + 1, area.y, area.width, &name, style);
    let style = theme::part(ScreenPart::Quiet);
    print_right(buffer, right, area.y, &count, style);
}

/// A line of the list.
#[derive(Clone, Copy)]
enum ListLine<'a> {
    /// The heading above the defective candidates.
    Defective,
    /// A candidate: its index, its row, and whether it does the task.
    Candidate(usize, &'a CandidateRow, bool),
}

fn lines(list: &CandidateList) -> Vec<ListLine<'_>> {
    let (good, defective) = list.count();
    let line = |(number, row)| ListLine::Candidate(number, row, number < good);
    let mut lines: Vec<ListLine<'_>> = list.rows().iter().enumerate().map(line).collect();
    if defective > 0 {
        lines.insert(good, ListLine::Defective);
    }
    lines
}

fn rows(app: &App, list: &CandidateList, area: Rect, buffer: &mut Buffer) {
    if let Some(percent) = list.percent() {
        let text = words().looking_for_linkages(percent);
        paragraph(app, &text, area, ScreenPart::Text, buffer);
        return;
    }
    let lines = lines(list);
    if lines.is_empty() {
        paragraph(app, list.nothing(), area, ScreenPart::Text, buffer);
        return;
    }
    let places = CandidateColumns::of(list.rows());
    let (head, area) = split(area, 1);
    heads(app, list, &places, head, buffer);
    let cursor = lines.iter().position(
        |line| matches!(line, ListLine::Candidate(number, ..) if *number == list.cursor()),
    );
    for (at, line) in list_rows(cursor.unwrap_or(0), lines.len(), area, buffer) {
        match lines[at] {
            ListLine::Defective => {
                print_line(buffer, line, words().defective_ones(), ScreenPart::Quiet);
            }
            ListLine::Candidate(number, row, is_good) => {
                let under_cursor = number == list.cursor();
                let entered = (number, row, is_good);
                entry(app, &places, entered, under_cursor, line, buffer);
            }
        }
    }
}

/// The right edges of the list's columns, from its left side. The words begin behind the last
/// column.
struct CandidateColumns {
    number: u16,
    miss: u16,
    transmission: u16,
    words: u16,
}

impl CandidateColumns {
    fn of(rows: &[CandidateRow]) -> CandidateColumns {
        let number = INDENT + columns(&rows.len().to_string());
        let misses = rows.iter().map(|row| columns(&row.miss));
        let miss = number + GAP + misses.fold(MIN_MISS, u16::max);
        let transmission = miss + GAP + columns(words().head_transmission());
        CandidateColumns {
            number,
            miss,
            transmission,
            words: transmission + GAP + GAP,
        }
    }

    /// Returns the column of the unmet preferences, which follow the words about the crank.
    fn preference_column(&self) -> u16 {
        let turns = [words().turns_fully_shortly(), words().swings_shortly()];
        let widest = turns.map(columns).into_iter().max().unwrap_or(0);
        self.words + widest.max(columns(words().head_turns())) + GAP + GAP
    }
}

/// Prints text that ends at this column of the line if `right`, or else starts there.
fn print_at(
    area: Rect,
    buffer: &mut Buffer,
    column: u16,
    text: &str,
    part: ScreenPart,
    right: bool,
) {
    let style = theme::part(part);
    if right {
        print_right(buffer, area.x + column, area.y, text, style);
    } else {
        let x = area.x + column;
        let space = area.right().saturating_sub(x);
        print(buffer, x, area.y, space, &cut(text, space.into()), style);
    }
}

fn heads(
    app: &App,
    list: &CandidateList,
    places: &CandidateColumns,
    area: Rect,
    buffer: &mut Buffer,
) {
    let mut head = |column, text: &str, right| {
        let text = shown_text(text, app.glyphs());
        print_at(area, buffer, column, &text, ScreenPart::Quiet, right);
    };
    let miss = format!("{} {}", words().head_miss(), list.miss_unit());
    head(places.miss, &miss, true);
    head(places.transmission, words().head_transmission(), true);
    head(places.words, words().head_turns(), false);
    let missing = list.rows().iter().any(|row| !row.unmet.is_empty());
    if missing && area.width > places.preference_column() + columns(words().head_lacks()) {
        head(places.preference_column(), words().head_lacks(), false);
    }
}

fn entry(
    app: &App,
    places: &CandidateColumns,
    (number, row, is_good): (usize, &CandidateRow, bool),
    under_cursor: bool,
    area: Rect,
    buffer: &mut Buffer,
) {
    let mut cell = |column, text: &str, part, right| {
        let part = if under_cursor { ScreenPart::Key } else { part };
        let text = shown_text(text, app.glyphs());
        print_at(area, buffer, column, &text, part, right);
    };
    if under_cursor {
        cell(0, ">", ScreenPart::Key, false);
    }
    cell(
        places.number,
        &(number + 1).to_string(),
        ScreenPart::Name,
        true,
    );
    // The mark is needed because the words behind the values may not fit.
    if !row.unmet.is_empty() {
        cell(1, "!", ScreenPart::Warning, false);
    }
    if !is_good {
        cell(places.number + GAP, &row.reasons, ScreenPart::Quiet, false);
        return;
    }
    cell(places.miss, &row.miss, ScreenPart::Text, true);
    cell(
        places.transmission,
        &row.transmission,
        ScreenPart::Text,
        true,
    );
    cell(places.words, row.turns, ScreenPart::Text, false);
    if area.width > places.preference_column() {
        cell(
            places.preference_column(),
            &row.unmet,
            ScreenPart::Warning,
            false,
        );
    }
}

/// Renders the selected candidate: its moving drawing and its facts.
fn candidate(app: &App, list: &CandidateList, area: Rect, buffer: &mut Buffer) {
    let facts = facts(app, list, area.width.into());
    let picture = print_facts(&facts, area, buffer);
    if let Some(shown) = list.shown() {
        drawing(app, list, shown, picture, buffer);
    }
}

/// Prints the facts at the bottom of an area and returns the area above them for a drawing.
fn print_facts(facts: &[(String, ScreenPart)], area: Rect, buffer: &mut Buffer) -> Rect {
    let maximum = area.height.saturating_sub(MIN_DRAWING_HEIGHT);
    let lines = u16::try_from(facts.len()).unwrap_or(maximum).min(maximum);
    let (picture, text) = split(area, area.height - lines);
    for (line, (fact, part)) in text.rows().zip(facts) {
        print_line(buffer, line, fact, *part);
    }
    picture
}

fn drawing(
    app: &App,
    list: &CandidateList,
    shown: &ShownCandidate,
    area: Rect,
    buffer: &mut Buffer,
) {
    let mut figure = shown.figure();
    for course in list.curves().chain([shown.way()]) {
        let course = course.clone();
        let role = drawing::Role::Trace;
        figure.add(Shape::Trace { course, role });
    }
    show_figure(app, &figure, shown.extents(), area, buffer);
}

/// Returns the wrapped facts on the candidate and on all candidates.
fn facts(app: &App, list: &CandidateList, width: usize) -> Vec<(String, ScreenPart)> {
    let Some((_, row)) = list.chosen() else {
        return Vec::new();
    };
    let driver_state = list.nearest_point().map(|(point, points, at)| {
        let at = format!("{at:.1}");
        words().at_point_of_task(point, points, &at)
    });
    let missing = match row.unmet.is_empty() {
        true => String::new(),
        false => format!("{}: {}", words().head_lacks(), row.unmet),
    };
    let legend = match list.has_curves() {
        true => words().dotted_curves(),
        false => "",
    };
    let text = [
        (
            driver_state.unwrap_or_default(),
            ScreenPart::Text,
            usize::MAX,
        ),
        (row.lengths.clone(), ScreenPart::Text, usize::MAX),
        (missing, ScreenPart::Warning, usize::MAX),
        (row.reasons.clone(), ScreenPart::Warning, usize::MAX),
        (list.verdict().to_owned(), ScreenPart::Quiet, MAX_VERDICT),
        (legend.to_owned(), ScreenPart::Quiet, usize::MAX),
    ];
    in_lines(app, text, width)
}

/// Wraps each text, truncates it to its maximum number of lines, and drops empty texts.
fn in_lines(
    app: &App,
    message: impl IntoIterator<Item = (String, ScreenPart, usize)>,
    width: usize,
) -> Vec<(String, ScreenPart)> {
    let message = message.into_iter().filter(|(text, ..)| !text.is_empty());
    let lines = message.flat_map(|(text, part, maximum)| {
        let text = shown_text(&text, app.glyphs()).into_owned();
        let mut lines = wrapped(&text, width);
        lines.truncate(maximum);
        lines.into_iter().map(move |line| (line, part))
    });
    lines.collect()
}
