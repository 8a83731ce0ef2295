//! Draws a figure as an SVG document, with the shapes, window and label places used for cells.
//!
//! The document is as large as the window's cells, with eight user units per column.

mod style;

use crate::Vec2;
use crate::drawing::cells::arrow;
use crate::drawing::cells::labels::Labels;
use crate::drawing::cells::pattern;
use crate::drawing::cells::raster::Raster;
use crate::drawing::cells::render::{Glyphs, draw_order, render_into};
use crate::drawing::figure::{Figure, Role, Shape};
use crate::drawing::legend::LegendEntry;
use crate::drawing::view::WorldView;
use crate::page::{Artwork, SvgGround, TextAnchor};
use std::f64::consts::FRAC_1_SQRT_2;
use style::{STYLE, class};

/// Width of a column in user units.
pub const COLUMN: f64 = 8.0;
/// Height of the legend's line.
const LEGEND: f64 = 26.0;

/// Sizes of symbols in user units.
const PIN: f64 = 4.5;
const SUPPORT: f64 = 14.0;
const TOOTH: f64 = 7.0;
const BLOCK: Vec2 = Vec2 { x: 14.0, y: 8.0 };
/// Distance of a guide's rails from its middle.
const RAIL: f64 = BLOCK.y + 2.0;
const BARREL: f64 = 6.0;
const HEAD: f64 = 9.0;
const MOMENT: f64 = 16.0;
const SPRING: f64 = 7.0;
/// Maximum width of a name's letter, and its height.
const LETTER: f64 = 7.5;
const LINE: f64 = 12.0;

/// Returns the figure in this window as a complete document, with its legend below. The reader's
/// preference selects the background.
#[must_use]
pub fn svg(figure: &Figure, view: &WorldView, title: &str, legend: &[LegendEntry]) -> String {
    let labels = &mut Labels::default();
    svg_on(SvgGround::Preferred, figure, view, title, legend, labels)
}

/// Returns the figure as a document on the given background; `labels` keeps the places of names
/// from one picture to the next.
#[must_use]
pub fn svg_on(
    ground: SvgGround,
    figure: &Figure,
    view: &WorldView,
    title: &str,
    legend: &[LegendEntry],
    labels: &mut Labels,
) -> String {
    artwork(figure, view, title, legend, labels).svg(ground)
}

/// Returns the figure as a picture for a page.
#[must_use]
pub fn artwork(
    figure: &Figure,
    view: &WorldView,
    title: &str,
    legend: &[LegendEntry],
    labels: &mut Labels,
) -> Artwork {
    let cell = Vec2::new(COLUMN, COLUMN * view.aspect());
    let size = Vec2::new(
        f64::from(view.cols()) * cell.x,
        f64::from(view.rows()) * cell.y,
    );
    let below = if legend.is_empty() { 0.0 } else { LEGEND };
    let complete = Vec2::new(size.x.max(1.0), (size.y + below).max(1.0));
    let mut picture = Picture {
        view,
        cell,
        art: Artwork::new(complete, title, STYLE),
    };
    for shape in draw_order(figure) {
        picture.shape(shape);
    }
    picture.names(figure, labels);
    picture.legend(legend, size);
    picture.art
}

struct Picture<'a> {
    view: &'a WorldView,
    cell: Vec2,
    art: Artwork,
}

