//! Represents reports as data, independent of the width of the reader's screen.
//!
//! Reports fill pages. A page is written as plain text ([`Page::to_text`]), as Markdown
//! ([`Page::to_markdown`]), as an HTML file ([`Page::to_html`]), as LaTeX ([`Page::to_latex`]), or
//! line by line for a screen ([`Page::lines`]). Every part of a line has a [`TextRole`], but no
//! colours.
//!
//! Its strings contain Greek letters, `·` for a product and `→` from point to point. A writer
//! spells them out if they cannot be displayed.

mod artwork;
mod columns;
mod formula;
mod html;
mod latex;
mod layout;
mod line;
mod markdown;
mod math;
mod prose;
mod style;
mod svg;
mod table;
mod terminal_text;
#[cfg(test)]
mod tests;
mod text;
mod tikz;
mod words;

#[cfg(test)]
pub(crate) use artwork::ArtElement;
pub use artwork::Artwork;
pub(crate) use artwork::TextAnchor;
#[cfg(feature = "tui")]
pub(crate) use columns::ColumnLayout;
pub(crate) use html::html_document;
pub use line::{Line, Span, TextRole};
pub use math::{Formula, Symbol};
pub(crate) use style::StyleSheet;
pub use svg::SvgGround;
pub(crate) use svg::marked_up;
pub(crate) use table::with_unit;
pub use table::{Cell, Head, Rest, Row, Setting, Table, Units, UnprovedDigits};
pub use terminal_text::TextStyle;
pub(crate) use words::wrapped;
#[cfg(feature = "tui")]
pub(crate) use words::{cut, truncate_lines};

use crate::parallel;
use std::fmt;
use std::sync::Arc;

/// A document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// The blocks in order.
    pub blocks: Vec<Block>,
    /// Whether the names in all its tables and facts have the same width, so that they form one
    /// column.
    pub is_aligned: bool,
    /// The names to typeset as symbols within sentences, sorted.
    symbols: Vec<String>,
    /// The numbers of the last headings of level 1 and 2.
    numbers: [usize; 2],
}

/// A block of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// The content.
    pub content: Content,
    /// Whether a blank line precedes it.
    pub is_apart: bool,
}

/// The content of a block.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// The title of the page.
    Title(String),
    /// A heading of level 1 or 2.
    Heading(u8, String),
    /// A paragraph.
    Text(String),
    /// Names with their descriptions.
    Facts(Facts),
    /// Formulas below one another.
    Equations(Vec<Equation>),
    /// Values in columns.
    Table(Table),
    /// A drawing in characters, line by line, unchanged.
    Characters(Vec<String>),
    /// A picture.
    Picture(Illustration),
}

/// A picture with its caption, and a version in characters for text output.
#[derive(Clone, Debug, PartialEq)]
pub struct Illustration {
    /// The picture.
    pub artwork: Arc<Artwork>,
    /// The caption.
    pub caption: String,
    /// The caption of the version in characters, if that shows less.
    pub character_caption: Option<String>,
    /// The picture in characters, line by line.
    pub characters: Vec<String>,
}

impl Illustration {
    /// Returns the caption of the version in characters.
    pub(crate) fn character_caption(&self) -> &str {
        self.character_caption.as_deref().unwrap_or(&self.caption)
    }
}

/// Names with their descriptions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// The minimum width of the names in characters, including the blanks behind them, limited to a
    /// third of the width. The longest name can require more.
    pub names: usize,
    /// The indentation of continuation lines of a description.
    pub hanging_indent: usize,
    /// Each name with its descriptions, which begin on separate lines.
    pub list: Vec<(String, Vec<String>)>,
}

/// A chain of equal sides: `m = sqrt(350^2 + 86.6^2) = 360.555 mm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The sides; the first is the symbol to be determined.
    pub sides: Vec<Formula>,
}

impl fmt::Display for Equation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sides: Vec<String> = self.sides.iter().map(Formula::to_string).collect();
        f.write_str(&sides.join(" = "))
    }
}

