//! Writes a page as Markdown: headings, tables, and formulas in fenced blocks.

use super::{Content, Facts, Page, Row, Table};

impl Page {
    /// Returns the page as Markdown; with `ascii`, Greek letters are spelled out.
    #[must_use]
    pub fn to_markdown(&self, ascii: bool) -> String {
        let mut parts = Vec::new();
        for block in &self.blocks {
            parts.push(match &block.content.shown(ascii) {
                Content::Title(title) => format!("# {}\n", escaped(title)),
                Content::Heading(level, text) => {
                    let marks = "#".repeat(usize::from(*level) + 1);
                    format!("{marks} {}\n", escaped(text))
                }
                Content::Text(text) => format!("{}\n", escaped(text.trim_start())),
                Content::Facts(list) => facts(list),
                Content::Equations(equations) => {
                    let lines = equations.iter();
                    let lines = lines.map(|equation| format!("{equation}\n"));
                    format!("```text\n{}```\n", lines.collect::<String>())
                }
                Content::Table(table) => columns(table),
                Content::Characters(lines) => format!("```text\n{}\n```\n", lines.join("\n")),
                Content::Picture(picture) => {
                    let drawn = picture.characters.join("\n");
                    let caption = escaped(picture.character_caption());
                    format!("{caption}\n\n```text\n{drawn}\n```\n")
                }
            });
        }
        parts.retain(|part| !part.is_empty());
        parts.join("\n")
    }
}

fn facts(facts: &Facts) -> String {
    let list = facts.list.iter();
    let line = |(name, text): &(String, Vec<String>)| {
        let text: Vec<String> = text.iter().map(|text| escaped(text)).collect();
        format!("- **{}**: {}\n", escaped(name.trim()), text.join("; "))
    };
    list.map(line).collect()
}

fn columns(table: &Table) -> String {
    let count = table.heads.len();
    let line = |name: &str, cells: Vec<String>| {
        let cells = std::iter::once(escaped(name.trim())).chain(cells);
        format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
    };
    let headers = table
        .heads
        .iter()
        .map(|head| escaped(head.one_line().trim()));
    let mut text = line(&table.title, headers.collect());
    let marks = ["---"]
        .into_iter()
        .chain(std::iter::repeat_n("---:", count));
    text.push_str(&format!("| {} |\n", marks.collect::<Vec<_>>().join(" | ")));
    for row in &table.rows {
        let (mark, name) = row.label(true);
        let name = format!("{mark} {}", name.trim());
        let blank = || vec![String::new(); count];
        let cells = match row {
            Row::Part(_) => blank(),
            Row::Told { words, .. } => {
                let mut cells = blank();
                cells[..count.min(1)].fill(escaped(words));
                cells
            }
            Row::Figures { cells, .. } => {
                let mut texts = blank();
                for (text, cell) in texts.iter_mut().zip(cells) {
                    *text = cell
                        .as_ref()
                        .map_or_else(String::new, |c| escaped(c.text.trim()));
                }
                texts
            }
        };
        text.push_str(&line(&name, cells));
    }
    text
}

/// Escapes the characters with a special meaning in Markdown.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(
            c,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '~' | '&'
        ) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
