//! The symbols of kinematic sketches: supports, hatching, blocks, marks. Their size is counted in
//! cells, so they stay readable at any scale.

use super::figure::Role;
use super::raster::Raster;
use super::render::Glyphs;
use super::stroke;
use super::view::View;
use crate::Vec2;

/// From this size on there is room for the triangle under a ground pin.
const ROOMY_ROWS: u16 = 16;

/// What the symbols are drawn with.
pub(super) struct Symbols<'a> {
    pub(super) view: &'a View,
    pub(super) glyphs: Glyphs,
    pub(super) raster: &'a mut Raster,
}

/// The cell that holds a place in cell coordinates. Far outside it saturates, which is outside still.
pub(super) fn cell_of(at: Vec2) -> (i32, i32) {
    (at.x.floor() as i32, at.y.floor() as i32)
}

impl Symbols<'_> {
    /// The support under a ground pin: a triangle and hatching, or hatching alone in a low window.
    pub(super) fn support(&mut self, at: Vec2) {
        let (col, row) = cell_of(self.view.cell(at));
        let (row, hatching) = if self.view.rows() >= ROOMY_ROWS {
            self.stamp(col - 1, row + 1, "/_\\", Role::Ground);
            (row + 2, "/////")
        } else {
            (row + 1, "/////")
        };
        self.stamp(col - 2, row, hatching, Role::Ground);
    }

    fn stamp(&mut self, col: i32, row: i32, glyphs: &str, role: Role) {
        for (i, glyph) in (0..).zip(glyphs.chars()) {
            self.raster.put(col.saturating_add(i), row, glyph, role);
        }
    }

    /// Short strokes beside a guide, on the right of its direction.
    pub(super) fn hatching(&mut self, from: Vec2, to: Vec2) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        let along = b - a;
        let steep = along.y.abs() > along.x.abs();
        let offset = if steep {
            Vec2::new(-along.y.signum(), 0.0)
        } else {
            Vec2::new(0.0, along.x.signum())
        };
        let rising = along.x * along.y < 0.0;
        let glyph = if rising && along.x.abs() * 4.0 > along.y.abs() {
            '\\'
        } else {
            '/'
        };
        stroke::solid(self.raster, glyph, a + offset, b + offset, Role::Ground);
    }

    /// A block on its guide.
    pub(super) fn block(&mut self, at: Vec2, along: Vec2, pin: bool) {
        let middle = self.view.cell(at);
        if self.glyphs == Glyphs::Braille {
            self.box_around(middle, along);
            if pin {
                let (col, row) = cell_of(middle);
                self.raster.put(col, row, 'o', Role::Slider);
            }
            return;
        }
        let (col, row) = cell_of(middle);
        let glyphs = if pin { "[o]" } else { "[ ]" };
        self.stamp(col - 1, row, glyphs, Role::Slider);
    }

    fn box_around(&mut self, middle: Vec2, along: Vec2) {
        // Half a length of 1.75 cells and half a width of 1, turned with the guide at true aspect.
        let turned = |x: f64, y: f64| {
            let p = Vec2::new(x, y).turned(along);
            middle + Vec2::new(p.x, -p.y / self.view.aspect())
        };
        let corners = [
            turned(1.75, 1.0),
            turned(-1.75, 1.0),
            turned(-1.75, -1.0),
            turned(1.75, -1.0),
        ];
        self.outline(&corners, Role::Slider);
    }

    /// A closed line through places in cell coordinates.
    pub(super) fn outline(&mut self, corners: &[Vec2], role: Role) {
        let ends = corners.iter().cycle().skip(1);
        for (&a, &b) in corners.iter().zip(ends) {
            stroke::line(self.raster, self.glyphs, a, b, role);
        }
    }

    /// The barrel of a cylinder.
    pub(super) fn barrel(&mut self, from: Vec2, to: Vec2, role: Role) {
        let (a, b) = (self.view.cell(from), self.view.cell(to));
        let glyph = match self.glyphs {
            Glyphs::Ascii => '#',
            Glyphs::Line => '▒',
            Glyphs::Braille => {
                let aspect = self.view.aspect();
                let along = Vec2::new(b.x - a.x, (b.y - a.y) * aspect);
                let across = along.perp() / along.norm() * 0.75;
                if across.is_finite() {
                    let across = Vec2::new(across.x, across.y / aspect);
                    self.outline(&[a + across, b + across, b - across, a - across], role);
                }
                return;
            }
        };
        stroke::solid(self.raster, glyph, a, b, role);
    }

    /// A mark of one cell.
    pub(super) fn mark(&mut self, at: Vec2, role: Role) {
        let (col, row) = cell_of(self.view.cell(at));
        self.raster.put(col, row, glyph_of(role), role);
    }
}

fn glyph_of(role: Role) -> char {
    match role {
        Role::GroundPin => 'O',
        Role::Joint | Role::Slider => 'o',
        Role::Rider => '*',
        Role::CentreOfMass => 'x',
        Role::Ground | Role::Guide | Role::Link | Role::Driver | Role::Label | Role::Empty => '+',
    }
}
