//! Lengths view: the sensitivity of the results to the given lengths. It is separate from the
//! tables because these errors differ from rounding errors.
//!
//! ```text
//!  change for 1 mm               in every length     in one  in which
//!  r3.angle [deg]                          0.843      0.193  r4.length
//! ```

use super::pane::{Copied, Pane, USUAL_HINTS};
use super::{Sketch, inset, page, split};
use crate::page::{Content, Line, Page, Row, cut};
use crate::quantity::{Catalogue, Quantity, Sensitivity};
use crate::report::{Answers, ToleranceAnswers, ToleranceReport};
use crate::scene::Scene;
use crate::solver::Order;
use crate::study::{Distribution, SampleOrder, ToleranceStudy};
use crate::tui::app::{App, View};
use crate::tui::commands::action::Action;
use crate::tui::player::open_scene::OpenScene;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Minimum width for units and for the largest single influence.
const MIN_WIDTH_WITH_UNITS: u16 = 56;
/// The name of a length takes at most `1 / NAME_SHARE` of the width.
const NAME_SHARE: u16 = 3;

/// Maximum number of lengths. More would delay the frame.
const MAX_LENGTHS: usize = 200;
/// Number of random machines for the tolerance report on one quantity.
const MACHINES: u32 = 10_000;

/// The sensitivity of the motion to the lengths, at the driver's position.
#[derive(Debug)]
pub(crate) struct LengthsStudy {
    sensitivity: Sensitivity,
    answers: Answers,
    /// The tolerance study and its results, if the scene has tolerances.
    tolerances: Option<(ToleranceStudy, ToleranceAnswers)>,
    /// The effect of all tolerances on one quantity, at the coordinate where it was requested.
    pub(crate) told: Option<ToleranceReport>,
}

impl LengthsStudy {
    /// Studies the lengths of a scene; `None` if they are too many.
    pub(super) fn new(open_scene: &OpenScene) -> Option<LengthsStudy> {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        if has_too_many_lengths(scene) {
            return None;
        }
        let quantities = Catalogue::new(scene).figures();
        let mut sensitivity = Sensitivity::new(scene, solver, &quantities);
        let of_motion = quantities.into_iter().filter(|q| q.order() != Order::Force);
        let of_motion: Vec<Quantity> = of_motion.collect();
        let study = ToleranceStudy::new(scene, solver, scene.tolerances(), &of_motion);
        let at = open_scene.at();
        Some(LengthsStudy {
            answers: Answers::at(&mut sensitivity, scene.unit.symbol(), at).without_trivial(),
            sensitivity,
            tolerances: study.ok().map(|mut study| {
                let found = ToleranceAnswers::at(scene, &mut study, at);
                (study, found)
            }),
            told: None,
        })
    }

    /// Updates the results for another driver state.
    pub(super) fn go(&mut self, open_scene: &OpenScene) {
        let (scene, at) = (open_scene.scene(), open_scene.at());
        let answers = Answers::at(&mut self.sensitivity, scene.unit.symbol(), at);
        self.answers = answers.without_trivial();
        if let Some((study, found)) = &mut self.tolerances {
            *found = ToleranceAnswers::at(scene, study, at);
        }
    }
}

/// Computes the effect of all tolerances on one quantity at the driver's position.
///
/// # Errors
/// Returns a message if the tolerance study fails.
pub(crate) fn tolerance_report(
    open_scene: &OpenScene,
    quantity: Quantity,
) -> Result<ToleranceReport, String> {
    let (scene, solver) = (open_scene.scene(), open_scene.solver());
    let study = ToleranceStudy::new(scene, solver, scene.tolerances(), &[quantity]);
    let mut study = study.map_err(|why| why.to_string())?;
    let order = SampleOrder {
        count: MACHINES,
        seed: 1,
        distribution: Distribution::default(),
    };
    let (at, condition) = (open_scene.at(), open_scene.condition());
    Ok(ToleranceReport::at(
        scene,
        &mut study,
        at,
        condition,
        Some(order),
    ))
}

fn has_too_many_lengths(scene: &Scene) -> bool {
    scene.mechanism.lengths().len() > MAX_LENGTHS
}

/// The lengths view: the effect of each length.
pub(super) struct LengthsView;

impl Pane for LengthsView {
    fn view(&self) -> View {
        View::Lengths
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let too_many = has_too_many_lengths(app.open_scene().scene());
        too_many.then(|| words().too_many_lengths())
    }

    fn is_timed(&self, _app: &App) -> bool {
        false
    }

    fn hints(&self, app: &App) -> &'static [Action] {
        let study = app.views.lengths.get();
        match study.and_then(|study| study.tolerances.as_ref()) {
            Some(_) => &[
                Action::Help,
                Action::Tolerance,
                Action::MOTION,
                Action::LineDown,
                Action::Quit,
                Action::Play,
                Action::StepForward,
            ],
            None => &USUAL_HINTS,
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
    split(area, u16::from(head.is_some())).1
}

/// Returns the fixed head line of the only table, if there is one, and the rows; or a message.
fn lines(app: &App, area: Rect) -> (Option<Line>, Vec<Line>) {
    let Some(study) = app.views.lengths.get() else {
        return (None, page::words(words().too_many_lengths(), area));
    };
    if let Some(text) = &study.told {
        return (None, page::lines(app, &text.page(), area));
    }
    let (mut page, answers) = (Page::default(), &study.answers);
    if let Some((_, off)) = &study.tolerances {
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
        .filter(|_| area.width < MIN_WIDTH_WITH_UNITS);
    let mut content = short.map_or_else(|| answers.content(true), Content::Table);
    if let Content::Table(table) = &mut content {
        let maximum = usize::from(area.width / NAME_SHARE);
        table.rows.iter_mut().for_each(|row| shorten(row, maximum));
    }
    content
}

/// Cuts the name of a length in the row's last cell.
fn shorten(row: &mut Row, maximum: usize) {
    if let Row::Figures { cells, .. } = row
        && let Some(Some(length)) = cells.last_mut()
    {
        length.text = cut(&length.text, maximum);
    }
}
