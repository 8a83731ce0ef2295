//! Motor view: the curve of the driver's effort over a cycle, with the values next to or below it.
//!
//! ```text
//! N m      * driver.torque 12.3    over driver.angle 60.00 deg
//!  1000 |          ..
//!     0 |..........  ...........
//! torque [N m]               all       loads     gravity
//!   largest              1133.76     1188.18     35.4129
//! ```

pub(crate) mod study;

use super::pane::{Copied, Pane};
use super::{Sketch, chart_and_list, inset, page, show, split, split_columns};
use crate::drawing::plot::{Plot, PlotStyle};
use crate::page::Line;
use crate::tui::app::{App, View};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Widths of the values: with all parts of the effort, and with its total only.
const WIDE: u16 = 66;
const NARROW: u16 = 42;
/// Minimum width of a curve next to the values; on a narrower screen the curve is above them.
const MIN_CURVE: u16 = 44;
/// Blanks between the curve and the values.
const GAP: u16 = 2;
/// Minimum and maximum height of a curve above the values, which takes two fifths of the area.
const ROWS_ABOVE: (u16, u16) = (5, 16);

/// Returns the areas of the curve and of the values.
fn arrange(app: &App, area: Rect) -> (Rect, Rect) {
    if app.views.motor.plot().is_none() {
        return (split(area, 0).0, inset(area));
    }
    let (minimum, maximum) = ROWS_ABOVE;
    let rows = (area.height * 2 / 5).clamp(minimum, maximum);
    let (curve, list) = chart_and_list(area, &[WIDE, NARROW], MIN_CURVE, rows);
    let gap = if curve.width < area.width { GAP } else { 0 };
    (
        split_columns(curve, curve.width.saturating_sub(gap)).0,
        list,
    )
}

/// The motor view: the motor's duty over a cycle.
pub(super) struct MotorView;

impl Pane for MotorView {
    fn view(&self) -> View {
        View::Motor
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let acts = app.open_scene().solver().has_forces();
        (!acts).then(|| words().nothing_acts_in_short())
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        if let Some(plot) = app.views.motor.plot() {
            render_curve(app, plot, arrange(app, body).0, buffer);
        }
        let (lines, list) = self.listed(app, body);
        page::render(app, self.view(), &lines, list, buffer);
    }

    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        let list = arrange(app, body).1;
        (lines(app, list), list)
    }

    fn copy(&self, app: &App) -> Copied {
        app.views
            .motor
            .text(true)
            .map_or(Copied::Nothing, Copied::Text)
    }

    fn csv(&self, app: &App) -> Result<String, String> {
        let motor = &app.views.motor;
        motor.csv(app.csv_dialect()).ok_or_else(|| motor.nothing())
    }

    fn svg(&self, app: &App) -> Result<(&'static str, String), String> {
        let motor = &app.views.motor;
        let text = motor.svg(app.open_scene()).ok_or_else(|| motor.nothing())?;
        Ok((words().the_curve(), text))
    }

    fn file_part(&self) -> Option<&'static str> {
        Some(self.view().name())
    }
}

fn lines(app: &App, list: Rect) -> Vec<Line> {
    let page = app.views.motor.page();
    page.map_or_else(Vec::new, |page| page::lines(app, page, list))
}

fn render_curve(app: &App, plot: &Plot, area: Rect, buffer: &mut Buffer) {
    let look = PlotStyle {
        cols: area.width,
        rows: area.height,
        glyphs: app.glyphs(),
        aspect: app.aspect(),
        extrema: true,
        first: 0,
    };
    let here = app.views.motor.here(app.open_scene());
    let raster = plot.render(&look, here.as_ref());
    show(&raster, area, buffer);
}
