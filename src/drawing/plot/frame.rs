//! The parts that plots and charts share: the axes that frame them, and text in cells.

use crate::drawing::cells::raster::Raster;
use crate::drawing::cells::render::Glyphs;
use crate::drawing::figure::Role;
use std::ops::Range;

/// The glyphs of axes, cursor and legend.
pub(super) struct FrameGlyphs {
    upright: char,
    level: char,
    corner: char,
    pub(super) tick: char,
    pub(super) nought: char,
    pub(super) cursor: char,
    /// The sample of a line in a legend.
    pub(super) sample: char,
}

impl FrameGlyphs {
    pub(super) fn of(glyphs: Glyphs) -> FrameGlyphs {
        let [upright, level, corner, zero, cursor, sample] = match glyphs {
            Glyphs::Ascii => ['|', '-', '+', '.', ':', '*'],
            // Every console font has these glyphs; not all have the half-crossings.
            Glyphs::Line => [
                '\u{2502}', '\u{2500}', '\u{2514}', '\u{b7}', ':', '\u{2500}',
            ],
            Glyphs::Braille | Glyphs::Blocks(_) => [
                '\u{2502}', '\u{2500}', '\u{2514}', '\u{b7}', '\u{2506}', '\u{2500}',
            ],
        };
        FrameGlyphs {
            upright,
            level,
            corner,
            tick: '+',
            nought: zero,
            cursor,
            sample,
        }
    }

    /// Draws the horizontal axis in a row, with the corner in the first column.
    pub(super) fn draw_level(&self, columns: Range<i32>, row: i32, raster: &mut Raster) {
        for col in columns.clone() {
            raster.set_cell(col, row, self.level, Role::Axis);
        }
        raster.set_cell(columns.start, row, self.corner, Role::Axis);
    }

    pub(super) fn draw_upright(&self, col: i32, rows: Range<i32>, raster: &mut Raster) {
        for row in rows {
            raster.set_cell(col, row, self.upright, Role::Axis);
        }
    }

    /// Draws a tick of the vertical axis with its label to the left.
    pub(super) fn draw_label(&self, (col, row): (i32, i32), label: &str, raster: &mut Raster) {
        write(raster, col - length(label), row, label, Role::Axis);
        raster.set_cell(col, row, self.tick, Role::Axis);
    }
}

/// Returns the number of columns of a text.
pub(super) fn length(text: &str) -> i32 {
    i32::try_from(text.chars().count()).unwrap_or(i32::MAX)
}

pub(super) fn write(raster: &mut Raster, col: i32, row: i32, text: &str, role: Role) {
    for (col, glyph) in (col..).zip(text.chars()) {
        raster.set_cell(col, row, glyph, role);
    }
}
