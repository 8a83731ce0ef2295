//! Motion view: the linkage with live tables next to it, or below it on narrow screens.

mod arrangement;
mod cycle_line;
mod framing;
pub(crate) mod tracked_points;
pub(crate) mod viewport;

use super::pane::{Copied, Pane};
use super::{assemblies, columns, print, show, table, title};
use crate::Vec2;
use crate::drawing::{
    self, Figure, Glyphs, Labels, LegendPiece, Raster, Role, SvgGround, WorldView,
};
use crate::quantity::Subject;
use crate::report::perpendicular_up;
use crate::solver::State;
use crate::tui::app::{App, Mode, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, MotionAction};
use crate::tui::player::scene_version::SceneRevision;
use crate::tui::views::motion::viewport::ViewportSetting;
use crate::wording::words;
use arrangement::arrange;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// The action that fits the window, offered when only a part of the motion is visible.
pub(super) const FIT: Action = Action::Motion(MotionAction::Fit);

/// Maximum width of a simple drawing with names. They take a tenth of the bytes of a larger one.
const MAX_SIMPLE_WIDTH: u16 = 100;

/// The last drawing, kept so that labels stay on the same sides from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Sketch {
    labels: Labels,
    raster: Raster,
    /// The scene and layers that the labels were placed for.
    drawn: Option<DrawnStage>,
    /// The drawing's area on the screen, and the view on the scene's plane.
    window: Option<(Rect, drawing::WorldView)>,
    /// The visible polygons.
    polygons: Vec<PolygonSketch>,
    /// Whether to draw with as few bytes as possible: in ASCII, without trails, a large drawing without
    /// names, and the position in the cycle without numbers.
    pub(crate) is_simple: bool,
}

/// A polygon of a loop, kept so that labels stay on the same sides from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct PolygonSketch {
    labels: Labels,
    raster: Raster,
    /// The panel's number and the area of its drawing.
    of: (usize, Rect),
    /// The scale of the drawing.
    pub(super) scale: Option<drawing::LegendEntry>,
}

impl PolygonSketch {
    /// Starts an empty drawing. Labels keep their places only in the same panel and area.
    pub(super) fn start(&mut self, number: usize, area: Rect) {
        if self.of != (number, area) {
            self.of = (number, area);
            self.labels = Labels::default();
        }
        self.scale = None;
        self.raster.reset(area.width, area.height);
    }

    /// Returns the labels and the raster to draw in.
    pub(super) fn drawing(&mut self) -> (&mut Labels, &mut Raster) {
        (&mut self.labels, &mut self.raster)
    }

    pub(super) fn raster(&self) -> &Raster {
        &self.raster
    }

    pub(super) fn number(&self) -> usize {
        self.of.0
    }
}

/// A scene in a window with its layers. A different one needs different places of labels.
#[derive(Clone, Debug, PartialEq)]
struct DrawnStage {
    scene: SceneRevision,
    setting: ViewportSetting,
    /// Whether a point leads.
    is_led: bool,
    /// The share of the motion at which the stage was drawn first, if it has a motion, and the
    /// window then.
    share: Option<f64>,
    view: WorldView,
    highlighted: Option<Subject>,
}

impl DrawnStage {
    /// Returns `true` if the scene and its layers are the same.
    fn is_of(&self, other: &DrawnStage) -> bool {
        self.scene == other.scene && self.setting == other.setting && self.is_led == other.is_led
    }
}

/// A place of the scene seen in the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DrawnPlace {
    pub(crate) position: Vec2,
    /// Vector from the middle of the visible part, in the scene's length unit.
    pub(crate) from_middle: Vec2,
    /// Width of a column in the scene's length unit.
    pub(crate) column: f64,
    /// The window in which it is seen.
    pub(crate) window: WorldView,
}

impl Sketch {
    /// Returns the drawing.
    pub(crate) fn raster(&self) -> &Raster {
        &self.raster
    }

    /// Returns the polygons of the last frame, to draw them again.
    pub(super) fn polygons(&mut self) -> &mut Vec<PolygonSketch> {
        &mut self.polygons
    }

    /// Returns the polygons.
    pub(super) fn drawn_polygons(&self) -> &[PolygonSketch] {
        &self.polygons
    }

    /// Starts a frame in which the drawing is not placed yet.
    pub(super) fn start_frame(&mut self) {
        self.window = None;
    }

    /// Returns the drawing's area on the screen, if it is visible.
    pub(crate) fn area(&self) -> Option<Rect> {
        self.window.map(|(area, _)| area)
    }

