//! Tables view: all values in columns, with a cursor on one of them. The cursor is visible without
//! colours and attributes: `>` before its row, brackets around the value. `+` marks the points
//! selected for the motion view.
//!
//! ```text
//!    point        x [mm]      y [mm]
//!    A             0.000       0.000
//! >+ C           318.197    [236.202]
//! ```

use super::pane::{Copied, Listing, Pane, PaneSpot};
use super::table::{self, columns_of, render_line};
use super::{MARGIN, Sketch, columns, first_visible_line, print};
use crate::page::Line;
use crate::quantity::Subject;
use crate::report::perpendicular_up;
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::figures::cursor::visible_lines;
use crate::tui::figures::rows::subject_of;
use crate::tui::figures::sheet::{COMPUTED_MARK, SheetPart, TableLine};
use crate::tui::views::motion::tracked_points;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// The tables view: all values in columns.
pub(super) struct TablesView;

impl Pane for TablesView {
    fn view(&self) -> View {
        View::Tables
    }

    fn list(&self) -> Listing {
        Listing::Figures
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        table::title(app, place(body), buffer);
        let body = table::below_title(app, place(body));
        let placed = table::placed(app, body);
        let lines = placed.lines();
        let first = first_visible_line(
            app.views.scroll[self.view() as usize],
            lines.len(),
            body,
            buffer,
        );
        let seen = visible_lines(&lines, first, body.height.into());
        for (y, at) in (body.top()..body.bottom()).zip(seen) {
            let body = Rect { y, ..body };
            let shown = render_line(app, &placed, &lines[at], body, buffer);
            mark(app, &lines[at], &shown, body, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let (lines, height) = lines(app, body);
        (lines.len(), height)
    }

    fn subject(&self, app: &App) -> Option<Subject> {
        let cursor = app.views.cursor;
        subject_of(app.open_scene().scene(), cursor.part, cursor.row)
    }

    fn under(&self, app: &App, body: Rect, at: Position) -> Option<PaneSpot> {
        let area = table::below_title(app, place(body));
        let lines = table::placed(app, area).lines();
        let maximum = lines.len().saturating_sub(area.height.into());
        let first = app.views.scroll[self.view() as usize].min(maximum);
        let seen = visible_lines(&lines, first, area.height.into());
        let line = seen.get(usize::from(at.y.checked_sub(area.y)?))?;
        match lines.get(*line)? {
            TableLine::Row(part, row, _) => Some(PaneSpot::Figure(*part, *row)),
            TableLine::Names(..) | TableLine::Units(..) | TableLine::Blank => None,
        }
    }

    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            Action::Search,
            Action::Copy,
            Action::MOTION,
            Action::Tables(TablesAction::Choose),
            Action::Csv,
            Action::Quit,
        ]
    }

    fn legend(&self) -> Option<(char, &'static str)> {
        Some((COMPUTED_MARK, words().found()))
    }

    /// Returns the error bound of the selected value.
    fn trust(&self, app: &App, _room: u16) -> Option<String> {
        let (sheet, tables, cursor) = (app.sheet(), app.tables(), app.views.cursor);
        let entries = sheet.entries(tables, cursor.part, cursor.row);
        let entry = entries.get(cursor.column).copied().flatten()?;
        let unit = sheet.unit(cursor.part, cursor.column)?;
        entry.value?;
        Some(match entry.display_bound() {
            _ if entry.given => words().given().into(),
            Some(bound) => format!("+-{} {unit}", perpendicular_up(bound, 1)),
            None => words().no_bound().into(),
        })
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Asked
    }
}

/// Returns the lines of the tables for an area and the number of visible ones.
pub(super) fn lines(app: &App, area: Rect) -> (Vec<TableLine>, usize) {
    let area = table::below_title(app, place(area));
    (table::placed(app, area).lines(), area.height.into())
}

/// Returns the minimum number of lines at a width, with the title.
pub(super) fn min_lines(app: &App, width: u16) -> usize {
    let area = place(Rect::new(0, 0, width, 1));
    let placed = app.sheet().dense(area.width.into(), app.glyphs());
    placed.line_count() + usize::from(table::title_lines(app))
}

/// Returns the area of the values, between the marks to their left and the margin to their right.
fn place(area: Rect) -> Rect {
    Rect {
        x: area.x + MARKS,
        width: area.width.saturating_sub(MARKS + MARGIN),
        ..area
    }
}

/// Draws the marks of the cursor and of selected points.
fn mark(app: &App, line: &TableLine, shown: &Line, area: Rect, buffer: &mut Buffer) {
    let TableLine::Row(part, row, _) = line else {
        return;
    };
    let chosen = *part == SheetPart::Points && {
        let points = tracked_points::moving(app.open_scene().scene(), *part, *row);
        points
            .iter()
            .any(|(point, _)| app.views.followed.contains(*point))
    };
    let key = theme::part(ScreenPart::Key);
    if chosen {
        print(buffer, area.x - 1, area.y, 1, CHOSEN, key);
    }
    // If keys go to another view, this one has no cursor.
    let cursor = (app.view() == View::Tables).then_some(app.views.cursor);
    let Some(cell) = cursor.and_then(|cursor| cursor.cell_of(line)) else {
        return;
    };
    print(buffer, area.x - MARKS, area.y, 1, ROW, key);
    if table::is_alone(app, line) {
        return;
    }
    // The name is the first span, the values follow.
    let Some(figure) = shown.spans.get(1 + cell) else {
        return;
    };
    let left = area.x.saturating_add(columns_of(figure.at));
    let right = left.saturating_add(columns(&figure.text));
    if right > area.right() {
        return;
    }
    // Each value has a blank on both sides. If its neighbour begins right behind that blank, a
    // bracket would touch it.
    let beyond = [left.checked_sub(2), Some(right.saturating_add(1))];
    let is_blank =
        |x: u16| !area.contains((x, area.y).into()) || buffer[(x, area.y)].symbol() == " ";
    if beyond.into_iter().flatten().all(is_blank) {
        print(buffer, left.saturating_sub(1), area.y, 1, "[", key);
        print(buffer, right, area.y, 1, "]", key);
    }
    for x in left..right {
        buffer[(x, area.y)].set_style(theme::part(ScreenPart::Cursor));
    }
}

/// Columns at the left for the marks.
const MARKS: u16 = 2;
const ROW: &str = ">";
const CHOSEN: &str = "+";
