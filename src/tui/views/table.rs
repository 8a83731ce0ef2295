//! Renders the live tables of the motion view.

use super::{cut, first_visible_line, page, print, split};
use crate::capability::Colours;
use crate::page::{Line, Span, UnprovedDigits};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::figures::sheet::{self, Placed, TableLine};
use crate::tui::player::open_scene::shown;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Renders the tables at the width of the area with the view's scroll offset.
pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    title(app, area, buffer);
    let area = below_title(app, area);
    let placed = placed(app, area);
    let lines = placed.lines();
    let scroll = app.views.scroll[View::Motion as usize];
    let scroll = first_visible_line(scroll, lines.len(), area, buffer);
    for (y, line) in (area.top()..area.bottom()).zip(lines.iter().skip(scroll)) {
        render_line(app, &placed, line, Rect { y, ..area }, buffer);
    }
}

/// Returns the tables' layout for an area.
pub(super) fn placed(app: &App, area: Rect) -> Placed<'_> {
    app.sheet()
        .placed_in(area.width.into(), area.height.into(), app.glyphs())
}

/// Returns the number of lines of the tables and the number of visible ones.
pub(super) fn extent(app: &App, area: Rect) -> (usize, usize) {
    let area = below_title(app, area);
    (placed(app, area).line_count(), area.height.into())
}

/// Prints the title above tables of differences.
pub(super) fn title(app: &App, area: Rect, buffer: &mut Buffer) {
    if let Some(title) = app.difference_title(area.width.into()) {
        let title = cut(&shown(&title, app.glyphs()), area.width.into());
        let style = theme::part(ScreenPart::Quiet);
        print(buffer, area.x, area.y, area.width, &title, style);
    }
}

/// Returns the area below the tables' title, if they have one.
pub(super) fn below_title(app: &App, area: Rect) -> Rect {
    split(area, title_lines(app)).1
}

/// Returns the height of the tables' title.
pub(super) fn title_lines(app: &App) -> u16 {
    u16::from(app.compared().is_some())
}

/// Returns `true` if the row has no partner in the compared scene.
pub(super) fn is_alone(app: &App, line: &TableLine) -> bool {
    let Some(compared) = app.compared() else {
        return false;
    };
    match *line {
        TableLine::Row(sheet::SheetPart::Vectors, row, _) => !compared.pairing().has_vector(row),
        TableLine::Row(sheet::SheetPart::Points, row, _) => !compared.pairing().has_point(row),
        TableLine::Blank | TableLine::Names(..) | TableLine::Units(..) => false,
    }
}

/// Renders a line of the tables at the top of an area and returns it.
pub(super) fn render_line(
    app: &App,
    placed: &Placed<'_>,
    line: &TableLine,
    area: Rect,
    buffer: &mut Buffer,
) -> Line {
    let shown = match *line {
        TableLine::Row(part, row, _) if is_alone(app, line) => {
            placed.text_line((part, row), words().only_here())
        }
        _ => placed.show(line, app.tables()),
    };
    page::render_line((app.glyphs(), app.colours()), &shown, area, buffer);
    tint(app, line, &shown, area, buffer);
    shown
}

/// Colours the name of a vector like its link in the drawing.
fn tint(app: &App, line: &TableLine, shown: &Line, area: Rect, buffer: &mut Buffer) {
    let TableLine::Row(sheet::SheetPart::Vectors, row, _) = *line else {
        return;
    };
    if let (Some(role), Some(name)) = (app.open_scene().vector_role(row), shown.spans.first()) {
        let width = columns_of(name.text.chars().count()).min(area.width);
        let name = Rect::new(area.x, area.y, width, 1);
        buffer.set_style(name.intersection(buffer.area), theme::role(role.of_name()));
    }
}

/// Dims the unproved digits of a value. Without colours dim text may look like any other, so points
/// replace these digits. A value without any bound is then unmarked; the status line reports it.
pub(super) fn doubt(colours: Colours, figure: &Span, left: u16, area: Rect, buffer: &mut Buffer) {
    let digits = match &figure.unproved {
        UnprovedDigits::Nothing => return,
        UnprovedDigits::Last(digits) => digits.clone(),
        UnprovedDigits::Everything if colours == Colours::None => return,
        UnprovedDigits::Everything => 0..figure.text.len(),
    };
    for at in digits {
        let x = left.saturating_add(columns_of(at));
        if x >= area.right() {
            return;
        }
        let place = &mut buffer[(x, area.y)];
        place.set_style(theme::part(ScreenPart::UnprovedDigits));
        if colours == Colours::None && place.symbol().bytes().all(|b| b.is_ascii_digit()) {
            place.set_char(UNPROVED_DIGIT);
        }
    }
}

/// The character in place of an unproved digit that cannot be dimmed.
pub(super) const UNPROVED_DIGIT: char = '.';

/// Converts a width to columns, saturating.
pub(super) fn columns_of(width: usize) -> u16 {
    u16::try_from(width).unwrap_or(u16::MAX)
}
