//! The working as plain text of any width.

use super::document::{Block, Document, Equation, Table, spelled};
use crate::scene::sanitized;

/// What a line of the text is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// The title of the scene.
    Title,
    /// A heading of the first level.
    Part,
    /// A heading of the second level.
    Section,
    /// The head of a table.
    Head,
    /// Anything else.
    Body,
}

/// How the text is laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextStyle {
    /// 7-bit characters alone: Greek letters are spelled.
    pub ascii: bool,
    /// Columns; lines are broken where they can be.
    pub width: usize,
}

/// Blanks before a formula and before a table.
const INDENT: usize = 2;
/// A left side up to here keeps the following sides below its sign of equality.
const SHORT_SIDE: usize = 16;
/// Blanks between columns.
const GAP: usize = 2;

impl Document {
    /// The text, every line with its end.
    #[must_use]
    pub fn to_text(&self, style: TextStyle) -> String {
        let mut text = String::new();
        for (kind, line) in self.lines(style) {
            if matches!(kind, LineKind::Title | LineKind::Part) {
                let rule = "-".repeat(length(&line));
                text.push_str(&format!("{line}\n{rule}\n"));
            } else {
                text.push_str(&line);
                text.push('\n');
            }
        }
        text
    }

    /// The lines of the text.
    #[must_use]
    pub fn lines(&self, style: TextStyle) -> Vec<(LineKind, String)> {
        let mut lines: Vec<(LineKind, String)> = Vec::new();
        for (i, block) in self.blocks.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|before| self.blocks.get(before));
            if before.is_some_and(|before| !leads_to(before, block)) {
                lines.push((LineKind::Body, String::new()));
            }
            let kind = match block {
                Block::Title(_) => LineKind::Title,
                Block::Heading(1, _) => LineKind::Part,
                Block::Heading(..) => LineKind::Section,
                Block::Text(_) | Block::Equations(_) | Block::Table(_) => LineKind::Body,
            };
            let of_kind = |line| (kind, line);
            match block {
                Block::Title(title) => {
                    let title = sanitized(title, style.ascii);
                    lines.extend(broken(&title, style.width).into_iter().map(of_kind));
                }
                Block::Heading(_, text) | Block::Text(text) => {
                    let text = style.shown(text);
                    lines.extend(broken(&text, style.width).into_iter().map(of_kind));
                }
                Block::Equations(equations) => {
                    let broken = equations.iter().flat_map(|e| equation(e, style));
                    lines.extend(broken.map(of_kind));
                }
                Block::Table(table) => lines.extend(columns(table, style)),
            }
        }
        lines
    }
}

/// Whether a block stands directly below another: below a heading, and below a text that announces it.
fn leads_to(before: &Block, block: &Block) -> bool {
    match before {
        Block::Heading(..) => !matches!(block, Block::Heading(..)),
        Block::Text(text) => text.ends_with(':') && !matches!(block, Block::Heading(..)),
        Block::Title(_) | Block::Equations(_) | Block::Table(_) => false,
    }
}

impl TextStyle {
    fn shown(self, text: &str) -> String {
        if self.ascii {
            spelled(text)
        } else {
            text.to_owned()
        }
    }
}

/// A chain of sides: on one line, or side below side.
fn equation(equation: &Equation, style: TextStyle) -> Vec<String> {
    let sides: Vec<String> = equation.sides.iter().map(|s| style.shown(s)).collect();
    let indent = " ".repeat(INDENT);
    let whole = format!("{indent}{}", sides.join(" = "));
    let Some((first, others)) = sides.split_first().map(|(f, o)| (f.as_str(), o)) else {
        return Vec::new();
    };
    if length(&whole) <= style.width {
        return vec![whole];
    }
    let left = length(first);
    if left > SHORT_SIDE || left + 2 * INDENT > style.width / 2 {
        return terms(&whole, style.width, 2 * INDENT);
    }
    // As many sides to a line as fit, the signs of equality below one another.
    let mut rows: Vec<String> = Vec::new();
    let begin = INDENT + left + " = ".len();
    for side in others {
        let fits = |row: &&mut String| begin + length(row) + 3 + length(side) <= style.width;
        match rows.last_mut().filter(fits) {
            Some(row) => row.push_str(&format!(" = {side}")),
            None => rows.push(side.clone()),
        }
    }
    let room = style.width.saturating_sub(begin);
    let blank = " ".repeat(begin);
    let mut lines = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let name = if i == 0 { first } else { "" };
        for (j, line) in terms(row, room, 2).into_iter().enumerate() {
            let before = match j {
                0 => format!("{indent}{name:left$} = "),
                _ => blank.clone(),
            };
            lines.push(before + &line);
        }
    }
    lines
}

