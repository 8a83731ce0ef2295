//! Speed against error: the chart, and beside or below it the methods by their letters.
//!
//! ```text
//! error                              method               time   error
//!  1e-8|   e..                     a*closed form       71.0 ns 2.4e-16
//! 1e-16|     a....c                b Newton from anchors
//!      +--+-------+----              not needed: every group has ..
//! ```

pub(crate) mod study_run;

use super::pane::{Copied, Need, Pane};
use super::{MARGIN, Sketch, inset, page, show};
use crate::drawing::trade_off;
use crate::page::{Line, Page};
use crate::report::{Accuracy, StudyMeasure};
use crate::study::Findings;
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::tui::views::accuracy::study_run::Phase;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns of the list: with time and error of position, and with all that there is.
const NARROW: u16 = 37;
const WIDE: u16 = 59;
/// A chart beside the list has at least so many columns; below that it stands above.
const LEAST_CHART: u16 = 34;
/// Where it stands above, it takes half the height, but within these rows.
const ROWS_ABOVE: (u16, u16) = (7, 18);

/// Where the parts of the view are.
struct AccuracyAreas {
    chart: Rect,
    list: Rect,
}

fn arrange(area: Rect) -> AccuracyAreas {
    let sides = 1 + MARGIN;
    let beside = |list: u16| {
        area.width
            .checked_sub(list + sides)
            .filter(|&w| w >= LEAST_CHART)
    };
    let both = |width: u16| AccuracyAreas {
        chart: Rect { width, ..area },
        list: inset(Rect {
            x: area.x + width,
            width: area.width - width,
            ..area
        }),
    };
    if let Some(width) = beside(WIDE).or(beside(NARROW)) {
        return both(width);
    }
    let (least, most) = ROWS_ABOVE;
    let height = (area.height / 2).clamp(least, most).min(area.height);
    AccuracyAreas {
        chart: Rect { height, ..area },
        list: inset(Rect {
            y: area.y + height,
            height: area.height - height,
            ..area
        }),
    }
}

/// Speed against error.
pub(super) struct AccuracyView;

impl Pane for AccuracyView {
    fn name(&self) -> &'static str {
        "accuracy"
    }

    fn view(&self) -> View {
        View::Accuracy
    }

    fn about(&self) -> &'static str {
        words().accuracy_of_methods()
    }

    fn help_title(&self) -> &'static str {
        words().in_the_accuracy_view()
    }

    fn needs(&self) -> Need {
        Need::Study
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let Some(findings) = app.study_run().findings() else {
            return;
        };
        render_chart(app, findings, arrange(body).chart, buffer);
        let (lines, list) = self.listed(app, body);
        page::render(app, self.view(), &lines, list, buffer);
    }

    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        let list = arrange(body).list;
        let findings = app.study_run().findings();
        let lines = findings.map_or_else(Vec::new, |findings| lines(app, findings, list));
        (lines, list)
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Lines
    }

    fn hints(&self, app: &App) -> &'static [Action] {
        match app.study_run().phase() {
            Phase::Running => &[
                Action::Help,
                Action::Back,
                Action::LineDown,
                Action::MOTION,
                Action::Quit,
            ],
            Phase::Idle | Phase::Stopped | Phase::Done => &[
                Action::Help,
                Action::Look(View::Accuracy),
                Action::LineDown,
                Action::MOTION,
                Action::Quit,
            ],
        }
    }

    fn progress(&self, app: &App) -> Option<String> {
        let percent = (app.study_run().progress() * 100.0).floor();
        match app.study_run().phase() {
            Phase::Idle => None,
            Phase::Running => Some(words().measuring(&format!("{percent:>2}"))),
            Phase::Stopped => Some(words().stopped_at(&percent)),
            Phase::Done => Some(words().all_measured().into()),
        }
    }
}

fn render_chart(app: &App, findings: &Findings, area: Rect, buffer: &mut Buffer) {
    let raster = trade_off(findings).render(area.width, area.height, app.glyphs());
    show(&raster, area, buffer);
}

/// The methods by their letters: what is most asked for where there is little room.
fn lines(app: &App, findings: &Findings, list: Rect) -> Vec<Line> {
    let measures: &[StudyMeasure] = match list.width >= WIDE {
        true => &[
            StudyMeasure::Time,
            StudyMeasure::Position,
            StudyMeasure::Velocity,
            StudyMeasure::Acceleration,
            StudyMeasure::Failures,
        ],
        false => &[StudyMeasure::Time, StudyMeasure::Position],
    };
    let scene = app.open_scene().scene();
    let accuracy = Accuracy { scene, findings };
    let mut table = accuracy.table(measures);
    // Both figures have room on the smallest screen.
    (table.setting.gap, table.setting.names) = (1, 0);
    let mut page = Page::default();
    page.table(table);
    page::lines(app, &page, list)
}
