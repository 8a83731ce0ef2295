//! Draws the symbols of kinematic sketches: supports, hatching, blocks and marks. Their size is
//! counted in cells, so they stay readable at any scale.

use super::raster::Raster;
use super::render::Glyphs;
use super::stroke;
use super::{arrow, pattern};
use crate::Vec2;
use crate::drawing::figure::Role;
use crate::drawing::view::WorldView;
use std::f64::consts::FRAC_PI_3;

/// Minimum number of rows for the triangle under a ground pin.
const MIN_ROWS_WITH_TRIANGLE: u16 = 16;

/// Distance of the strokes of hatching, in cells.
const HATCHING: usize = 2;

/// Half the width of a barrel, in cell widths per dot of a bar's width plus one.
const BARREL: f64 = 0.35;

/// The smallest sine of the angle between the x axis and an inclined guide. A block on any other
/// guide is level, and three characters draw it more clearly than dots.
const INCLINED: f64 = 0.2;

/// Additional width of a highlighted bar, in dots.
const HIGHLIGHT_WIDTH: u8 = 2;

/// Distance of a guide's rails from its middle, in cell widths: just outside the block.
const RAIL: f64 = (pattern::BLOCK.y + 1.5) / stroke::FINE.x;

/// Length of a dotted guide beyond its ends, in cell widths: it must be visible on both sides of a
/// block at the end of its travel.
const GUIDE_END: f64 = 2.0;

/// Radius of the arrow of a moment, in cell widths; its start and end in radians, and the number of
/// straight pieces.
const MOMENT: f64 = 2.2;
const ARC: std::ops::Range<f64> = FRAC_PI_3..5.0 * FRAC_PI_3;
const ARC_STEPS: u8 = 12;

/// Height of a spring's teeth, in cell widths.
const SPRING: f64 = 1.0;

/// The window, glyphs and raster that symbols are drawn with.
pub(in crate::drawing) struct Symbols<'a> {
    pub(in crate::drawing) view: &'a WorldView,
    pub(in crate::drawing) glyphs: Glyphs,
    pub(in crate::drawing) raster: &'a mut Raster,
}

/// A coordinate beyond any raster, and small enough for integer arithmetic.
const OFF_RASTER: f64 = 1e6;

/// Returns the cell that contains a point in cell coordinates. A far or undefined point gives a
/// cell outside any raster.
pub(in crate::drawing) fn cell_of(at: Vec2) -> (i32, i32) {
    let index = |v: f64| {
        if v.is_nan() {
            OFF_RASTER
        } else {
            v.clamp(-OFF_RASTER, OFF_RASTER)
        }
        .floor() as i32
    };
    (index(at.x), index(at.y))
}

