//! Polygons view: the vectors of each loop head to tail, and the same sum of velocities and of
//! accelerations, to scale and moving with the linkage.
//!
//! ```text
//!  position, r 200 mm = ---->    velocity, v 1000 mm/s = --->    acceleration, ..
//!            r3                       vB
//!      .-------->.                  <------.
//!  r2 /          | r4          vC/B  \     | vC
//! ```

use super::motion::PolygonSketch;
use super::pane::Pane;
use super::{Sketch, inset, mark_more, page, print, print_line, show, status};
use crate::Vec2;
use crate::drawing::{
    self, ArrowKind, DiagramArrow, Extents, LegendEntry, Role, VectorDiagram, WorldView,
};
use crate::page::Line;
use crate::quantity::Aspect;
use crate::report::{LoopVectors, Working};
use crate::solver::{Order, Workspace};
use crate::tui::app::{App, View};
use crate::tui::appearance::theme::{self, ScreenPart};
use crate::tui::commands::action::Action;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::solution_cache::{DIGITS, Explained};
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// The orders of the polygons, with the letter of their scale.
const ORDERS: [(Order, &str); 3] = [
    (Order::Position, "r"),
    (Order::Velocity, "v"),
    (Order::Acceleration, "a"),
];
/// Minimum size of a panel with its title.
const MIN_COLUMNS: u16 = 24;
const MIN_ROWS: u16 = 9;
/// A narrower panel has its scale below its title.
const MIN_COLUMNS_OF_ONE_LINE: u16 = 48;
/// Maximum number of panels side by side, one for each order.
const MAX_SIDE_BY_SIDE: u16 = 3;
/// A polygon larger than this multiple of the median size has its own scale. Rates grow without
/// bound near a dead point.
const MAX_SIZE_FACTOR: f64 = 3.0;
/// The fixed scale has this factor of space beyond the largest sampled polygon, because a peak may be
/// between two samples.
const HEADROOM: f64 = 1.05;
/// A polygon smaller than this fraction of the largest one does not count: the driver rests there.
const MIN_SIZE_FRACTION: f64 = 1e-9;
/// The fraction of the fixed size below which an arrow is not drawn.
const MIN_VISIBLE_ARROW: f64 = 5e-3;

/// The polygons of all loops at the driver's position.
#[derive(Debug)]
pub(crate) struct LoopPolygons {
    working: Working,
    state: Workspace,
    loops: Vec<LoopVectors>,
    /// The extents over the whole motion by loop and order, with the size of the largest polygon in
    /// them; `None` if there is no such polygon.
    extents: Vec<[Option<(Extents, f64)>; 3]>,
}

impl LoopPolygons {
    /// Creates the polygons at the driver's position; `None` if the scene has too many links.
    pub(super) fn new(open_scene: &OpenScene) -> Option<LoopPolygons> {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        if !Explained::is_possible(scene) {
            return None;
        }
        let mut polygons = LoopPolygons {
            working: Working::new(scene, solver),
            state: solver.state(),
            loops: Vec::new(),
            extents: Vec::new(),
        };
        let mut places: Vec<[Vec<Vec<Vec2>>; 3]> = Vec::new();
        for driver_state in open_scene.places() {
            let _ = driver_state.solve(solver, Order::Acceleration, &mut polygons.state);
            let state = &polygons.state;
            let loops = polygons.working.loop_vectors(scene, solver, state, DIGITS);
            places.resize(loops.len(), Default::default());
            for (of, places) in loops.iter().zip(&mut places) {
                for ((order, _), places) in ORDERS.iter().zip(places) {
                    let diagram = of.polygon(*order, "");
                    places.extend(diagram.map(|diagram| diagram.places()));
                }
            }
        }
        let extents = places.into_iter().map(|of| of.map(extents_of));
        polygons.extents = extents.collect();
        polygons.go(open_scene);
        Some(polygons)
    }

