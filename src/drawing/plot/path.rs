//! Draws curves in cells, in three kinds of glyphs.
//!
//! A curve runs from the cell of each sample to the cell of the next one along the nearest cells,
//! so the cell of every sample is marked. With 7-bit characters every cell has the curve's symbol.
//! With lines, box-drawing strokes join the cells and step from row to row. Braille dots do the
//! same on a grid with eight dots per cell.

use super::super::cells::raster::Raster;
use super::super::cells::render::Glyphs;
use super::super::cells::stroke::{clip_to, dot};
use super::super::figure::Role;
use super::is_place;
use crate::Vec2;

/// A block of cells that limits a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CellBlock {
    pub(super) left: i32,
    pub(super) top: i32,
    pub(super) width: i32,
    pub(super) height: i32,
}

impl CellBlock {
    pub(super) fn contains(&self, (col, row): (i32, i32)) -> bool {
        (self.left..self.left + self.width).contains(&col)
            && (self.top..self.top + self.height).contains(&row)
    }

    fn ends(&self) -> [Vec2; 2] {
        let corner = |col, row| Vec2::new(f64::from(col), f64::from(row));
        let low = corner(self.left, self.top);
        [low, corner(self.left + self.width, self.top + self.height)]
    }
}

/// Divisions of a cell, across and down.
type Grain = (i32, i32);
const WHOLE: Grain = (1, 1);
const DOTS: Grain = (2, 4);

/// Returns the path of a curve through a grid, in stretches connected inside the block.
fn ways(points: &[Vec2], block: &CellBlock, (across, down): Grain) -> Vec<Vec<(i32, i32)>> {
    // Keeps far samples finite.
    let times = |v: f64, by: i32| (v * f64::from(by)).clamp(f64::MIN, f64::MAX);
    let fine = |p: Vec2| Vec2::new(times(p.x, across), times(p.y, down));
    let [low, high] = block.ends().map(fine);
    let maximum = (high.x as i32 - 1, high.y as i32 - 1);
    let cell = |p: Vec2| {
        // The block begins at 0 or later, so truncation equals `floor` inside it.
        let inside = |v: f64, low: f64, maximum: i32| (v as i32).clamp(low as i32, maximum);
        (inside(p.x, low.x, maximum.0), inside(p.y, low.y, maximum.1))
    };
    let mut paths: Vec<Vec<(i32, i32)>> = Vec::new();
    let points: Vec<Vec2> = points.iter().map(|&p| fine(p)).collect();
    // A piece of one sample is a segment from the sample to itself.
    let only = points.first().copied();
    let pairs = points.windows(2).map(|pair| (pair[0], pair[1]));
    let pairs = pairs.chain(only.filter(|_| points.len() == 1).map(|p| (p, p)));
    for (a, b) in pairs {
        let Some((a, b)) = clip_to(a, b, [low, high]) else {
            continue;
        };
        let (from, to) = (cell(a), cell(b));
        match paths.last_mut() {
            Some(path) if path.last() == Some(&from) => march(from, to, path),
            _ => {
                let mut path = vec![from];
                march(from, to, &mut path);
                paths.push(path);
            }
        }
    }
    paths
}

/// Appends the cells after `from` up to `to` (Bresenham 1965).
fn march(from: (i32, i32), to: (i32, i32), path: &mut Vec<(i32, i32)>) {
    let (wide, high) = ((to.0 - from.0).abs(), (to.1 - from.1).abs());
    let sense = ((to.0 - from.0).signum(), (to.1 - from.1).signum());
    let (mut at, mut error) = (from, wide - high);
    while at != to {
        let twice = 2 * error;
        if twice > -high {
            error -= high;
            at.0 += sense.0;
        }
        if twice < wide {
            error += wide;
            at.1 += sense.1;
        }
        path.push(at);
    }
}

/// The style of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pen {
    pub(super) glyphs: Glyphs,
    /// The curve's symbol.
    pub(super) symbol: char,
    pub(super) role: Role,
    /// `true` to draw sparse points only, for the curve of another scene.
    pub(super) dotted: bool,
    /// The distance of symbols on a line and the place of the first one, in cells; `None` if the
    /// line needs none.
    pub(super) marks: Option<(usize, usize)>,
}

/// The glyph of a single point.
pub(super) const PLACE: char = 'o';
/// A dotted curve has one drawn cell, or dot, in this many.
const SPARSE: usize = 3;

impl Pen {
    /// Draws a piece of a curve; `points` are in cell coordinates.
    pub(super) fn draw(&self, points: &[Vec2], block: &CellBlock, raster: &mut Raster) {
        if self.dotted && is_place(points) {
            for path in ways(points, block, WHOLE) {
                self.cells(&path, PLACE, raster);
            }
            return;
        }
        match self.glyphs {
            Glyphs::Ascii => {
                let glyph = if self.dotted { '.' } else { self.symbol };
                for path in ways(points, block, WHOLE) {
                    self.cells(&path, glyph, raster);
                }
            }
            Glyphs::Line if self.dotted => {
                for path in ways(points, block, WHOLE) {
                    self.cells(&path, '\u{b7}', raster);
                }
            }
            Glyphs::Line => {
                for path in ways(points, block, WHOLE) {
                    self.strokes(&path, raster);
                }
            }
            Glyphs::Braille | Glyphs::Blocks(_) => {
                let spacing = if self.dotted { SPARSE } else { 1 };
                for path in ways(points, block, DOTS) {
                    for &(x, y) in path.iter().step_by(spacing) {
                        dot(raster, x, y, self.role);
                    }
                }
            }
        }
    }

