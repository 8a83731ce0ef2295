//! The working shown: how the figures of the present state come about, line by line.
//!
//! ```text
//! 4.2 Group 2, dyad RRR at C: links r3, r4
//! With m from B to D, and C where the two arms meet:
//!   m = sqrt(mx^2 + my^2) = 360.555 mm
//! ```

use super::page;
use super::pane::{Need, Pane};
use crate::page::Line;
use crate::tui::app::App;
use crate::wording::words;
use ratatui::layout::Rect;

/// The working, line by line.
pub(super) struct WorkingView;

impl Pane for WorkingView {
    fn name(&self) -> &'static str {
        "working"
    }

    fn about(&self) -> &'static str {
        words().working_line_by_line()
    }

    fn help_title(&self) -> &'static str {
        words().in_the_working()
    }

    fn needs(&self) -> Need {
        Need::Working
    }

    fn lines(&self, app: &App, area: Rect) -> Vec<Line> {
        match app.open_scene().explained() {
            Some(explained) => page::lines(app, explained.page(), area),
            None => page::words(words().too_many_links(), area),
        }
    }
}
