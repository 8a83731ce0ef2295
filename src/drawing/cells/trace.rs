//! Draws traces in cells: fine dots in Braille, or else points in the upper and the lower half of a
//! cell.

use super::raster::Raster;
use super::render::Glyphs;
use super::stroke;
use crate::Vec2;
use crate::drawing::figure::Role;
use crate::drawing::view::WorldView;

/// Parts of a cell that characters can show: two halves.
const HALVES: Vec2 = Vec2 { x: 1.0, y: 2.0 };
const UPPER: char = '\'';
const LOWER: char = '.';
const BOTH: char = ':';

/// Draws a chain of straight lines in world units; a point that is not finite is a gap.
pub(in crate::drawing) fn draw(
    raster: &mut Raster,
    glyphs: Glyphs,
    view: &WorldView,
    course: &[Vec2],
    role: Role,
) {
    let mut places = course.iter().map(|&p| view.cell(p));
    let Some(mut last) = places.next() else {
        return;
    };
    for position in places {
        // A line from or to a point that is not finite has no parts.
        match glyphs {
            Glyphs::Braille | Glyphs::Blocks(_) => {
                for (x, y) in stroke::parts(raster, last, position, stroke::FINE) {
                    stroke::dot(raster, x, y, role);
                }
            }
            Glyphs::Ascii | Glyphs::Line => {
                for (col, half) in stroke::parts(raster, last, position, HALVES) {
                    point(raster, col, half, role);
                }
            }
        }
        last = position;
    }
}

/// Puts a point into the upper or the lower half of a cell, keeping a trace in the other half.
fn point(raster: &mut Raster, col: i32, half: i32, role: Role) {
    let row = half.div_euclid(2);
    let (here, other) = if half.rem_euclid(2) == 0 {
        (UPPER, LOWER)
    } else {
        (LOWER, UPPER)
    };
    let Some(old) = raster.cell(col, row) else {
        return;
    };
    let is_trace = matches!(old.role, Role::Trace | Role::Trail);
    let shared = is_trace && [other, BOTH].contains(&old.glyph);
    raster.set_cell(col, row, if shared { BOTH } else { here }, role);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Extents, Figure, Shape, render};
    use std::sync::Arc;

    /// Returns a circle of radius 8, with a gap from 0 to 45 degrees.
    fn circle() -> Arc<[Vec2]> {
        let at = |k: i32| match k {
            1..9 => Vec2::new(f64::NAN, 0.0),
            _ => crate::angle::unit(f64::from(k) * 5.0) * 8.0,
        };
        (0..=72).map(at).collect()
    }

    fn picture(glyphs: Glyphs) -> String {
        let corners = [Vec2::new(-8.0, -8.0), Vec2::new(8.0, 8.0)];
        let view = WorldView::fit(&Extents::of_places(&corners, &[]), 26, 12, 2.0);
        let mut figure = Figure::new();
        let (course, role) = (circle(), Role::Trace);
        figure.add(Shape::Trace { course, role });
        render(&figure, &view, glyphs).text()
    }

    #[test]
    fn trace_matches_snapshots() {
        insta::assert_snapshot!("trace-ascii", picture(Glyphs::Ascii));
        insta::assert_snapshot!("trace-line", picture(Glyphs::Line));
        insta::assert_snapshot!("trace-braille", picture(Glyphs::Braille));
    }

    #[test]
    fn distant_and_invalid_points_do_not_break_rendering() {
        let mut figure = Figure::new();
        let course = [
            (f64::NAN, 1.0),
            (1e300, -1e300),
            (-1e300, 3.0),
            (f64::INFINITY, 0.0),
        ];
        let course = course.map(|(x, y)| Vec2::new(x, y)).into();
        let role = Role::Trace;
        figure.add(Shape::Trace { course, role });
        let view = WorldView::fit(&Extents::of_places(&[Vec2::ZERO], &[]), 9, 4, 2.0);
        for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
            assert_eq!(render(&figure, &view, glyphs).text().lines().count(), 4);
        }
    }
}