/// A formula in lines of at most `width` columns, broken before the signs between its terms.
fn terms(formula: &str, width: usize, indent: usize) -> Vec<String> {
    let own = formula.len() - formula.trim_start().len();
    fill(&parts(formula), width, [own, indent])
}

/// The terms of a formula, each with the sign before it: breaks only outside of brackets.
fn parts(formula: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut depth = 0_usize;
    for word in formula.split_whitespace() {
        let begins = depth == 0 && matches!(word, "+" | "-" | "=" | "+-");
        match parts.last_mut().filter(|_| !begins) {
            Some(part) => part.push_str(&format!(" {word}")),
            None => parts.push(word.to_owned()),
        }
        let open = word.matches('(').count();
        depth = (depth + open).saturating_sub(word.matches(')').count());
    }
    // That a sum is 0 does not stand on a line of its own.
    if let [.., last, end] = &mut parts[..]
        && end == "= 0"
    {
        last.push_str(" = 0");
        parts.pop();
    }
    parts
}

/// The words of a text in lines of at most `width` columns.
fn broken(text: &str, width: usize) -> Vec<String> {
    let words: Vec<String> = text.split_whitespace().map(str::to_owned).collect();
    fill(&words, width, [0, 0])
}

/// Parts in lines of at most `width` columns: `indents` blanks before the first line and before the
/// others. A part that is longer than a line is broken at its blanks, or anywhere.
fn fill(parts: &[String], width: usize, indents: [usize; 2]) -> Vec<String> {
    let width = width.max(8);
    let [first, other] = indents.map(|indent| indent.min(width / 2));
    let mut lines = vec![" ".repeat(first)];
    let mut is_begun = false;
    for part in parts {
        let line = lines.last().map_or(0, |line| length(line));
        if is_begun && line + 1 + length(part) > width {
            lines.push(" ".repeat(other));
            is_begun = false;
        }
        let room = width - if is_begun { 0 } else { other };
        let pieces = if length(part) > room {
            short_words(part, room)
        } else {
            vec![part.clone()]
        };
        for piece in pieces {
            let line = lines.last().map_or(0, |line| length(line));
            if is_begun && line + 1 + length(&piece) > width {
                lines.push(" ".repeat(other));
                is_begun = false;
            }
            if let Some(line) = lines.last_mut() {
                if is_begun {
                    line.push(' ');
                }
                line.push_str(&piece);
                is_begun = true;
            }
        }
    }
    lines
}

/// The words of a part, none longer than `most`.
fn short_words(part: &str, most: usize) -> Vec<String> {
    let most = most.max(1);
    let words = part
        .split_whitespace()
        .map(|word| word.chars().collect::<Vec<char>>());
    let cut = words.flat_map(|word| word.chunks(most).map(String::from_iter).collect::<Vec<_>>());
    cut.collect()
}

/// A table; columns that do not fit follow below, under the same first column.
fn columns(table: &Table, style: TextStyle) -> Vec<(LineKind, String)> {
    let rows = std::iter::once(&table.head).chain(&table.rows);
    let rows: Vec<Vec<String>> = rows
        .map(|row| row.iter().map(|cell| style.shown(cell)).collect())
        .collect();
    let widths: Vec<usize> = (0..table.head.len())
        .map(|c| {
            rows.iter()
                .filter_map(|row| row.get(c))
                .map(|cell| length(cell))
                .max()
        })
        .map(|width| width.unwrap_or(0))
        .collect();
    let names = widths.first().copied().unwrap_or(0) + INDENT;
    let mut lines = Vec::new();
    let mut first = 1;
    while first < widths.len() {
        let mut end = first + 1;
        let mut used = names + GAP + widths[first];
        while end < widths.len() && used + GAP + widths[end] <= style.width {
            used += GAP + widths[end];
            end += 1;
        }
        for (i, row) in rows.iter().enumerate() {
            let name = row.first().map_or("", String::as_str);
            let mut line = format!("{}{name:width$}", " ".repeat(INDENT), width = widths[0]);
            for (cell, &width) in row.iter().zip(&widths).take(end).skip(first) {
                line.push_str(&format!("{}{cell:>width$}", " ".repeat(GAP)));
            }
            let kind = if i == 0 {
                LineKind::Head
            } else {
                LineKind::Body
            };
            // A narrow screen cuts what one column alone does not fit.
            let line: String = line.chars().take(style.width.max(8)).collect();
            lines.push((kind, line.trim_end().to_owned()));
        }
        first = end;
    }
    lines
}

fn length(text: &str) -> usize {
    text.chars().count()
}