    /// Returns the place of the scene at a cell of the drawing; `None` outside the drawing.
    pub(crate) fn place(&self, at: Position) -> Option<DrawnPlace> {
        let (area, view) = self.window.filter(|(area, _)| area.contains(at))?;
        let cell = Vec2::new(f64::from(at.x - area.x), f64::from(at.y - area.y));
        let middle = Vec2::new(f64::from(area.width), f64::from(area.height)) * 0.5;
        let position = view.world(cell + Vec2::new(0.5, 0.5));
        Some(DrawnPlace {
            position,
            from_middle: position - view.world(middle),
            column: 1.0 / view.cells_along(1.0),
            window: view,
        })
    }

    /// Draws the linkage's current state for an area of the screen.
    pub(super) fn draw_in(&mut self, app: &App, area: Rect) {
        let highlighted = app.view().pane_in(app).subject(app);
        let view = arrangement::window(app, area);
        self.window = Some((area, view));
        self.place_labels(app, &view, highlighted);
        // Other glyphs take three bytes each.
        let glyphs = match self.is_simple {
            true => Glyphs::Ascii,
            false => app.glyphs(),
        };
        let mut figure = figure_of(app, highlighted);
        if !self.is_simple {
            add_trails(&mut figure, app);
        } else if area.width > MAX_SIMPLE_WIDTH {
            figure.remove_names();
        }
        let Sketch { labels, raster, .. } = self;
        drawing::render_into(&figure, &view, glyphs, labels, raster);
    }

    /// Starts new labels for another scene or layer. Plans their sides over the whole motion with
    /// the first frame that moves, so that neither the first frame nor an edit waits.
    fn place_labels(&mut self, app: &App, view: &WorldView, highlighted: Option<Subject>) {
        let (open_scene, viewport) = (app.open_scene(), &app.views.viewport);
        let extents = open_scene.extents();
        let share = match open_scene.led() {
            Some(led) => Some(led.share(led.time())),
            None => extents.share(open_scene.at()),
        };
        let is_fixed = viewport.lens.is_fixed();
        let now = DrawnStage {
            scene: open_scene.edition().clone(),
            setting: viewport.setting(),
            is_led: open_scene.led().is_some(),
            share,
            view: *view,
            highlighted,
        };
        let same = self.drawn.as_ref().filter(|drawn| drawn.is_of(&now));
        let Some(drawn) = same else {
            self.labels = Labels::default();
            self.drawn = Some(now);
            return;
        };
        if drawn.highlighted != highlighted || (is_fixed && drawn.view != *view) {
            self.labels.drop_plan();
            self.drawn = Some(now);
            return;
        }
        if is_fixed && share != drawn.share && !self.labels.is_planned() {
            let figure_of = |state: &State| viewport.figure_in(open_scene, state, highlighted);
            let (labels, glyphs) = (&mut self.labels, app.glyphs());
            if let Some(led) = open_scene.led() {
                let figures = led.states().map(figure_of);
                labels.plan(led.is_closed(), drawn.share, view, glyphs, figures);
            } else {
                let (solver, order) = (open_scene.solver(), viewport.order(open_scene));
                let mut state = solver.state();
                let figures = extents.steps().map(|at| {
                    let _ = solver.solve(at, order, &mut state);
                    figure_of(state.state())
                });
                labels.plan(extents.is_closed(), drawn.share, view, glyphs, figures);
            }
        }
        self.labels.go(share);
    }

    /// Returns the last drawing as an SVG document for a background, without highlighting, and its
    /// area on the screen; `None` if the screen shows no drawing.
    pub(crate) fn document(&self, app: &App, ground: SvgGround) -> Option<(String, Rect)> {
        let (area, view) = self.window?;
        let labels = &mut self.labels.clone();
        let mut figure = figure_of(app, None);
        add_trails(&mut figure, app);
        let svg = drawing::svg_on(ground, &figure, &view, "", &[], labels);
        Some((svg, area))
    }
}

/// Returns the linkage's current state, with the ghosts of the linkages that it is compared with.
fn figure_of(app: &App, highlighted: Option<Subject>) -> Figure {
    let open_scene = app.open_scene();
    let viewport = &app.views.viewport;
    let mut figure = viewport.figure(open_scene, highlighted);
    if let Mode::Assemblies(assemblies) = app.mode() {
        for ghost in assemblies.ghosts() {
            drawing::add_ghost(&mut figure, open_scene.scene(), open_scene.state(), ghost);
        }
    }
    if let Some(compared) = app.compared() {
        compared.add_ghost(&mut figure);
    }
    // While the motion plays, the state before the edit belongs to another driver coordinate.
    if let Some(before) = app.scene_before().filter(|_| !app.playback().is_playing()) {
        let [now, before] = [open_scene, before].map(|of| (of.scene(), of.state()));
        drawing::add_before(&mut figure, now, before);
    }
    figure
}

