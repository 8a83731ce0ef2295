//! Speed against error: the chart, and beside or below it the methods by their letters.
//!
//! ```text
//! error                              method               time   error
//!  1e-8|   e..                     a*closed form       71.0 ns 2.4e-16
//! 1e-16|     a....c                b Newton from anchors
//!      +--+-------+----              not needed: every group has ..
//! ```

pub(crate) mod study_run;

use super::pane::{Need, Pane};
use super::{MARGIN, Sketch, columns, first_seen, inset, print, print_right, show};
use crate::drawing::trade_off;
use crate::report::{TIME_DIGITS, error_text, method_name, time_text, unfit_text};
use crate::study::{Errors, Figures, Finding, Findings, Verdict};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, Part};
use crate::tui::commands::action::Action;
use crate::tui::player::open_scene::shown;
use crate::tui::views::accuracy::study_run::Phase;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Columns of a letter and its mark, of a name, and of a figure with the blank before it.
const KEY: u16 = 2;
const NAME: u16 = 19;
const FIGURE: u16 = 8;
/// A line of the list: with time and error of position, and with all that there is.
const NARROW: u16 = KEY + NAME + 2 * FIGURE;
const WIDE: u16 = NARROW + 3 * FIGURE;
/// A chart beside the list has at least so many columns; below that it stands above.
const LEAST_CHART: u16 = 34;
/// Where it stands above, it takes half the height, but within these rows.
const ROWS_ABOVE: (u16, u16) = (7, 18);

/// Where the parts of the view are.
struct Arrangement {
    chart: Rect,
    list: Rect,
}

fn arrange(area: Rect) -> Arrangement {
    let sides = 1 + MARGIN;
    let beside = |list: u16| {
        area.width
            .checked_sub(list + sides)
            .filter(|&w| w >= LEAST_CHART)
    };
    let both = |width: u16| Arrangement {
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
    Arrangement {
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

    fn about(&self) -> &'static str {
        "Speed against error"
    }

    fn help_title(&self) -> &'static str {
        "In the accuracy view"
    }

    fn needs(&self) -> Need {
        Need::Study
    }

    fn render(&self, app: &App, _sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let Some(findings) = app.study_run().findings() else {
            return;
        };
        let Arrangement { chart, list } = arrange(body);
        render_chart(app, findings, chart, buffer);
        let lines = lines(app, findings, list.width);
        let first = first_seen(app, lines.len(), list, buffer);
        for (y, line) in (list.top()..list.bottom()).zip(lines.iter().skip(first)) {
            line.render(
                Rect {
                    y,
                    height: 1,
                    ..list
                },
                buffer,
            );
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let list = arrange(body).list;
        let findings = app.study_run().findings();
        let lines = findings.map_or(0, |findings| lines(app, findings, list.width).len());
        (lines, list.height.into())
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
            Phase::Running => Some(format!("measuring {percent:>2} %")),
            Phase::Stopped => Some(format!("stopped at {percent} %")),
            Phase::Done => Some("all measured".into()),
        }
    }
}

fn render_chart(app: &App, findings: &Findings, area: Rect, buffer: &mut Buffer) {
    let raster = trade_off(findings).render(area.width, area.height, app.glyphs());
    show(&raster, area, buffer);
}

/// A line of the list.
struct Line {
    key: String,
    name: String,
    figures: Vec<String>,
    part: Part,
}

fn lines(app: &App, findings: &Findings, width: u16) -> Vec<Line> {
    let is_wide = width >= WIDE;
    let mut lines = vec![heading(is_wide)];
    for finding in &findings.methods {
        lines.push(line(finding, is_wide));
        if let Verdict::Unfit(unfit) = finding.verdict {
            let reason = unfit_text(unfit, app.open_scene().scene());
            lines.extend(told(
                &shown(&reason, app.glyphs()),
                width.saturating_sub(KEY),
            ));
        }
    }
    lines
}

fn heading(is_wide: bool) -> Line {
    let narrow = ["time", "error"];
    let wide = ["time", "pos", "vel", "acc", "fail"];
    let titles = if is_wide { &wide[..] } else { &narrow[..] };
    Line {
        key: String::new(),
        name: "method".into(),
        figures: titles.iter().map(|&title| title.to_owned()).collect(),
        part: Part::Quiet,
    }
}

fn line(finding: &Finding, is_wide: bool) -> Line {
    let best = if finding.best { '*' } else { ' ' };
    let figures = match &finding.verdict {
        Verdict::Measured(figures) => cells(figures, is_wide),
        Verdict::Unfit(_) => Vec::new(),
        Verdict::Pending => vec!["..".into()],
    };
    Line {
        key: format!("{}{best}", finding.key),
        name: method_name(finding.method),
        figures,
        part: Part::Text,
    }
}

fn cells(figures: &Figures, is_wide: bool) -> Vec<String> {
    let time = figures
        .time
        .map_or("-".into(), |time| time_text(time.median, TIME_DIGITS));
    let error = |part: fn(&Errors) -> f64| {
        let error = figures.errors.as_ref().map(part);
        error.map_or("-".into(), error_text)
    };
    let position = error(|e| e.position);
    if !is_wide {
        return vec![time, position];
    }
    let rates = [error(|e| e.velocity), error(|e| e.acceleration)];
    let [velocity, acceleration] = rates;
    let failures = figures.failures.to_string();
    vec![time, position, velocity, acceleration, failures]
}

/// Why a method cannot be used, in lines below its name.
fn told(reason: &str, width: u16) -> Vec<Line> {
    let lines = crate::report::wrapped(reason, width.into());
    let line = |name| Line {
        key: String::new(),
        name,
        figures: Vec::new(),
        part: Part::Quiet,
    };
    lines.into_iter().map(line).collect()
}

impl Line {
    fn render(&self, area: Rect, buffer: &mut Buffer) {
        let Rect { x, y, width, .. } = area;
        print(
            buffer,
            x,
            y,
            KEY.min(width),
            &self.key,
            theme::part(Part::Key),
        );
        let room = width.saturating_sub(KEY);
        print(buffer, x + KEY, y, room, &self.name, theme::part(self.part));
        let mut right = x + KEY + NAME;
        for figure in &self.figures {
            right += FIGURE;
            if right > area.right() {
                break;
            }
            debug_assert!(columns(figure) < FIGURE);
            print_right(buffer, right, y, figure, theme::part(self.part));
        }
    }
}
