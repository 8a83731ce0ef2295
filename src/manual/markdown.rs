//! Parses the Markdown of the manual: headings, paragraphs, lists of one level, tables and code. Code is fenced or
//! indented by four blanks.

/// A block of a Markdown text.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct MarkdownBlock<'t> {
    pub(super) content: MarkdownContent<'t>,
    /// The indentation in columns; not 0 if the block belongs to a list item.
    pub(super) indent: usize,
    /// Whether a blank line precedes the block.
    pub(super) apart: bool,
}

/// The content of a block.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum MarkdownContent<'t> {
    /// The level, counted from 1, and the text.
    Heading(usize, &'t str),
    Paragraph(String),
    /// The first paragraph of a list item, without its dash.
    Item(String),
    /// Verbatim lines, without the indentation of the block.
    Code(Vec<&'t str>),
    Table(MarkdownTable<'t>),
}

/// The rows and alignment of a table.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct MarkdownTable<'t> {
    /// The cells as Markdown; the first row is the head.
    pub(super) rows: Vec<Vec<&'t str>>,
    /// Whether each column is aligned to the right.
    pub(super) right: Vec<bool>,
}

const FENCE: &str = "```";
/// The indentation of a list item's further lines and blocks.
const ITEM: &str = "  ";
/// The indentation of code without fences.
const CODE: &str = "    ";

/// Splits a Markdown text into blocks.
pub(super) fn blocks(text: &str) -> Vec<MarkdownBlock<'_>> {
    let mut reader = MarkdownReader::default();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if line.trim().is_empty() {
            reader.apart = true;
            continue;
        }
        let inner = reader.within_item(line);
        if inner.starts_with(FENCE) {
            let indent = reader.indent;
            let code = lines.by_ref().map(|line| line.get(indent..).unwrap_or(""));
            let code = code.take_while(|line| !line.starts_with(FENCE)).collect();
            reader.start_block(MarkdownContent::Code(code));
        } else {
            reader.line(inner);
        }
    }
    reader.blocks
}

/// The blocks read so far, with the indentation of the current line.
#[derive(Default)]
struct MarkdownReader<'t> {
    blocks: Vec<MarkdownBlock<'t>>,
    indent: usize,
    apart: bool,
}

impl<'t> MarkdownReader<'t> {
    /// Sets the indentation, and returns the line without the blanks that make it part of a list item.
    fn within_item(&mut self, line: &'t str) -> &'t str {
        let in_list = self.indent > 0 || matches!(self.last(), Some(MarkdownContent::Item(_)));
        match line.strip_prefix(ITEM).filter(|_| in_list) {
            Some(inner) => {
                self.indent = ITEM.len();
                inner
            }
            None => {
                self.indent = 0;
                line
            }
        }
    }

    fn last(&mut self) -> Option<&mut MarkdownContent<'t>> {
        self.blocks.last_mut().map(|block| &mut block.content)
    }

    fn start_block(&mut self, content: MarkdownContent<'t>) {
        self.blocks.push(MarkdownBlock {
            content,
            indent: self.indent,
            apart: self.apart,
        });
        self.apart = false;
    }

    /// Reads a line outside a fence: it continues the current block or begins a new one.
    fn line(&mut self, line: &'t str) {
        if let Some(code) = line.strip_prefix(CODE) {
            match self.last() {
                Some(MarkdownContent::Code(lines)) => lines.push(code),
                _ => self.start_block(MarkdownContent::Code(vec![code])),
            }
        } else if line.starts_with('#') {
            let text = line.trim_start_matches('#');
            let level = line.len() - text.len();
            self.start_block(MarkdownContent::Heading(level, text.trim()));
        } else if let Some(item) = line.strip_prefix("- ") {
            self.start_block(MarkdownContent::Item(item.to_owned()));
        } else if line.starts_with('|') {
            self.row(line);
        } else {
            self.words(line);
        }
    }

    fn words(&mut self, line: &str) {
        let distance = self.apart;
        match self.last() {
            Some(MarkdownContent::Paragraph(text) | MarkdownContent::Item(text)) if !distance => {
                text.push(' ');
                text.push_str(line);
            }
            _ => self.start_block(MarkdownContent::Paragraph(line.to_owned())),
        }
    }

    fn row(&mut self, line: &'t str) {
        if self.apart || !matches!(self.last(), Some(MarkdownContent::Table(_))) {
            self.start_block(MarkdownContent::Table(MarkdownTable::default()));
        }
        let cells = line.trim().trim_start_matches('|');
        let cells = split(cells.strip_suffix('|').unwrap_or(cells));
        let Some(MarkdownContent::Table(table)) = self.last() else {
            return;
        };
        if cells.iter().all(|cell| cell.contains("---")) {
            table.right = cells.iter().map(|cell| cell.ends_with(':')).collect();
        } else {
            table.rows.push(cells);
        }
    }
}

/// Splits a row into its cells; a bar after a backslash belongs to the text.
fn split(row: &str) -> Vec<&str> {
    let bars = row.match_indices('|').map(|(bar, _)| bar);
    let bars = bars.filter(|&bar| !row[..bar].ends_with('\\'));
    let mut from = 0;
    let mut cells = Vec::new();
    for bar in bars.chain([row.len()]) {
        cells.push(row[from..bar].trim());
        from = bar + 1;
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contents(text: &str) -> Vec<(usize, bool, MarkdownContent<'_>)> {
        let blocks = blocks(text).into_iter();
        blocks.map(|b| (b.indent, b.apart, b.content)).collect()
    }

    #[test]
    fn every_kind_of_block_is_known() {
        let text = "## One\n\nTwo\nwords.\n- an item\n  goes on\n\n  ```toml\n  a = 1\n\n    b\n  ```\n\n  and on\n\n    krank\n";
        let paragraph = |text: &str| MarkdownContent::Paragraph(text.into());
        assert_eq!(
            contents(text),
            [
                (0, false, MarkdownContent::Heading(2, "One")),
                (0, true, paragraph("Two words.")),
                (0, false, MarkdownContent::Item("an item goes on".into())),
                (2, true, MarkdownContent::Code(vec!["a = 1", "", "  b"])),
                (2, true, paragraph("and on")),
                (2, true, paragraph("  krank")),
            ]
        );
    }

    #[test]
    fn a_table_has_its_head_first() {
        let found = contents("|a|b|\n|---|---:|\n| 1 | |\n\n    krank list\n    krank\n");
        let table = MarkdownTable {
            rows: vec![vec!["a", "b"], vec!["1", ""]],
            right: vec![false, true],
        };
        assert_eq!(found[0], (0, false, MarkdownContent::Table(table)));
        let code = MarkdownContent::Code(vec!["krank list", "krank"]);
        assert_eq!(found[1], (0, true, code));
    }

    #[test]
    fn a_bar_behind_a_backslash_parts_no_cells() {
        assert_eq!(split(r"`\|` | a ||"), [r"`\|`", "a", "", ""]);
    }

    #[test]
    fn a_fence_that_is_left_open_ends_with_the_text() {
        assert_eq!(
            contents("```\na"),
            [(0, false, MarkdownContent::Code(vec!["a"]))]
        );
        assert_eq!(contents(""), []);
    }
}