/// Adds the part of each trace that its point has just left behind.
fn add_trails(figure: &mut Figure, app: &App) {
    let (state, is_backwards) = (app.open_scene().state(), app.playback().is_backwards());
    app.views.viewport.add_trails(figure, state, is_backwards);
}

/// The drawing with live tables.
pub(super) struct MotionView;

/// The drawing among other panes; the tables have a pane of their own.
pub(super) struct DrawingPane;

impl Pane for DrawingPane {
    fn view(&self) -> View {
        View::Motion
    }

    fn heading(&self, app: &App, space: u16) -> (String, String) {
        title::heading(app, space)
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        sketch.draw_in(app, arrangement::with_legend(app, body)[0]);
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let [drawing, cycle, legend] = arrangement::with_legend(app, body);
        show(&sketch.raster, drawing, buffer);
        cycle_line::render(app, sketch.is_simple, cycle, buffer);
        explain(app, drawing, legend, buffer);
    }

    fn extent(&self, _app: &App, _body: Rect) -> (usize, usize) {
        (0, 0)
    }
}

impl Pane for MotionView {
    fn view(&self) -> View {
        View::Motion
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        sketch.draw_in(app, arrange(app, body).drawing);
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let arrangement = arrange(app, body);
        if let Some(title) = arrangement.title {
            title::render(app, title, buffer);
        }
        show(&sketch.raster, arrangement.drawing, buffer);
        cycle_line::render(app, sketch.is_simple, arrangement.cycle, buffer);
        explain(app, arrangement.drawing, arrangement.legend, buffer);
        rule(app.glyphs(), arrangement.rule, buffer);
        if let Mode::Assemblies(assemblies) = app.mode() {
            assemblies::render(app, assemblies, arrangement.table, buffer);
        } else {
            table::render(app, arrangement.table, buffer);
        }
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        table::extent(app, arrange(app, body).table)
    }

    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            FIT,
            Action::Play,
            Action::Quit,
            Action::StepForward,
            Action::GoTo,
            Action::NextPreset,
        ]
    }

    /// Returns the last state's cost, if it was measured and fits into `space` columns, and the
    /// largest error bound of a position.
    fn trust(&self, app: &App, space: u16) -> Option<String> {
        let open_scene = app.open_scene();
        let bound = match open_scene.largest_bound() {
            Some(bound) => format!(
                "+-{} {}",
                perpendicular_up(bound, 1),
                open_scene.scene().unit.symbol()
            ),
            None => words().no_bound().into(),
        };
        let both = open_scene.cost().map(|cost| format!("{cost}, {bound}"));
        Some(both.filter(|both| columns(both) <= space).unwrap_or(bound))
    }

    fn copy(&self, app: &App) -> Copied {
        Copied::Text(app.shown().tables())
    }

    fn svg(&self, app: &App) -> Result<(&'static str, String), String> {
        Ok((
            words().the_drawing(),
            app.views.viewport.svg(app.open_scene()),
        ))
    }
}

/// Prints the legend; arrows have the same style as in the drawing.
fn explain(app: &App, drawing: Rect, area: Rect, buffer: &mut Buffer) {
    // Uses the area in which the arrows were measured, so that the scales agree.
    let lines = arrangement::legend(app, drawing);
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        let mut x = area.x;
        for LegendPiece { text, role } in line {
            let style = match role {
                Role::Label | Role::Empty => theme::part(ScreenPart::Quiet),
                role => theme::role(role),
            };
            let space = area.right().saturating_sub(x);
            x = print(buffer, x, y, space.min(columns(&text)), &text, style);
        }
    }
}

/// Draws a line between two parts of the screen.
pub(super) fn rule(glyphs: Glyphs, area: Rect, buffer: &mut Buffer) {
    let (upright, level) = match glyphs {
        Glyphs::Ascii => ('|', '-'),
        Glyphs::Line | Glyphs::Braille | Glyphs::Blocks(_) => ('\u{2502}', '\u{2500}'),
    };
    let glyph = if area.width == 1 { upright } else { level };
    for position in area.positions() {
        buffer[position]
            .set_char(glyph)
            .set_style(theme::part(ScreenPart::Quiet));
    }
}