impl Page {
    /// Creates an empty page whose names all have the same width.
    pub(crate) fn aligned() -> Page {
        Page {
            is_aligned: true,
            ..Page::default()
        }
    }

    /// Sets the names to typeset as symbols within sentences.
    pub(crate) fn set_symbols(&mut self, names: impl IntoIterator<Item = String>) {
        self.symbols = names.into_iter().collect();
        self.symbols.sort_unstable();
    }

    /// Adds a block, preceded by a blank line unless the previous block introduces it.
    pub(crate) fn add(&mut self, content: Content) {
        let before = self.blocks.last();
        let is_apart = before.is_some_and(|before| !before.content.leads_to(&content));
        self.blocks.push(Block { content, is_apart });
    }

    /// Adds a block without a blank line before it.
    pub(crate) fn add_below(&mut self, content: Content) {
        let is_apart = false;
        self.blocks.push(Block { content, is_apart });
    }

    /// Adds the title: the only text that may contain any character.
    pub(crate) fn title(&mut self, title: &str) {
        self.add(Content::Title(title.to_owned()));
    }

    /// Adds a numbered heading of the first level.
    pub(crate) fn part(&mut self, text: &str) {
        let [part, _] = self.numbers;
        self.numbers = [part + 1, 0];
        self.add(Content::Heading(1, format!("{} {text}", part + 1)));
    }

    /// Adds a numbered heading of the second level.
    pub(crate) fn section(&mut self, text: impl AsRef<str>) {
        self.numbers[1] += 1;
        let [part, section] = self.numbers;
        let text = format!("{part}.{section} {}", text.as_ref());
        self.add(Content::Heading(2, text));
    }

    /// Adds a heading of the second level without a number.
    pub(crate) fn heading(&mut self, text: impl Into<String>) {
        self.add(Content::Heading(2, text.into()));
    }

    pub(crate) fn text(&mut self, text: impl Into<String>) {
        self.add(Content::Text(text.into()));
    }

    /// Adds a paragraph without a blank line before it.
    pub(crate) fn text_below(&mut self, text: impl Into<String>) {
        self.add_below(Content::Text(text.into()));
    }

    /// Adds a formula; consecutive formulas form one block.
    pub(crate) fn equation(&mut self, sides: impl IntoIterator<Item = Formula>) {
        let sides = sides.into_iter().collect();
        let equation = Equation { sides };
        match self.blocks.last_mut().map(|block| &mut block.content) {
            Some(Content::Equations(equations)) => equations.push(equation),
            _ => self.add(Content::Equations(vec![equation])),
        }
    }

    pub(crate) fn table(&mut self, table: Table) {
        self.add(Content::Table(table));
    }
}

/// Number of blocks that are written by one job.
const CHUNK: usize = 64;

/// Writes blocks on all processors, a chunk at a time, and returns the results in order.
fn in_chunks<T: Send>(blocks: &[Block], write: impl Fn(&[Block]) -> T + Sync) -> Vec<T> {
    let chunks: Vec<&[Block]> = blocks.chunks(CHUNK).collect();
    let write = |(): &mut (), i: usize| write(chunks[i]);
    let cores = parallel::cores().min(chunks.len());
    parallel::each(chunks.len(), cores, || (), write, &mut |_| true)
}

impl Facts {
    /// Adds a name with its descriptions, unless there are none.
    pub(crate) fn add(&mut self, name: &str, text: impl IntoIterator<Item = String>) {
        let text: Vec<String> = text.into_iter().collect();
        if !text.is_empty() {
            self.list.push((name.to_owned(), text));
        }
    }
}

impl Content {
    /// Returns `true` if the next block follows directly, as it does below a heading and below a
    /// text that ends with a colon.
    fn leads_to(&self, next: &Content) -> bool {
        match self {
            Content::Heading(..) => !matches!(next, Content::Heading(..)),
            Content::Text(text) => text.ends_with(':') && !matches!(next, Content::Heading(..)),
            Content::Title(_)
            | Content::Facts(_)
            | Content::Equations(_)
            | Content::Table(_)
            | Content::Characters(_)
            | Content::Picture(_) => false,
        }
    }
}
