//! The working shown: how the figures of the present state come about, line by line.
//!
//! ```text
//! 4.2 Group 2, dyad RRR at C: links r3, r4
//! With m from B to D, and C where the two arms meet:
//!   m = sqrt(mx^2 + my^2) = 360.555 mm
//! ```

use super::pane::{Need, Pane};
use super::{Sketch, first_seen, inset, print};
use crate::drawing::Glyphs;
use crate::report::{LineKind, TextStyle, wrapped};
use crate::tui::app::App;
use crate::tui::appearance::theme::{self, Part};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// The working, line by line.
pub(super) struct WorkingView;

impl Pane for WorkingView {
    fn name(&self) -> &'static str {
        "working"
    }

    fn about(&self) -> &'static str {
        "The working, line by line"
    }

    fn help_title(&self) -> &'static str {
        "In the working"
    }

    fn needs(&self) -> Need {
        Need::Working
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let area = inset(body);
        let lines = lines(app, area);
        let first = first_seen(app, lines.len(), area, buffer);
        let seen = lines.iter().skip(first);
        for (y, (kind, line)) in (area.top()..area.bottom()).zip(seen) {
            let style = theme::part(match kind {
                LineKind::Title | LineKind::Part => Part::Title,
                LineKind::Section => Part::Name,
                LineKind::Head => Part::Quiet,
                LineKind::Body => Part::Text,
            });
            print(buffer, area.x, y, area.width, line, style);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let area = inset(body);
        (lines(app, area).len(), area.height.into())
    }
}

fn lines(app: &App, area: Rect) -> Vec<(LineKind, String)> {
    let width = usize::from(area.width);
    let Some(explained) = app.open_scene().explained() else {
        let lines = wrapped(TOO_MANY, width).into_iter();
        return lines.map(|line| (LineKind::Body, line)).collect();
    };
    let style = TextStyle {
        // Console fonts have no Greek letters.
        ascii: app.glyphs() != Glyphs::Braille,
        width,
    };
    let lines = explained.document().lines(style).into_iter();
    // The title stands above the view already.
    let own = lines.skip_while(|(kind, line)| *kind == LineKind::Title || line.is_empty());
    own.collect()
}

const TOO_MANY: &str = "too many links to follow here: krank explain writes all of it";