    /// Updates the polygons for another driver state.
    pub(super) fn go(&mut self, open_scene: &OpenScene) {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        let driver_state = open_scene.driver_state();
        let _ = driver_state.solve(solver, Order::Acceleration, &mut self.state);
        self.loops = self
            .working
            .loop_vectors(scene, solver, &self.state, DIGITS);
    }

    /// Returns the number of panels.
    fn count(&self) -> usize {
        self.loops.len() * ORDERS.len()
    }

    /// Returns a panel's polygon in the unit of its order, and the extents of its window.
    fn panel(&self, number: usize, unit: &str) -> Option<(VectorDiagram, Extents)> {
        let (of, order) = (number / ORDERS.len(), number % ORDERS.len());
        let aspect = [Aspect::Length, Aspect::Rate, Aspect::Accel][order];
        let diagram = self
            .loops
            .get(of)?
            .polygon(ORDERS[order].0, &aspect.unit(unit))?;
        let places = diagram.places();
        let extents = match &self.extents.get(of)?[order] {
            Some((extents, size)) if size_of(&places) <= *size * HEADROOM => extents.clone(),
            _ => around(&places),
        };
        Some((diagram, extents))
    }
}

/// Returns the distance of the farthest corner from the pole.
fn size_of(places: &[Vec2]) -> f64 {
    places.iter().map(|at| at.norm()).fold(0.0, f64::max)
}

/// Returns the extents of polygons over the motion and the size of the largest one in them, without
/// those that are far larger than most.
fn extents_of(mut polygons: Vec<Vec<Vec2>>) -> Option<(Extents, f64)> {
    polygons.retain(|places| size_of(places).is_finite());
    polygons.sort_by(|a, b| size_of(a).total_cmp(&size_of(b)));
    let minimum = MIN_SIZE_FRACTION * size_of(polygons.last()?);
    polygons.retain(|places| size_of(places) > minimum);
    let median = size_of(polygons.get(polygons.len() / 2)?);
    let maximum = MAX_SIZE_FACTOR * median;
    polygons.retain(|places| size_of(places) <= maximum);
    let size = polygons.last().map_or(0.0, |places| size_of(places));
    let seen: Vec<Vec2> = polygons.concat().iter().map(|at| *at * HEADROOM).collect();
    (size > 0.0).then(|| (around(&seen), size))
}

/// Returns the extents of some places, without the places themselves.
fn around(places: &[Vec2]) -> Extents {
    let mut low = places.first().copied().unwrap_or(Vec2::ZERO);
    let mut high = low;
    for at in places {
        low = Vec2::new(low.x.min(at.x), low.y.min(at.y));
        high = Vec2::new(high.x.max(at.x), high.y.max(at.y));
    }
    Extents::of_places(&[low, high], &[])
}

/// The placed panels: the number of the first one, and the area of each.
struct Panels {
    first: usize,
    areas: Vec<Rect>,
}

/// Places as many panels as fit, such that they are as large as possible.
fn panels(app: &App, area: Rect) -> Panels {
    let all = app.views.polygons.get().map_or(0, LoopPolygons::count);
    let most_columns = (area.width / MIN_COLUMNS).clamp(1, MAX_SIDE_BY_SIDE);
    let most_rows = (area.height / MIN_ROWS).max(1);
    let count = all.min(usize::from(most_columns) * usize::from(most_rows));
    let height_for = |columns: u16| count.div_ceil(usize::from(columns));
    let grids = (1..=most_columns).filter_map(|columns| {
        let rows = u16::try_from(height_for(columns)).ok()?;
        (1..=most_rows).contains(&rows).then_some((columns, rows))
    });
    // A cell is about twice as high as wide.
    let size = |&(columns, rows): &(u16, u16)| {
        (area.width / columns).min((area.height / rows).saturating_sub(1) * 2)
    };
    let (columns, rows) = grids.max_by_key(size).unwrap_or((1, 1));
    let (width, height) = (area.width / columns, area.height / rows);
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let areas = places.take(count).map(|(column, row)| Rect {
        x: area.x + column * width,
        y: area.y + row * height,
        // A blank column separates panels.
        width: width - u16::from(column + 1 < columns),
        height,
    });
    Panels {
        first: app.views.scroll[View::Polygons as usize].min(all - count),
        areas: areas.collect(),
    }
}

