//! A page: what is to be read, as data, before anybody knows how wide the reader's screen is.
//!
//! Reports fill pages. A page is written as plain text ([`Page::to_text`]), as Markdown
//! ([`Page::to_markdown`]), as an HTML file ([`Page::to_html`]), as LaTeX ([`Page::to_latex`]), or line by line for a screen ([`Page::lines`]), where every part of a line says
//! what it is by its [`TextRole`] and nothing about colours.
//!
//! Its strings are written with Greek letters, `·` for a product and `→` from point to point; a writer
//! spells them out where they cannot be shown.

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
mod spelled;
mod style;
mod svg;
mod table;
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
pub(crate) use math::UNIT;
pub use spelled::TextStyle;
pub(crate) use style::StyleSheet;
pub use svg::SvgGround;
pub(crate) use svg::marked_up;
pub(crate) use table::with_unit;
pub use table::{Cell, Head, Rest, Row, Setting, Table, Units, Unsure};
#[cfg(feature = "tui")]
pub(crate) use words::cut;
pub(crate) use words::wrapped;

use std::sync::Arc;

/// Something to read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// Its parts in order.
    pub blocks: Vec<Block>,
    /// Whether the names in all its tables and facts take the same room, so that they stand in one column.
    pub is_aligned: bool,
    /// Names that are set as in formulas where a sentence has them.
    symbols: Vec<String>,
    /// The numbers of the last headings of level 1 and 2.
    numbers: [usize; 2],
}

/// A part of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// What is to be read.
    pub content: Content,
    /// Whether a blank line stands before it.
    pub is_apart: bool,
}

/// What is to be read.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// What the page is about.
    Title(String),
    /// A heading of level 1 or 2.
    Heading(u8, String),
    /// A paragraph.
    Text(String),
    /// Names, and what is told of them.
    Facts(Facts),
    /// Formulas below one another.
    Equations(Vec<Equation>),
    /// Figures in columns.
    Table(Table),
    /// A drawing in characters, line by line as it stands.
    Characters(Vec<String>),
    /// Something to look at.
    Picture(Illustration),
}

/// A picture with what is said of it, and the same in characters for those who read text.
#[derive(Clone, Debug, PartialEq)]
pub struct Illustration {
    /// The picture.
    pub artwork: Arc<Artwork>,
    /// What it shows.
    pub caption: String,
    /// What it shows in characters, where that is less.
    pub in_characters: Option<String>,
    /// The picture in characters, line by line.
    pub characters: Vec<String>,
}

impl Illustration {
    /// What the picture in characters shows.
    pub(crate) fn told(&self) -> &str {
        self.in_characters.as_deref().unwrap_or(&self.caption)
    }
}

/// Names, and what is told of each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// Characters of the names, with the blanks behind them: so many, but no more than a third of the width,
    /// and as many as the longest takes.
    pub names: usize,
    /// Blanks before the rest of a fact that takes several lines.
    pub hanging: usize,
    /// A name and its facts, each of which begins a line.
    pub list: Vec<(String, Vec<String>)>,
}

/// A chain of equal sides: `m = sqrt(350^2 + 86.6^2) = 360.555 mm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The sides, the symbol that is found first.
    pub sides: Vec<String>,
}

impl Page {
    /// An empty page of which all names take the same room.
    pub(crate) fn aligned() -> Page {
        Page {
            is_aligned: true,
            ..Page::default()
        }
    }

    /// Sets these names as in formulas where a sentence has them.
    pub(crate) fn set_symbols(&mut self, names: impl IntoIterator<Item = String>) {
        self.symbols = names.into_iter().collect();
    }

    /// Adds a part, with a blank line before it where the part before does not lead to it.
    pub(crate) fn add(&mut self, content: Content) {
        let before = self.blocks.last();
        let is_apart = before.is_some_and(|before| !before.content.leads_to(&content));
        self.blocks.push(Block { content, is_apart });
    }

    /// Adds a part directly below the one before.
    pub(crate) fn add_below(&mut self, content: Content) {
        let is_apart = false;
        self.blocks.push(Block { content, is_apart });
    }

    /// What the page is about: the one text that may hold any character.
    pub(crate) fn title(&mut self, title: &str) {
        self.add(Content::Title(title.to_owned()));
    }

    /// A heading of the first level, with its number.
    pub(crate) fn part(&mut self, text: &str) {
        let [part, _] = self.numbers;
        self.numbers = [part + 1, 0];
        self.add(Content::Heading(1, format!("{} {text}", part + 1)));
    }

    /// A heading of the second level, with its number.
    pub(crate) fn section(&mut self, text: impl AsRef<str>) {
        self.numbers[1] += 1;
        let [part, section] = self.numbers;
        let text = format!("{part}.{section} {}", text.as_ref());
        self.add(Content::Heading(2, text));
    }

    /// A heading of the second level, without a number.
    pub(crate) fn heading(&mut self, text: impl Into<String>) {
        self.add(Content::Heading(2, text.into()));
    }

    pub(crate) fn text(&mut self, text: impl Into<String>) {
        self.add(Content::Text(text.into()));
    }

    /// A sentence directly below what stands before.
    pub(crate) fn text_below(&mut self, text: impl Into<String>) {
        self.add_below(Content::Text(text.into()));
    }

    /// A formula; formulas that follow one another stand together.
    pub(crate) fn equation<S: Into<String>>(&mut self, sides: impl IntoIterator<Item = S>) {
        let sides = sides.into_iter().map(Into::into).collect();
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

impl Facts {
    /// What is told of a name; nothing where nothing is told.
    pub(crate) fn tell(&mut self, name: &str, told: impl IntoIterator<Item = String>) {
        let told: Vec<String> = told.into_iter().collect();
        if !told.is_empty() {
            self.list.push((name.to_owned(), told));
        }
    }
}

impl Content {
    /// Whether another part stands directly below: below a heading, and below a text that announces it.
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
