//! A text in Markdown as lines of a width.

use super::markdown::{MarkdownBlock, MarkdownContent, blocks};
use super::table;
use crate::page::wrapped;

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineKind {
    /// A heading.
    Title,
    /// Words, or nothing.
    Words,
    /// Part of a file or of a screen, as it stands: the only lines that may be wider than there is room.
    Code,
}

/// A line, without the blanks at its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ManualLine {
    pub(crate) kind: LineKind,
    pub(crate) text: String,
    /// Whether it goes on with the line before: with its next word, or as code right behind it. What begins is a
    /// paragraph, a row of a table or a line of code.
    pub(crate) goes_on: bool,
}

/// Longer lines of words are no pleasure to read.
const MAX_WIDTH: usize = 100;
/// Narrower than this no table and no word has room.
const MIN_WIDTH: usize = 30;
/// Blanks before what is shown as it stands, where there is room for them.
const CODE: usize = 4;
/// Code of more characters than this may be broken between its words.
pub(super) const TOGETHER: usize = 22;
/// Stands for a blank at which no line is broken.
const TIED: char = '\u{1}';

/// The text in lines of at most so many characters, however wide the screen is.
pub(crate) fn lines(text: &str, width: usize) -> Vec<ManualLine> {
    let mut lines: Vec<ManualLine> = Vec::new();
    for block in blocks(text) {
        if block.apart && !lines.is_empty() {
            lines.push(line(LineKind::Words, ""));
        }
        lines.extend(laid_out(&block, width.clamp(MIN_WIDTH, MAX_WIDTH)));
    }
    lines
}

fn laid_out(block: &MarkdownBlock<'_>, width: usize) -> Vec<ManualLine> {
    let room = width - block.indent;
    let inner = match &block.content {
        MarkdownContent::Heading(_, text) => passage(LineKind::Title, broken(&plain(text), room)),
        MarkdownContent::Paragraph(text) => passage(LineKind::Words, broken(&plain(text), room)),
        MarkdownContent::Item(text) => passage(LineKind::Words, item(text, room)),
        MarkdownContent::Code(code) => as_it_stands(code, room),
        MarkdownContent::Table(table) => table::lines(table, room),
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

/// The words behind their mark.
fn item(text: &str, width: usize) -> Vec<String> {
    let lines = broken(&plain(text), width - 2).into_iter();
    let marks = std::iter::once("- ").chain(std::iter::repeat("  "));
    lines
        .zip(marks)
        .map(|(line, mark)| mark.to_owned() + &line)
        .collect()
}

fn as_it_stands(code: &[&str], width: usize) -> Vec<ManualLine> {
    let widest = code.iter().map(|line| line.chars().count()).max();
    let indent = CODE.min(width.saturating_sub(widest.unwrap_or(0)));
    let indented = code.iter().map(|code| format!("{:indent$}{code}", ""));
    indented.map(|code| line(LineKind::Code, &code)).collect()
}

/// Words in lines of at most so many characters; short code stays together.
pub(super) fn broken(text: &str, width: usize) -> Vec<String> {
    let pieces = text.split('`').enumerate();
    let tied = pieces.map(|(i, piece)| match i % 2 == 1 && piece.len() <= TOGETHER {
        true => piece.replace(' ', &TIED.to_string()),
        false => piece.to_owned(),
    });
    let tied: Vec<String> = tied.collect();
    let lines = wrapped(&tied.join("`"), width).into_iter();
    lines.map(|line| line.replace(TIED, " ")).collect()
}

/// Without the marks of what is to be bold, and of a bar within a table; those of code stay, for a terminal has no
/// other.
pub(crate) fn plain(text: &str) -> String {
    text.replace("**", "").replace(r"\|", "|")
}

/// A line that goes on with nothing.
pub(super) fn line(kind: LineKind, text: &str) -> ManualLine {
    ManualLine {
        kind,
        text: text.trim_end().to_owned(),
        goes_on: false,
    }
}

/// Lines of which each goes on with the one before.
fn passage(kind: LineKind, lines: Vec<String>) -> Vec<ManualLine> {
    let lines = lines.iter().enumerate().map(|(number, text)| ManualLine {
        goes_on: number > 0,
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
