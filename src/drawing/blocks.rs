//! From dots of Braille to pieces of cells. A drawing is made in dots, 2 x 4 to a cell, and each cell then
//! gets the block that comes nearest: octants are the same grid, sextants have three rows, quadrants two.

use super::figure::Role;
use super::raster::Raster;
use super::render::Glyphs;

/// Pieces of a cell that a font may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blocks {
    /// 2 x 2: most fonts (Unicode 1.0 and 3.2).
    Quadrants,
    /// 2 x 3: fonts with symbols for legacy computing (Unicode 13, 2020).
    Sextants,
    /// 2 x 4: few fonts (Unicode 16, 2024).
    Octants,
}

/// The plate of a link: a light ground for what is drawn with whole blocks.
const PLATE: char = '\u{2591}';

/// Puts blocks in the place of dots.
pub(super) fn settle(raster: &mut Raster, glyphs: Glyphs) {
    let Glyphs::Blocks(blocks) = glyphs else {
        return;
    };
    for cell in raster.cells_mut() {
        let Some(dots) = dots_of(cell.glyph) else {
            continue;
        };
        cell.glyph = match cell.role {
            Role::Plate(_) => PLATE,
            _ => blocks.glyph(dots),
        };
    }
}

/// The dots of a character of Braille, row by row from the top, the left one first.
fn dots_of(glyph: char) -> Option<u8> {
    let pattern = u32::from(glyph).checked_sub(0x2800).filter(|p| *p < 256)?;
    // Braille counts down the columns, and its fourth row came later.
    const ROWS: [u32; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];
    let bit = |k: usize| u8::from(pattern & ROWS[k] != 0) << k;
    Some((0..8).map(bit).sum())
}

/// The four quarters of a cell, by the bits upper left, upper right, lower left, lower right.
const QUADRANTS: [char; 16] = [
    ' ', '\u{2598}', '\u{259d}', '\u{2580}', '\u{2596}', '\u{258c}', '\u{259e}', '\u{259b}',
    '\u{2597}', '\u{259a}', '\u{2590}', '\u{259c}', '\u{2584}', '\u{2599}', '\u{259f}', '\u{2588}',
];

/// Octants that had a character before there were octants, and are no quadrants.
const OLDER: [(u8, char); 10] = [
    (0b0000_0001, '\u{1cea8}'),
    (0b0000_0010, '\u{1ceab}'),
    (0b0000_0011, '\u{1fb82}'),
    (0b0001_0100, '\u{1fbe6}'),
    (0b0010_1000, '\u{1fbe7}'),
    (0b0011_1111, '\u{1fb85}'),
    (0b0100_0000, '\u{1cea3}'),
    (0b1000_0000, '\u{1cea0}'),
    (0b1100_0000, '\u{2582}'),
    (0b1111_1100, '\u{2586}'),
];

/// The first of the octants; they are numbered by their bits, older characters left out.
const FIRST_OCTANT: u32 = 0x1cd00;
/// The same of the sextants.
const FIRST_SEXTANT: u32 = 0x1fb00;

impl Blocks {
    /// The block for these dots.
    fn glyph(self, dots: u8) -> char {
        // A row of a coarser grid is set where one of the dots in it is.
        let row = |row: u8| dots >> (2 * row) & 3;
        match self {
            Blocks::Quadrants => quadrant(row(0) | row(1), row(2) | row(3)),
            Blocks::Sextants => sextant(row(0) | (row(1) | row(2)) << 2 | row(3) << 4),
            Blocks::Octants => octant(dots),
        }
    }
}

fn quadrant(upper: u8, lower: u8) -> char {
    QUADRANTS[usize::from(upper | lower << 2)]
}

/// By the bits of its six parts, row by row.
fn sextant(parts: u8) -> char {
    // Halves and the whole were there before.
    const LEFT: u8 = 0b01_01_01;
    const RIGHT: u8 = 0b10_10_10;
    match parts {
        0 => ' ',
        LEFT => '\u{258c}',
        RIGHT => '\u{2590}',
        0b11_11_11 => '\u{2588}',
        parts => {
            let older = 1 + u32::from(parts > LEFT) + u32::from(parts > RIGHT);
            char::from_u32(FIRST_SEXTANT + u32::from(parts) - older).unwrap_or(' ')
        }
    }
}

/// The quarters that an octant is made of, if it is.
fn as_quadrant(dots: u8) -> Option<char> {
    let row = |row: u8| dots >> (2 * row) & 3;
    (row(0) == row(1) && row(2) == row(3)).then(|| quadrant(row(0), row(2)))
}

fn octant(dots: u8) -> char {
    let is_older = |dots: u8| {
        OLDER
            .iter()
            .find(|(older, _)| *older == dots)
            .map(|(_, c)| *c)
    };
    if let Some(older) = as_quadrant(dots).or_else(|| is_older(dots)) {
        return older;
    }
    let before = (0..dots).filter(|&d| as_quadrant(d).is_none() && is_older(d).is_none());
    let number = u32::try_from(before.count()).unwrap_or(0);
    char::from_u32(FIRST_OCTANT + number).unwrap_or(' ')
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn dots_are_read_row_by_row() {
        assert_eq!(dots_of('\u{2800}'), Some(0));
        assert_eq!(dots_of('\u{28ff}'), Some(255));
        // The dots 1, 4, 7 and 8 of Braille: the first row and the last.
        assert_eq!(dots_of('\u{28c9}'), Some(0b1100_0011));
        assert_eq!(dots_of('o'), None);
    }

    #[test]
    fn blocks_cover_what_the_dots_do() {
        let quadrants: HashSet<char> = (0..=255).map(|d| Blocks::Quadrants.glyph(d)).collect();
        let sextants: HashSet<char> = (0..=255).map(|d| Blocks::Sextants.glyph(d)).collect();
        let octants: HashSet<char> = (0..=255).map(|d| Blocks::Octants.glyph(d)).collect();
        assert_eq!(
            (quadrants.len(), sextants.len(), octants.len()),
            (16, 64, 256)
        );
        for blocks in [Blocks::Quadrants, Blocks::Sextants, Blocks::Octants] {
            assert_eq!(blocks.glyph(0), ' ');
            assert_eq!(blocks.glyph(255), '\u{2588}');
            assert_eq!(blocks.glyph(0b0101_0101), '\u{258c}');
        }
        assert_eq!(Blocks::Quadrants.glyph(0b0000_0001), '\u{2598}');
        assert_eq!(Blocks::Sextants.glyph(0b0000_0001), '\u{1fb00}');
        assert_eq!(Blocks::Sextants.glyph(0b1111_1110), '\u{1fb3b}');
    }

    /// Places in the chart of Unicode 16: BLOCK OCTANT-3 is the first, -2345678 the last.
    #[test]
    fn octants_stand_where_unicode_has_them() {
        assert_eq!(octant(0b0000_0100), '\u{1cd00}');
        assert_eq!(octant(0b0000_0110), '\u{1cd01}');
        assert_eq!(octant(0b0001_0000), '\u{1cd09}');
        assert_eq!(octant(0b1111_1110), '\u{1cde5}');
    }
}
