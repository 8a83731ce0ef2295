//! Renders the scene picker: the list of presets and files, with a preview of the selected scene
//! next to it.
//!
//! ```text
//! Open a scene  search: pre_                     3 of 31
//!   scenes/             | Press with a ram
//! > press-mine.toml     |     o-----o
//!   presets             |    /       \
//!   press               | 5 links, 1 slide, in mm
//! open  Press with a ram                 Enter open  Esc back
//! ```

pub(crate) mod folder;
pub(crate) mod list;
pub(crate) mod preview;

use super::{
    columns, cut, inset, list_rows, middle, print, print_line, print_right, row, split,
    split_columns,
};
use crate::drawing::{self, Layers};
use crate::page::{truncate_lines, wrapped};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::tui::views::scene_picker::list::{Picker, PickerItem, PickerRow, Purpose};
use crate::tui::views::scene_picker::preview::{Preview, Sample, Unopenable};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// The areas of the list and of the preview.
pub(super) struct PickerAreas {
    pub(super) list: Rect,
    /// The separator and the preview right of it; `None` on small screens.
    pub(super) preview: Option<(Rect, Rect)>,
}

/// Arranges a list and the preview next to it; the list has one width on usual screens and one on
/// wide ones.
pub(super) fn arrange(area: Rect, [usual, wide]: [u16; 2]) -> PickerAreas {
    if area.width < MIN_WIDTH || area.height < MIN_HEIGHT {
        let list = inset(area);
        return PickerAreas {
            list,
            preview: None,
        };
    }
    let width = if area.width < MIN_WIDTH_WITH_TITLES {
        usual
    } else {
        wide
    };
    let (list, side) = split_columns(area, width);
    let (rule, preview) = split_columns(side, 1);
    PickerAreas {
        list: inset(list),
        preview: Some((rule, inset(preview))),
    }
}

pub(super) fn render(app: &App, picker: &Picker, screen: Rect, buffer: &mut Buffer) {
    let arrangement = arrange(middle(screen), LISTS);
    search(app, picker, row(screen, 0), buffer);
    list(app, picker, arrangement.list, buffer);
    if let Some((rule, area)) = arrangement.preview {
        super::motion::rule(app.glyphs(), rule, buffer);
        preview(app, picker, area, buffer);
    }
}

/// Returns the number of lines of the list and the number of visible ones.
pub(super) fn extent(picker: &Picker, area: Rect) -> (usize, usize) {
    (picker.rows().len(), arrange(area, LISTS).list.height.into())
}

/// Renders the title line: the search and the number of matches.
fn search(app: &App, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    let what = match picker.purpose() {
        Purpose::Open => words().open_a_scene(),
        Purpose::Compare => words().compare_with(),
    };
    let right = area.right().saturating_sub(1);
    let put = |buffer: &mut Buffer, x: u16, text: &str, part| {
        let space = right.saturating_sub(x);
        print(buffer, x, area.y, space, text, theme::part(part))
    };
    let x = put(buffer, area.x + 1, what, ScreenPart::Title);
    let x = put(buffer, x + 2, words().search_for(), ScreenPart::Quiet);
    let x = put(
        buffer,
        x,
        &shown(picker.search.text(), app.glyphs()),
        ScreenPart::Text,
    );
    let x = put(buffer, x, " ", ScreenPart::Caret);
    let (found, all) = picker.list.count();
    let count = words().some_of(found, all);
    if x + columns(&count) < right {
        let style = theme::part(ScreenPart::Quiet);
        print_right(buffer, right, area.y, &count, style);
    }
}

