//! Accuracy view: a chart of speed against error, with the list of methods next to or below it.
//!
//! ```text
//! error                              method               time   error
//!  1e-8|   e..                     a*closed form       71.0 ns 2.4e-16
//! 1e-16|     a....c                b Newton from anchors
//!      +--+-------+----              not needed: every group has ..
//! ```

pub(crate) mod study_run;

use super::pane::{Copied, Pane};
use super::{MARGIN, Sketch, chart_and_list, inset, page, show};
use crate::drawing::{convergence, trade_off};
use crate::page::{Line, Page};
use crate::report::{Accuracy, PositionMethod, StudyMeasure};
use crate::study::Findings;
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::tui::player::current_results::LiveResult;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::watched_method::WatchedMethod;
use crate::tui::views::accuracy::study_run::Phase;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Widths of the list in columns: with time and position error only, and with every measure.
const NARROW: u16 = 37;
const WIDE: u16 = 59;
/// Minimum width of a chart next to the list; on a narrower screen the chart is above the list.
const MIN_CHART: u16 = 34;
/// Minimum and maximum height of a chart above the list, which takes half of the area.
const ROWS_ABOVE: (u16, u16) = (7, 18);

/// Returns the areas of the chart and of the list.
fn arrange(area: Rect) -> (Rect, Rect) {
    let (minimum, maximum) = ROWS_ABOVE;
    let rows = (area.height / 2).clamp(minimum, maximum);
    chart_and_list(area, &[WIDE, NARROW], MIN_CHART, rows)
}

/// Width of the table of iterations. The chart is next to it on a wide screen and above it on a
/// high one.
const ITERATIONS: u16 = 80;
const MIN_HEIGHT: u16 = 18;
const CHART_ROWS: u16 = 8;

/// Returns the areas of a watched method: its convergence chart, if there are errors to plot and the
/// screen is large enough, and its table of iterations.
fn method_areas(watched: &WatchedMethod, area: Rect) -> (Option<Rect>, Rect) {
    let is_wide = area.width >= ITERATIONS + 1 + MARGIN + MIN_CHART;
    if watched.curves().is_empty() || !(is_wide || area.height >= MIN_HEIGHT) {
        return (None, inset(area));
    }
    let rows = CHART_ROWS.max(area.height / 3);
    let (chart, list) = chart_and_list(area, &[ITERATIONS], MIN_CHART, rows);
    (Some(chart), list)
}

/// The method whose iterations replace the study's display, if any.
#[derive(Debug, Default)]
pub(crate) struct MethodWatch {
    pub(crate) method: Option<PositionMethod>,
    /// The initial guess, as typed.
    pub(crate) guess: String,
    result: LiveResult<WatchedMethod>,
}

impl MethodWatch {
    /// Watches a method from its default guess, or none.
    pub(crate) fn select(&mut self, method: Option<PositionMethod>) {
        *self = MethodWatch {
            method,
            ..MethodWatch::default()
        };
    }

    /// Sets the initial guess.
    ///
    /// # Errors
    /// Returns a message if the guess is invalid for this scene; the previous one then stays.
    pub(crate) fn set_guess(&mut self, guess: &str, open_scene: &OpenScene) -> Result<(), String> {
        if let Some(watched) = self.result.get_mut() {
            watched.set_guess(guess, open_scene)?;
        }
        guess.clone_into(&mut self.guess);
        Ok(())
    }

    /// Runs the method at the driver's position while the view is visible.
    pub(super) fn refresh(&mut self, is_visible: bool, open_scene: &OpenScene) {
        let guess = &self.guess;
        let method = self.method.filter(|_| is_visible);
        let watch = |open_scene: &OpenScene| WatchedMethod::new((method?, guess), open_scene);
        let result = &mut self.result;
        result.refresh(method.is_some(), open_scene, watch, WatchedMethod::go);
    }

    /// Returns the iterations, if the scene is not too large.
    pub(crate) fn watched(&self) -> Option<&WatchedMethod> {
        self.result.get()
    }
}

/// The accuracy view: speed against error.
pub(super) struct AccuracyView;

impl Pane for AccuracyView {
    fn view(&self) -> View {
        View::Accuracy
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let is_missing = app.is_watching() && app.views.method.watched().is_none();
        is_missing.then(|| words().too_many_links())
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        match (app.views.method.watched(), app.views.study_run.findings()) {
            (Some(watched), _) => {
                if let Some(area) = method_areas(watched, body).0 {
                    let chart = convergence(watched.curves());
                    let raster = chart.render(area.width, area.height, app.glyphs());
                    show(&raster, area, buffer);
                }
            }
            (None, Some(findings)) => render_chart(app, findings, arrange(body).0, buffer),
            (None, None) => return,
        }
        let (lines, list) = self.listed(app, body);
        page::render(app, self.view(), &lines, list, buffer);
    }

    fn listed(&self, app: &App, body: Rect) -> (Vec<Line>, Rect) {
        if let Some(watched) = app.views.method.watched() {
            let list = method_areas(watched, body).1;
            return (page::lines(app, watched.page(), list), list);
        }
        let list = arrange(body).1;
        let findings = app.views.study_run.findings();
        let lines = findings.map_or_else(Vec::new, |findings| lines(app, findings, list));
        (lines, list)
    }

    fn copy(&self, _app: &App) -> Copied {
        Copied::Lines
    }

    fn hints(&self, app: &App) -> &'static [Action] {
        if app.is_watching() {
            return &[
                Action::Help,
                Action::Guess,
                Action::Method,
                Action::Back,
                Action::LineDown,
                Action::StepForward,
                Action::Quit,
            ];
        }
        match app.views.study_run.phase() {
            Phase::Running => &[
                Action::Help,
                Action::Back,
                Action::Method,
                Action::LineDown,
                Action::MOTION,
                Action::Quit,
            ],
            Phase::Idle | Phase::Stopped | Phase::Done => &[
                Action::Help,
                Action::Look(View::Accuracy),
                Action::Method,
                Action::LineDown,
                Action::MOTION,
                Action::Quit,
            ],
        }
    }

    fn progress(&self, app: &App) -> Option<String> {
        if let Some(watched) = app.views.method.watched() {
            return Some(watched.method().title().into());
        }
        let percent = (app.views.study_run.progress() * 100.0).floor();
        match app.views.study_run.phase() {
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

/// Returns the lines of the methods' table; a narrow list shows only time and position error.
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
    // Without a minimum name width and with the smallest gap, both values fit on the smallest
    // screen.
    (table.setting.gap, table.setting.names) = (1, 0);
    let mut page = Page::default();
    page.table(table);
    page::lines(app, &page, list)
}
