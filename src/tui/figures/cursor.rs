//! The cursor of the tables, and its movement over the lines of a layout.

use crate::tui::figures::sheet::{SheetPart, TableLine};
use std::ops::Range;

/// A value of a row, independent of the layout's width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cursor {
    pub(crate) part: SheetPart,
    pub(crate) row: usize,
    /// Index over all columns of the part.
    pub(crate) column: usize,
}

impl Default for Cursor {
    fn default() -> Self {
        Cursor::at(SheetPart::Vectors, 0)
    }
}

impl Cursor {
    /// Creates a cursor on the first value of a row.
    pub(crate) fn at(part: SheetPart, row: usize) -> Cursor {
        Cursor {
            part,
            row,
            column: 0,
        }
    }

    /// Returns the columns of a line if it contains the selected value.
    fn chunk_of(self, line: &TableLine) -> Option<&Range<usize>> {
        match line {
            TableLine::Row(part, row, chunk) if (*part, *row) == (self.part, self.row) => {
                chunk.contains(&self.column).then_some(chunk)
            }
            TableLine::Row(..) | TableLine::Names(..) | TableLine::Units(..) | TableLine::Blank => {
                None
            }
        }
    }

    /// Returns the selected cell of a line, if the line has it.
    pub(crate) fn cell_of(self, line: &TableLine) -> Option<usize> {
        self.chunk_of(line).map(|chunk| self.column - chunk.start)
    }

    /// Moves to the first value of the next or previous chunk of columns; stays if there is none.
    pub(crate) fn in_part(self, lines: &[TableLine], forward: bool) -> Cursor {
        let starts = |line: &TableLine| matches!(line, TableLine::Names(..));
        let parts = lines.iter().enumerate().filter(|(_, line)| starts(line));
        let here = self.line(lines).unwrap_or(0);
        let (before, after): (Vec<usize>, Vec<usize>) =
            parts.map(|(at, _)| at).partition(|at| *at < here);
        let part = match forward {
            true => after.first(),
            // The last chunk before the cursor's line is the cursor's own.
            false => before.iter().rev().nth(1),
        };
        let below = part.map_or(&[][..], |part| &lines[*part..]);
        let row = below.iter().find_map(|line| match line {
            TableLine::Row(part, row, chunk) => Some(Cursor {
                column: chunk.start,
                ..Cursor::at(*part, *row)
            }),
            TableLine::Names(..) | TableLine::Units(..) | TableLine::Blank => None,
        });
        row.unwrap_or(self)
    }

    /// Returns the index of the selected line.
    pub(crate) fn line(self, lines: &[TableLine]) -> Option<usize> {
        lines.iter().position(|line| self.chunk_of(line).is_some())
    }

    /// Returns the cursor if these lines contain it; or else the first value of its row, or the
    /// first row. Fixed points have no rates at some widths, and another scene has other rows.
    pub(crate) fn settled(self, lines: &[TableLine]) -> Cursor {
        let first = lines.iter().find_map(|line| match line {
            TableLine::Row(part, row, _) => Some(Cursor::at(*part, *row)),
            TableLine::Names(..) | TableLine::Units(..) | TableLine::Blank => None,
        });
        let places = [self, Cursor::at(self.part, self.row)];
        let found = places.into_iter().find(|c| c.line(lines).is_some());
        found.or(first).unwrap_or(self)
    }

    /// Moves by `by` lines, to the last row within that distance, or else the next row. The cursor
    /// keeps its cell.
    pub(crate) fn moved(self, lines: &[TableLine], by: isize) -> Cursor {
        let Some(here) = self.line(lines) else {
            return self.settled(lines);
        };
        let goal = here.saturating_add_signed(by);
        let rows = |range: Range<usize>| {
            let rows = range.filter(|&at| matches!(lines.get(at), Some(TableLine::Row(..))));
            rows.collect::<Vec<_>>()
        };
        let target = if by > 0 {
            let below = rows(here + 1..lines.len());
            let near = below.iter().rfind(|&&at| at <= goal);
            near.or(below.first()).copied()
        } else {
            let above = rows(0..here);
            let near = above.iter().find(|&&at| at >= goal);
            near.or(above.last()).copied()
        };
        match (target.and_then(|at| lines.get(at)), by) {
            (None, _) | (_, 0) => self,
            (Some(line), _) => self.under(&lines[here], line),
        }
    }