fn list(app: &App, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    let rows = picker.rows();
    if rows.is_empty() {
        paragraph(
            app,
            words().nothing_matches(),
            area,
            ScreenPart::Text,
            buffer,
        );
        return;
    }
    let cursor = rows
        .iter()
        .position(|row| matches!(row, PickerRow::Item(_, true)));
    for (at, line) in list_rows(cursor.unwrap_or(0), rows.len(), area, buffer) {
        match rows[at] {
            PickerRow::Folder(path) => {
                let path = path.display().to_string();
                let path = ending(&shown(&path, app.glyphs()), area.width.into());
                print_line(buffer, line, &path, ScreenPart::Quiet);
            }
            PickerRow::Presets => print_line(buffer, line, words().presets(), ScreenPart::Quiet),
            PickerRow::Note(note) => {
                let line = split_columns(line, INDENT).1;
                let text = cut(&shown(note, app.glyphs()), line.width.into());
                print_line(buffer, line, &text, ScreenPart::Quiet);
            }
            PickerRow::Item(item, under_cursor) => entry(app, item, under_cursor, line, buffer),
        }
    }
}

fn entry(app: &App, item: &PickerItem, under_cursor: bool, area: Rect, buffer: &mut Buffer) {
    let part = |other| theme::part(if under_cursor { ScreenPart::Key } else { other });
    let space = usize::from(area.width.saturating_sub(INDENT));
    let mark = if under_cursor { ">" } else { " " };
    print(buffer, area.x, area.y, 1, mark, part(ScreenPart::Key));
    let name = cut(&shown(&item.name, app.glyphs()), space);
    let x = area.x + INDENT;
    print(buffer, x, area.y, area.width, &name, part(ScreenPart::Text));
    // Titles are aligned in a column.
    let x = x + NAMES;
    if area.right() >= x + MIN_TITLE_LEN && columns(&name) < NAMES {
        let space = area.right() - x;
        let title = cut(&shown(&item.title, app.glyphs()), space.into());
        print(buffer, x, area.y, space, &title, part(ScreenPart::Quiet));
    }
}

fn preview(app: &App, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    let Some(item) = picker.chosen() else {
        return;
    };
    let below = split(area, 1).1;
    let name = match app.preview() {
        Some(Preview::Scene(sample)) => &sample.scene.title(),
        Some(Preview::Fault(_) | Preview::Folder(_) | Preview::Unseen(_)) | None => &item.name,
    };
    let name = cut(&shown(name, app.glyphs()), area.width.into());
    print_line(buffer, area, &name, ScreenPart::Title);
    match app.preview() {
        Some(Preview::Scene(sample)) => scene(app, sample, below, buffer),
        Some(Preview::Fault(fault)) => faulty(app, fault, below, buffer),
        Some(Preview::Folder(names)) => folder(app, names, below, buffer),
        Some(Preview::Unseen(why)) => {
            paragraph(app, why, split(below, 1).1, ScreenPart::Text, buffer);
        }
        None => {}
    }
}

/// Renders the drawing with the facts below it.
fn scene(app: &App, sample: &Sample, area: Rect, buffer: &mut Buffer) {
    let facts = facts(sample, area.width.into());
    let maximum = area
        .height
        .saturating_sub(MIN_DRAWING_HEIGHT)
        .min(area.height / 2);
    let lines = u16::try_from(facts.len()).unwrap_or(maximum).min(maximum);
    let (picture, text) = split(area, area.height - lines);
    let figure = drawing::linkage(
        &sample.scene,
        &sample.reach,
        &sample.state,
        Layers::default(),
    );
    super::show_figure(app, &figure, &sample.reach, picture, buffer);
    for (line, (fact, part)) in text.rows().zip(facts) {
        print_line(buffer, line, &shown(&fact, app.glyphs()), part);
    }
}

/// Returns the facts about a scene, wrapped and truncated.
fn facts(sample: &Sample, width: usize) -> Vec<(String, ScreenPart)> {
    let Sample { scene, .. } = sample;
    let lines = |text: &str, maximum: usize, part: ScreenPart| {
        let mut lines = wrapped(text, width);
        truncate_lines(&mut lines, maximum, width);
        lines.into_iter().map(move |line| (line, part))
    };
    let own = format!("{}; {}", sample.parts, sample.range);
    let shown_text =
        |text: &Option<String>| words().translated_scene_text(text.as_deref().unwrap_or_default());
    let (source, note) = (shown_text(&scene.source), shown_text(&scene.note));
    let message = [
        (own.as_str(), MAX_FACTS, ScreenPart::Text),
        (source.as_str(), MAX_SOURCE, ScreenPart::Quiet),
        (note.as_str(), MAX_NOTE, ScreenPart::Text),
    ];
    let message = message.into_iter().filter(|(text, ..)| !text.is_empty());
    message
        .flat_map(|(text, maximum, part)| lines(text, maximum, part))
        .collect()
}