impl Symbols<'_> {
    /// Draws the support under a ground pin: a triangle and hatching, or hatching alone in a low
    /// window.
    pub(in crate::drawing) fn support(&mut self, at: Vec2) {
        let middle = self.view.cell(at);
        let (col, row) = cell_of(middle);
        let roomy = self.view.rows() >= MIN_ROWS_WITH_TRIANGLE;
        if self.glyphs.is_dotted() {
            self.dotted_support(middle, roomy);
            return;
        }
        if roomy {
            self.stamp(col - 1, row + 1, "/_\\", Role::Ground);
        }
        self.stamp(col - 2, row + 1 + i32::from(roomy), "/////", Role::Ground);
    }

    /// Draws the support from lines, centred under the pin's mark.
    fn dotted_support(&mut self, middle: Vec2, roomy: bool) {
        let pin = self.pin_place(middle);
        let apex = Vec2::new(pin.x, pin.y + 0.4);
        let base = if roomy { apex.y + 1.1 } else { apex.y + 0.2 };
        let at = |x: f64, y: f64| Vec2::new(apex.x + x, base + y);
        if roomy {
            for side in [-1.5, 1.5] {
                self.line(apex, at(side, 0.0), Role::Ground);
            }
        }
        self.line(at(-2.5, 0.0), at(2.5, 0.0), Role::Ground);
        for x in [-2.0, -1.0, 0.0, 1.0, 2.0] {
            self.line(at(x, 0.0), at(x - 1.0, 0.5), Role::Ground);
        }
    }

    /// Returns the place of a pin's mark: between four dots if marks are made of dots, or else the
    /// middle of its cell.
    fn pin_place(&self, at: Vec2) -> Vec2 {
        if self.has_large_marks() {
            let (x, y) = pattern::corner(at);
            Vec2::new(f64::from(x) / stroke::FINE.x, f64::from(y) / stroke::FINE.y)
        } else {
            Vec2::new(at.x.floor() + 0.5, at.y.floor() + 0.5)
        }
    }

    /// Returns `true` if marks are made of dots: a character would be lost next to wide bars.
    fn has_large_marks(&self) -> bool {
        self.glyphs.is_dotted() && self.view.weight() > 2
    }

    /// Draws a straight piece of a link, as wide as the window allows.
    pub(in crate::drawing) fn bar(&mut self, a: Vec2, b: Vec2, role: Role) {
        if self.glyphs.is_dotted() && role.is_body() {
            let more = if role == Role::Lit {
                HIGHLIGHT_WIDTH
            } else {
                0
            };
            stroke::bar(self.raster, a, b, self.view.weight() + more, role);
        } else {
            self.line(a, b, role);
        }
    }

    fn line(&mut self, a: Vec2, b: Vec2, role: Role) {
        stroke::line(self.raster, self.glyphs, a, b, role);
    }

    fn stamp(&mut self, col: i32, row: i32, glyphs: &str, role: Role) {
        for (i, glyph) in (0..).zip(glyphs.chars()) {
            self.raster.set_cell(col + i, row, glyph, role);
        }
    }

    /// Draws an arrow around two thirds of a circle.
    pub(in crate::drawing) fn moment(&mut self, at: Vec2, is_left: bool) {
        if self.glyphs.is_dotted() {
            return self.dotted_moment(at, is_left);
        }
        let (col, row) = cell_of(self.view.cell(at));
        let lines = if is_left {
            [(-1, ".--"), (-2, "("), (-1, "'->")]
        } else {
            [(-1, "--."), (2, ")"), (-1, "<-'")]
        };
        for ((left, glyphs), below) in lines.into_iter().zip([-1, 0, 1]) {
            self.stamp(col + left, row + below, glyphs, Role::Force);
        }
    }

    /// Draws the arrow of a moment as an arc with a head, which is below the point.
    fn dotted_moment(&mut self, at: Vec2, is_left: bool) {
        let (middle, aspect) = (self.view.cell(at), self.view.aspect());
        let side = if is_left { 1.0 } else { -1.0 };
        let on_arc = |step: u8| {
            let share = f64::from(step) / f64::from(ARC_STEPS);
            let (sin, cos) = (ARC.start + share * (ARC.end - ARC.start)).sin_cos();
            middle + Vec2::new(side * cos, -sin / aspect) * MOMENT
        };
        for step in 0..ARC_STEPS {
            self.line(on_arc(step), on_arc(step + 1), Role::Force);
        }
        let (col, row) = cell_of(on_arc(ARC_STEPS));
        let head = arrow::head(self.glyphs, Vec2::new(side, 0.0));
        self.raster.set_cell(col, row, head, Role::Force);
    }

    /// Draws a guide on the ground. If blocks and pins are made of dots, it is two rails with the
    /// block between them, because a single line through both would hide them.
    pub(in crate::drawing) fn guide(&mut self, from: Vec2, to: Vec2, role: Role) {
        let (a, b) = self.guide_ends(from, to);
        if !self.has_large_marks() {
            return self.bar(a, b, role);
        }
        let nearby = self.cell_offset(a, b) * RAIL;
        for rail in [nearby, Vec2::ZERO - nearby] {
            self.line(a + rail, b + rail, role);
        }
    }

    /// Returns the ends of a guide in cell coordinates, in dots some cells beyond the given ones.
    fn guide_ends(&self, from: Vec2, to: Vec2) -> (Vec2, Vec2) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        if !self.glyphs.is_dotted() {
            return (a, b);
        }
        let aspect = self.view.aspect();
        let along = Vec2::new(b.x - a.x, (b.y - a.y) * aspect);
        let more = along * (GUIDE_END / along.norm());
        let more = Vec2::new(more.x, more.y / aspect);
        if more.is_finite() {
            (a - more, b + more)
        } else {
            (a, b)
        }
    }

    /// Returns a vector of one cell width to the right of a direction; not finite for a direction
    /// of zero length.
    fn cell_offset(&self, a: Vec2, b: Vec2) -> Vec2 {
        let aspect = self.view.aspect();
        let along = Vec2::new(b.x - a.x, (b.y - a.y) * aspect);
        // Rows count downwards, so `perp` points to the right.
        let right = along.perp() / along.norm();
        Vec2::new(right.x, right.y / aspect)
    }

    /// Draws short strokes along a guide, to the right of its direction.
    pub(in crate::drawing) fn hatching(&mut self, from: Vec2, to: Vec2) {
        let (a, b) = self.guide_ends(from, to);
        if self.has_large_marks() {
            let rail = self.cell_offset(a, b) * RAIL;
            return self.dotted_hatching(a + rail, b + rail);
        }
        if self.glyphs.is_dotted() {
            return self.dotted_hatching(a, b);
        }
        let along = b - a;
        let steep = along.y.abs() > along.x.abs();
        let offset = if steep {
            Vec2::new(-along.y.signum(), 0.0)
        } else {
            Vec2::new(0.0, along.x.signum())
        };
        // Slashes next to a line of slashes would be indistinguishable from it.
        let rising = along.x * along.y < 0.0;
        let glyph = if rising && along.x.abs() * 4.0 > along.y.abs() {
            '\\'
        } else {
            '/'
        };
        let cells = stroke::cells(self.raster, a + offset, b + offset);
        for (col, row) in cells.step_by(HATCHING) {
            self.raster.set_cell(col, row, glyph, Role::Ground);
        }
    }

    fn dotted_hatching(&mut self, a: Vec2, b: Vec2) {
        let Some((a, b)) = stroke::clip(a, b, self.raster) else {
            return;
        };
        let aspect = self.view.aspect();
        // In cell widths, so that a square on the grid is a square on the screen.
        let along = Vec2::new(b.x - a.x, (b.y - a.y) * aspect);
        let length = along.norm();
        let unit = along / length;
        // Rows count downwards, so `perp` points to the right.
        let stroke = (unit.perp() - unit) * 1.3;
        let on_screen = |v: Vec2| Vec2::new(v.x, v.y / aspect);
        let spacing = HATCHING as f64;
        let count = (length / spacing) as u32;
        for k in 1..=count {
            let foot = a + on_screen(unit * (f64::from(k) * spacing));
            self.line(foot, foot + on_screen(stroke), Role::Ground);
        }
    }

    /// Draws a block on its guide. In characters it is always horizontal: brackets read as a block
    /// at any angle, a rotated box of so few cells does not. In dots it lies along an inclined
    /// guide.
    pub(in crate::drawing) fn block(&mut self, at: Vec2, along: Vec2) {
        let position = self.view.cell(at);
        let along = Vec2::new(along.x, -along.y);
        let along = along / along.norm();
        if self.has_large_marks() {
            if along.is_finite() {
                pattern::block(self.raster, position, along, pattern::BLOCK, Role::Slider);
            }
            return;
        }
        if self.glyphs.is_dotted() && along.y.abs() >= INCLINED {
            let position = self.pin_place(position);
            pattern::block(
                self.raster,
                position,
                along,
                pattern::SMALL_BLOCK,
                Role::Slider,
            );
            return;
        }
        let (col, row) = cell_of(position);
        self.stamp(col - 1, row, "[ ]", Role::Slider);
    }

    /// Draws the plate of a link; the corners are in cell coordinates. In characters its edges
    /// suffice.
    pub(in crate::drawing) fn plate(&mut self, corners: &[Vec2], role: Role) {
        if self.glyphs.is_dotted() {
            pattern::plate(self.raster, corners, role);
        }
    }

    /// Draws a spring: a zigzag between two straight ends.
    pub(in crate::drawing) fn spring(&mut self, from: Vec2, to: Vec2) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        if self.glyphs.is_dotted() {
            let aspect = self.view.aspect();
            let on_screen = |v: Vec2| Vec2::new(v.x, v.y * aspect);
            let corners = pattern::zigzag(on_screen(a), on_screen(b), SPRING);
            let mut corners = corners.map(|v| Vec2::new(v.x, v.y / aspect));
            let Some(mut last) = corners.next() else {
                return;
            };
            for corner in corners {
                self.line(last, corner, Role::Spring);
                last = corner;
            }
            return;
        }
        for ((col, row), glyph) in
            stroke::cells(self.raster, a, b).zip(['/', '\\'].into_iter().cycle())
        {
            self.raster.set_cell(col, row, glyph, Role::Spring);
        }
    }

    /// Draws a closed line through points in cell coordinates.
    pub(in crate::drawing) fn outline(&mut self, corners: &[Vec2], role: Role) {
        let ends = corners.iter().cycle().skip(1);
        for (&a, &b) in corners.iter().zip(ends) {
            self.bar(a, b, role);
        }
    }

    /// Draws the barrel of a cylinder.
    pub(in crate::drawing) fn barrel(&mut self, from: Vec2, to: Vec2, role: Role) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        let glyph = match self.glyphs {
            Glyphs::Ascii => '#',
            Glyphs::Line => '▒',
            Glyphs::Braille | Glyphs::Blocks(_) => {
                let aspect = self.view.aspect();
                let along = Vec2::new(b.x - a.x, (b.y - a.y) * aspect);
                let wide = f64::from(self.view.weight() + 1) * BARREL;
                let across = along.perp() / along.norm() * wide;
                if across.is_finite() {
                    let across = Vec2::new(across.x, across.y / aspect);
                    let corners = [a + across, b + across, b - across, a - across];
                    if let Some(inside) = role.of_plate() {
                        pattern::plate(self.raster, &corners, inside);
                    }
                    for k in 0..4 {
                        self.line(corners[k], corners[(k + 1) % 4], role);
                    }
                }
                return;
            }
        };
        for (col, row) in stroke::cells(self.raster, a, b) {
            self.raster.set_cell(col, row, glyph, role);
        }
    }

    /// Draws the rod of a cylinder: in dots thinner than other links.
    pub(in crate::drawing) fn rod(&mut self, from: Vec2, to: Vec2, role: Role) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        if self.glyphs.is_dotted() && role == Role::Driver {
            let width = self.view.weight().saturating_sub(1).max(1);
            stroke::bar(self.raster, a, b, width, role);
        } else {
            self.bar(a, b, role);
        }
    }

    /// Draws the mark of a point, a single cell in characters.
    pub(in crate::drawing) fn mark(&mut self, at: Vec2, role: Role) {
        let position = self.view.cell(at);
        if self.has_large_marks() {
            match role {
                Role::Joint | Role::GroundPin | Role::Slider => {
                    return pattern::ring(self.raster, position, role);
                }
                Role::DriverPin => {
                    pattern::ring(self.raster, position, role);
                    return pattern::core(self.raster, position, role);
                }
                Role::Lit => {
                    pattern::ring(self.raster, position, role);
                    return pattern::disc(self.raster, position, role);
                }
                Role::Rider => return pattern::disc(self.raster, position, role),
                _ => {}
            }
        }
        let (col, row) = cell_of(position);
        self.raster.set_cell(col, row, glyph_of(role), role);
    }
}

