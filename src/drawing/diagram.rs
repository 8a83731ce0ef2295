//! Draws vectors to scale: the closed polygon of a loop's vectors, head to tail, and velocities or
//! accelerations from one pole.

use super::cells::render::{Glyphs, render};
use super::figure::{Figure, Role, Shape};
use super::motion::extents::Extents;
use super::view::WorldView;
use crate::page::{Artwork, StyleSheet, TextAnchor};
use crate::{Vec2, angle};
use std::collections::HashMap;

/// Vectors in a plane, drawn to one scale.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VectorDiagram {
    /// The vectors.
    pub arrows: Vec<DiagramArrow>,
    /// Angles at the tails of vectors.
    pub arcs: Vec<DiagramArc>,
    /// The unit of the vectors, such as `mm/s`.
    pub unit: String,
}

/// A vector of a diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramArrow {
    /// The tail.
    pub from: Vec2,
    /// The head.
    pub to: Vec2,
    /// The symbol.
    pub name: String,
    /// The vector's kind.
    pub kind: ArrowKind,
    /// The vector of a loop to which it belongs; empty if it belongs to none.
    pub vector: String,
}

/// The kind of a diagram's vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowKind {
    /// Known from the start.
    Given,
    /// Moved by the driver.
    Driven,
    /// Computed.
    Sought,
    /// A component of another vector.
    Part,
}

/// An angle, counter-clockwise from the x axis, at the tail of a vector.
#[derive(Clone, Debug, PartialEq)]
pub struct DiagramArc {
    /// The vector's tail.
    pub at: Vec2,
    /// The angle in degrees, in [0, 360).
    pub to: f64,
    /// The symbol.
    pub name: String,
}

/// The sheet and the margin around the drawing, in user units; the scale bar takes the foot below.
const SHEET: Vec2 = Vec2 { x: 640.0, y: 480.0 };
const MARGIN: f64 = 56.0;
const FOOT: f64 = 40.0;
const HEAD: f64 = 10.0;
/// The radius of an arc, and the distance of its name from it.
const ARC: f64 = 20.0;
const ASIDE: f64 = 13.0;
/// The average width of a letter.
const LETTER: f64 = 7.0;
/// Minimum arrow length. A shorter arrow would be a head alone.
const MIN_LEN: f64 = 2.0;
/// Distance from the middle of a text down to its baseline.
const HALF_TEXT: f64 = 4.5;

const STYLE: StyleSheet = StyleSheet {
    light: include_str!("diagram/light.css"),
    dark: include_str!("diagram/dark.css"),
};

/// Maximum columns and rows of the diagram in characters.
const CHARACTERS: (u16, u16) = (76, 26);
const CELL_ASPECT: f64 = 2.0;

