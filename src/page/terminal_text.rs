//! Converts the texts of a page to characters that a terminal can display.

use super::{Block, Cell, Content, Equation, Facts, Head, Illustration, Page, Row, Table};
use crate::document::sanitized;

/// The layout of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextStyle {
    /// Whether only 7-bit characters are allowed: Greek letters are spelled out.
    pub ascii: bool,
    /// The number of columns; lines are wrapped where possible.
    pub width: usize,
}

impl TextStyle {
    /// Returns the style of a plain terminal, 80 columns wide.
    pub(crate) const fn plain(ascii: bool) -> TextStyle {
        TextStyle { ascii, width: 80 }
    }
}

impl Page {
    /// Returns the page with every text as displayed: nothing in it can harm a terminal.
    pub(super) fn shown(&self, ascii: bool) -> Page {
        let blocks = self.blocks.iter();
        let block = |block: &Block| Block {
            content: block.content.shown(ascii),
            ..*block
        };
        Page {
            blocks: blocks.map(block).collect(),
            symbols: Vec::new(),
            ..*self
        }
    }
}

impl Content {
    /// Returns the content with every text as displayed.
    pub(super) fn shown(&self, ascii: bool) -> Content {
        self.with_texts(&|text| shown(text, ascii))
    }

    /// Returns the content for writers that typeset formulas: sanitized.
    pub(super) fn harmless(&self) -> Content {
        self.with_texts(&|text| shown(text, false))
    }

    fn with_texts(&self, shown: &impl Fn(&str) -> String) -> Content {
        let all = |texts: &[String]| texts.iter().map(|text| shown(text)).collect();
        match self {
            Content::Title(text) => Content::Title(shown(text)),
            Content::Heading(level, text) => Content::Heading(*level, shown(text)),
            Content::Text(text) => Content::Text(shown(text)),
            Content::Equations(equations) => {
                let sides = |equation: &Equation| Equation {
                    sides: equation
                        .sides
                        .iter()
                        .map(|side| side.with_texts(shown))
                        .collect(),
                };
                Content::Equations(equations.iter().map(sides).collect())
            }
            Content::Facts(facts) => {
                let list = facts.list.iter();
                let list = list
                    .map(|(name, shown_lines)| (shown(name), all(shown_lines)))
                    .collect();
                Content::Facts(Facts { list, ..*facts })
            }
            Content::Characters(lines) => Content::Characters(lines.clone()),
            Content::Picture(picture) => Content::Picture(Illustration {
                artwork: picture.artwork.clone(),
                caption: shown(&picture.caption),
                character_caption: picture.character_caption.as_deref().map(shown),
                characters: all(&picture.characters),
            }),
            Content::Table(table) => Content::Table(Table {
                title: shown(&table.title),
                heads: table.heads.iter().map(|head| head.shown(shown)).collect(),
                rows: table.rows.iter().map(|row| row.shown(shown)).collect(),
                setting: table.setting.clone(),
            }),
        }
    }
}

impl Head {
    fn shown(&self, shown: &impl Fn(&str) -> String) -> Head {
        Head {
            name: shown(&self.name),
            unit: shown(&self.unit),
        }
    }
}

impl Row {
    fn shown(&self, shown: &impl Fn(&str) -> String) -> Row {
        let cell = |cell: &Cell| Cell {
            text: shown(&cell.text),
            unproved: cell.unproved.clone(),
            formula: cell.formula.as_ref().map(|f| f.with_texts(shown)),
        };
        match self {
            Row::Part(name) => Row::Part(shown(name)),
            Row::Told { mark, name, words } => Row::Told {
                mark: mark.clone(),
                name: shown(name),
                words: shown(words),
            },
            Row::Figures {
                mark,
                name,
                more,
                cells,
            } => Row::Figures {
                mark: mark.clone(),
                name: shown(name),
                more: more.as_deref().map(shown),
                cells: cells.iter().map(|c| c.as_ref().map(cell)).collect(),
            },
        }
    }
}

/// Returns the text as displayed. With `ascii`, letters and signs of formulas are spelled out, and
/// characters without a spelling become `?`.
pub(super) fn shown(text: &str, ascii: bool) -> String {
    if ascii && !text.is_ascii() {
        sanitized(&spelled(text), ascii)
    } else {
        sanitized(text, ascii)
    }
}

fn spelled(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'θ' => out.push_str("theta"),
            'ω' => out.push_str("omega"),
            'α' => out.push_str("alpha"),
            'β' => out.push_str("beta"),
            'γ' => out.push_str("gamma"),
            'μ' => out.push_str("mu"),
            'ν' => out.push_str("nu"),
            '·' => out.push('*'),
            '→' => out.push_str("->"),
            _ => out.push(c),
        }
    }
    out
}
