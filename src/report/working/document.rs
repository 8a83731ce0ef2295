//! A small model of a text with formulas: headings, paragraphs, equations and tables.
//!
//! Its strings are written with Greek letters, `·` for a product and `→` from point to point; a writer
//! spells them out where they cannot be shown. Names of a scene are ASCII, so nothing of it is touched.

/// The working of one state, ready to be written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Its parts in order.
    pub blocks: Vec<Block>,
    /// The numbers of the last headings of level 1 and 2.
    numbers: [usize; 2],
}

/// A part of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A heading of level 1 or 2, with its number.
    Heading(u8, String),
    /// The title of a scene: the one text that may hold any character.
    Title(String),
    /// A paragraph.
    Text(String),
    /// Formulas below one another.
    Equations(Vec<Equation>),
    /// Figures in columns.
    Table(Table),
}

/// A chain of equal sides: `m = sqrt(350^2 + 86.6^2) = 360.555 mm`.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The sides, the symbol that is found first.
    pub sides: Vec<String>,
}

/// Rows under a head; the first column stands to the left, the others to the right.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The names of the columns.
    pub head: Vec<String>,
    /// As many cells to a row as the head has.
    pub rows: Vec<Vec<String>>,
}

impl Document {
    pub(super) fn title(&mut self, title: &str) {
        self.blocks.push(Block::Title(title.to_owned()));
    }

    /// A heading of the first level.
    pub(super) fn part(&mut self, text: &str) {
        let [part, _] = self.numbers;
        self.numbers = [part + 1, 0];
        self.blocks
            .push(Block::Heading(1, format!("{} {text}", part + 1)));
    }

    /// A heading of the second level.
    pub(super) fn section(&mut self, text: impl AsRef<str>) {
        self.numbers[1] += 1;
        let [part, section] = self.numbers;
        let text = format!("{part}.{section} {}", text.as_ref());
        self.blocks.push(Block::Heading(2, text));
    }

    pub(super) fn text(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// A formula; formulas that follow one another stand together.
    pub(super) fn equation<S: Into<String>>(&mut self, sides: impl IntoIterator<Item = S>) {
        let sides = sides.into_iter().map(Into::into).collect();
        let equation = Equation { sides };
        match self.blocks.last_mut() {
            Some(Block::Equations(equations)) => equations.push(equation),
            _ => self.blocks.push(Block::Equations(vec![equation])),
        }
    }

    /// A table of any number of columns.
    pub(super) fn wide_table(&mut self, head: Vec<String>, rows: Vec<Vec<String>>) {
        self.blocks.push(Block::Table(Table { head, rows }));
    }

    pub(super) fn table<const N: usize>(&mut self, head: [&str; N], rows: Vec<[String; N]>) {
        self.blocks.push(Block::Table(Table {
            head: head.map(str::to_owned).into(),
            rows: rows.into_iter().map(Into::into).collect(),
        }));
    }
}

/// The text with Greek letters and signs spelled in ASCII.
pub(super) fn spelled(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'θ' => out.push_str("theta"),
            'ω' => out.push_str("omega"),
            'α' => out.push_str("alpha"),
            'β' => out.push_str("beta"),
            'γ' => out.push_str("gamma"),
            '·' => out.push('*'),
            '→' => out.push_str("->"),
            _ => out.push(c),
        }
    }
    out
}
