//! The working as Markdown: headings, tables and formulas between fences.

use super::document::{Block, Document, Table, spelled};
use crate::scene::sanitized;

impl Document {
    /// The text as Markdown; with `ascii` Greek letters are spelled.
    #[must_use]
    pub fn to_markdown(&self, ascii: bool) -> String {
        let shown = |text: &str| {
            if ascii {
                spelled(text)
            } else {
                text.to_owned()
            }
        };
        let mut parts = Vec::new();
        for block in &self.blocks {
            parts.push(match block {
                Block::Title(title) => format!("# {}\n", escaped(&sanitized(title, ascii))),
                Block::Heading(level, text) => {
                    let marks = "#".repeat(usize::from(*level) + 1);
                    format!("{marks} {}\n", escaped(&shown(text)))
                }
                Block::Text(text) => format!("{}\n", escaped(&shown(text))),
                Block::Equations(equations) => {
                    let lines = equations.iter().map(|e| shown(&e.sides.join(" = ")) + "\n");
                    format!("```text\n{}```\n", lines.collect::<String>())
                }
                Block::Table(table) => columns(table, shown),
            });
        }
        parts.join("\n")
    }
}

fn columns(table: &Table, shown: impl Fn(&str) -> String) -> String {
    let line = |cells: &[String]| {
        let cells: Vec<String> = cells.iter().map(|cell| escaped(&shown(cell))).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let marks = (0..table.head.len()).map(|c| if c == 0 { "---" } else { "---:" });
    let marks: Vec<&str> = marks.collect();
    let mut text = line(&table.head);
    text.push_str(&format!("| {} |\n", marks.join(" | ")));
    text.extend(table.rows.iter().map(|row| line(row)));
    text
}

/// What Markdown would take for a mark of its own, escaped.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(
            c,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '~'
        ) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
