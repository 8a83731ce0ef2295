//! Draws straight lines in cells.
//!
//! With characters a line is a chain of strokes that meet at the edges of their cells. `_` lies on
//! the lower edge, `-` in the middle, `/` runs from corner to corner, and `|` is in the middle. The
//! glyph of a cell depends on where the line passes, not on the step from the last cell. The line
//! runs between the middles of its end cells, where the glyphs of joints are. Drawn from its exact
//! ends it would miss them by up to half a cell, and flicker while they stay in place.

use super::dashes;
use super::raster::Raster;
use super::render::Glyphs;
use crate::Vec2;
use crate::drawing::figure::Role;

/// The slope, in rows per column, from which a shallow line climbs by slashes; below it, by half
/// rows. `__/__/` looks like a staircase below about a third, `__--` like a comb above it.
const MIN_SLASH_SLOPE: f64 = 0.36;

/// Draws the line from `a` to `b`, in cell coordinates.
pub(in crate::drawing) fn line(raster: &mut Raster, glyphs: Glyphs, a: Vec2, b: Vec2, role: Role) {
    match glyphs {
        // Without attributes strokes have no weight.
        Glyphs::Ascii | Glyphs::Line if role == Role::Lit => points(raster, a, b, '#', role),
        Glyphs::Ascii if is_dotted(role) => points(raster, a, b, '.', role),
        // Console fonts have this glyph, because it is in Latin-1.
        Glyphs::Line if is_dotted(role) => points(raster, a, b, '\u{b7}', role),
        Glyphs::Ascii => strokes(raster, a, b, role, ('-', '|')),
        Glyphs::Line => strokes(raster, a, b, role, ('─', '│')),
        Glyphs::Braille | Glyphs::Blocks(_) => dots(raster, a, b, role),
    }
}

/// Returns the cells of the line from `a` to `b`, from the left, or from above if it is steep.
pub(in crate::drawing) fn cells(
    raster: &Raster,
    a: Vec2,
    b: Vec2,
) -> impl Iterator<Item = (i32, i32)> + use<> {
    let clipped = clip(middle_of_cell(a), middle_of_cell(b), raster);
    let course = clipped.map(|(a, b)| LineFunction::new(a, b));
    course.into_iter().flat_map(|course| {
        let cells = course.cells();
        cells.map(move |cell| course.cell(cell, course.middle(cell).floor() as i32))
    })
}

fn middle_of_cell(p: Vec2) -> Vec2 {
    Vec2::new(p.x.floor() + 0.5, p.y.floor() + 0.5)
}

/// Returns the part of the line inside the raster enlarged by one cell on each side; `None` if it
/// is empty, or if an end is not finite.
pub(in crate::drawing) fn clip(a: Vec2, b: Vec2, raster: &Raster) -> Option<(Vec2, Vec2)> {
    let size = Vec2::new(f64::from(raster.cols()), f64::from(raster.rows()));
    let one = Vec2::new(1.0, 1.0);
    clip_to(a, b, [Vec2::ZERO - one, size + one])
}

