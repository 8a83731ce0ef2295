//! Figures in columns, live beside or below the drawing.

use super::{columns, cut, mark_more, print, print_right};
use crate::capability::Colours;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, Part};
use crate::tui::figures::format::Unsure;
use crate::tui::figures::sheet::{self, Line, Shown};
use crate::tui::player::open_scene::shown;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// The tables at this width, scrolled as the view is.
pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    title(app, area, buffer);
    let area = below_title(app, area);
    let (sheet, glyphs) = (app.sheet(), app.glyphs());
    let lines = sheet.lines(area.width.into(), glyphs);
    let most = lines.len().saturating_sub(area.height.into());
    let scroll = app.scroll().min(most);
    let seen = lines.iter().skip(scroll);
    mark_more(area, scroll > 0, scroll < most, buffer);
    for (y, line) in (area.top()..area.bottom()).zip(seen) {
        render_line(
            app,
            line,
            Rect {
                y,
                height: 1,
                ..area
            },
            buffer,
        );
    }
}

/// All lines of the tables at this width, and how many are seen.
pub(super) fn extent(app: &App, area: Rect) -> (usize, usize) {
    let lines = app.sheet().lines(area.width.into(), app.glyphs());
    (lines.len(), below_title(app, area).height.into())
}

/// Says above tables of differences what they are.
pub(super) fn title(app: &App, area: Rect, buffer: &mut Buffer) {
    if let Some(title) = app.difference_title(area.width.into()) {
        let title = cut(&shown(&title, app.glyphs()), area.width.into());
        let style = theme::part(Part::Quiet);
        print(buffer, area.x, area.y, area.width, &title, style);
    }
}

/// Where the tables begin: below their title, if they have one.
pub(super) fn below_title(app: &App, area: Rect) -> Rect {
    let title = title_lines(app);
    Rect {
        y: area.y + title,
        height: area.height.saturating_sub(title),
        ..area
    }
}

/// Lines that the title of the tables takes.
pub(super) fn title_lines(app: &App) -> u16 {
    u16::from(app.compared().is_some())
}

/// Whether the row has no partner in what is compared with.
pub(super) fn is_alone(app: &App, line: &Line) -> bool {
    let Some(compared) = app.compared() else {
        return false;
    };
    match *line {
        Line::Row(sheet::Part::Vectors, row, _) => !compared.pairing().has_vector(row),
        Line::Row(sheet::Part::Points, row, _) => !compared.pairing().has_point(row),
        Line::Blank | Line::Names(..) | Line::Units(..) => false,
    }
}

/// One line of the tables in an area of its height.
pub(super) fn render_line(app: &App, line: &Line, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let (name, cells) = app.sheet().show(line, app.tables(), width, app.glyphs());
    let (of_name, of_cells) = match line {
        Line::Names(..) | Line::Units(..) | Line::Blank => (Part::Quiet, Part::Quiet),
        Line::Row(..) => (Part::Name, Part::Text),
    };
    let text = shown(&name.text, app.glyphs());
    print(
        buffer,
        area.x,
        area.y,
        area.width,
        &text,
        theme::part(of_name),
    );
    let mut right = area.x.saturating_add(columns_of(name.width));
    if is_alone(app, line) {
        let style = theme::part(Part::Quiet);
        let room = area.right().saturating_sub(right + 1);
        print(buffer, right + 1, area.y, room, "only here", style);
        return;
    }
    for cell in cells {
        right = right.saturating_add(columns_of(cell.width));
        if right > area.right() {
            break;
        }
        debug_assert!(usize::from(columns(&cell.text)) < cell.width);
        print_right(buffer, right, area.y, &cell.text, theme::part(of_cells));
        let left = right.saturating_sub(columns(&cell.text));
        doubt(app.colours(), &cell, left, area.y, buffer);
    }
}

/// Dims the digits of a cell that nothing proves. Without colours, where dim text may look like any
/// other, points stand in their place; a figure without any bound is left to the last line to tell.
pub(super) fn doubt(colours: Colours, cell: &Shown, left: u16, y: u16, buffer: &mut Buffer) {
    let digits = match &cell.unsure {
        Unsure::Nothing => return,
        Unsure::Last(digits) => digits.clone(),
        Unsure::Everything if colours == Colours::None => return,
        Unsure::Everything => 0..cell.text.len(),
    };
    for at in digits {
        let x = left.saturating_add(columns_of(at));
        let place = &mut buffer[(x, y)];
        place.set_style(theme::part(Part::Unsure));
        if colours == Colours::None && place.symbol().bytes().all(|b| b.is_ascii_digit()) {
            place.set_char(UNSURE);
        }
    }
}

/// Stands for a digit that nothing proves, where it cannot be dimmed.
pub(super) const UNSURE: char = '.';

/// Columns from `usize`; more than there can be are too many.
pub(super) fn columns_of(width: usize) -> u16 {
    u16::try_from(width).unwrap_or(u16::MAX)
}