    /// Moves from one line to another, to the cell with the same index, or the last one.
    fn under(self, from: &TableLine, to: &TableLine) -> Cursor {
        let TableLine::Row(part, row, chunk) = to else {
            return self;
        };
        let along = self.cell_of(from).unwrap_or(0);
        Cursor {
            part: *part,
            row: *row,
            column: (chunk.start + along).min(chunk.end.saturating_sub(1)),
        }
    }

    /// Moves to the next or previous value of the row; stays if there is none.
    pub(crate) fn aside(self, lines: &[TableLine], by: isize) -> Cursor {
        let there = Cursor {
            column: self.column.saturating_add_signed(by),
            ..self
        };
        match there.line(lines) {
            Some(_) => there,
            None => self.settled(lines),
        }
    }
}

/// Returns the visible lines at a scroll offset. The heading of the first visible rows stays above
/// them, even if it is scrolled out.
pub(crate) fn visible_lines(lines: &[TableLine], scroll: usize, height: usize) -> Vec<usize> {
    let mut seen: Vec<usize> = (scroll..lines.len()).take(height).collect();
    let heading = heading_above(lines, scroll);
    let rows_stay = matches!(lines.get(scroll + heading.len()), Some(TableLine::Row(..)));
    if rows_stay && heading.len() < seen.len() {
        for (place, at) in seen.iter_mut().zip(heading) {
            *place = at;
        }
    }
    seen
}

/// Returns the range of the heading of the columns in this line; empty if the line needs none.
fn heading_above(lines: &[TableLine], at: usize) -> Range<usize> {
    let is_heading = |line: &TableLine| matches!(line, TableLine::Names(..) | TableLine::Units(..));
    if !matches!(
        lines.get(at),
        Some(TableLine::Row(..) | TableLine::Units(..))
    ) {
        return 0..0;
    }
    let above = &lines[..at];
    let Some(last) = above.iter().rposition(is_heading) else {
        return 0..0;
    };
    // If the heading is cut in two, its units belong to it.
    let after = lines[last + 1..].iter().take_while(|l| is_heading(l));
    let end = last + 1 + after.count();
    let first = above[..last].iter().rposition(|l| !is_heading(l));
    first.map_or(0, |first| first + 1)..end
}

