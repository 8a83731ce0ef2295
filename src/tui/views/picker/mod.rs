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

use super::{columns, cut, inset, mark_more, middle, print, print_right, row};
use crate::drawing::{self, Layers};
use crate::page::wrapped;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::player::open_scene::shown;
use crate::tui::views::picker::list::{Picker, PickerItem, PickerRow, Purpose};
use crate::tui::views::picker::preview::{Preview, Sample, Unopenable};
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
    let width = if area.width < ROOM_FOR_TITLES {
        usual
    } else {
        wide
    };
    let part = |x: u16, width: u16| Rect {
        x: area.x + x,
        width,
        ..area
    };
    PickerAreas {
        list: inset(part(0, width)),
        preview: Some((
            part(width, 1),
            inset(part(width + 1, area.width - width - 1)),
        )),
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
        let room = right.saturating_sub(x);
        print(buffer, x, area.y, room, text, theme::part(part))
    };
    let x = put(buffer, area.x + 1, what, ScreenPart::Title);
    let x = put(buffer, x + 2, words().search_for(), ScreenPart::Quiet);
    let x = put(
        buffer,
        x,
        &shown(picker.search(), app.glyphs()),
        ScreenPart::Text,
    );
    let x = put(buffer, x, " ", ScreenPart::Caret);
    let (found, all) = picker.count();
    let count = words().some_of(found, all);
    if x + columns(&count) < right {
        print_right(
            buffer,
            right,
            area.y,
            &count,
            theme::part(ScreenPart::Quiet),
        );
    }
}

fn list(app: &App, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    let rows = picker.rows();
    if rows.is_empty() {
        let style = theme::part(ScreenPart::Text);
        paragraph(app, words().nothing_matches(), area, style, buffer);
        return;
    }
    let cursor = rows
        .iter()
        .position(|row| matches!(row, PickerRow::Item(_, true)));
    let (first, most) = first_and_most(cursor.unwrap_or(0), rows.len(), area);
    mark_more(area, first > 0, first < most, buffer);
    for (y, row) in (area.top()..area.bottom()).zip(&rows[first..]) {
        let line = Rect {
            y,
            height: 1,
            ..area
        };
        match *row {
            PickerRow::Folder(path) => {
                let path = path.display().to_string();
                heading(
                    &ending(&shown(&path, app.glyphs()), area.width.into()),
                    line,
                    buffer,
                );
            }
            PickerRow::Presets => heading(words().presets(), line, buffer),
            PickerRow::Note(note) => {
                let text = cut(&shown(note, app.glyphs()), usize::from(area.width) - 2);
                print(
                    buffer,
                    line.x + 2,
                    y,
                    line.width,
                    &text,
                    theme::part(ScreenPart::Quiet),
                );
            }
            PickerRow::Item(item, under_cursor) => entry(app, item, under_cursor, line, buffer),
        }
    }
}

/// Returns the first visible line of a list, such that the cursor is centred if possible, and the
/// maximum of that line.
pub(super) fn first_and_most(cursor: usize, lines: usize, area: Rect) -> (usize, usize) {
    let height = usize::from(area.height).max(1);
    let most = lines.saturating_sub(height);
    (cursor.saturating_sub(height / 2).min(most), most)
}

pub(super) fn heading(text: &str, area: Rect, buffer: &mut Buffer) {
    let style = theme::part(ScreenPart::Quiet);
    print(buffer, area.x, area.y, area.width, text, style);
}

fn entry(app: &App, item: &PickerItem, under_cursor: bool, area: Rect, buffer: &mut Buffer) {
    let part = |other| theme::part(if under_cursor { ScreenPart::Key } else { other });
    let room = usize::from(area.width.saturating_sub(INDENT));
    let mark = if under_cursor { ">" } else { " " };
    print(buffer, area.x, area.y, 1, mark, part(ScreenPart::Key));
    let name = cut(&shown(&item.name, app.glyphs()), room);
    let x = area.x + INDENT;
    print(buffer, x, area.y, area.width, &name, part(ScreenPart::Text));
    // Titles are aligned in a column.
    let x = x + NAMES;
    if area.right() >= x + MIN_TITLE_LEN && columns(&name) < NAMES {
        let title = cut(
            &shown(&item.title, app.glyphs()),
            usize::from(area.right() - x),
        );
        print(
            buffer,
            x,
            area.y,
            area.right() - x,
            &title,
            part(ScreenPart::Quiet),
        );
    }
}

fn preview(app: &App, picker: &Picker, area: Rect, buffer: &mut Buffer) {
    let Some(item) = picker.chosen() else {
        return;
    };
    let (title, below) = split(area, 1);
    let name = match app.preview() {
        Some(Preview::Scene(sample)) => &sample.scene.title(),
        Some(Preview::Fault(_) | Preview::Folder(_) | Preview::Unseen(_)) | None => &item.name,
    };
    let name = cut(&shown(name, app.glyphs()), area.width.into());
    print(
        buffer,
        title.x,
        title.y,
        title.width,
        &name,
        theme::part(ScreenPart::Title),
    );
    match app.preview() {
        Some(Preview::Scene(sample)) => scene(app, sample, below, buffer),
        Some(Preview::Fault(fault)) => faulty(app, fault, below, buffer),
        Some(Preview::Folder(names)) => folder(app, names, below, buffer),
        Some(Preview::Unseen(why)) => {
            paragraph(
                app,
                why,
                split(below, 1).1,
                theme::part(ScreenPart::Text),
                buffer,
            );
        }
        None => {}
    }
}