/// Returns the area of a panel's drawing, below its title and scale.
fn below_title(panel: Rect) -> Rect {
    let rows = if panel.width < MIN_COLUMNS_OF_ONE_LINE {
        2
    } else {
        1
    };
    Rect {
        y: panel.y + rows,
        height: panel.height.saturating_sub(rows),
        ..panel
    }
}

/// Returns the role of a vector: that of its link, as in the tables.
fn role_of(app: &App, arrow: &DiagramArrow) -> Role {
    let open_scene = app.open_scene();
    let mut vectors = open_scene.scene().vectors.iter();
    let row = vectors.position(|vector| vector.name == arrow.vector);
    let of_link = row.and_then(|row| open_scene.vector_role(row));
    of_link.unwrap_or(match arrow.kind {
        ArrowKind::Driven => Role::Driver,
        ArrowKind::Sought => Role::Datum,
        ArrowKind::Given | ArrowKind::Part => Role::Label,
    })
}

/// The polygons view: the position, velocity and acceleration polygon of each loop.
pub(super) struct PolygonsView;

impl Pane for PolygonsView {
    fn view(&self) -> View {
        View::Polygons
    }

    fn nothing(&self, app: &App) -> Option<&'static str> {
        let too_many = !Explained::is_possible(app.open_scene().scene());
        too_many.then(|| words().too_many_links())
    }

    fn prepare(&self, app: &App, sketch: &mut Sketch, body: Rect) {
        let Some(polygons) = app.views.polygons.get() else {
            return;
        };
        let unit = app.open_scene().scene().unit.symbol();
        let Panels { first, areas } = panels(app, inset(body));
        let sketches = sketch.polygons();
        sketches.resize_with(areas.len(), PolygonSketch::default);
        for (number, (area, sketch)) in (first..).zip(areas.into_iter().zip(sketches)) {
            let area = below_title(area);
            sketch.start(number, area);
            let Some((mut diagram, extents)) = polygons.panel(number, unit) else {
                continue;
            };
            let view = WorldView::fit(&extents, area.width, area.height, app.aspect());
            let longest = size_of(&diagram.places());
            diagram
                .arrows
                .retain(|arrow| (arrow.to - arrow.from).norm() > MIN_VISIBLE_ARROW * longest);
            let figure = diagram.figure(|arrow| role_of(app, arrow));
            let letter = ORDERS[number % ORDERS.len()].1;
            let each = view.cells_along(1.0);
            sketch.scale = Some(LegendEntry::arrow(Role::Label, letter, &diagram.unit, each));
            let (labels, raster) = sketch.drawing();
            drawing::render_into(&figure, &view, app.glyphs(), labels, raster);
        }
    }

    fn lines(&self, app: &App, area: Rect) -> Vec<Line> {
        match app.views.polygons.get() {
            Some(_) => Vec::new(),
            None => page::words(words().too_many_links(), area),
        }
    }

    fn render(&self, app: &App, sketch: &Sketch, body: Rect, buffer: &mut Buffer) {
        let Some(polygons) = app.views.polygons.get() else {
            let (lines, area) = self.listed(app, body);
            page::render(app, self.view(), &lines, area, buffer);
            return;
        };
        let area = inset(body);
        if polygons.count() == 0 {
            let names = app.open_scene().scene().vectors.iter();
            let names: Vec<&str> = names.map(|vector| vector.name.as_str()).collect();
            let reason = words().in_no_loop(&names.join(", "));
            print_line(buffer, area, &reason, ScreenPart::Quiet);
        }
        let Panels { first, areas } = panels(app, area);
        let last = first + areas.len();
        for (panel, drawn) in areas.into_iter().zip(sketch.drawn_polygons()) {
            let (mut title, scale) = (title(polygons, drawn), scale(app, drawn, panel.width));
            let body = below_title(panel);
            let style = theme::part(ScreenPart::Quiet);
            if body.y == panel.y + 1 {
                title = format!("{title}  {scale}");
            } else {
                print(buffer, panel.x, panel.y + 1, panel.width, &scale, style);
            }
            print(buffer, panel.x, panel.y, panel.width, &title, style);
            show(drawn.raster(), body, buffer);
            // The position polygon of a loop exists in every state, the rates do not.
            if drawn.scale.is_none() && drawn.number() % ORDERS.len() > 0 {
                let (reason, _) = status::state(app.condition(), false);
                print_line(buffer, body, reason, ScreenPart::Quiet);
            }
        }
        mark_more(area, first > 0, last < polygons.count(), buffer);
    }

    fn extent(&self, app: &App, body: Rect) -> (usize, usize) {
        let all = app.views.polygons.get().map_or(0, LoopPolygons::count);
        (all, panels(app, inset(body)).areas.len())
    }

    fn hints(&self, _app: &App) -> &'static [Action] {
        &[
            Action::Help,
            Action::MOTION,
            Action::LineDown,
            Action::Play,
            Action::StepForward,
            Action::Svg,
            Action::Quit,
        ]
    }

    /// Returns the first visible polygon, which is that of the screen.
    fn svg(&self, app: &App) -> Result<(&'static str, String), String> {
        let polygons = app.views.polygons.get();
        let unit = app.open_scene().scene().unit.symbol();
        let placed = super::placed(app);
        let own = placed.iter().find(|pane| pane.view == View::Polygons);
        let first = own.map_or(0, |own| panels(app, inset(own.area)).first);
        let diagram = polygons.and_then(|polygons| polygons.panel(first, unit));
        let (diagram, _) = diagram.ok_or_else(|| words().no_drawing_here().to_owned())?;
        let title = order_name(first);
        Ok((
            words().the_drawing(),
            diagram.artwork(title).svg(drawing::SvgGround::Preferred),
        ))
    }

    fn file_part(&self) -> Option<&'static str> {
        Some("polygon")
    }
}

