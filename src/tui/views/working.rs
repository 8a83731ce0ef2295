//! Working view: the derivation of the current state's values, line by line.
//!
//! ```text
//! 4.2 Group 2, dyad RRR at C: links r3, r4
//! With m from B to D, and C where the two arms meet:
//!   m = sqrt(mx^2 + my^2) = 360.555 mm
//! ```

use super::page;
use super::pane::{Copied, Pane};
use crate::page::{Line, Page};
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::tui::player::solution_cache::Explained;
use crate::wording::words;
use ratatui::layout::Rect;

/// The working view: the derivation of the values, line by line.
pub(super) struct WorkingView;

impl Pane for WorkingView {
    fn view(&self) -> View {
        View::Working
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let too_many = !Explained::is_possible(app.open_scene().scene());
        too_many.then(|| words().too_many_links())
    }

    fn lines(&self, app: &App, area: Rect) -> Vec<Line> {
        match app.views.working.get() {
            Some(explained) => page::lines(app, explained.page(), area),
            None => page::words(words().too_many_links(), area),
        }
    }

    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            Action::MOTION,
            Action::LineDown,
            Action::Quit,
            Action::NextPart,
            Action::Search,
            Action::Copy,
            Action::Play,
        ]
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Lines
    }

    fn page<'a>(&self, app: &'a App) -> Option<(&'static str, &'a Page)> {
        let explained = app.views.working.get()?;
        Some((words().the_working(), explained.page()))
    }
}
