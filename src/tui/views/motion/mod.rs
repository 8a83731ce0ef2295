//! The linkage, and its tables live beside it, on narrow screens below.

mod arrangement;
pub(crate) mod followed;
mod lens;
pub(crate) mod viewport;

use super::pane::{Copied, Pane};
use super::{assemblies, columns, print, show, table, title};
use crate::Vec2;
use crate::drawing::{
    self, Figure, Glyphs, Labels, LegendPiece, Raster, Role, SvgGround, WorldView,
};
use crate::quantity::Subject;
use crate::report::upwards;
use crate::tui::app::{App, Mode, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, MotionAction};
use crate::tui::player::edition::Edition;
use crate::tui::views::motion::viewport::ViewportSetting;
use crate::wording::words;
use arrangement::arrange;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Offered where only a part of the motion is seen.
pub(super) const FIT: Action = Action::Motion(MotionAction::Fit);

/// The drawing as it was made last: names keep their sides from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Sketch {
    labels: Labels,
    raster: Raster,
    /// Which scene the labels belong to, in which form, and what of it was shown.
    drawn: Option<(Edition, ViewportSetting)>,
    /// Where on the screen it stands, and what of the world is seen there.
    window: Option<(Rect, drawing::WorldView)>,
}

/// A place in the scene's frame that is seen in the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SeenPlace {
    pub(crate) place: Vec2,
    /// How far it lies from the middle of what is seen.
    pub(crate) from_middle: Vec2,
    /// How long a column is.
    pub(crate) column: f64,
    /// The window in which it is seen.
    pub(crate) window: WorldView,
}

impl Sketch {
    /// The drawing.
    pub(super) fn raster(&self) -> &Raster {
        &self.raster
    }

    /// Nothing is drawn yet in the frame that begins.
    pub(super) fn begin(&mut self) {
        self.window = None;
    }

    /// The place in the scene's frame that a cell of the drawing shows.
    pub(crate) fn place(&self, at: Position) -> Option<SeenPlace> {
        let (area, view) = self.window.filter(|(area, _)| area.contains(at))?;
        let cell = Vec2::new(f64::from(at.x - area.x), f64::from(at.y - area.y));
        let middle = Vec2::new(f64::from(area.width), f64::from(area.height)) * 0.5;
        let place = view.world(cell + Vec2::new(0.5, 0.5));
        Some(SeenPlace {
            place,
            from_middle: place - view.world(middle),
            column: 1.0 / view.cells_along(1.0),
            window: view,
        })
    }

    /// Draws the linkage as it is now, for a drawing of this size.
    pub(super) fn draw_in(&mut self, app: &App, area: Rect) {
        let drawn = Some((app.open_scene().edition().clone(), app.viewport().setting()));
        if self.drawn != drawn {
            self.drawn = drawn;
            self.labels = Labels::default();
        }
        let view = arrangement::window(app, area);
        self.window = Some((area, view));
        let Sketch { labels, raster, .. } = self;
        let lit = app.view().pane().subject(app);
        drawing::render_into(&figure_of(app, lit), &view, app.glyphs(), labels, raster);
    }

    /// What is drawn as a document for this ground, without what lights up, and where on the screen it stands; `None` where there is no
    /// drawing on it.
    pub(crate) fn document(&self, app: &App, ground: SvgGround) -> Option<(String, Rect)> {
        let (area, view) = self.window?;
        let labels = &mut self.labels.clone();
        let svg = drawing::svg_on(ground, &figure_of(app, None), &view, "", &[], labels);
        Some((svg, area))
    }
}

/// The linkage as it is now, with what it is compared with.
fn figure_of(app: &App, lit: Option<Subject>) -> Figure {
    let open_scene = app.open_scene();
    let mut figure = app.viewport().figure(open_scene, lit);
    if let (&Mode::Assemblies(cursor), Some(assembly_list)) =
        (app.mode(), open_scene.assembly_list())
    {
        for ghost in assembly_list.ghosts(cursor) {
            drawing::add_ghost(&mut figure, open_scene.scene(), open_scene.state(), ghost);
        }
    }
    if let Some(compared) = app.compared() {
        compared.add_ghost(&mut figure);
    }
    // While it plays, what was before has another place in the motion.
    if let Some(before) = app.scene_before().filter(|_| !app.playback().is_playing()) {
        let [now, before] = [open_scene, before].map(|of| (of.scene(), of.state()));
        drawing::add_before(&mut figure, now, before);
    }
    figure
}

/// The drawing, with live tables.
pub(super) struct MotionView;

/// The drawing among other panes: tables have one of their own.
pub(super) struct DrawingPane;

impl Pane for DrawingPane {
    fn name(&self) -> &'static str {
        MotionView.name()
    }

    fn about(&self) -> &'static str {
        MotionView.about()
    }

    fn help_title(&self) -> &'static str {
        MotionView.help_title()
    }

    fn view(&self) -> View {
        View::Motion
    }

    fn heading(&self, app: &App, room: u16) -> (String, String) {
        title::heading(app, room)
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        sketch.draw_in(app, arrangement::with_legend(app, body).0);
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let (drawing, legend) = arrangement::with_legend(app, body);
        show(&sketch.raster, drawing, buffer);
        explain(app, drawing, legend, buffer);
    }

    fn extent(&self, _app: &App, _body: Rect) -> (usize, usize) {
        (0, 0)
    }
}

impl Pane for MotionView {
    fn name(&self) -> &'static str {
        "motion"
    }

    fn about(&self) -> &'static str {
        words().drawing_with_live_tables()
    }

    fn view(&self) -> View {
        View::Motion
    }

    fn help_title(&self) -> &'static str {
        words().what_the_motion_view_shows()
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
        explain(app, arrangement.drawing, arrangement.legend, buffer);
        rule(app.glyphs(), arrangement.rule, buffer);
        if let Mode::Assemblies(cursor) = *app.mode() {
            assemblies::render(app, cursor, arrangement.table, buffer);
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

    /// What the last state cost, where that was measured and there is room for it, and how far a place in it
    /// can be from the truth.
    fn trust(&self, app: &App, room: u16) -> Option<String> {
        let open_scene = app.open_scene();
        let bound = match open_scene.largest_bound() {
            Some(bound) => format!(
                "+-{} {}",
                upwards(bound, 1),
                open_scene.scene().unit.symbol()
            ),
            None => words().no_bound().into(),
        };
        let both = open_scene.cost().map(|cost| format!("{cost}, {bound}"));
        Some(both.filter(|both| columns(both) <= room).unwrap_or(bound))
    }

    fn copy(&self, app: &App) -> Copied {
        Copied::Text(app.shown().tables())
    }

    fn svg(&self, app: &App) -> Result<(&'static str, String), String> {
        Ok((words().the_drawing(), app.viewport().svg(app.open_scene())))
    }
}

/// The legend, arrows in the look that they have in the drawing.
fn explain(app: &App, drawing: Rect, area: Rect, buffer: &mut Buffer) {
    // Where the arrows were measured, so that both say the same.
    let lines = arrangement::legend(app, drawing);
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        let mut x = area.x;
        for LegendPiece { text, role } in line {
            let style = match role {
                Role::Label | Role::Empty => theme::part(ScreenPart::Quiet),
                role => theme::role(role),
            };
            let room = area.right().saturating_sub(x);
            x = print(buffer, x, y, room.min(columns(&text)), &text, style);
        }
    }
}

/// A line between two parts of the screen.
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