impl Picture<'_> {
    /// Converts a world point to user units.
    fn place(&self, point: Vec2) -> Vec2 {
        let at = self.view.cell(point);
        Vec2::new(at.x * self.cell.x, at.y * self.cell.y)
    }

    fn shape(&mut self, shape: &Shape) {
        match *shape {
            Shape::Line { from, to, role } => {
                let ends = [from, to].map(|p| self.place(p));
                self.art.polyline(ends, &class(role));
            }
            Shape::Outline { ref corners, role } => {
                let corners: Vec<Vec2> = corners.iter().map(|&c| self.place(c)).collect();
                self.art.polygon(corners, &class(role));
            }
            Shape::Plate { ref corners, role } => {
                let corners: Vec<Vec2> = corners.iter().map(|&c| self.place(c)).collect();
                self.art.polygon(corners, &class(role));
            }
            Shape::Spring { from, to } => {
                let [a, b] = [from, to].map(|p| self.place(p));
                self.art.polyline(pattern::zigzag(a, b, SPRING), "spring");
            }
            Shape::Rod { from, to, role } => {
                let ends = [from, to].map(|p| self.place(p));
                self.art.polyline(ends, &format!("{} rod", class(role)));
            }
            Shape::Barrel { from, to, .. } => {
                let [a, b] = [from, to].map(|p| self.place(p));
                let across = unit(b - a).perp() * BARREL;
                let corners = [a + across, b + across, b - across, a - across];
                self.art.polygon(corners, "barrel");
            }
            Shape::Mark { at, role } => self.mark(at, role),
            Shape::Support { at } => self.support(at),
            Shape::Guide { from, to, role } => {
                let [a, b] = [from, to].map(|p| self.place(p));
                let rail = unit(b - a).perp() * RAIL;
                for rail in [rail, Vec2::ZERO - rail] {
                    self.art.polyline([a + rail, b + rail], &class(role));
                }
            }
            Shape::Hatching { from, to } => {
                let [a, b] = [from, to].map(|p| self.place(p));
                // User units count downwards, so `perp` points to the right.
                let rail = unit(b - a).perp() * RAIL;
                self.teeth(a + rail, b + rail);
            }
            Shape::Block { at, along } => self.block(at, along),
            Shape::Trace { ref course, role } => {
                let positions: Vec<Vec2> = course.iter().map(|&p| self.place(p)).collect();
                self.art.polyline(fewer(&positions), &class(role));
            }
            Shape::Arrow {
                from,
                to,
                role,
                cut,
            } => {
                let [a, b] = [from, to].map(|p| self.place(p));
                self.arrow(a, b, role, cut);
            }
            Shape::Moment { at, is_left } => self.moment(at, is_left),
            Shape::Label { .. } => {}
        }
    }

    fn mark(&mut self, at: Vec2, role: Role) {
        let at = self.place(at);
        match role {
            Role::DriverPin => {
                self.art.circle(at, PIN, "pin");
                self.art.circle(at, PIN - 3.0, "core");
            }
            Role::Rider => self.art.circle(at, PIN - 1.5, "rider"),
            Role::CentreOfMass => {
                self.art.circle(at, PIN, "centre");
                let arm = PIN * FRAC_1_SQRT_2;
                for corner in [Vec2::new(arm, arm), Vec2::new(arm, -arm)] {
                    self.art.polyline([at - corner, at + corner], "cross");
                }
            }
            Role::Ground => self.art.circle(at, 1.5, "rider"),
            _ => self.art.circle(at, PIN, "pin"),
        }
    }

    fn support(&mut self, at: Vec2) {
        let apex = self.place(at);
        let [left, right] = [-SUPPORT * 0.7, SUPPORT * 0.7].map(|x| apex + Vec2::new(x, SUPPORT));
        self.art.polyline([left, apex, right], "ground");
        let [left, right] = [-SUPPORT, SUPPORT].map(|x| apex + Vec2::new(x, SUPPORT));
        self.art.polyline([left, right], "ground");
        self.teeth(left, right);
    }

    /// Draws hatching to the right of a direction on the drawing.
    fn teeth(&mut self, a: Vec2, b: Vec2) {
        let along = b - a;
        let unit = unit(along);
        // User units count downwards, so `perp` points to the right.
        let tooth = (unit.perp() - unit) * (TOOTH * FRAC_1_SQRT_2);
        // Limits the number of teeth of lines far larger than the paper.
        let maximum = (self.art.size().norm() * 4.0 / TOOTH).min(10_000.0);
        let count = (along.norm() / TOOTH).min(maximum).floor();
        let places = std::iter::successors(Some(1.0), |k| Some(k + 1.0));
        let mut teeth = Vec::new();
        for k in places.take_while(|&k| k <= count) {
            let foot = a + unit * (k * TOOTH);
            teeth.extend([foot, foot + tooth, GAP]);
        }
        self.art.polyline(teeth, "ground");
    }

    fn block(&mut self, at: Vec2, along: Vec2) {
        let at = self.place(at);
        let along = unit(Vec2::new(along.x, -along.y));
        let (x, y) = (along * BLOCK.x, along.perp() * BLOCK.y);
        self.art
            .polygon([at + x + y, at - x + y, at - x - y, at + x - y], "block");
    }

    fn arrow(&mut self, from: Vec2, to: Vec2, role: Role, cut: bool) {
        let step = to - from;
        if step.norm() < HEAD / 2.0 {
            return;
        }
        let class = class(role);
        for &(start, end) in arrow::pieces(cut) {
            self.art
                .polyline([from + step * start, from + step * end], &class);
        }
        let back = unit(step) * HEAD;
        let side = back.perp() * 0.4;
        let heads: &[f64] = match role {
            Role::Acceleration => &[0.0, 0.8],
            _ => &[0.0],
        };
        for &after in heads {
            let tip = to - back * after;
            let barbs = [tip - back + side, tip, tip - back - side];
            self.art.polyline(barbs, &format!("{class} head"));
        }
        if role == Role::Force {
            let foot = to - back;
            self.art.polyline([foot + side, foot - side], &class);
        }
    }

    /// Draws an arrow around three quarters of a circle.
    fn moment(&mut self, at: Vec2, is_left: bool) {
        let at = self.place(at);
        let sense = if is_left { 1.0 } else { -1.0 };
        // User units count downwards: counter-clockwise is upwards on the paper.
        let on_ring = |degrees: f64| {
            let v = crate::angle::unit(degrees) * MOMENT;
            at + Vec2::new(v.x * sense, -v.y)
        };
        let ring = (0..=27).map(|k| on_ring(45.0 + 10.0 * f64::from(k)));
        self.art.polyline(ring, "force");
        let tip = on_ring(315.0);
        let back = unit(tip - on_ring(295.0)) * HEAD;
        let side = back.perp() * 0.4;
        self.art
            .polyline([tip - back + side, tip, tip - back - side], "force head");
    }

    /// Draws the names on the sides chosen for cells, clear of everything else. Their offsets are
    /// measured from the points, not from the points' cells, so that names move smoothly with their
    /// points.
    fn names(&mut self, figure: &Figure, labels: &mut Labels) {
        let mut raster = Raster::new();
        render_into(figure, self.view, Glyphs::Braille, labels, &mut raster);
        for (text, point, col, row) in labels.placed_names(figure, self.view) {
            let away = Vec2::new(f64::from(col) - 0.5, f64::from(row) + 0.25);
            let away = Vec2::new(away.x * self.cell.x, away.y * self.cell.y);
            let at = self.place(point) + away;
            let (size, space) = (self.art.size(), LETTER * text.chars().count() as f64);
            let inside = |v: f64, minimum: f64, maximum: f64| v.min(maximum).max(minimum);
            let at = Vec2::new(
                inside(at.x, 1.0, size.x - space),
                inside(at.y, LINE, size.y - 0.3 * LINE),
            );
            self.art.text(at, TextAnchor::Start, "halo", text);
            self.art.text(at, TextAnchor::Start, "name", text);
        }
    }

    fn legend(&mut self, legend: &[LegendEntry], below: Vec2) {
        let mut at = Vec2::new(COLUMN, below.y + LEGEND * 0.5);
        for entry in legend {
            let (text, arrow) = match entry {
                LegendEntry::Arrow { role, text, cells } => {
                    (format!("{text} ="), Some((*role, cells * COLUMN)))
                }
                LegendEntry::Note(text) => (text.clone(), None),
            };
            self.art
                .text(at + Vec2::new(0.0, 4.0), TextAnchor::Start, "name", &text);
            at.x += (text.chars().count() as f64 + 1.0) * COLUMN;
            if let Some((role, length)) = arrow {
                self.arrow(at, at + Vec2::new(length, 0.0), role, false);
                at.x += length + COLUMN;
            }
            at.x += 2.0 * COLUMN;
        }
    }
}

