//! Character cells with a glyph and a role.

use crate::drawing::figure::Role;

/// A character cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CharCell {
    /// The glyph.
    pub glyph: char,
    /// The role of the part that it shows.
    pub role: Role,
}

impl CharCell {
    /// An empty cell.
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
    /// Creates a raster without cells, to be rendered into.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Clears the raster to `cols` x `rows`, keeping the memory.
    pub(crate) fn reset(&mut self, cols: u16, rows: u16) {
        self.cols = cols;
        self.rows = rows;
        self.cells.clear();
        self.cells
            .resize(usize::from(cols) * usize::from(rows), CharCell::EMPTY);
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn cols(&self) -> u16 {
        self.cols
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> u16 {
        self.rows
    }

    /// Returns the rows from the top, each of [`Raster::cols`] cells.
    pub fn lines(&self) -> impl Iterator<Item = &[CharCell]> {
        self.cells.chunks(usize::from(self.cols).max(1))
    }

    /// Returns the cell in a column and a row; `None` outside.
    #[must_use]
    pub fn cell(&self, col: i32, row: i32) -> Option<CharCell> {
        self.index(col, row).map(|i| self.cells[i])
    }

    /// Sets a cell; does nothing outside.
    pub(in crate::drawing) fn set_cell(&mut self, col: i32, row: i32, glyph: char, role: Role) {
        if let Some(i) = self.index(col, row) {
            self.cells[i] = CharCell { glyph, role };
        }
    }

    /// Returns the number of a cell, counted row by row; `None` outside.
    pub(in crate::drawing) fn index(&self, col: i32, row: i32) -> Option<usize> {
        let (col, row) = (u16::try_from(col).ok()?, u16::try_from(row).ok()?);
        (col < self.cols && row < self.rows)
            .then(|| usize::from(row) * usize::from(self.cols) + usize::from(col))
    }

    /// Returns the rows from the top, mutably.
    pub(in crate::drawing) fn lines_mut(&mut self) -> impl Iterator<Item = &mut [CharCell]> {
        self.cells.chunks_mut(usize::from(self.cols).max(1))
    }

    /// Returns the glyphs as lines of text, without trailing blanks.
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