    /// Puts the curve's symbol on the line at intervals, so that curves differ without colour.
    pub(super) fn mark(&self, points: &[Vec2], block: &CellBlock, raster: &mut Raster) {
        let (Some((every, first)), false) = (self.marks, self.glyphs == Glyphs::Ascii) else {
            return;
        };
        for path in ways(points, block, WHOLE) {
            let first = first.min(path.len() / 2);
            for &(col, row) in path.iter().skip(first).step_by(every.max(1)) {
                raster.set_cell(col, row, self.symbol, self.role);
            }
        }
    }

    fn cells(&self, path: &[(i32, i32)], glyph: char, raster: &mut Raster) {
        let spacing = if self.dotted { SPARSE } else { 1 };
        for &(col, row) in path.iter().step_by(spacing) {
            raster.set_cell(col, row, glyph, self.role);
        }
    }

    /// Draws box-drawing strokes from cell to cell; a diagonal step goes up or down first.
    fn strokes(&self, path: &[(i32, i32)], raster: &mut Raster) {
        let mut steps: Vec<(i32, i32)> = Vec::with_capacity(path.len() * 2);
        for &(col, row) in path {
            if let Some(&(last_col, last_row)) = steps.last()
                && last_col != col
                && last_row != row
            {
                steps.push((last_col, row));
            }
            steps.push((col, row));
        }
        let nearby = |i: Option<usize>| i.and_then(|i| steps.get(i)).copied();
        for (i, &(col, row)) in steps.iter().enumerate() {
            let sides = [nearby(i.checked_sub(1)), nearby(Some(i + 1))];
            let sides = sides.map(|side| side.map(|(c, r)| (c - col, r - row)));
            raster.set_cell(col, row, stroke(sides), self.role);
        }
    }
}

/// Returns the stroke that joins a cell with the previous and the next one, given as steps to them.
fn stroke(sides: [Option<(i32, i32)>; 2]) -> char {
    let has = |side| sides.contains(&Some(side));
    let (left, right, up, down) = (has((-1, 0)), has((1, 0)), has((0, -1)), has((0, 1)));
    match (left, right, up, down) {
        (true, false, true, false) => '\u{2518}',
        (true, false, false, true) => '\u{2510}',
        (false, true, true, false) => '\u{2514}',
        (false, true, false, true) => '\u{250c}',
        (false, false, true, _) | (false, false, _, true) => '\u{2502}',
        _ => '\u{2500}',
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const BLOCK: CellBlock = CellBlock {
        left: 3,
        top: 2,
        width: 20,
        height: 8,
    };

    fn drawn(points: &[Vec2], glyphs: Glyphs) -> Raster {
        let mut raster = Raster::new();
        raster.reset(30, 12);
        let pen = Pen {
            glyphs,
            symbol: '*',
            role: Role::Datum,
            dotted: false,
            marks: None,
        };
        pen.draw(points, &BLOCK, &mut raster);
        raster
    }

    #[test]
    fn line_glyphs_step_between_rows() {
        let points = [(3.5, 9.5), (6.5, 9.5), (7.5, 6.5), (10.5, 6.5), (11.5, 7.5)];
        let points = points.map(|(x, y)| Vec2::new(x, y));
        let text = drawn(&points, Glyphs::Line).text();
        let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
        assert_eq!(
            lines[6..10],
            [
                "       \u{250c}\u{2500}\u{2500}\u{2510}",
                "      \u{250c}\u{2518}  \u{2514}\u{2500}",
                "      \u{2502}",
                "   \u{2500}\u{2500}\u{2500}\u{2518}",
            ]
        );
    }

    proptest! {
        #[test]
        fn samples_are_marked_only_inside_block(
            points in prop::collection::vec((-9.0..40.0_f64, -9.0..20.0_f64), 1..30),
            far in prop::sample::select(vec![0.0, 1e9, -1e300, f64::MAX]),
        ) {
            let mut points: Vec<Vec2> = points.into_iter().map(|(x, y)| Vec2::new(x, y)).collect();
            if far != 0.0 {
                points.push(Vec2::new(9.0, far));
            }
            for glyphs in [Glyphs::Ascii, Glyphs::Line, Glyphs::Braille] {
                let raster = drawn(&points, glyphs);
                for (row, line) in (0..).zip(raster.lines()) {
                    for (col, cell) in (0..).zip(line) {
                        prop_assert!(cell.role == Role::Empty || BLOCK.contains((col, row)));
                    }
                }
                for p in &points {
                    let inside = |v: f64| v.abs() < 100.0;
                    if !(inside(p.x) && inside(p.y)) {
                        continue;
                    }
                    let cell = (p.x.floor() as i32, p.y.floor() as i32);
                    if BLOCK.contains(cell) {
                        prop_assert_eq!(raster.cell(cell.0, cell.1).unwrap().role, Role::Datum);
                    }
                }
            }
        }
    }
}
