//! What the given lengths do to the figures: a view of its own, since it is another kind of error than
//! that of the tables.
//!
//! ```text
//!  change for 1 mm               in every length     in one  in which
//!  r3.angle [deg]                          0.843      0.193  r4.length
//! ```

use super::pane::{Need, Pane};
use super::{Sketch, inset, page};
use crate::page::{Content, Line, Page};
use crate::report::Answers;
use crate::tui::app::App;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Narrower views leave out the units, and by how much a figure follows the length that matters most.
const ROOM_FOR_UNITS: u16 = 56;

/// What each length does.
pub(super) struct LengthsView;

impl Pane for LengthsView {
    fn name(&self) -> &'static str {
        "lengths"
    }

    fn about(&self) -> &'static str {
        "What each length does"
    }

    fn help_title(&self) -> &'static str {
        "In the lengths view"
    }

    fn needs(&self) -> Need {
        Need::Lengths
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let area = inset(body);
        let (head, rows) = lines(app, area);
        if let Some(head) = head {
            page::render_line((app.glyphs(), app.colours()), &head, area, buffer);
            page::render(app, &rows, below_head(area), buffer);
        } else {
            page::render(app, &rows, area, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let area = inset(body);
        let (_, rows) = lines(app, area);
        (rows.len(), below_head(area).height.into())
    }
}

fn below_head(area: Rect) -> Rect {
    Rect {
        y: area.y + 1,
        height: area.height.saturating_sub(1),
        ..area
    }
}

/// The names of the columns, which stay where they are, and the rows below them; or words in their place.
fn lines(app: &App, area: Rect) -> (Option<Line>, Vec<Line>) {
    let Some(answers) = app.open_scene().answers() else {
        return (None, page::words(TOO_MANY, area));
    };
    let has_head = answers.list.is_some();
    let mut page = Page::default();
    page.add(content(answers, area));
    let mut lines = page::lines(app, &page, area);
    let head = (has_head && !lines.is_empty()).then(|| lines.remove(0));
    (head, lines)
}

fn content(answers: &Answers, area: Rect) -> Content {
    let short = answers
        .short_table()
        .filter(|_| area.width < ROOM_FOR_UNITS);
    short.map_or_else(|| answers.content(true), Content::Table)
}

const TOO_MANY: &str = "too many lengths: krank table --sensitivity tells what they do";
