//! Straight lines in cells.
//!
//! With characters a line is a chain of strokes that meet at the edges of their cells: `_` lies on the
//! lower edge, `-` in the middle, `/` runs from corner to corner, `|` stands in the middle. Which one a
//! cell gets is decided by where the line really passes, not by the step from the last cell, so a
//! slowly turning link does not shiver.

use super::figure::Role;
use super::raster::Raster;
use super::render::Glyphs;
use crate::Vec2;

/// From this slope (rows per column) on, a shallow line climbs by slashes; below it, by half rows.
/// `__/__/` looks like a staircase below about a third, `__--` like a comb above it.
const CLIMB: f64 = 0.36;

/// Draws the line from `a` to `b`, in cell coordinates.
pub(super) fn line(raster: &mut Raster, glyphs: Glyphs, a: Vec2, b: Vec2, role: Role) {
    let size = Vec2::new(f64::from(raster.cols()), f64::from(raster.rows()));
    let Some((a, b)) = clip(a, b, size) else {
        return;
    };
    match glyphs {
        Glyphs::Ascii => strokes(raster, a, b, role, '-', '|'),
        Glyphs::Line => strokes(raster, a, b, role, '─', '│'),
        Glyphs::Braille => dots(raster, a, b, role),
    }
}

/// Draws the line from `a` to `b` with one glyph.
pub(super) fn solid(raster: &mut Raster, glyph: char, a: Vec2, b: Vec2, role: Role) {
    let size = Vec2::new(f64::from(raster.cols()), f64::from(raster.rows()));
    if let Some((a, b)) = clip(a, b, size) {
        trace(a, b, |x, y| {
            raster.put(x.floor() as i32, y.floor() as i32, glyph, role);
        });
    }
}

/// The part of the line inside the cells and one around them (Liang and Barsky 1984); `None` if there
/// is none, or if an end is not finite.
fn clip(a: Vec2, b: Vec2, size: Vec2) -> Option<(Vec2, Vec2)> {
    let step = b - a;
    if !(a.is_finite() && step.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (start, rate, high) in [(a.x, step.x, size.x), (a.y, step.y, size.y)] {
        let (to_low, to_high) = (-1.0 - start, high + 1.0 - start);
        if rate == 0.0 {
            if to_low > 0.0 || to_high < 0.0 {
                return None;
            }
            continue;
        }
        let (near, far) = (to_low / rate, to_high / rate);
        enter = enter.max(near.min(far));
        leave = leave.min(near.max(far));
    }
    (enter <= leave).then(|| (a + step * enter, a + step * leave))
}

/// Visits a line once in every column, or in every row if it is steep, at the middle of the cell.
/// A line that passes no middle is visited once, half way.
fn trace(a: Vec2, b: Vec2, mut visit: impl FnMut(f64, f64)) {
    let step = b - a;
    let steep = step.y.abs() > step.x.abs();
    let (from, to, from_side, rate) = if steep {
        (a.y, b.y, a.x, step.x / step.y)
    } else {
        (a.x, b.x, a.y, step.y / step.x)
    };
    let rate = if rate.is_finite() { rate } else { 0.0 };
    let mut at = |main: f64| {
        let side = from_side + rate * (main - from);
        if steep {
            visit(side, main);
        } else {
            visit(main, side);
        }
    };
    let first = (from.min(to) - 0.5).ceil() as i32;
    let last = (from.max(to) - 0.5).floor() as i32;
    if first > last {
        at((from + to) / 2.0);
    }
    for cell in first..=last {
        at(f64::from(cell) + 0.5);
    }
}

fn strokes(raster: &mut Raster, a: Vec2, b: Vec2, role: Role, flat: char, upright: char) {
    let step = b - a;
    if step.y.abs() > step.x.abs() {
        let lean = step.x / step.y;
        trace(a, b, |x, y| {
            let (top, bottom) = (x - lean / 2.0, x + lean / 2.0);
            let glyph = if top.floor() == bottom.floor() {
                upright
            } else {
                slash(lean)
            };
            raster.put(x.floor() as i32, y.floor() as i32, glyph, role);
        });
        return;
    }
    let slope = if step.x == 0.0 { 0.0 } else { step.y / step.x };
    trace(a, b, |x, y| {
        let (row, glyph) = if slope.abs() < CLIMB {
            half_row(y, flat)
        } else {
            climb(y, slope)
        };
        raster.put(x.floor() as i32, row, glyph, role);
    });
}

/// `/` where a line runs down to the left, `\` where it runs down to the right; rows count downwards,
/// so the sign is that of columns per row as well as of rows per column.
fn slash(slope: f64) -> char {
    if slope < 0.0 { '/' } else { '\\' }
}

/// The nearest of the strokes at the middle of a row and on its lower edge.
fn half_row(y: f64, flat: char) -> (i32, char) {
    let halves = (y * 2.0).round() as i32;
    if halves.rem_euclid(2) == 1 {
        (halves.div_euclid(2), flat)
    } else {
        (halves / 2 - 1, '_')
    }
}

/// Between the corners nearest to the line on both sides of the cell: a slash, or `_` where they are level.
fn climb(y: f64, slope: f64) -> (i32, char) {
    let left = (y - slope / 2.0).round() as i32;
    let right = (y + slope / 2.0).round() as i32;
    if left == right {
        (left - 1, '_')
    } else {
        (left.min(right), slash(slope))
    }
}

/// The Braille pattern without a dot; the next 255 follow.
const BLANK: u32 = 0x2800;

/// The bit of each dot of a Braille cell, by row and column.
const DOTS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

fn dots(raster: &mut Raster, a: Vec2, b: Vec2, role: Role) {
    let fine = |p: Vec2| Vec2::new(p.x * 2.0, p.y * 4.0);
    trace(fine(a), fine(b), |x, y| {
        dot(raster, x.floor() as i32, y.floor() as i32, role);
    });
}

/// Sets one dot, counted over the whole raster, and keeps those that the cell has.
fn dot(raster: &mut Raster, x: i32, y: i32, role: Role) {
    let (col, row) = (x.div_euclid(2), y.div_euclid(4));
    let Some(old) = raster.cell(col, row) else {
        return;
    };
    let (in_row, in_col) = (y.rem_euclid(4) as usize, x.rem_euclid(2) as usize);
    let kept = u32::from(old.glyph).checked_sub(BLANK).filter(|&k| k < 256);
    let pattern = BLANK + (kept.unwrap_or(0) | DOTS[in_row][in_col]);
    if let Some(glyph) = char::from_u32(pattern) {
        raster.put(col, row, glyph, role);
    }
}
