//! Lengths view: the sensitivity of the results to the given lengths. It is separate from the
//! tables because these errors differ from rounding errors.
//!
//! ```text
//!  change for 1 mm               in every length     in one  in which
//!  r3.angle [deg]                          0.843      0.193  r4.length
//! ```

use super::pane::{Copied, Need, Pane};
use super::{Sketch, inset, page};
use crate::page::{Content, Line, Page, Row, cut};
use crate::report::Answers;
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Minimum width for units and for the largest single influence.
const ROOM_FOR_UNITS: u16 = 56;
/// The name of a length takes at most `1 / SHARE` of the width.
const SHARE: u16 = 3;

/// The lengths view: the effect of each length.
pub(super) struct LengthsView;

impl Pane for LengthsView {
    fn name(&self) -> &'static str {
        "lengths"
    }

    fn view(&self) -> View {
        View::Lengths
    }

    fn about(&self) -> &'static str {
        words().lengths_and_figures()
    }

    fn help_title(&self) -> &'static str {
        words().in_the_lengths_view()
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let too_many = app.open_scene().has_too_many_lengths();
        too_many.then(|| words().too_many_lengths())
    }

    fn is_timed(&self, _app: &App) -> bool {
        false
    }

    fn needs(&self) -> Need {
        Need::Lengths
    }

    fn hints(&self, app: &App) -> &'static [Action] {
        match app.open_scene().tolerance_answers() {
            Some(_) => &[
                Action::Help,
                Action::Tolerance,
                Action::MOTION,
                Action::LineDown,
                Action::Quit,
                Action::Play,
                Action::StepForward,
            ],
            None => &[
                Action::Help,
                Action::MOTION,
                Action::LineDown,
                Action::Quit,
                Action::Play,
                Action::StepForward,
            ],
        }
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let area = inset(body);
        let (head, rows) = lines(app, area);
        if let Some(head) = &head {
            page::render_line((app.glyphs(), app.colours()), head, area, buffer);
        }
        page::render(app, self.view(), &rows, below(head.as_ref(), area), buffer);
    }

    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        let area = inset(body);
        let (head, rows) = lines(app, area);
        (rows, below(head.as_ref(), area))
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Lines
    }
}

/// Returns the area of the rows, below a fixed head line if there is one.
fn below(head: Option<&Line>, area: Rect) -> Rect {
    let head = u16::from(head.is_some());
    Rect {
        y: area.y + head,
        height: area.height.saturating_sub(head),
        ..area
    }
}

/// Returns the fixed head line of the only table, if there is one, and the rows; or a message.
fn lines(app: &App, area: Rect) -> (Option<Line>, Vec<Line>) {
    let Some(answers) = app.open_scene().answers() else {
        return (None, page::words(words().too_many_lengths(), area));
    };
    if let Some(told) = app.open_scene().told_tolerance() {
        return (None, page::lines(app, &told.page(), area));
    }
    let mut page = Page::default();
    if let Some(off) = app.open_scene().tolerance_answers() {
        page.table(off.table());
    }
    page.add(content(answers, area));
    let mut lines = page::lines(app, &page, area);
    // Two tables are separated by a blank line; their heads must then scroll with the rows.
    let is_whole = answers.list.is_some() && lines.iter().all(|line| !line.spans.is_empty());
    let head = (is_whole && !lines.is_empty()).then(|| lines.remove(0));
    (head, lines)
}

fn content(answers: &Answers, area: Rect) -> Content {
    let short = answers
        .short_table()
        .filter(|_| area.width < ROOM_FOR_UNITS);
    let mut content = short.map_or_else(|| answers.content(true), Content::Table);
    if let Content::Table(table) = &mut content {
        let most = usize::from(area.width / SHARE);
        table.rows.iter_mut().for_each(|row| shorten(row, most));
    }
    content
}

/// Cuts the name of a length in the row's last cell.
fn shorten(row: &mut Row, most: usize) {
    if let Row::Figures { cells, .. } = row
        && let Some(Some(length)) = cells.last_mut()
    {
        length.text = cut(&length.text, most);
    }
}
