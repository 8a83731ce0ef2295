//! Aligned tables in plain text.

/// Columns of a plain terminal: tables and lines wrap to stay within them where they can.
pub(super) const WIDTH: usize = 80;
/// Blanks between two columns.
const GAP: &str = "  ";

/// A table of text: rows of cells; the first cell of a row is its label.
#[derive(Clone, Debug, Default)]
pub(super) struct Grid {
    rows: Vec<Vec<String>>,
    labels: usize,
    columns: usize,
}

impl Grid {
    /// Labels and columns have at least these widths, so that tables below one another line up.
    pub(super) fn new(labels: usize, columns: usize) -> Self {
        Grid {
            rows: Vec::new(),
            labels,
            columns,
        }
    }

    pub(super) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }

    /// The labels to the left, everything else to the right; as many columns side by side as fit,
    /// the others below under the same labels.
    pub(super) fn render(&self) -> String {
        let labels = self.width(0).max(self.labels);
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut out = String::new();
        let mut first = 1;
        while first < columns {
            let widths = self.fitting(first, columns, labels);
            if !out.is_empty() {
                out.push('\n');
            }
            self.render_block(first, labels, &widths, &mut out);
            first += widths.len();
        }
        out
    }

    fn width(&self, column: usize) -> usize {
        let cells = self.rows.iter().filter_map(|row| row.get(column));
        cells.map(|c| c.chars().count()).max().unwrap_or(0)
    }

    /// The widths of the columns from `first` on that fit beside the labels: at least one.
    fn fitting(&self, first: usize, columns: usize, labels: usize) -> Vec<usize> {
        let mut used = labels;
        let mut widths = Vec::new();
        for column in first..columns {
            let width = self.width(column).max(self.columns);
            used += GAP.len() + width;
            if used > WIDTH && !widths.is_empty() {
                break;
            }
            widths.push(width);
        }
        widths
    }

    fn render_block(&self, first: usize, labels: usize, widths: &[usize], out: &mut String) {
        for row in &self.rows {
            let label = row.first().map_or("", String::as_str);
            let mut line = format!("{label:labels$}");
            for (cell, width) in row.iter().skip(first).zip(widths) {
                line.push_str(GAP);
                line.push_str(&format!("{cell:>width$}"));
            }
            out.push_str(line.trim_end());
            out.push('\n');
        }
    }
}

/// The words of a text in lines of at most `width` characters; a longer word has its own line.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_wrap_and_none_is_lost() {
        let lines = wrapped("one two  three-and-more four", 8);
        assert_eq!(lines, ["one two", "three-and-more", "four"]);
        assert!(wrapped(" ", 8).is_empty());
    }

    #[test]
    fn columns_that_do_not_fit_follow_below() {
        let mut grid = Grid::default();
        let cells = |k: usize| (0..10).map(move |c| format!("{}", c * k + 1_000_000));
        grid.row(std::iter::once("label".to_owned()).chain(cells(1)));
        grid.row(std::iter::once("x".to_owned()).chain(cells(2)));
        let text = grid.render();
        assert!(text.lines().all(|l| l.len() <= WIDTH), "{text}");
        assert_eq!(text.matches("label").count(), 2, "{text}");
        assert!(text.contains("\nx      1000000"), "{text}");
        for c in 0..10 {
            assert!(text.contains(&(c * 2 + 1_000_000).to_string()));
        }
    }

    #[test]
    fn a_table_without_columns_is_no_lines() {
        let mut grid = Grid::default();
        grid.row(["alone".to_owned()]);
        assert_eq!(grid.render(), "");
    }
}