/// Returns the scroll offset nearest to `scroll` at which the cursor's line and its heading are
/// visible.
pub(crate) fn follow(lines: &[TableLine], cursor: Cursor, scroll: usize, height: usize) -> usize {
    let maximum = lines.len().saturating_sub(height);
    let scroll = scroll.min(maximum);
    let Some(line) = cursor.line(lines) else {
        return scroll;
    };
    let names = heading_above(lines, line).start;
    let shows = |scroll: &usize| {
        let seen = visible_lines(lines, *scroll, height);
        seen.contains(&line) && seen.contains(&names)
    };
    if shows(&scroll) {
        return scroll;
    }
    let found = if line < scroll + height {
        (0..scroll).rev().find(shows)
    } else {
        (scroll..=maximum).find(shows)
    };
    found.unwrap_or(scroll)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns two blocks of vectors and one of points, the first of which is fixed.
    fn lines() -> Vec<TableLine> {
        use SheetPart::{Points, Vectors};
        let mut lines = Vec::new();
        let blocks = [
            (Vectors, 0..3, 0..2),
            (Vectors, 0..3, 2..4),
            (Points, 0..4, 0..2),
            (Points, 1..4, 2..5),
        ];
        for (part, rows, chunk) in blocks {
            lines.push(TableLine::Names(part, chunk.clone()));
            lines.push(TableLine::Units(part, chunk.clone()));
            lines.extend(rows.map(|row| TableLine::Row(part, row, chunk.clone())));
            lines.push(TableLine::Blank);
        }
        lines.pop();
        lines
    }

    fn place(part: SheetPart, row: usize, column: usize) -> Cursor {
        Cursor { part, row, column }
    }

    #[test]
    fn cursor_moves_between_rows_across_headings() {
        use SheetPart::{Points, Vectors};
        let lines = lines();
        let cursor = place(Vectors, 2, 1);
        assert_eq!(cursor.moved(&lines, 1), place(Vectors, 0, 3));
        assert_eq!(cursor.moved(&lines, -1), place(Vectors, 1, 1));
        assert_eq!(cursor.moved(&lines, -9), place(Vectors, 0, 1));
        assert_eq!(
            cursor.moved(&lines, 9),
            place(Points, 0, 1).moved(&lines, -1)
        );
        assert_eq!(cursor.moved(&lines, 10), place(Points, 0, 1));
        assert_eq!(cursor.moved(&lines, isize::MAX), place(Points, 3, 3));
        assert_eq!(cursor.moved(&lines, 0), cursor);
        assert_eq!(place(Points, 3, 4).moved(&lines, 1), place(Points, 3, 4));
    }

    #[test]
    fn cursor_jumps_between_parts_and_stops_at_ends() {
        use SheetPart::{Points, Vectors};
        let lines = lines();
        let parts = [
            place(Vectors, 0, 0),
            place(Vectors, 0, 2),
            place(Points, 0, 0),
            place(Points, 1, 2),
        ];
        for pair in parts.windows(2) {
            assert_eq!(pair[0].in_part(&lines, true), pair[1]);
            assert_eq!(pair[1].in_part(&lines, false), pair[0]);
        }
        assert_eq!(parts[3].in_part(&lines, true), parts[3]);
        assert_eq!(
            place(Vectors, 2, 1).in_part(&lines, false),
            place(Vectors, 2, 1)
        );
        assert_eq!(place(Vectors, 2, 1).in_part(&lines, true), parts[1]);
    }

    #[test]
    fn cursor_moves_between_columns_across_blocks() {
        use SheetPart::{Points, Vectors};
        let lines = lines();
        let mut cursor = place(Vectors, 1, 0);
        for column in 1..4 {
            cursor = cursor.aside(&lines, 1);
            assert_eq!(cursor, place(Vectors, 1, column));
        }
        assert_eq!(cursor.aside(&lines, 1), cursor);
        assert_eq!(place(Vectors, 1, 0).aside(&lines, -1), place(Vectors, 1, 0));
        // The row of a fixed point ends with its position.
        assert_eq!(place(Points, 0, 1).aside(&lines, 1), place(Points, 0, 1));
    }

    #[test]
    fn cursor_settles_if_its_cell_is_not_shown() {
        use SheetPart::{Points, Vectors};
        let lines = lines();
        assert_eq!(place(Points, 0, 3).settled(&lines), place(Points, 0, 0));
        assert_eq!(place(Points, 9, 3).settled(&lines), place(Vectors, 0, 0));
        assert_eq!(place(Points, 9, 3).settled(&[]), place(Points, 9, 3));
        assert_eq!(place(Points, 9, 3).moved(&[], 1), place(Points, 9, 3));
    }

    #[test]
    fn cursor_row_and_its_column_names_stay_visible() {
        let lines = lines();
        for height in 4..lines.len() + 2 {
            let mut scroll = 0;
            let mut cursor = Cursor::default();
            let steps = [1; 40]
                .into_iter()
                .chain([-1; 40])
                .chain([7, 7, -5, 9, -99]);
            for by in steps {
                cursor = cursor.moved(&lines, by);
                scroll = follow(&lines, cursor, scroll, height);
                let seen = visible_lines(&lines, scroll, height);
                let line = cursor.line(&lines).unwrap();
                assert!(seen.contains(&line), "{cursor:?} at {height}");
                let mut names = seen.iter().filter(|&&at| at < line);
                let names = names.rfind(|&&at| matches!(lines[at], TableLine::Names(..)));
                let names = &lines[*names.unwrap()];
                let (TableLine::Row(part, _, chunk), TableLine::Names(above, of)) =
                    (&lines[line], names)
                else {
                    panic!("{cursor:?}");
                };
                assert_eq!((part, chunk), (above, of), "{cursor:?} at {height}");
            }
        }
    }
}