/// Maximum deviation of a simplified chain of lines, in user units.
const OFF: f64 = 0.1;

/// Returns the chain without invisible corners; gaps are kept.
fn fewer(positions: &[Vec2]) -> Vec<Vec2> {
    let mut kept = Vec::new();
    for run in positions.split(|p| !p.is_finite()) {
        if !kept.is_empty() {
            kept.push(GAP);
        }
        let mut from = 0;
        for to in 1..run.len() {
            let chord = run[to] - run[from];
            let near = |p: &Vec2| (*p - run[from]).cross(chord).abs() <= OFF * chord.norm();
            // A reversal along the same line is a corner too.
            let continues = (run[to - 1] - run[from]).norm() <= chord.norm();
            if !(continues && run[from + 1..to].iter().all(near)) {
                kept.push(run[from]);
                from = to - 1;
            }
        }
        kept.extend(run.get(from));
        kept.extend(run.last().filter(|_| from + 1 < run.len()));
    }
    kept
}

/// The point that interrupts a polyline.
const GAP: Vec2 = Vec2 {
    x: f64::NAN,
    y: f64::NAN,
};

/// Returns the unit vector; not finite for a zero vector.
fn unit(v: Vec2) -> Vec2 {
    v / v.norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{
        Extents, Layers, Overlay, OverlayRequest, linkage, usual_arrows, usual_traces,
    };
    use crate::scene::{Scene, presets};
    use crate::solver::{Order, Solver};

    /// Returns the document of a preset with all layers and overlays, enlarged by `zoom`.
    fn document(text: &str, title: &str, zoom: f64) -> String {
        let scene = Scene::parse(text, "test").unwrap();
        let solver = Solver::new(&scene.mechanism).unwrap();
        let extents = Extents::of(&scene, &solver);
        let points = usual_arrows(&scene.mechanism);
        let wanted = OverlayRequest {
            is_timed: false,
            traces: usual_traces(&scene),
            velocities: points.clone(),
            accelerations: points,
            forces: true,
            ghosts: 3,
        };
        let overlay = Overlay::of(&scene, &solver, &extents, &wanted);
        let mut state = solver.state();
        let _ = solver.solve(scene.mechanism.driver().start, Order::Force, &mut state);
        let layers = Layers {
            links: true,
            centres: true,
            ..Layers::default()
        };
        let mut figure = linkage(&scene, &extents, &state, layers);
        overlay.add_to(&mut figure, &scene, &solver, &state, zoom);
        let view = WorldView::lowest_window(50, |rows| WorldView::fit(&extents, 100, rows, 2.0))
            .zoomed(zoom, Vec2::ZERO);
        svg(&figure, &view, title, &overlay.legend(&view, zoom))
    }

    /// Returns `true` if every element is closed, and the document contains only permitted XML.
    fn is_well_formed(document: &str) -> bool {
        let mut open = Vec::new();
        let mut rest = document;
        while let Some(at) = rest.find('<') {
            let Some(end) = rest[at..].find('>') else {
                return false;
            };
            let tag = &rest[at + 1..at + end];
            let name = tag.trim_start_matches('/').split([' ', '/']).next();
            if tag.starts_with('/') {
                if open.pop() != name {
                    return false;
                }
            } else if !tag.ends_with('/') {
                open.push(name.unwrap_or(""));
            }
            if tag.matches('"').count() % 2 == 1 || tag.contains('<') {
                return false;
            }
            rest = &rest[at + end + 1..];
        }
        let allowed = |c: char| c == '\n' || !c.is_control();
        open.is_empty() && !rest.contains('>') && document.chars().all(allowed)
    }

    #[test]
    fn svg_of_every_preset_is_well_formed() {
        for preset in presets::all() {
            for zoom in [1.0, 40.0] {
                let document = document(preset.text, preset.name, zoom);
                assert!(is_well_formed(&document), "{}\n{document}", preset.name);
                for word in ["NaN", "inf"] {
                    assert!(!document.contains(word), "{}: {word}", preset.name);
                }
                assert!(
                    document.len() < 200_000,
                    "{}: {}",
                    preset.name,
                    document.len()
                );
            }
        }
    }

    #[test]
    fn checker_rejects_malformed_documents() {
        assert!(is_well_formed("<svg a=\"1\"><g/><t>x</t></svg>\n"));
        for bad in ["<svg>", "<a><b></a></b>", "<a b=\"></a>", "<a>\u{1b}</a>"] {
            assert!(!is_well_formed(bad), "{bad}");
        }
    }

    #[test]
    fn svg_contains_every_part_of_the_figure() {
        let text = presets::find("press-ram").unwrap().text;
        let document = document(text, "A & B", 1.0);
        assert!(document.contains("<title>A &amp; B</title>"));
        let classes = [
            "link hue0",
            "plate hue1",
            "driver",
            "guide",
            "ground",
            "trace",
            "echo",
            "block",
            "pin",
            "velocity",
            "velocity head",
            "acceleration head",
            "name",
        ];
        for class in classes {
            assert!(document.contains(&format!("class=\"{class}\"")), "{class}");
        }
        for name in [">A<", ">r2<", "mm/s =<", "mm/s^2 =<"] {
            assert!(document.contains(name), "{name}");
        }
        assert!(document.contains("prefers-color-scheme:dark"));
    }

    #[test]
    fn simplified_curve_stays_within_tolerance() {
        let circle = |k: i32| crate::angle::unit(f64::from(k) * 0.5) * 200.0;
        let mut course: Vec<Vec2> = (0..=720).map(circle).collect();
        let kept = fewer(&course);
        assert!(kept.len() < 200, "{}", kept.len());
        assert_eq!((kept[0], kept[kept.len() - 1]), (course[0], course[720]));
        for pair in kept.windows(2) {
            let middle = (pair[0] + pair[1]) * 0.5;
            assert!((middle.norm() - 200.0).abs() <= OFF);
        }
        course[100] = GAP;
        let gaps = fewer(&course).iter().filter(|p| !p.is_finite()).count();
        assert_eq!(gaps, 1);
        // Back and forth on a line: the turning point stays.
        let along = [0.0, 4.0, 9.0, 5.0, 0.0].map(|x| Vec2::new(x, 0.0));
        let turned: Vec<f64> = fewer(&along).iter().map(|p| p.x).collect();
        assert_eq!(turned, [0.0, 9.0, 0.0]);
        assert_eq!(fewer(&[]), []);
        assert_eq!(fewer(&along[..1]), along[..1]);
    }
}
