//! The views of the driver's motion while a point leads.

use super::page;
use super::pane::Pane;
use crate::page::Line;
use crate::tui::app::{App, View};
use crate::wording::words;
use ratatui::layout::Rect;

/// A view that shows only the driver's motion.
struct DriverOnly(View);

/// Returns the pane that shows a view while a point leads.
pub(super) fn pane(view: View) -> &'static dyn Pane {
    match view {
        View::Motion | View::Tables | View::Forces | View::Scene => view.pane(),
        View::Plots => &DriverOnly(View::Plots),
        View::Accuracy => &DriverOnly(View::Accuracy),
        View::Lengths => &DriverOnly(View::Lengths),
        View::Working => &DriverOnly(View::Working),
        View::Motor => &DriverOnly(View::Motor),
        View::Polygons => &DriverOnly(View::Polygons),
    }
}

impl Pane for DriverOnly {
    fn view(&self) -> View {
        self.0
    }

    fn nothing(&self, _app: &App) -> Option<&'static str> {
        Some(words().shows_the_driver_only())
    }

    fn lines(&self, _app: &App, area: Rect) -> Vec<Line> {
        page::words(words().shows_the_driver_only(), area)
    }

    fn csv(&self, _app: &App) -> Result<String, String> {
        Err(words().shows_the_driver_only().to_owned())
    }
}
