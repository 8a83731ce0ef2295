//! Lays out a Markdown text as lines of a given width.

use super::markdown::{MarkdownBlock, MarkdownContent, blocks};
use super::table;
use crate::page::wrapped;

/// The kind of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineKind {
    /// A heading.
    Title,
    /// A line of prose or of a table; blank lines too.
    Words,
    /// A verbatim line of a file or screen. Only these lines may be wider than the requested width.
    Code,
}

/// A laid-out line of a topic. Only folded code has trailing blanks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ManualLine {
    pub(crate) kind: LineKind,
    pub(crate) text: String,
    /// Whether the line continues the one before it: prose with its next word, code without a blank in between. Any
    /// other line begins a paragraph, a table row or a line of code.
    pub(crate) continues: bool,
}

/// Maximum width of prose, in characters; longer lines are hard to read.
const MAX_WIDTH: usize = 100;
/// Minimum width, in characters; tables and long words do not fit into less.
const MIN_WIDTH: usize = 30;
/// Indentation of code, in blanks; less if the code would not fit.
const CODE: usize = 4;
/// Maximum length, in bytes, of inline code that is never broken; longer code is broken between its words.
pub(super) const MAX_UNBROKEN_CODE: usize = 22;
/// Placeholder for a blank at which a line must not be broken.
const TIED: char = '\u{1}';

/// Lays out a Markdown text in lines of at most `width` characters, clamped to the range from [`MIN_WIDTH`] to
/// [`MAX_WIDTH`].
pub(crate) fn lines(text: &str, width: usize) -> Vec<ManualLine> {
    let mut lines: Vec<ManualLine> = Vec::new();
    for block in blocks(text) {
        if block.apart && !lines.is_empty() {
            lines.push(line(LineKind::Words, ""));
        }
        lines.extend(layout_block(&block, width.clamp(MIN_WIDTH, MAX_WIDTH)));
    }
    lines
}

fn layout_block(block: &MarkdownBlock<'_>, width: usize) -> Vec<ManualLine> {
    let space = width - block.indent;
    let inner = match &block.content {
        MarkdownContent::Heading(_, text) => passage(LineKind::Title, broken(&plain(text), space)),
        MarkdownContent::Paragraph(text) => passage(LineKind::Words, broken(&plain(text), space)),
        MarkdownContent::Item(text) => passage(LineKind::Words, item(text, space)),
        MarkdownContent::Code(code) => verbatim(code, space),
        MarkdownContent::Table(table) => table::lines(table, space),
    };
    let indented = inner.into_iter().map(|inner| match inner.text.as_str() {
        "" => inner,
        text => ManualLine {
            text: format!("{:1$}{text}", "", block.indent),
            ..inner
        },
    });
    indented.collect()
}

/// Lays out a list item: a dash, and an indentation of the lines after the first.
fn item(text: &str, width: usize) -> Vec<String> {
    let lines = broken(&plain(text), width - 2).into_iter();
    let marks = std::iter::once("- ").chain(std::iter::repeat("  "));
    lines
        .zip(marks)
        .map(|(line, mark)| mark.to_owned() + &line)
        .collect()
}

/// Returns code verbatim, indented as far as `width` permits.
fn verbatim(code: &[&str], width: usize) -> Vec<ManualLine> {
    let widest = code.iter().map(|line| line.chars().count()).max();
    let indent = CODE.min(width.saturating_sub(widest.unwrap_or(0)));
    let indented = code.iter().map(|code| format!("{:indent$}{code}", ""));
    indented.map(|code| line(LineKind::Code, &code)).collect()
}

/// Breaks words into lines of at most `width` characters; short code stays on one line.
pub(super) fn broken(text: &str, width: usize) -> Vec<String> {
    let pieces = text.split('`').enumerate();
    let tied = pieces.map(
        |(i, piece)| match i % 2 == 1 && piece.len() <= MAX_UNBROKEN_CODE {
            true => piece.replace(' ', &TIED.to_string()),
            false => piece.to_owned(),
        },
    );
    let tied: Vec<String> = tied.collect();
    let lines = wrapped(&tied.join("`"), width).into_iter();
    lines.map(|line| line.replace(TIED, " ")).collect()
}

/// Removes the Markdown of bold words and of escaped bars in tables. Backquotes stay, because a terminal has no other
/// mark for code.
pub(crate) fn plain(text: &str) -> String {
    text.replace("**", "").replace(r"\|", "|")
}

/// Creates a line that does not continue the one before it.
pub(super) fn line(kind: LineKind, text: &str) -> ManualLine {
    ManualLine {
        kind,
        text: text.trim_end().to_owned(),
        continues: false,
    }
}

/// Creates the lines of a passage: each continues the one before it.
fn passage(kind: LineKind, lines: Vec<String>) -> Vec<ManualLine> {
    let lines = lines.iter().enumerate().map(|(number, text)| ManualLine {
        continues: number > 0,
        ..line(kind, text)
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, width: usize) -> String {
        let lines = lines(text, width).into_iter();
        lines.map(|line| line.text + "\n").collect()
    }

    #[test]
    fn words_wrap_and_what_stands_as_it_is_does_not() {
        let text = "# A **heading**\n\n- one two three four five six seven\n- eight\n\n```text\n  a   b\n```\n";
        let lines = "A heading\n\n- one two three four five six\n  seven\n- eight\n\n      a   b\n";
        assert_eq!(shown(text, 30), lines);
        let wide = "a".repeat(90);
        let text = format!("```txt\n{wide}\n```\n");
        assert_eq!(shown(&text, 80), wide + "\n");
    }

    #[test]
    fn short_code_stays_together() {
        let text =
            "one two three four five `six seven`, and `that --which is too long for it` goes on\n";
        let lines = "one two three four five\n`six seven`, and `that --which\nis too long for it` goes on\n";
        assert_eq!(shown(text, 30), lines);
    }

    #[test]
    fn a_screen_of_no_width_gets_what_the_narrowest_gets() {
        let text = "one two three four five six seven\n\n| a | b |\n|---|---|\n| 1 | 2 |\n";
        assert_eq!(lines(text, 0), lines(text, MIN_WIDTH));
    }
}