/// Returns the name of a panel's order.
fn order_name(number: usize) -> &'static str {
    [
        words().position_polygon(),
        words().velocity_polygon(),
        words().acceleration_polygon(),
    ][number % ORDERS.len()]
}

/// Returns the title of a panel: its order, and its loop if there are several.
fn title(polygons: &LoopPolygons, drawn: &PolygonSketch) -> String {
    let number = drawn.number();
    match polygons.loops.len() {
        1 => order_name(number).to_owned(),
        _ => words().polygon_in_loop(order_name(number), number / ORDERS.len() + 1),
    }
}

/// Returns the scale of a panel, with its unit and an arrow of that length.
fn scale(app: &App, drawn: &PolygonSketch, width: u16) -> String {
    let scale = drawn.scale.iter().cloned().collect::<Vec<_>>();
    let lines = drawing::legend_lines(&scale, app.glyphs(), usize::from(width), 1);
    let pieces = lines.iter().flat_map(|line| line.iter());
    pieces.map(|piece| piece.text.as_str()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(size: f64) -> Vec<Vec2> {
        vec![Vec2::ZERO, Vec2::new(size, 0.0), Vec2::new(0.0, 0.5 * size)]
    }

    /// A driver that rests for half of its cycle has zero polygons there.
    #[test]
    fn resting_driver_keeps_scale_of_its_motion() {
        let sizes = [0.0, 0.0, 0.0, 1.0, 2.0, 100.0];
        let (_, size) = extents_of(sizes.map(triangle).to_vec()).unwrap();
        assert_eq!(size, 2.0, "the last one is far larger than most");
        assert!(extents_of(vec![triangle(0.0); 3]).is_none());
        assert!(extents_of(Vec::new()).is_none());
    }
}
