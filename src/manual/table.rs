//! Lays out tables: in columns if they fit, if necessary with the widest one wrapped, or else entry by entry.

use super::layout::{LineKind, ManualLine, broken, line, plain};
use super::markdown::MarkdownTable;

/// Blanks between two columns.
const GAP: usize = 2;
/// Minimum width of a wrapped column, in characters; narrower columns are hard to read.
const MIN_WIDTH: usize = 24;
/// Indentation of the further cells of an entry, in blanks.
const INDENT: usize = 4;

/// Lays out a table in lines of at most `width` characters.
pub(super) fn lines(table: &MarkdownTable<'_>, width: usize) -> Vec<ManualLine> {
    let rows = table.rows.iter().map(|cells| ManualRow::new(cells));
    let rows: Vec<ManualRow> = rows.collect();
    let widths = widths(&rows);
    match fitting(&widths, width) {
        Some(widths) => in_columns(&rows, &table.right, &widths),
        None => by_entry(&rows, widest(&widths), width),
    }
}

/// The cells of a row without Markdown for bold words.
struct ManualRow {
    cells: Vec<String>,
    /// Whether the row begins a group of rows: its first cell is bold.
    opens: bool,
}

impl ManualRow {
    fn new(cells: &[&str]) -> Self {
        ManualRow {
            opens: cells.first().is_some_and(|cell| cell.starts_with("**")),
            cells: cells.iter().map(|cell| plain(cell)).collect(),
        }
    }

    fn is_blank(&self) -> bool {
        self.cells.iter().all(String::is_empty)
    }

    fn kind(&self) -> LineKind {
        if self.opens {
            LineKind::Title
        } else {
            LineKind::Words
        }
    }
}

/// Returns the width of each column's longest cell. Titles of groups do not count, because they have their own line.
fn widths(rows: &[ManualRow]) -> Vec<usize> {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows.iter().filter(|row| !is_title(row)) {
        widths.resize(widths.len().max(row.cells.len()), 0);
        for (width, cell) in widths.iter_mut().zip(&row.cells) {
            *width = (*width).max(cell.chars().count());
        }
    }
    widths
}

/// Returns the index of the first of the widest columns; 0 if there are none.
fn widest(widths: &[usize]) -> usize {
    let maximum = widths.iter().max();
    let first = widths.iter().position(|width| Some(width) == maximum);
    first.unwrap_or(0)
}

/// Returns the column widths that fit into `width`; if necessary, the widest column shrinks. Returns `None` if it would
/// be narrower than [`MIN_WIDTH`].
fn fitting(widths: &[usize], width: usize) -> Option<Vec<usize>> {
    let gaps = GAP * widths.len().saturating_sub(1);
    let used = widths.iter().sum::<usize>() + gaps;
    let mut fitting = widths.to_vec();
    if used > width {
        let widest = fitting.get_mut(widest(widths))?;
        *widest = (*widest + width).checked_sub(used)?;
        if *widest < MIN_WIDTH {
            return None;
        }
    }
    Some(fitting)
}

/// Returns `true` if a row has only the title of a group.
fn is_title(row: &ManualRow) -> bool {
    row.opens && row.cells.iter().skip(1).all(String::is_empty)
}

/// Lays out the rows in columns of these widths, with a blank line before each group.
fn in_columns(rows: &[ManualRow], right: &[bool], widths: &[usize]) -> Vec<ManualLine> {
    let mut lines = Vec::new();
    for row in rows.iter().filter(|row| !row.is_blank()) {
        if row.opens && !lines.is_empty() {
            lines.push(line(LineKind::Words, ""));
        }
        if is_title(row) {
            lines.push(line(LineKind::Title, &row.cells[0]));
            continue;
        }
        let cells = row.cells.iter().zip(widths);
        let cells: Vec<_> = cells.map(|(cell, width)| broken(cell, *width)).collect();
        let deepest = cells.iter().map(Vec::len).max().unwrap_or(0);
        for depth in 0..deepest {
            let mut text = String::new();
            for (column, (cell, &width)) in cells.iter().zip(widths).enumerate() {
                let words = cell.get(depth).map_or("", String::as_str);
                text += &match right.get(column) {
                    Some(true) => format!("{words:>width$}"),
                    _ => format!("{words:width$}"),
                };
                text += &" ".repeat(GAP);
            }
            lines.push(ManualLine {
                continues: depth > 0,
                ..line(row.kind(), &text)
            });
        }
    }
    lines
}

/// Lays out each row as an entry: its first cell, and the other cells on indented lines below. The head of the column
/// labels each of these; the widest column, and a column without a head, have no label.
fn by_entry(rows: &[ManualRow], widest: usize, width: usize) -> Vec<ManualLine> {
    let Some((head, rows)) = rows.split_first() else {
        return Vec::new();
    };
    let mut lines = Vec::new();
    for row in rows {
        if row.opens && !lines.is_empty() {
            lines.push(line(LineKind::Words, ""));
        }
        let cells = row.cells.iter().zip(&head.cells).enumerate();
        for (column, (cell, head)) in cells.filter(|(_, (cell, _))| !cell.is_empty()) {
            let (kind, indent, shown_text) = match column {
                0 => (row.kind(), 0, cell.clone()),
                _ if column == widest || head.is_empty() => (LineKind::Words, INDENT, cell.clone()),
                _ => (LineKind::Words, INDENT, format!("{head}: {cell}")),
            };
            let shown_text = broken(&shown_text, width - indent).into_iter();
            lines.extend(shown_text.enumerate().map(|(number, text)| ManualLine {
                continues: column > 0 || number > 0,
                ..line(kind, &format!("{:indent$}{text}", ""))
            }));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use crate::manual::lines;

    fn shown(text: &str, width: usize) -> String {
        let lines = lines(text, width).into_iter();
        lines.map(|line| line.text + "\n").collect()
    }

    const KEYS: &str = "\
| key | what it is | default |
|---|---|---:|
| `a` | short | 1 |
| **Group** | | |
| `length` | one two three four five six seven | none |
";

    #[test]
    fn columns_line_up() {
        let lines = "\
key       what it is                         default
`a`       short                                    1

Group
`length`  one two three four five six seven     none
";
        assert_eq!(shown(KEYS, 80), lines);
    }

    #[test]
    fn the_widest_column_is_wrapped() {
        let lines = "\
key       what it is                 default
`a`       short                            1

Group
`length`  one two three four five       none
          six seven
";
        assert_eq!(shown(KEYS, 44), lines);
    }

    #[test]
    fn where_there_is_no_room_entries_follow_each_other() {
        let lines = "\
`a`
    short
    default: 1

Group
`length`
    one two three four five
    six seven
    default: none
";
        assert_eq!(shown(KEYS, 30), lines);
    }
}
