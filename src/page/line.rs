//! A line of a page at some width.

use super::Unsure;

/// A line: pieces of text, each at its place, from left to right.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    /// The pieces.
    pub spans: Vec<Span>,
}

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// The column in which it begins.
    pub at: usize,
    /// Its characters.
    pub text: String,
    /// What it is.
    pub role: TextRole,
    /// Which of its characters nothing proves.
    pub unsure: Unsure,
}

/// What a piece of a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextRole {
    /// What the page is about.
    Title,
    /// A heading of the first level.
    Part,
    /// A heading of the second level.
    Section,
    /// The head of a table.
    Head,
    /// The name of a row.
    Name,
    /// The name of a fact.
    Label,
    /// The letter of a chart.
    Mark,
    /// A figure: shown whole or not at all.
    Figure,
    /// What is said by the way.
    Aside,
    /// Anything else.
    Body,
}

impl Line {
    /// A line of one piece, which begins with its first character.
    pub(crate) fn of(role: TextRole, text: impl Into<String>) -> Line {
        let mut line = Line::default();
        let text: String = text.into();
        let begin = text.len() - text.trim_start_matches(' ').len();
        line.push(begin, text.trim(), role);
        line
    }

    /// What the line is: as its first piece; the body of the page where there is none.
    #[must_use]
    pub fn role(&self) -> TextRole {
        self.spans.first().map_or(TextRole::Body, |span| span.role)
    }

    /// Adds a piece at a place; nothing where it says nothing.
    pub(crate) fn push(&mut self, at: usize, text: impl Into<String>, role: TextRole) {
        let text = text.into();
        if !text.is_empty() {
            let unsure = Unsure::Nothing;
            self.spans.push(Span {
                at,
                text,
                role,
                unsure,
            });
        }
    }

    /// The line as text, without blanks at its end.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        let mut column = 0;
        for span in &self.spans {
            while column < span.at {
                text.push(' ');
                column += 1;
            }
            text.push_str(&span.text);
            column += span.text.chars().count();
        }
        text.truncate(text.trim_end().len());
        text
    }
}
