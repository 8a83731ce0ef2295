//! Converts Braille dots to block characters. A drawing is made in dots, 2 x 4 to a cell; each cell
//! then gets the nearest block. Octants have the same grid, sextants three rows, quadrants two.

use super::pattern;
use super::raster::Raster;
use super::render::Glyphs;
use crate::drawing::figure::Role;

/// Block characters, by the grid they divide a cell into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blocks {
    /// 2 x 2: most fonts (Unicode 1.0 and 3.2).
    Quadrants,
    /// 2 x 3: fonts with symbols for legacy computing (Unicode 13, 2020).
    Sextants,
    /// 2 x 4: few fonts (Unicode 16, 2024).
    Octants,
}

/// The glyph for a link's plate: light shading behind solid blocks.
const PLATE: char = '\u{2591}';

/// Replaces Braille dots by blocks.
pub(in crate::drawing) fn settle(raster: &mut Raster, glyphs: Glyphs) {
    let Glyphs::Blocks(blocks) = glyphs else {
        return;
    };
    for line in raster.lines_mut() {
        for (col, cell) in (0..).zip(line) {
            let Some(dots) = dots_of(cell.glyph) else {
                continue;
            };
            let is_plate = matches!(cell.role, Role::Plate(_) | Role::DriverPlate);
            // A plate is transparent: traces and ghosts behind it show through.
            let through = if is_plate {
                dots & !plate_dots(col)
            } else {
                dots
            };
            cell.glyph = match through {
                0 if is_plate => PLATE,
                through => blocks.glyph(through),
            };
        }
    }
}

/// Returns the dots that a plate sets in a cell of this column: one dot, the same in any row.
fn plate_dots(col: i32) -> u8 {
    let dots = (0..4).flat_map(|row| (0..2).map(move |side| (row, side)));
    let set = dots.filter(|&(row, side)| pattern::is_of_plate(2 * col + side, row));
    set.map(|(row, side)| 1 << (2 * row + side)).sum()
}

/// Returns the dots of a Braille character as bits, row by row from the top, left dot first; `None`
/// for any other character.
fn dots_of(glyph: char) -> Option<u8> {
    let pattern = u32::from(glyph).checked_sub(0x2800).filter(|p| *p < 256)?;
    // Braille counts down the columns, and its fourth row was added later.
    const ROWS: [u32; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];
    let bit = |k: usize| u8::from(pattern & ROWS[k] != 0) << k;
    Some((0..8).map(bit).sum())
}

/// The quadrant characters, indexed by the bits upper left, upper right, lower left, lower right.
const QUADRANTS: [char; 16] = [
    ' ', '\u{2598}', '\u{259d}', '\u{2580}', '\u{2596}', '\u{258c}', '\u{259e}', '\u{259b}',
    '\u{2597}', '\u{259a}', '\u{2590}', '\u{259c}', '\u{2584}', '\u{2599}', '\u{259f}', '\u{2588}',
];

/// Octants that are not quadrants and had a character before Unicode 16.
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

/// The first octant; octants are numbered by their bits, skipping older characters.
const FIRST_OCTANT: u32 = 0x1cd00;
/// The first sextant; sextants are numbered by their bits, skipping older characters.
const FIRST_SEXTANT: u32 = 0x1fb00;

impl Blocks {
    /// Returns the block that is nearest to these dots.
    fn glyph(self, dots: u8) -> char {
        // A row of a coarser grid is set if any dot in it is set.
        let row = |row: u8| dots >> (2 * row) & 3;
        match self {
            Blocks::Quadrants => quadrant(row(0) | row(1), row(2) | row(3)),
            Blocks::Sextants => sextant(row(0) | (row(1) | row(2)) << 2 | row(3) << 4),
            Blocks::Octants => OCTANTS[usize::from(dots)],
        }
    }
}

const fn quadrant(upper: u8, lower: u8) -> char {
    QUADRANTS[(upper | lower << 2) as usize]
}