fn glyph_of(role: Role) -> char {
    match role {
        // All pins look alike: a ground pin differs by its support, as on paper.
        Role::Joint | Role::GroundPin | Role::Slider => 'o',
        // A ring with a core, visible without colours even if its bar is hidden between pins.
        Role::DriverPin => '@',
        Role::Rider => '*',
        Role::Lit => '#',
        Role::CentreOfMass => 'x',
        Role::Ghost | Role::Echo => '.',
        Role::Ground | Role::Guide | Role::Link(_) | Role::Driver => '+',
        Role::Label | Role::LinkName(_) | Role::Empty => '+',
        // Other code draws these.
        Role::Plate(_) | Role::DriverPlate | Role::Spring | Role::Trace | Role::Trail => '+',
        Role::Velocity | Role::Acceleration | Role::Force => '+',
        Role::Axis | Role::Datum | Role::Second | Role::Third | Role::Front => '+',
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Blocks, Extents, Figure, Shape, render};
    use std::collections::BTreeSet;

    /// Returns the rows of a role, relative to the row of the path of a horizontal guide's block.
    fn rows(size: (u16, u16), glyphs: Glyphs, wanted: Role) -> BTreeSet<i32> {
        let (from, to) = (Vec2::ZERO, Vec2::new(30.0, 0.0));
        let extents = Extents::of_places(&[from, to, Vec2::new(0.0, 12.0)], &[from]);
        let view = WorldView::fit(&extents, size.0, size.1, 2.0);
        let mut figure = Figure::new();
        let (at, along, role) = (to * 0.5, to, Role::Guide);
        figure.add(Shape::Guide { from, to, role });
        figure.add(Shape::Hatching { from, to });
        figure.add(Shape::Block { at, along });
        let raster = render(&figure, &view, glyphs);
        let path = cell_of(view.cell(from)).1;
        let lines = (0..).zip(raster.lines());
        let inked = lines.filter(|(_, line)| line.iter().any(|cell| cell.role == wanted));
        inked.map(|(row, _)| row - path).collect()
    }

    /// Regression: in a large view, too, a guide was a line through its block and pin.
    #[test]
    fn guide_is_two_rails_if_block_fits() {
        for glyphs in [Glyphs::Braille, Glyphs::Blocks(Blocks::Octants)] {
            let of = |role| rows((120, 40), glyphs, role);
            assert_eq!(of(Role::Guide), [-1, 1].into(), "{glyphs:?}");
            assert_eq!(of(Role::Slider), [-1, 0, 1].into(), "{glyphs:?}");
            assert!(of(Role::Ground).iter().all(|&row| row >= 1), "{glyphs:?}");
        }
        for (size, glyphs) in [((40, 12), Glyphs::Braille), ((120, 40), Glyphs::Ascii)] {
            assert_eq!(rows(size, glyphs, Role::Guide), [0].into(), "{size:?}");
            assert!(rows(size, glyphs, Role::Ground).iter().all(|&row| row >= 0));
        }
    }

    /// Regression: the guide of a short stroke was hidden by its block.
    #[test]
    fn guide_is_visible_on_both_sides_of_block_at_ends_of_travel() {
        let (low, along) = (Vec2::ZERO, Vec2::new(0.0, 1.0));
        let corners = [Vec2::new(-10.0, -10.0), Vec2::new(10.0, 10.0)];
        let extents = Extents::of_places(&corners, &[low]);
        // As far beyond the travel as the guide of a scene.
        let overhang = along * (0.04 * extents.bounds().size().norm());
        let (from, to) = (low - overhang, along + overhang);
        for (cols, rows) in [(80, 24), (120, 40)] {
            for at in [low, along] {
                let view = WorldView::fit(&extents, cols, rows, 2.0);
                let role = Role::Guide;
                let mut figure = Figure::new();
                figure.add(Shape::Guide { from, to, role });
                figure.add(Shape::Block { at, along });
                let raster = render(&figure, &view, Glyphs::Braille);
                let rows_of = |role| {
                    let lines = (0..).zip(raster.lines());
                    let inked = lines.filter(move |(_, line)| line.iter().any(|c| c.role == role));
                    inked.map(|(row, _)| row).collect::<Vec<i32>>()
                };
                let [guide, block] = [Role::Guide, Role::Slider].map(rows_of);
                assert!(guide.first() < block.first(), "{cols}: {guide:?} {block:?}");
                assert!(guide.last() > block.last(), "{cols}: {guide:?} {block:?}");
            }
        }
    }
}