impl VectorDiagram {
    /// Returns `true` if the diagram has no vectors.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.arrows.is_empty()
    }

    /// Adds a vector. One that is not finite is left out.
    pub fn add(&mut self, from: Vec2, to: Vec2, name: impl Into<String>, kind: ArrowKind) {
        self.add_of("", from, to, &name.into(), kind);
    }

    /// Adds a vector that belongs to a vector of a loop.
    pub(crate) fn add_of(
        &mut self,
        vector: &str,
        from: Vec2,
        to: Vec2,
        name: &str,
        kind: ArrowKind,
    ) {
        if from.is_finite() && to.is_finite() {
            self.arrows.push(DiagramArrow {
                from,
                to,
                name: name.to_owned(),
                kind,
                vector: vector.to_owned(),
            });
        }
    }

    /// Returns the diagram as a picture.
    #[must_use]
    pub fn artwork(&self, title: &str) -> Artwork {
        let scale = DiagramScale::of(self);
        let size = Vec2::new(SHEET.x, scale.height + FOOT);
        let mut sheet = DiagramSheet {
            art: Artwork::new(size, title, STYLE),
            scale,
            occupied: TakenPlaces::default(),
        };
        for arrow in &self.arrows {
            let ends = [arrow.from, arrow.to].map(|p| sheet.scale.place(p));
            let along = |k| ends[0] + (ends[1] - ends[0]) * (f64::from(k) / 24.0);
            (0..=24).for_each(|k| sheet.occupied.add(along(k)));
        }
        for arc in &self.arcs {
            sheet.arc(arc);
        }
        for arrow in &self.arrows {
            sheet.arrow(arrow);
        }
        sheet.foot(&self.unit);
        sheet.art
    }

    /// Returns the diagram in characters, line by line.
    #[must_use]
    pub fn characters(&self) -> Vec<String> {
        let figure = self.figure(|_| Role::Velocity);
        let extents = Extents::of_places(&self.places(), &[]);
        let (cols, maximum) = CHARACTERS;
        let of_rows = |rows| WorldView::fit(&extents, cols, rows, CELL_ASPECT);
        let drawn = render(
            &figure,
            &WorldView::lowest_window(maximum, of_rows),
            Glyphs::Ascii,
        );
        lines_drawn(&drawn.text())
    }

    /// Returns the figure of the vectors with their names, each with the role of its vector.
    pub(crate) fn figure(&self, role_of: impl Fn(&DiagramArrow) -> Role) -> Figure {
        let mut figure = Figure::new();
        for arrow in &self.arrows {
            let (from, to) = (arrow.from, arrow.to);
            figure.add(Shape::Arrow {
                from,
                to,
                role: role_of(arrow),
                cut: false,
            });
            figure.add(Shape::Label {
                at: (from + to) * 0.5,
                text: arrow.name.clone(),
                role: Role::Label,
            });
        }
        // The heads are drawn last, above all shafts.
        for arrow in &self.arrows {
            let (middle, to) = ((arrow.from + arrow.to) * 0.5, arrow.to);
            figure.add(Shape::Arrow {
                from: middle,
                to,
                role: role_of(arrow),
                cut: false,
            });
        }
        figure
    }

    /// Returns the ends of all vectors.
    pub(crate) fn places(&self) -> Vec<Vec2> {
        self.arrows.iter().flat_map(|a| [a.from, a.to]).collect()
    }
}

/// Returns the lines of a text drawing, without blank lines at its start and end.
pub(crate) fn lines_drawn(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| line.trim_end().to_owned());
    let mut lines: Vec<String> = lines.skip_while(String::is_empty).collect();
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// The transformation from the plane to the sheet.
struct DiagramScale {
    /// User units on the sheet per unit of the plane.
    each: f64,
    /// The point of the plane at the upper left corner, inside the margin.
    corner: Vec2,
    height: f64,
}

impl DiagramScale {
    fn of(diagram: &VectorDiagram) -> DiagramScale {
        let positions = diagram.places();
        let bound = |of: fn(f64, f64) -> f64, axis: fn(&Vec2) -> f64| {
            positions.iter().map(axis).reduce(of).unwrap_or(0.0)
        };
        let [low_x, high_x] = [f64::min, f64::max].map(|of| bound(of, |p| p.x));
        let [low_y, high_y] = [f64::min, f64::max].map(|of| bound(of, |p| p.y));
        let space = SHEET - Vec2::new(2.0, 2.0) * MARGIN;
        let each = (space.x / (high_x - low_x)).min(space.y / (high_y - low_y));
        let each = if each.is_finite() && each > 0.0 {
            each
        } else {
            1.0
        };
        // Centred in the sheet's width.
        let spare = (space.x / each - (high_x - low_x)) * 0.5;
        DiagramScale {
            each,
            corner: Vec2::new(low_x - spare, high_y),
            height: (high_y - low_y) * each + 2.0 * MARGIN,
        }
    }

    fn place(&self, at: Vec2) -> Vec2 {
        let away = (at - self.corner) * self.each;
        Vec2::new(MARGIN + away.x, MARGIN - away.y)
    }
}

struct DiagramSheet {
    art: Artwork,
    scale: DiagramScale,
    /// Occupied points, which names should not cover.
    occupied: TakenPlaces,
}

/// Occupied points of a sheet in square cells, so that only near ones are searched.
#[derive(Default)]
struct TakenPlaces {
    cells: HashMap<[i32; 2], Vec<Vec2>>,
}

impl TakenPlaces {
    /// The distance beyond which all places are equally free, and the size of a cell.
    const FAR: f64 = 3.0 * ASIDE;

    fn cell(at: Vec2) -> [i32; 2] {
        // The cast limits places far outside the sheet.
        [at.x, at.y].map(|v| (v / TakenPlaces::FAR).floor() as i32)
    }

