//! The linkage, and its tables live beside or below it: wherever it is drawn larger.

pub(crate) mod followed;
pub(crate) mod viewport;

use super::pane::{Copied, Pane};
use super::{assemblies, columns, inset, print, show, table};
use crate::Vec2;
use crate::drawing::{self, Glyphs, Labels, LegendPiece, Raster, Reach, Role};
use crate::report::upwards;
use crate::tui::app::{App, Mode};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::{Action, MotionAction};
use crate::tui::player::compared_scene::ComparedScene;
use crate::tui::player::edition::Edition;
use crate::tui::views::motion::viewport::ViewportSetting;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use std::borrow::Cow;

/// Offered where only a part of the motion is seen.
pub(super) const FIT: Action = Action::Motion(MotionAction::Fit);

/// Where the parts of the view are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MotionAreas {
    pub(super) drawing: Rect,
    /// Below the drawing, without a line where nothing needs to be told.
    pub(super) legend: Rect,
    /// One cell wide or high.
    pub(super) rule: Rect,
    pub(super) table: Rect,
}

/// Tables beside the drawing leave it at least so many columns.
const NARROWEST_DRAWING: u16 = 40;
/// Columns for names and supports at the sides of a drawing.
const MARGINS: f64 = 12.0;
/// Tables below the drawing leave it two thirds of the height.
const TABLE_SHARE: u16 = 3;
const LOWEST_TABLE: u16 = 4;
/// On lower screens the rule's line goes to the drawing.
const ROOM_FOR_RULE: u16 = 14;

/// A drawing below this height is no drawing.
const LOWEST_DRAWING: u16 = 4;

/// Puts the tables where they leave the linkage the larger scale.
pub(super) fn arrange(app: &App, area: Rect) -> MotionAreas {
    let below = below(app, area);
    let arrangement = match beside(app, area) {
        Some(beside) if scale(app, beside.drawing) >= scale(app, below.drawing) => beside,
        _ => below,
    };
    arrangement.with_legend(app)
}

/// A legend takes so many lines at the most, and one on low screens.
const MOST_LEGEND: usize = 2;

impl MotionAreas {
    /// The legend takes its lines from the drawing.
    fn with_legend(self, app: &App) -> MotionAreas {
        let drawing = self.drawing;
        let lines = legend(app, drawing).len();
        let lines = u16::try_from(lines).unwrap_or(0);
        let height = drawing.height.saturating_sub(lines).max(1);
        MotionAreas {
            drawing: Rect { height, ..drawing },
            legend: Rect {
                y: drawing.y + height,
                height: drawing.height - height,
                ..inset(drawing)
            },
            ..self
        }
    }
}

/// The lines of the legend for a drawing in this area.
fn legend(app: &App, area: Rect) -> Vec<Vec<LegendPiece>> {
    let most = if area.height < ROOM_FOR_RULE {
        1
    } else {
        MOST_LEGEND
    };
    let view = window(app, area);
    let width = usize::from(inset(area).width);
    drawing::legend_lines(&app.viewport().legend(&view), app.glyphs(), width, most)
}

/// The window on the drawing in this area.
fn window(app: &App, area: Rect) -> drawing::WorldView {
    let (viewport, open_scene) = (app.viewport(), app.open_scene());
    let own = viewport.reach(open_scene, area.height);
    let reach = match (app.mode(), open_scene.assembly_list(), app.compared()) {
        (Mode::Assemblies(_), Some(assembly_list), _) => Cow::Borrowed(assembly_list.reach()),
        (_, _, Some(compared)) => Cow::Owned(compared.reach_beside(own)),
        _ => Cow::Borrowed(own),
    };
    viewport.view(&reach, (area.width, area.height), app.aspect())
}

fn beside(app: &App, area: Rect) -> Option<MotionAreas> {
    let (narrow, wide) = app.sheet().widths(app.glyphs());
    let [narrow, wide] = [narrow, wide].map(|w| u16::try_from(w).unwrap_or(u16::MAX));
    // The blanks beside the tables, and the rule.
    let sides = 1 + 1 + super::MARGIN;
    let most = area.width.checked_sub(narrow.checked_add(sides)?)?;
    if most < NARROWEST_DRAWING {
        return None;
    }
    // What the height keeps the drawing from using widens the table.
    let spare = most.saturating_sub(columns_used(app, area).max(NARROWEST_DRAWING));
    let drawing = most - spare.min(wide.saturating_sub(narrow));
    let table = area.width - drawing - 1;
    let columns = [(0, drawing), (drawing, 1), (drawing + 1, table)];
    let [drawing, rule, table] = columns.map(|(x, w)| Rect {
        x: area.x + x,
        width: w,
        ..area
    });
    Some(MotionAreas {
        drawing,
        legend: Rect::ZERO,
        rule,
        table: inset(table),
    })
}

