//! All figures in columns, with a cursor on one of them. Where it is shows without colours and
//! attributes too: `>` before its row, brackets around the figure; `+` marks the points that are
//! chosen for the motion view.
//!
//! ```text
//!    point        x [mm]      y [mm]
//!    A             0.000       0.000
//! >+ C           318.197    [236.202]
//! ```

use super::pane::{Copied, List, Pane};
use super::table::{self, columns_of, render_line};
use super::{MARGIN, Sketch, columns, first_seen, print};
use crate::report::upwards;
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, Part};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::figures::cursor::seen;
use crate::tui::figures::sheet::{FOUND, Line, Part as Rows};
use crate::tui::views::motion::followed;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// All figures in columns.
pub(super) struct TablesView;

impl Pane for TablesView {
    fn name(&self) -> &'static str {
        "tables"
    }

    fn about(&self) -> &'static str {
        "All tables"
    }

    fn help_title(&self) -> &'static str {
        "In the tables"
    }

    fn list(&self) -> List {
        List::Figures
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let (lines, height) = lines(app, body);
        table::title(app, place(body), buffer);
        let body = table::below_title(app, place(body));
        let first = first_seen(app, lines.len(), body, buffer);
        for (y, at) in (body.top()..body.bottom()).zip(seen(&lines, first, height)) {
            let height = 1;
            let body = Rect { y, height, ..body };
            render_line(app, &lines[at], body, buffer);
            mark(app, &lines[at], body, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let (lines, height) = lines(app, body);
        (lines.len(), height)
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
        Some((FOUND, "found"))
    }

    /// How far the figure under the cursor can be from the truth.
    fn trust(&self, app: &App, _room: u16) -> Option<String> {
        let (sheet, tables, cursor) = (app.sheet(), app.tables(), app.cursor());
        let entries = sheet.entries(tables, cursor.part, cursor.row);
        let entry = entries.get(cursor.column).copied().flatten()?;
        let unit = sheet.unit(cursor.part, cursor.column)?;
        entry.value?;
        Some(match entry.bound {
            _ if entry.given => "given".into(),
            Some(bound) => format!("+-{} {unit}", upwards(bound, 1)),
            None => "no bound".into(),
        })
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Asked
    }
}

/// All lines of the tables at this width, and how many are seen.
pub(super) fn lines(app: &App, area: Rect) -> (Vec<Line>, usize) {
    let area = table::below_title(app, place(area));
    let lines = app.sheet().lines(area.width.into(), app.glyphs());
    (lines, area.height.into())
}

/// Where the figures stand: the marks to their left, the margin to their right.
fn place(area: Rect) -> Rect {
    Rect {
        x: area.x + MARKS,
        width: area.width.saturating_sub(MARKS + MARGIN),
        ..area
    }
}

/// The marks of the cursor and of what is chosen.
fn mark(app: &App, line: &Line, area: Rect, buffer: &mut Buffer) {
    let Line::Row(part, row, _) = line else {
        return;
    };
    let chosen = *part == Rows::Points && {
        let points = followed::moving(app.open_scene().scene(), *part, *row);
        points
            .iter()
            .any(|(point, _)| app.followed().contains(*point))
    };
    let key = theme::part(Part::Key);
    if chosen {
        print(buffer, area.x - 1, area.y, 1, CHOSEN, key);
    }
    let Some(cell) = app.cursor().cell_of(line) else {
        return;
    };
    print(buffer, area.x - MARKS, area.y, 1, ROW, key);
    if table::is_alone(app, line) {
        return;
    }
    let width = area.width.into();
    let (name, cells) = app.sheet().show(line, app.tables(), width, app.glyphs());
    let widths = cells.iter().take(cell + 1).map(|cell| cell.width);
    let right = name.width + widths.sum::<usize>();
    let right = area.x.saturating_add(columns_of(right));
    let Some(cell) = cells.get(cell).filter(|_| right <= area.right()) else {
        return;
    };
    let text = columns(&cell.text);
    let left = right.saturating_sub(text);
    // There is a blank at either side of every figure.
    print(buffer, left.saturating_sub(1), area.y, 1, "[", key);
    print(buffer, right, area.y, 1, "]", key);
    for x in left..right {
        buffer[(x, area.y)].set_style(theme::part(Part::Cursor));
    }
}

/// Columns at the left for the marks.
const MARKS: u16 = 2;
const ROW: &str = ">";
const CHOSEN: &str = "+";