    fn add(&mut self, at: Vec2) {
        self.cells
            .entry(TakenPlaces::cell(at))
            .or_default()
            .push(at);
    }

    /// Returns the distance of a place from the nearest point, at most [`TakenPlaces::FAR`]. Returns
    /// any distance up to `minimum` if the point is not farther than that.
    fn room(&self, seat: Vec2, minimum: f64) -> f64 {
        let [col, row] = TakenPlaces::cell(seat);
        let mut space = TakenPlaces::FAR;
        for dy in [0, -1, 1] {
            for dx in [0, -1, 1] {
                let cell = [col.saturating_add(dx), row.saturating_add(dy)];
                for place in self.cells.get(&cell).into_iter().flatten() {
                    let between = *place - seat;
                    // A square root for each of thousands of points would take most of the time.
                    if between.x.abs() >= space || between.y.abs() >= space {
                        continue;
                    }
                    space = space.min(between.norm());
                    if space <= minimum {
                        return space;
                    }
                }
            }
        }
        space
    }
}

impl DiagramSheet {
    fn arrow(&mut self, arrow: &DiagramArrow) {
        let [from, to] = [arrow.from, arrow.to].map(|p| self.scale.place(p));
        let along = to - from;
        if along.norm() < MIN_LEN {
            return;
        }
        let class = match arrow.kind {
            ArrowKind::Given => "given",
            ArrowKind::Driven => "driven",
            ArrowKind::Sought => "sought",
            ArrowKind::Part => "part",
        };
        let unit = along / along.norm();
        self.art.polyline([from, to], class);
        let back = unit * HEAD.min(along.norm() * 0.6);
        let side = back.perp() * 0.35;
        let barbs = [to - back + side, to, to - back - side];
        self.art.polyline(barbs, &format!("{class} head"));
        let aside = unit.perp() * (ASIDE + LETTER * 0.25 * arrow.name.chars().count() as f64);
        let shares = [0.5, 0.4, 0.6, 0.3, 0.7];
        let seats = shares.into_iter().flat_map(|share| {
            let at = from + along * share;
            [at + aside, at - aside]
        });
        let at = self.freest(seats.collect());
        self.name(at, "name", &arrow.name);
    }

    fn arc(&mut self, arc: &DiagramArc) {
        let at = self.scale.place(arc.at);
        self.art
            .polyline([at, at + Vec2::new(2.2 * ARC, 0.0)], "level");
        let on_ring = |degrees: f64, radius: f64| {
            let v = angle::unit(degrees) * radius;
            at + Vec2::new(v.x, -v.y)
        };
        let steps = (arc.to / 6.0).ceil().clamp(1.0, 60.0);
        let places = std::iter::successors(Some(0.0), |k| Some(k + 1.0));
        let places = places.take_while(|&k| k <= steps);
        let ring: Vec<Vec2> = places.map(|k| on_ring(arc.to * k / steps, ARC)).collect();
        if arc.to > 1.0 {
            self.art.polyline(ring.iter().copied(), "arc");
            let (tip, before) = (on_ring(arc.to, ARC), on_ring(arc.to - 14.0, ARC));
            let back = (before - tip) / (before - tip).norm() * 5.0;
            let side = back.perp() * 0.5;
            self.art
                .polyline([tip + back + side, tip, tip + back - side], "arc");
        }
        ring.into_iter().for_each(|at| self.occupied.add(at));
        let shares = [0.5, 0.35, 0.65, 0.2, 0.8];
        let seats = [1.0, 2.0]
            .into_iter()
            .flat_map(|out| shares.map(|share| on_ring(arc.to * share, ARC + out * ASIDE)));
        let seat = self.freest(seats.collect());
        self.name(seat, "of-arc", &arc.name);
    }

    /// Returns the place farthest from everything drawn already; the first of nearly equal places.
    fn freest(&self, seats: Vec<Vec2>) -> Vec2 {
        let mut best = seats.first().copied().unwrap_or(Vec2::ZERO);
        let mut maximum = self.occupied.room(best, 0.0);
        for seat in seats {
            let space = self.occupied.room(seat, maximum + 1.0);
            if space > maximum + 1.0 {
                (best, maximum) = (seat, space);
            }
        }
        best
    }