/// Returns the sextant for the bits of its six parts, row by row.
fn sextant(parts: u8) -> char {
    // Halves and the full block already had characters.
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

/// The octant characters, indexed by the bits of their eight parts, row by row.
const OCTANTS: [char; 256] = octants();

const fn octants() -> [char; 256] {
    let mut octants = [' '; 256];
    let mut next = FIRST_OCTANT;
    let mut dots = 0;
    while dots < octants.len() {
        octants[dots] = match (older(dots), char::from_u32(next)) {
            (Some(older), _) => older,
            (None, Some(own)) => {
                next += 1;
                own
            }
            (None, None) => panic!("they end far below the last character"),
        };
        dots += 1;
    }
    octants
}

/// Returns the character that an octant had before Unicode 16: a quadrant, or an entry of `OLDER`.
const fn older(dots: usize) -> Option<char> {
    let rows = [dots & 3, dots >> 2 & 3, dots >> 4 & 3, dots >> 6 & 3];
    if rows[0] == rows[1] && rows[2] == rows[3] {
        return Some(QUADRANTS[rows[0] | rows[2] << 2]);
    }
    let mut k = 0;
    while k < OLDER.len() {
        let (of, character) = OLDER[k];
        if of as usize == dots {
            return Some(character);
        }
        k += 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec2;
    use crate::drawing::{Extents, Figure, Shape, WorldView, render};
    use std::collections::HashSet;

    #[test]
    fn braille_dots_are_read_row_by_row() {
        assert_eq!(dots_of('\u{2800}'), Some(0));
        assert_eq!(dots_of('\u{28ff}'), Some(255));
        // The Braille dots 1, 4, 7 and 8: the first row and the last.
        assert_eq!(dots_of('\u{28c9}'), Some(0b1100_0011));
        assert_eq!(dots_of('o'), None);
    }

    #[test]
    fn blocks_cover_the_area_of_their_dots() {
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

    /// Code points in Unicode 16: BLOCK OCTANT-3 is the first, BLOCK OCTANT-2345678 the last.
    #[test]
    fn octants_have_unicode_code_points() {
        let octant = |dots| Blocks::Octants.glyph(dots);
        assert_eq!(octant(0b0000_0100), '\u{1cd00}');
        assert_eq!(octant(0b0000_0110), '\u{1cd01}');
        assert_eq!(octant(0b0001_0000), '\u{1cd09}');
        assert_eq!(octant(0b1111_1110), '\u{1cde5}');
    }

    /// Compares every block with the tables of ratatui, an independent source.
    #[cfg(feature = "tui")]
    #[test]
    fn blocks_match_tables_of_ratatui() {
        use ratatui::symbols::pixel;
        assert_eq!(OCTANTS, pixel::OCTANTS);
        for parts in 0..64 {
            assert_eq!(
                sextant(parts),
                pixel::SEXTANTS[usize::from(parts)],
                "{parts:06b}"
            );
        }
        assert_eq!(QUADRANTS, pixel::QUADRANTS);
    }

    /// Regression: a ghost behind a plate was hidden in block characters, but visible in dots.
    #[test]
    fn ghost_shows_through_plate() {
        let square = [(1.0, 1.0), (19.0, 1.0), (19.0, 9.0), (1.0, 9.0)];
        let square = square.map(|(x, y)| Vec2::new(x, y));
        let (from, to, role) = (square[0], square[2], Role::Ghost);
        let plates = [Role::Plate(1), Role::DriverPlate];
        for blocks in [Blocks::Quadrants, Blocks::Sextants, Blocks::Octants] {
            for plate in plates {
                let mut figure = Figure::new();
                let (corners, role_of_plate) = (square.to_vec(), plate);
                figure.add(Shape::Plate {
                    corners,
                    role: role_of_plate,
                });
                let raster = |figure: &Figure| {
                    let view = WorldView::fit(&Extents::of_places(&square, &[]), 40, 20, 2.0);
                    render(figure, &view, Glyphs::Blocks(blocks))
                };
                let alone = raster(&figure);
                let inked = |raster: &Raster| {
                    let cells = raster.lines().flatten().filter(|cell| cell.role == plate);
                    cells.map(|cell| cell.glyph).collect::<Vec<_>>()
                };
                assert!(inked(&alone).len() > 100);
                assert!(inked(&alone).iter().all(|&glyph| glyph == PLATE));
                figure.add(Shape::Line { from, to, role });
                let through = inked(&raster(&figure));
                let seen = through.iter().filter(|&&glyph| glyph != PLATE).count();
                assert!(seen > 8 && seen < 40, "{blocks:?} {plate:?}: {seen}");
            }
        }
    }
}
