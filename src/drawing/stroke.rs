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
pub(super) fn trace(a: Vec2, b: Vec2, mut visit: impl FnMut(f64, f64)) {
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
            let (col, glyph) = descend(x, lean, upright);
            raster.put(col, y.floor() as i32, glyph, role);
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

/// The stroke of a steep line in one row: a slash where it changes columns, else upright.
///
/// Up to half a column per row it changes where it really does, between the middles of two columns.
/// Beyond, slashes follow each other, and they must meet at corners.
fn descend(x: f64, lean: f64, upright: char) -> (i32, char) {
    let (top, bottom) = (x - lean / 2.0, x + lean / 2.0);
    let straight = (x.floor() as i32, upright);
    if lean.abs() <= 0.5 {
        if top.floor() == bottom.floor() {
            straight
        } else {
            (x.floor() as i32, slash(lean))
        }
    } else if top.round() == bottom.round() {
        straight
    } else {
        (top.round().min(bottom.round()) as i32, slash(lean))
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: u16 = 40;

    fn drawn(a: Vec2, b: Vec2, glyphs: Glyphs) -> Vec<(i32, i32, char)> {
        let mut raster = Raster::new();
        raster.reset(SIZE, SIZE);
        line(&mut raster, glyphs, a, b, Role::Link);
        let mut cells = Vec::new();
        for (row, line) in (0..).zip(raster.lines()) {
            for (col, cell) in (0..).zip(line) {
                if cell.role != Role::Empty {
                    cells.push((col, row, cell.glyph));
                }
            }
        }
        cells
    }

    /// The stroke that a glyph draws, from (0, 0) at the upper left of its cell.
    fn stroke_of(glyph: char) -> (Vec2, Vec2) {
        let v = Vec2::new;
        match glyph {
            '-' => (v(0.0, 0.5), v(1.0, 0.5)),
            '_' => (v(0.0, 1.0), v(1.0, 1.0)),
            '|' => (v(0.5, 0.0), v(0.5, 1.0)),
            '/' => (v(0.0, 1.0), v(1.0, 0.0)),
            '\\' => (v(0.0, 0.0), v(1.0, 1.0)),
            other => panic!("{other:?} is no stroke"),
        }
    }

    proptest! {
        #[test]
        fn every_stroke_lies_within_half_a_cell_of_the_line(
            (ax, ay) in (2.0..38.0, 2.0..38.0),
            (bx, by) in (2.0..38.0, 2.0..38.0),
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let step = b - a;
            for (col, row, glyph) in drawn(a, b, Glyphs::Ascii) {
                let (start, end) = stroke_of(glyph);
                let middle = Vec2::new(f64::from(col), f64::from(row)) + (start + end) * 0.5;
                let off = (middle - a).cross(step);
                let axis = step.x.abs().max(step.y.abs());
                prop_assert!((off / axis).abs() <= 0.5 + 1e-9, "{glyph} at {col}, {row}");
            }
        }

        #[test]
        fn shallow_strokes_meet(
            (ax, ay) in (2.0..8.0, 16.0..24.0),
            (bx, slope) in (30.0..38.0, -0.999..0.999),
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, ay + slope * (bx - ax)));
            let mut cells = drawn(a, b, Glyphs::Ascii);
            cells.sort_by_key(|c| c.0);
            for pair in cells.windows(2) {
                let [(c, r, g), (d, s, h)] = [pair[0], pair[1]];
                prop_assert_eq!(c + 1, d, "a gap");
                let leaves = f64::from(r) + stroke_of(g).1.y;
                let enters = f64::from(s) + stroke_of(h).0.y;
                prop_assert!((leaves - enters).abs() <= 0.5, "{g} then {h}");
            }
        }

        #[test]
        fn nothing_is_drawn_twice_over(
            (ax, ay) in (-50.0..90.0, -50.0..90.0),
            (bx, by) in (-50.0..90.0, -50.0..90.0),
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let cells = drawn(a, b, Glyphs::Ascii);
            prop_assert!(cells.len() <= usize::from(SIZE));
        }
    }

    #[test]
    fn a_line_is_the_same_from_both_ends() {
        for k in 0..360 {
            let b = Vec2::new(20.3, 20.7) + crate::angle::unit(f64::from(k)) * 15.0;
            let a = Vec2::new(20.3, 20.7);
            for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                assert_eq!(drawn(a, b, glyphs), drawn(b, a, glyphs), "{k} {glyphs:?}");
            }
        }
    }

    #[test]
    fn level_and_upright_lines_are_plain() {
        let v = Vec2::new;
        let level = drawn(v(1.5, 3.5), v(5.5, 3.5), Glyphs::Ascii);
        assert_eq!(level.len(), 5);
        assert!(level.iter().all(|&(_, row, g)| row == 3 && g == '-'));
        let upright = drawn(v(3.5, 1.5), v(3.5, 5.5), Glyphs::Line);
        assert_eq!(upright.len(), 5);
        assert!(upright.iter().all(|&(col, _, g)| col == 3 && g == '│'));
    }

    #[test]
    fn what_lies_outside_or_nowhere_draws_nothing() {
        let v = Vec2::new;
        let cases = [
            (v(f64::NAN, 1.0), v(5.0, 5.0)),
            (v(1.0, 1.0), v(f64::INFINITY, 5.0)),
            (v(-1e308, 1.0), v(1e308, 5.0)),
            (v(-9.0, -9.0), v(-5.0, 80.0)),
            (v(60.0, 0.0), v(60.0, 9.0)),
        ];
        for (a, b) in cases {
            assert_eq!(drawn(a, b, Glyphs::Ascii), [], "{a:?} {b:?}");
            assert_eq!(drawn(a, b, Glyphs::Braille), [], "{a:?} {b:?}");
        }
    }

    #[test]
    fn far_ends_cost_no_more_than_the_window() {
        let (a, b) = (Vec2::new(-1e12, 5.5), Vec2::new(1e12, 5.5));
        assert_eq!(drawn(a, b, Glyphs::Ascii).len(), usize::from(SIZE));
    }
}