/// Returns the part of the line inside a box (Liang and Barsky 1984); `None` if it is empty, or if
/// an end is not finite.
pub(in crate::drawing) fn clip_to(
    a: Vec2,
    b: Vec2,
    [low, high]: [Vec2; 2],
) -> Option<(Vec2, Vec2)> {
    // The most frequent case.
    let is_inside = |p: Vec2| low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
    if is_inside(a) && is_inside(b) {
        return Some((a, b));
    }
    let step = b - a;
    if !(a.is_finite() && step.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (start, rate, low, high) in [(a.x, step.x, low.x, high.x), (a.y, step.y, low.y, high.y)] {
        let (to_low, to_high) = (low - start, high - start);
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

/// A line as a function of the column if it is shallow, or of the row if it is steep.
#[derive(Clone, Copy)]
struct LineFunction {
    is_steep: bool,
    /// The smaller and the larger end along the main axis, and the other coordinate at the smaller.
    from: f64,
    to: f64,
    side: f64,
    /// The slope, in [-1, 1].
    rate: f64,
}

/// An offset in cells that moves all ambiguous places to one side despite rounding errors. Places
/// exactly between two strokes are common, because ends lie on the middles of cells.
const NUDGE: f64 = 1e-6;

impl LineFunction {
    fn new(a: Vec2, b: Vec2) -> LineFunction {
        let step = b - a;
        let steep = step.y.abs() > step.x.abs();
        let turned = |p: Vec2| if steep { Vec2::new(p.y, p.x) } else { p };
        let (a, b) = (turned(a), turned(b));
        let (a, b) = if a.x <= b.x { (a, b) } else { (b, a) };
        let rate = if a.x == b.x {
            0.0
        } else {
            (b.y - a.y) / (b.x - a.x)
        };
        LineFunction {
            is_steep: steep,
            from: a.x,
            to: b.x,
            side: a.y + NUDGE,
            rate,
        }
    }

    /// Returns the columns (or rows) whose middles the line passes, or else the one that contains
    /// it.
    fn cells(&self) -> std::ops::RangeInclusive<i32> {
        let first = (self.from - 0.5).ceil() as i32;
        let last = (self.to - 0.5).floor() as i32;
        if first <= last {
            return first..=last;
        }
        let only = ((self.from + self.to) / 2.0).floor() as i32;
        only..=only
    }

    /// Returns the other coordinate at a place on the main axis.
    fn at(&self, main: f64) -> f64 {
        self.side + self.rate * (main - self.from)
    }

    fn middle(&self, cell: i32) -> f64 {
        self.at(f64::from(cell) + 0.5)
    }

    /// Returns the coordinates where the line enters and leaves a column (or row).
    fn crossing(&self, cell: i32) -> (f64, f64) {
        (self.at(f64::from(cell)), self.at(f64::from(cell) + 1.0))
    }

    /// Returns column and row from the coordinates along and across the line.
    fn cell(&self, main: i32, side: i32) -> (i32, i32) {
        if self.is_steep {
            (side, main)
        } else {
            (main, side)
        }
    }

    /// Returns `/` for a line down to the left, `\` for one down to the right.
    fn slash(&self) -> char {
        if self.rate < 0.0 { '/' } else { '\\' }
    }

    /// Returns the row and the glyph of a shallow line in one column.
    ///
    /// A nearly horizontal line has the nearest of `flat` in the middle of a row and `_` on its
    /// lower edge. Any other line joins the nearest corners on both sides of the cell: by a slash,
    /// or by `_` if they are at the same height.
    fn shallow(&self, col: i32, flat: char) -> (i32, char) {
        if self.rate.abs() < MIN_SLASH_SLOPE {
            let halves = (self.middle(col) * 2.0).round() as i32;
            return if halves.rem_euclid(2) == 1 {
                (halves.div_euclid(2), flat)
            } else {
                (halves.div_euclid(2) - 1, '_')
            };
        }
        let (left, right) = self.crossing(col);
        let (left, right) = (left.round() as i32, right.round() as i32);
        if left == right {
            (left - 1, '_')
        } else {
            (left.min(right), self.slash())
        }
    }

    /// Returns the column and the glyph of a steep line in one row: a slash if it changes columns,
    /// or else `upright`.
    ///
    /// Up to half a column per row, it changes at its exact crossing between the middles of two
    /// columns. Above that, slashes follow each other and must meet at corners.
    fn steep(&self, row: i32, upright: char) -> (i32, char) {
        let (top, bottom) = self.crossing(row);
        let straight = self.middle(row).floor();
        if self.rate.abs() <= 0.5 {
            let changes = top.floor() != bottom.floor();
            return (
                straight as i32,
                if changes { self.slash() } else { upright },
            );
        }
        if top.round() == bottom.round() {
            (straight as i32, upright)
        } else {
            (top.round().min(bottom.round()) as i32, self.slash())
        }
    }
}

fn strokes(raster: &mut Raster, a: Vec2, b: Vec2, role: Role, (flat, upright): (char, char)) {
    let Some((a, b)) = clip(middle_of_cell(a), middle_of_cell(b), raster) else {
        return;
    };
    let course = LineFunction::new(a, b);
    for cell in course.cells() {
        let (side, glyph) = if course.is_steep {
            course.steep(cell, upright)
        } else {
            course.shallow(cell, flat)
        };
        let (col, row) = course.cell(cell, side);
        if !dashes::of_cells(role).is_some_and(|dashes| dashes.is_gap(cell)) {
            raster.set_cell(col, row, glyph, role);
        }
    }
}

/// Draws a line of points, which differs from a line of strokes without colour.
fn points(raster: &mut Raster, a: Vec2, b: Vec2, glyph: char, role: Role) {
    let step = middle_of_cell(b) - middle_of_cell(a);
    let is_steep = step.y.abs() > step.x.abs();
    let dashes = dashes::of_cells(role);
    for (col, row) in cells(raster, a, b) {
        let place = if is_steep { row } else { col };
        if !dashes.is_some_and(|dashes| dashes.is_gap(place)) {
            raster.set_cell(col, row, glyph, role);
        }
    }
}

fn is_dotted(role: Role) -> bool {
    matches!(role, Role::Ghost | Role::Echo)
}

/// The Braille pattern without dots; the other 255 patterns follow it.
const BLANK: u32 = 0x2800;

/// The bit of each dot of a Braille cell, by row and column.
const DOTS: [[u32; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

/// Number of dots of a cell along x and y.
pub(in crate::drawing) const FINE: Vec2 = Vec2 { x: 2.0, y: 4.0 };

fn dots(raster: &mut Raster, a: Vec2, b: Vec2, role: Role) {
    let is_steep = (b.y - a.y).abs() * FINE.y > (b.x - a.x).abs() * FINE.x;
    let dashes = dashes::of_dots(role, if is_steep { 4 } else { 2 });
    for (x, y) in parts(raster, a, b, FINE) {
        let place = if is_steep { y } else { x };
        if !dashes.is_some_and(|dashes| dashes.is_gap(place)) {
            dot(raster, x, y, role);
        }
    }
}

/// Draws a line `width` dots wide.
pub(in crate::drawing) fn bar(raster: &mut Raster, a: Vec2, b: Vec2, width: u8, role: Role) {
    let finer = |p: Vec2| Vec2::new(p.x * FINE.x, p.y * FINE.y);
    let Some((a, b)) = clip(a, b, raster) else {
        return;
    };
    let course = LineFunction::new(finer(a), finer(b));
    // Along the other axis a sloping bar is wider than across itself.
    let half = f64::from(width) / 2.0 * (1.0 + course.rate * course.rate).sqrt();
    for main in course.cells() {
        let middle = course.middle(main);
        let edge = |side: f64| (middle + side).round() as i32;
        for side in edge(-half)..edge(half) {
            let (x, y) = course.cell(main, side);
            dot(raster, x, y, role);
        }
    }
}

/// Returns the parts of cells that the line from `a` to `b` passes; a cell has `count` parts along
/// x and y. Parts are counted over the whole raster and returned from the left, or from above if
/// the line is steep.
pub(in crate::drawing) fn parts(
    raster: &Raster,
    a: Vec2,
    b: Vec2,
    count: Vec2,
) -> impl Iterator<Item = (i32, i32)> + use<> {
    let finer = |p: Vec2| Vec2::new(p.x * count.x, p.y * count.y);
    let course = clip(a, b, raster).map(|(a, b)| LineFunction::new(finer(a), finer(b)));
    course.into_iter().flat_map(|course| {
        let cells = course.cells();
        cells.map(move |cell| course.cell(cell, course.middle(cell).floor() as i32))
    })
}

/// Sets one dot, counted over the whole raster, and keeps the cell's other dots.
pub(in crate::drawing) fn dot(raster: &mut Raster, x: i32, y: i32, role: Role) {
    let (col, row) = (x.div_euclid(2), y.div_euclid(4));
    let Some(old) = raster.cell(col, row) else {
        return;
    };
    let (in_row, in_col) = (y.rem_euclid(4) as usize, x.rem_euclid(2) as usize);
    // A solid part hides the parts behind it, so its edges stay clear.
    let hides = role.is_body() && old.role.is_behind();
    let kept = pattern(old.glyph).filter(|_| !hides);
    let pattern = BLANK + (kept.unwrap_or(0) | DOTS[in_row][in_col]);
    if let Some(glyph) = char::from_u32(pattern) {
        raster.set_cell(col, row, glyph, role);
    }
}

/// Clears one dot, or a whole character, and gives the rest of its cell this role.
pub(in crate::drawing) fn clear(raster: &mut Raster, x: i32, y: i32, role: Role) {
    let (col, row) = (x.div_euclid(2), y.div_euclid(4));
    let Some(old) = raster.cell(col, row).filter(|old| old.glyph != ' ') else {
        return;
    };
    // Any other character, such as an arrow's head, is cleared as a whole.
    let kept = pattern(old.glyph).unwrap_or(0);
    let (in_row, in_col) = (y.rem_euclid(4) as usize, x.rem_euclid(2) as usize);
    let left = kept & !DOTS[in_row][in_col];
    if let Some(glyph) = char::from_u32(BLANK + left) {
        // Fonts show the pattern without dots in various ways, so a blank replaces it.
        raster.set_cell(col, row, if left == 0 { ' ' } else { glyph }, role);
    }
}

/// Returns the dots of a Braille character; `None` for other characters.
fn pattern(glyph: char) -> Option<u32> {
    u32::from(glyph).checked_sub(BLANK).filter(|&k| k < 256)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: u16 = 40;

    fn drawn(a: Vec2, b: Vec2, glyphs: Glyphs) -> Vec<(i32, i32, char)> {
        drawn_as(Role::Link(0), a, b, glyphs)
    }

    fn drawn_as(role: Role, a: Vec2, b: Vec2, glyphs: Glyphs) -> Vec<(i32, i32, char)> {
        let mut raster = Raster::new();
        raster.reset(SIZE, SIZE);
        line(&mut raster, glyphs, a, b, role);
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

    /// Returns the ends of the stroke that a glyph draws, relative to the upper left corner of its
    /// cell.
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
        fn strokes_lie_within_half_a_cell_of_line(
            (ax, ay) in (2.0..38.0, 2.0..38.0),
            (bx, by) in (2.0..38.0, 2.0..38.0),
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let from = middle_of_cell(a);
            let step = middle_of_cell(b) - from;
            if step == Vec2::ZERO {
                return Ok(());
            }
            for (col, row, glyph) in drawn(a, b, Glyphs::Ascii) {
                let (start, end) = stroke_of(glyph);
                let middle = Vec2::new(f64::from(col), f64::from(row)) + (start + end) * 0.5;
                let off = (middle - from).cross(step);
                let axis = step.x.abs().max(step.y.abs());
                prop_assert!((off / axis).abs() <= 0.5 + 1e-9, "{glyph} at {col}, {row}");
            }
        }

        #[test]
        fn shallow_lines_have_no_gaps(
            (ax, ay) in (2.0..8.0, 16.0..24.0),
            (bx, slope) in (30.0..38.0, -0.9..0.9),
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
        fn line_has_one_cell_per_column_or_row(
            (ax, ay) in (-50.0..90.0, -50.0..90.0),
            (bx, by) in (-50.0..90.0, -50.0..90.0),
        ) {
            let (a, b) = (Vec2::new(ax, ay), Vec2::new(bx, by));
            let cells = drawn(a, b, Glyphs::Ascii);
            prop_assert!(cells.len() <= usize::from(SIZE));
        }
    }

    #[test]
    fn line_does_not_depend_on_direction() {
        for k in 0..360 {
            let b = Vec2::new(20.3, 20.7) + crate::angle::unit(f64::from(k)) * 15.0;
            let a = Vec2::new(20.3, 20.7);
            for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                assert_eq!(drawn(a, b, glyphs), drawn(b, a, glyphs), "{k} {glyphs:?}");
            }
        }
    }

    #[test]
    fn horizontal_and_vertical_lines_are_straight() {
        let v = Vec2::new;
        let level = drawn(v(1.5, 3.5), v(5.5, 3.5), Glyphs::Ascii);
        assert_eq!(level.len(), 5);
        assert!(level.iter().all(|&(_, row, g)| row == 3 && g == '-'));
        let upright = drawn(v(3.5, 1.5), v(3.5, 5.5), Glyphs::Line);
        assert_eq!(upright.len(), 5);
        assert!(upright.iter().all(|&(col, _, g)| col == 3 && g == '│'));
    }

    /// Regression: without colour a ghost looked like a link in a small view, and like an echo in
    /// characters.
    #[test]
    fn bars_ghosts_and_echoes_differ_without_colour() {
        for degrees in 0..360 {
            let a = Vec2::new(20.3, 20.7);
            let b = a + crate::angle::unit(f64::from(degrees)) * 15.0;
            for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                let [bar, ghost, echo] = [Role::Link(0), Role::Ghost, Role::Echo]
                    .map(|role| drawn_as(role, a, b, glyphs));
                assert!(
                    bar != ghost && bar != echo && ghost != echo,
                    "{degrees} {glyphs:?}"
                );
                // The eye can follow the line: it never skips two cells in a row.
                let far = |a: i32, b: i32| (a - b).abs() > 2;
                let is_torn = |p: &[(i32, i32, char)]| far(p[0].0, p[1].0) || far(p[0].1, p[1].1);
                let mut along = ghost.clone();
                let is_steep = (b.y - a.y).abs() > (b.x - a.x).abs();
                along.sort_by_key(|c| if is_steep { (c.1, c.0) } else { (c.0, c.1) });
                assert!(
                    !along.windows(2).any(is_torn),
                    "{degrees} {glyphs:?}: {along:?}"
                );
            }
        }
    }

    #[test]
    fn lines_outside_or_not_finite_draw_nothing() {
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
    fn distant_ends_draw_only_visible_cells() {
        let (a, b) = (Vec2::new(-1e12, 5.5), Vec2::new(1e12, 5.5));
        assert_eq!(drawn(a, b, Glyphs::Ascii).len(), usize::from(SIZE));
    }
}
