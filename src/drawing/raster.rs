//! Cells with a glyph and a role.

use super::figure::Role;

/// A character cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CharCell {
    /// What is seen.
    pub glyph: char,
    /// What it belongs to.
    pub role: Role,
}

impl CharCell {
    /// A cell in which nothing is drawn.
    pub const EMPTY: CharCell = CharCell {
        glyph: ' ',
        role: Role::Empty,
    };
}

/// A block of cells, row by row from the top.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Raster {
    cols: u16,
    rows: u16,
    cells: Vec<CharCell>,
}

impl Raster {
    /// A raster without a cell, to be rendered into.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Empties it to `cols` x `rows`, keeping the memory.
    pub(super) fn reset(&mut self, cols: u16, rows: u16) {
        self.cols = cols;
        self.rows = rows;
        self.cells.clear();
        self.cells
            .resize(usize::from(cols) * usize::from(rows), CharCell::EMPTY);
    }

    /// Columns.
    #[must_use]
    pub fn cols(&self) -> u16 {
        self.cols
    }

    /// Rows.
    #[must_use]
    pub fn rows(&self) -> u16 {
        self.rows
    }

    /// The rows from the top, each of [`Raster::cols`] cells.
    pub fn lines(&self) -> impl Iterator<Item = &[CharCell]> {
        self.cells.chunks(usize::from(self.cols).max(1))
    }

    /// The cell in a column and a row, if it lies inside.
    #[must_use]
    pub fn cell(&self, col: i32, row: i32) -> Option<CharCell> {
        self.index(col, row).map(|i| self.cells[i])
    }

    /// Sets a cell; outside nothing happens.
    pub(super) fn put(&mut self, col: i32, row: i32, glyph: char, role: Role) {
        if let Some(i) = self.index(col, row) {
            self.cells[i] = CharCell { glyph, role };
        }
    }

    fn index(&self, col: i32, row: i32) -> Option<usize> {
        let (col, row) = (u16::try_from(col).ok()?, u16::try_from(row).ok()?);
        (col < self.cols && row < self.rows)
            .then(|| usize::from(row) * usize::from(self.cols) + usize::from(col))
    }

    /// The rows from the top, to be written over.
    pub(super) fn lines_mut(&mut self) -> impl Iterator<Item = &mut [CharCell]> {
        self.cells.chunks_mut(usize::from(self.cols).max(1))
    }

    /// The glyphs as lines of text, without the blanks at their ends.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in self.lines() {
            let glyphs: String = line.iter().map(|cell| cell.glyph).collect();
            text.push_str(glyphs.trim_end());
            text.push('\n');
        }
        text
    }
}
