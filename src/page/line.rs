//! Represents a line of a page at a given width.

use super::UnprovedDigits;

/// A line: spans of text at given columns, from left to right.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    /// The spans.
    pub spans: Vec<Span>,
}

/// A span of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Span {
    /// The column in which the span begins.
    pub at: usize,
    /// The text of the span.
    pub text: String,
    /// The role of the span.
    pub role: TextRole,
    /// The digits that no error bound proves.
    pub unproved: UnprovedDigits,
}

/// The role of a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextRole {
    /// The title of the page.
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
    /// A value: shown completely or not at all.
    Figure,
    /// A side note.
    Aside,
    /// Anything else.
    Body,
}

impl Line {
    /// Creates a line of one span, which begins at its first non-blank character.
    pub(crate) fn of(role: TextRole, text: impl Into<String>) -> Line {
        let mut line = Line::default();
        let text: String = text.into();
        let start = text.len() - text.trim_start_matches(' ').len();
        line.push(start, text.trim(), role);
        line
    }

    /// Returns the role of the line: that of its first span, or the body's if there is none.
    #[must_use]
    pub fn role(&self) -> TextRole {
        self.spans.first().map_or(TextRole::Body, |span| span.role)
    }

    /// Adds a span at a column, unless it is empty.
    pub(crate) fn push(&mut self, at: usize, text: impl Into<String>, role: TextRole) {
        let text = text.into();
        if !text.is_empty() {
            let unsure = UnprovedDigits::Nothing;
            self.spans.push(Span {
                at,
                text,
                role,
                unproved: unsure,
            });
        }
    }

    /// Returns the line as text, without trailing blanks.
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
