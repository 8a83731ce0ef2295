//! Arranges the columns of a table within a width.

use super::line::{Line, Span, TextRole};
use super::table::{Cell, Rest, Setting};
use super::words::{cut_within, length};
use std::ops::Range;

/// Columns of values to the right of names, next to each other as far as they fit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ColumnLayout {
    setting: Setting,
    /// The width of the name column, with its indentation.
    names: usize,
    widths: Vec<usize>,
    chunks: Vec<Chunk>,
}

/// Columns printed next to each other.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Chunk {
    columns: Range<usize>,
    /// The number of blanks before each column.
    gap: usize,
}

impl ColumnLayout {
    /// Arranges columns of these widths to the right of names of `names` characters. Columns for
    /// which `opens` returns `true` begin a group and preferably begin a chunk.
    pub(crate) fn fit(
        setting: &Setting,
        names: usize,
        widths: Vec<usize>,
        opens: impl Fn(usize) -> bool,
        width: usize,
    ) -> ColumnLayout {
        let names = setting.indent + names;
        let needed = |columns: Range<usize>| names + sum(&widths[columns], setting.gap);
        let mut chunks = Vec::new();
        let mut start = 0;
        while start < widths.len() {
            let fits = |end: &usize| needed(start..*end) <= width;
            // A single column is shown even if it does not fit.
            let longest = (start + 1..=widths.len()).take_while(fits).last();
            let longest = longest.unwrap_or(start + 1);
            let is_end = |end: &usize| *end == widths.len() || opens(*end);
            let end = (start + 1..=longest).rev().find(is_end);
            chunks.push(start..end.unwrap_or(longest));
            start = end.unwrap_or(longest);
        }
        if setting.rest == Rest::LeftOut {
            chunks.truncate(1);
        }
        let spread = |columns: &Range<usize>| {
            let spare = width.saturating_sub(needed(columns.clone()));
            setting.spread.min(spare / columns.len().max(1))
        };
        // The spacing in chunks with fewer columns is not wider than in the fullest chunk.
        let fullest = chunks.iter().rev().max_by_key(|columns| columns.len());
        let maximum = fullest.map_or(0, spread);
        let chunk = |columns: Range<usize>| Chunk {
            gap: setting.gap + spread(&columns).min(maximum),
            columns,
        };
        let chunks = chunks.into_iter().map(chunk).collect();
        ColumnLayout {
            setting: setting.clone(),
            names,
            widths,
            chunks,
        }
    }

    /// Returns the columns of each chunk.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = &Range<usize>> {
        self.chunks.iter().map(|chunk| &chunk.columns)
    }

    /// Returns `true` if every chunk fits into this width.
    pub(crate) fn fits(&self, width: usize) -> bool {
        let needed = |chunk: &Chunk| {
            let widths = self.widths.get(chunk.columns.clone()).unwrap_or_default();
            self.names + sum(widths, chunk.gap)
        };
        self.chunks.iter().all(|chunk| needed(chunk) <= width)
    }

    /// Returns the maximum additional spacing of the columns.
    pub(super) fn spread(&self, setting: &Setting) -> usize {
        let gaps = self.chunks.iter().map(|chunk| chunk.gap);
        gaps.max().unwrap_or(0).saturating_sub(setting.gap)
    }

    /// Returns `true` if all columns fit next to each other.
    pub(super) fn fits_in_one_row(&self, width: usize) -> bool {
        let shown: usize = self.ranges().map(ExactSizeIterator::len).sum();
        self.chunks.len() < 2 && shown == self.widths.len() && self.fits(width)
    }

    /// Creates the line of a row: its mark, its name, and the right-aligned cells of a chunk.
    pub(crate) fn line<'c>(
        &self,
        range: &Range<usize>,
        (mark, name): (&str, &str),
        cells: impl IntoIterator<Item = Option<&'c Cell>>,
        [of_name, of_cells]: [TextRole; 2],
    ) -> Line {
        let mut line = Line::default();
        line.push(self.setting.indent, mark, TextRole::Mark);
        let start = self.setting.indent + self.setting.with_mark(mark);
        line.push(
            start,
            cut_within(name, self.names.saturating_sub(start)),
            of_name,
        );
        let chunk = self.chunks.iter().find(|chunk| chunk.columns == *range);
        let gap = chunk.map_or(0, |chunk| chunk.gap);
        let mut right = self.names;
        for (cell, column) in cells.into_iter().zip(range.clone()) {
            right += gap + self.widths.get(column).copied().unwrap_or(0);
            if let Some(cell) = cell {
                line.spans.push(Span {
                    at: right.saturating_sub(length(&cell.text)),
                    text: cell.text.clone(),
                    role: of_cells,
                    unproved: cell.unproved.clone(),
                });
            }
        }
        line
    }

    /// Returns the width of the name column.
    pub(super) fn names(&self) -> usize {
        self.names
    }
}

fn sum(widths: &[usize], gap: usize) -> usize {
    widths.iter().map(|width| gap + width).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunks(widths: &[usize], opens: &[usize], width: usize) -> Vec<Range<usize>> {
        let setting = Setting::default();
        let opens = |c: usize| opens.contains(&c);
        let columns = ColumnLayout::fit(&setting, 4, widths.to_vec(), opens, width);
        columns.chunks.into_iter().map(|c| c.columns).collect()
    }

    #[test]
    fn columns_fill_width_before_wrapping() {
        assert_eq!(chunks(&[8; 5], &[0, 1, 2, 3, 4], 24), [0..2, 2..4, 4..5]);
        // Groups of columns stay together if possible.
        assert_eq!(chunks(&[8; 5], &[0, 2], 34), [0..2, 2..5]);
        assert_eq!(chunks(&[8; 5], &[0], 34), [0..3, 3..5]);
        // A column that does not fit is shown nevertheless.
        assert_eq!(chunks(&[8; 2], &[0, 1], 3), [0..1, 1..2]);
    }

    #[test]
    fn spare_width_widens_gaps_equally_in_all_blocks() {
        let setting = Setting {
            spread: 4,
            ..Setting::default()
        };
        let columns = ColumnLayout::fit(&setting, 4, vec![8; 3], |_| true, 28);
        let gaps: Vec<usize> = columns.chunks.iter().map(|c| c.gap).collect();
        assert_eq!(gaps, [4, 4]);
        let wide = ColumnLayout::fit(&setting, 4, vec![8; 3], |_| true, 99);
        assert_eq!(wide.chunks[0].gap, 6);
    }
}