    fn name(&mut self, at: Vec2, class: &str, text: &str) {
        let half = 0.5 * LETTER * text.chars().count() as f64;
        let size = self.art.size();
        let inside = |v: f64, space: f64, margin: f64| v.min(space - margin).max(margin);
        let at = Vec2::new(
            inside(at.x, size.x, half),
            inside(at.y, size.y, 2.0 * HALF_TEXT),
        );
        let base = at + Vec2::new(0.0, HALF_TEXT);
        self.art.text(base, TextAnchor::Middle, class, text);
        self.occupied.add(at);
    }

    /// Draws the scale bar.
    fn foot(&mut self, unit: &str) {
        let Some(value) = round_length(100.0 / self.scale.each) else {
            return;
        };
        let y = self.art.size().y - FOOT * 0.5;
        let from = Vec2::new(MARGIN, y);
        let to = from + Vec2::new(value * self.scale.each, 0.0);
        self.art.polyline([from, to], "scale");
        for end in [from, to] {
            let tick = Vec2::new(0.0, 4.0);
            self.art.polyline([end - tick, end + tick], "scale");
        }
        let text = format!("{value} {unit}");
        let at = to + Vec2::new(8.0, HALF_TEXT);
        self.art.text(at, TextAnchor::Start, "name", &text);
    }
}

/// Returns the largest of 1, 2 and 5 times a power of ten that is at most `maximum`.
fn round_length(maximum: f64) -> Option<f64> {
    let power = 10.0_f64.powf(maximum.log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * power);
    let value = steps
        .into_iter()
        .find(|&step| step <= maximum * (1.0 + 1e-9));
    value.filter(|v| v.is_finite() && *v > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::ArtElement;

    /// Returns the vectors of all lines with a class.
    fn drawn(art: &Artwork, class: &str) -> Vec<Vec2> {
        let of = |element: &ArtElement| match element {
            ArtElement::Path {
                runs, class: own, ..
            } if own == class => Some(runs[0][1] - runs[0][0]),
            _ => None,
        };
        art.elements().iter().filter_map(of).collect()
    }

    #[test]
    fn closed_polygon_is_drawn_closed_and_to_scale() {
        let corners = [(0.0, 0.0), (-400.0, 0.0), (-350.0, 86.6), (-88.6, 233.8)];
        let corners = corners.map(|(x, y)| Vec2::new(x, y));
        let mut diagram = VectorDiagram::default();
        for (k, &from) in corners.iter().enumerate() {
            let to = corners[(k + 1) % corners.len()];
            diagram.add(from, to, format!("r{}", k + 1), ArrowKind::Sought);
        }
        let art = diagram.artwork("loop");
        let lines = drawn(&art, "sought");
        assert_eq!(lines.len(), 4);
        let sum = lines.iter().fold(Vec2::ZERO, |sum, line| sum + *line);
        assert!(sum.norm() < 1e-9, "{sum:?}");
        // The lines are to scale and within the picture.
        let each = lines[0].norm() / 400.0;
        assert!((lines[1].norm() - each * (corners[2] - corners[1]).norm()).abs() < 1e-9);
        for element in art.elements() {
            if let ArtElement::Path { runs, .. } = element {
                for p in runs.iter().flatten() {
                    assert!((0.0..=art.size().x).contains(&p.x), "{p:?}");
                    assert!((0.0..=art.size().y).contains(&p.y), "{p:?}");
                }
            }
        }
        let text = diagram.characters().join("\n");
        for name in ["r1", "r2", "r3", "r4"] {
            assert!(text.contains(name), "{text}");
        }
    }

    #[test]
    fn scale_lengths_are_round() {
        assert_eq!(round_length(123.0), Some(100.0));
        assert_eq!(round_length(49.0), Some(20.0));
        assert_eq!(round_length(0.5), Some(0.5));
        assert_eq!(round_length(f64::INFINITY), None);
    }

    #[test]
    fn empty_and_degenerate_diagrams_are_drawn() {
        let mut one = VectorDiagram::default();
        assert!(one.is_empty());
        let _ = one.artwork("nothing");
        one.add(Vec2::ZERO, Vec2::ZERO, "v", ArrowKind::Given);
        one.add(Vec2::ZERO, Vec2::new(f64::NAN, 0.0), "w", ArrowKind::Given);
        assert_eq!(one.arrows.len(), 1);
        let _ = (one.artwork("a point"), one.characters());
    }
}