/// Renders the first fault, its place and its fix.
fn faulty(app: &App, fault: &Unopenable, area: Rect, buffer: &mut Buffer) {
    let mut area = split(area, 1).1;
    let mut wording = |text: &str, above: u16, part| {
        area = paragraph(app, text, split(area, above).1, part, buffer);
    };
    wording(words().cannot_be_opened(), 0, ScreenPart::Warning);
    wording(&fault.what, 0, ScreenPart::Text);
    if let Some((line, column)) = fault.at {
        wording(&words().line_and_column(line, column), 0, ScreenPart::Quiet);
    }
    if let Some(fix) = &fault.fix {
        wording(fix, 1, ScreenPart::Text);
    }
    if fault.more > 0 {
        wording(&words().more_below(fault.more), 0, ScreenPart::Quiet);
    }
}

fn folder(app: &App, names: &[String], area: Rect, buffer: &mut Buffer) {
    let area = split(area, 1).1;
    if names.is_empty() {
        let none = words().no_scene_file_in_it();
        paragraph(app, none, area, ScreenPart::Quiet, buffer);
        return;
    }
    let height = usize::from(area.height);
    let is_whole = names.len() <= height;
    let seen = if is_whole {
        height
    } else {
        height.saturating_sub(1)
    };
    for (line, name) in area.rows().zip(names.iter().take(seen)) {
        let name = cut(&shown(name, app.glyphs()), area.width.into());
        print_line(buffer, line, &name, ScreenPart::Text);
    }
    if !is_whole && area.height > 0 {
        let more = words().and_more(names.len() - seen);
        print_line(buffer, row(area, area.height - 1), &more, ScreenPart::Quiet);
    }
}

/// Prints wrapped text and returns the area below it.
pub(super) fn paragraph(
    app: &App,
    text: &str,
    area: Rect,
    part: ScreenPart,
    buffer: &mut Buffer,
) -> Rect {
    let lines = wrapped(&shown(text, app.glyphs()), area.width.into());
    for (row, line) in area.rows().zip(&lines) {
        print_line(buffer, row, &cut(line, area.width.into()), part);
    }
    split(area, u16::try_from(lines.len()).unwrap_or(area.height)).1
}

/// Returns the text, or two points and its last characters if it is longer than `maximum`. The end of
/// a path is the most informative part.
fn ending(text: &str, maximum: usize) -> String {
    let length = text.chars().count();
    if length <= maximum {
        return text.to_owned();
    }
    let end: String = text.chars().skip(length + 2 - maximum.max(2)).collect();
    format!("..{end}")
}

/// Minimum screen size for a preview; on a smaller screen the list is alone.
const MIN_WIDTH: u16 = 70;
const MIN_HEIGHT: u16 = 14;
/// Widths of the list with its margins: on usual screens, and on wide ones with titles behind the
/// names.
const LISTS: [u16; 2] = [30, 56];
/// Minimum width of a wide screen.
const MIN_WIDTH_WITH_TITLES: u16 = 110;
/// Columns in front of a name for the cursor's mark.
const INDENT: u16 = 2;
/// Width of the names in front of titles, and the minimum width of a title.
const NAMES: u16 = 22;
const MIN_TITLE_LEN: u16 = 24;
/// Minimum height of the drawing, in lines.
const MIN_DRAWING_HEIGHT: u16 = 6;
/// Maximum numbers of lines for the facts, the source and the note.
const MAX_FACTS: usize = 2;
const MAX_SOURCE: usize = 2;
const MAX_NOTE: usize = 3;