/// Columns that a drawing of this height can fill, names and supports included.
fn columns_used(app: &App, area: Rect) -> u16 {
    let size = needed(app).bounds().size();
    let columns = f64::from(area.height) * app.aspect() * size.x / size.y + MARGINS;
    if columns < f64::from(u16::MAX) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and u16::MAX"
        )]
        let columns = columns.ceil() as u16;
        columns
    } else {
        u16::MAX
    }
}

fn below(app: &App, area: Rect) -> MotionAreas {
    let width = usize::from(inset(area).width);
    let placed = app.sheet().placed(width, app.glyphs());
    let [vectors, all] = [placed.vector_lines(), placed.lines().len()]
        .map(|lines| u16::try_from(lines).unwrap_or(u16::MAX))
        .map(|lines| lines.saturating_add(table::title_lines(app)));
    let share = (area.height / TABLE_SHARE).max(LOWEST_TABLE);
    let rule = u16::from(area.height >= ROOM_FOR_RULE);
    let drawing = area.height.saturating_sub(vectors.min(share) + rule);
    // What the width keeps the drawing from using shows more of the tables.
    let lowest = area.height.saturating_sub(all.saturating_add(rule));
    let scale_at = |height| scale(app, Rect { height, ..area });
    // A rounding error makes no drawing smaller.
    let least = scale_at(drawing) * (1.0 - 1e-9);
    let drawing = (lowest.max(LOWEST_DRAWING)..drawing)
        .find(|&lower| scale_at(lower) >= least)
        .unwrap_or(drawing);
    let table = area.height.saturating_sub(drawing + rule);
    let rows = [(0, drawing), (drawing, rule), (drawing + rule, table)];
    let [drawing, rule, table] = rows.map(|(y, h)| Rect {
        y: area.y + y,
        height: h,
        ..area
    });
    MotionAreas {
        drawing,
        legend: Rect::ZERO,
        rule,
        table: inset(table),
    }
}

/// The space that the linkage needs, and what it is held against.
fn needed(app: &App) -> &Reach {
    app.compared()
        .map_or(app.open_scene().reach(), ComparedScene::reach)
}

/// Cells along x for a unit of length in a drawing of this size.
fn scale(app: &App, area: Rect) -> f64 {
    let view = drawing::WorldView::fit(needed(app), area.width, area.height, app.aspect());
    (view.cell(Vec2::new(1.0, 0.0)) - view.cell(Vec2::ZERO)).x
}

/// The drawing as it was made last: names keep their sides from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Sketch {
    labels: Labels,
    raster: Raster,
    /// Which scene the labels belong to, in which form, and what of it was shown.
    drawn: Option<(Edition, ViewportSetting)>,
}

impl Sketch {
    /// The drawing.
    pub(super) fn raster(&self) -> &Raster {
        &self.raster
    }

    /// Draws the linkage as it is now, for a drawing of this size.
    pub(super) fn draw_in(&mut self, app: &App, area: Rect) {
        let drawn = Some((app.open_scene().edition().clone(), app.viewport().setting()));
        if self.drawn != drawn {
            self.drawn = drawn;
            self.labels = Labels::default();
        }
        let open_scene = app.open_scene();
        let mut figure = app.viewport().figure(open_scene);
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
        let view = window(app, area);
        let Sketch { labels, raster, .. } = self;
        drawing::render_into(&figure, &view, app.glyphs(), labels, raster);
    }
}

/// The drawing, with live tables.
pub(super) struct MotionView;

impl Pane for MotionView {
    fn name(&self) -> &'static str {
        "motion"
    }

    fn about(&self) -> &'static str {
        words().drawing_with_live_tables()
    }

    fn help_title(&self) -> &'static str {
        words().what_the_motion_view_shows()
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        sketch.draw_in(app, arrange(app, body).drawing);
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let arrangement = arrange(app, body);
        show(&sketch.raster, arrangement.drawing, buffer);
        explain(app, arrangement, buffer);
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
fn explain(app: &App, arrangement: MotionAreas, buffer: &mut Buffer) {
    let area = arrangement.legend;
    // Where the arrows were measured, so that both say the same.
    let lines = legend(app, arrangement.drawing);
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
        Glyphs::Line | Glyphs::Braille => ('\u{2502}', '\u{2500}'),
    };
    let glyph = if area.width == 1 { upright } else { level };
    for position in area.positions() {
        buffer[position]
            .set_char(glyph)
            .set_style(theme::part(ScreenPart::Quiet));
    }
}