/// Renders the drawing with the facts below it.
fn scene(app: &App, sample: &Sample, area: Rect, buffer: &mut Buffer) {
    let facts = facts(sample, area.width.into());
    let most = area
        .height
        .saturating_sub(MIN_DRAWING_HEIGHT)
        .min(area.height / 2);
    let lines = u16::try_from(facts.len()).unwrap_or(most).min(most);
    let (picture, text) = split(area, area.height - lines);
    let figure = drawing::linkage(
        &sample.scene,
        &sample.reach,
        &sample.state,
        Layers::default(),
    );
    let view = drawing::WorldView::fit(&sample.reach, picture.width, picture.height, app.aspect());
    super::show(
        &drawing::render(&figure, &view, app.glyphs()),
        picture,
        buffer,
    );
    for (y, (fact, part)) in (text.top()..text.bottom()).zip(facts) {
        let fact = shown(&fact, app.glyphs());
        print(buffer, text.x, y, text.width, &fact, theme::part(part));
    }
}

/// Returns the facts about a scene, wrapped and truncated.
fn facts(sample: &Sample, width: usize) -> Vec<(String, ScreenPart)> {
    let Sample { scene, .. } = sample;
    let lines = |text: &str, most: usize, part: ScreenPart| {
        let mut lines = wrapped(text, width);
        if lines.len() > most {
            lines.truncate(most);
            if let Some(last) = lines.last_mut() {
                *last = cut(&format!("{last} ..."), width);
            }
        }
        lines.into_iter().map(move |line| (line, part))
    };
    let own = format!("{}; {}", sample.parts, sample.range);
    let told =
        |text: &Option<String>| words().translated_scene_text(text.as_deref().unwrap_or_default());
    let (source, note) = (told(&scene.source), told(&scene.note));
    let said = [
        (own.as_str(), MAX_FACTS, ScreenPart::Text),
        (source.as_str(), MAX_SOURCE, ScreenPart::Quiet),
        (note.as_str(), MAX_NOTE, ScreenPart::Text),
    ];
    let said = said.into_iter().filter(|(text, ..)| !text.is_empty());
    said.flat_map(|(text, most, part)| lines(text, most, part))
        .collect()
}

/// Renders the first fault, its place and its fix.
fn faulty(app: &App, fault: &Unopenable, area: Rect, buffer: &mut Buffer) {
    let area = split(area, 1).1;
    let area = paragraph(
        app,
        words().cannot_be_opened(),
        area,
        theme::part(ScreenPart::Warning),
        buffer,
    );
    let area = paragraph(
        app,
        &fault.what,
        area,
        theme::part(ScreenPart::Text),
        buffer,
    );
    let mut area = area;
    if let Some((line, column)) = fault.at {
        let place = words().line_and_column(line, column);
        area = paragraph(app, &place, area, theme::part(ScreenPart::Quiet), buffer);
    }
    if let Some(mend) = &fault.mend {
        area = paragraph(
            app,
            mend,
            split(area, 1).1,
            theme::part(ScreenPart::Text),
            buffer,
        );
    }
    if fault.more > 0 {
        let more = words().more_below(fault.more);
        paragraph(app, &more, area, theme::part(ScreenPart::Quiet), buffer);
    }
}

fn folder(app: &App, names: &[String], area: Rect, buffer: &mut Buffer) {
    let area = split(area, 1).1;
    if names.is_empty() {
        let none = words().no_scene_file_in_it();
        paragraph(app, none, area, theme::part(ScreenPart::Quiet), buffer);
        return;
    }
    let height = usize::from(area.height);
    let is_whole = names.len() <= height;
    let seen = if is_whole {
        height
    } else {
        height.saturating_sub(1)
    };
    for (y, name) in (area.top()..area.bottom()).zip(names.iter().take(seen)) {
        let name = cut(&shown(name, app.glyphs()), area.width.into());
        print(
            buffer,
            area.x,
            y,
            area.width,
            &name,
            theme::part(ScreenPart::Text),
        );
    }
    if !is_whole && area.height > 0 {
        let more = words().and_more(names.len() - seen);
        let style = theme::part(ScreenPart::Quiet);
        print(buffer, area.x, area.bottom() - 1, area.width, &more, style);
    }
}

/// Prints wrapped text and returns the area below it.
pub(super) fn paragraph(
    app: &App,
    text: &str,
    area: Rect,
    style: ratatui::style::Style,
    buffer: &mut Buffer,
) -> Rect {
    let lines = wrapped(&shown(text, app.glyphs()), area.width.into());
    for (y, line) in (area.top()..area.bottom()).zip(&lines) {
        let line = cut(line, area.width.into());
        print(buffer, area.x, y, area.width, &line, style);
    }
    split(area, u16::try_from(lines.len()).unwrap_or(area.height)).1
}

/// Splits an area into its first `height` lines and the rest.
pub(super) fn split(area: Rect, height: u16) -> (Rect, Rect) {
    let height = height.min(area.height);
    let below = Rect {
        y: area.y + height,
        height: area.height - height,
        ..area
    };
    (Rect { height, ..area }, below)
}

/// Returns the text, or two points and its last characters if it is longer than `most`. The end of
/// a path is the most informative part.
fn ending(text: &str, most: usize) -> String {
    let length = text.chars().count();
    if length <= most {
        return text.to_owned();
    }
    let end: String = text.chars().skip(length + 2 - most.max(2)).collect();
    format!("..{end}")
}

/// Minimum screen size for a preview; on a smaller screen the list is alone.
const MIN_WIDTH: u16 = 70;
const MIN_HEIGHT: u16 = 14;
/// Widths of the list with its margins: on usual screens, and on wide ones with titles behind the
/// names.
const LISTS: [u16; 2] = [30, 56];
/// Minimum width of a wide screen.
const ROOM_FOR_TITLES: u16 = 110;
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
