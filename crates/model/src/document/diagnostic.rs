//! Diagnostics of a document: faults with their places, and their rendering.

use super::sanitize::{escaped, replacement};
use crate::wording::words;
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Width of a rendered message in characters: that of a plain terminal.
const WIDTH: usize = 80;

/// A part of the file with an annotation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The range in bytes of the text.
    pub span: Range<usize>,
    /// The annotation.
    pub text: String,
}

/// An error or a warning in a file, with its places and suggested fixes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Diagnostic {
    /// `true` for a warning: the file can still be used.
    pub is_warning: bool,
    /// The element, the value and the rule, in one line.
    pub message: String,
    /// The place; `None` for a fault of the file as a whole.
    pub primary: Option<Label>,
    /// Other relevant places.
    pub others: Vec<Label>,
    /// Further facts.
    pub notes: Vec<String>,
    /// Suggested fixes.
    pub suggestions: Vec<String>,
}

impl Diagnostic {
    /// Creates a fault of the file as a whole.
    pub fn new(message: impl Into<String>) -> Self {
        Diagnostic {
            message: message.into(),
            ..Diagnostic::default()
        }
    }

    /// Converts the diagnostic to a warning: the file can still be used.
    pub fn into_warning(mut self) -> Self {
        self.is_warning = true;
        self
    }

    /// Sets the place and its annotation.
    pub fn at(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.primary = Some(Label {
            span,
            text: label.into(),
        });
        self
    }

    /// Adds another place.
    pub fn and(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.others.push(Label {
            span,
            text: label.into(),
        });
        self
    }

    /// Adds a fact.
    pub(crate) fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// Adds a suggested fix.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.suggestions.push(help.into());
        self
    }

    /// Adds a suggested fix, if any.
    pub fn maybe_help(mut self, help: Option<String>) -> Self {
        self.suggestions.extend(help);
        self
    }
}

/// All faults found in a file, with the text that they point into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// The name of the file.
    pub origin: String,
    /// The text of the file.
    pub text: Arc<str>,
    /// The faults in the order of the text.
    pub items: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Returns the message of the first fault, or an empty string if there is none.
    #[must_use]
    pub fn first_words(&self) -> &str {
        self.items.first().map_or("", |item| &item.message)
    }

    /// Returns the line and the column of a fault, both from 1; columns count characters. Returns
    /// `None` for a fault of the file as a whole.
    #[must_use]
    pub fn position(&self, item: &Diagnostic) -> Option<(usize, usize)> {
        let start = item.primary.as_ref()?.span.start;
        let before = self.text.get(..start)?;
        let line = before.matches('\n').count() + 1;
        let first = before.rfind('\n').map_or(0, |i| i + 1);
        Some((line, before[first..].chars().count() + 1))
    }

    /// Renders the messages for a terminal. Harmful characters of the file are replaced; `ascii`
    /// restricts the output to ASCII.
    ///
    /// The frame is always ASCII, because console fonts lack arrows and rounded corners.
    #[must_use]
    pub fn render(&self, ascii: bool, colour: bool) -> String {
        let shown = ShownText::new(&self.text, ascii);
        let origin = escaped(&self.origin, ascii);
        let base = if colour {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let renderer = base.decor_style(DecorStyle::Ascii).term_width(WIDTH);
        let mut out = String::new();
        for item in &self.items {
            if !out.is_empty() {
                out.push('\n');
            }
            out.push_str(&renderer.render(&[shown.group(item, &origin, ascii)]));
            out.push('\n');
        }
        out
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.render(true, false).trim_end())
    }
}

impl std::error::Error for Diagnostics {}

/// The text of a file in printable form, with a mapping of byte offsets.
struct ShownText {
    text: String,
    /// For each character whose replacement has another length: the end offsets of the character in
    /// the file, and of its replacement.
    shifts: Vec<(usize, usize)>,
}

impl ShownText {
    /// Replaces each character by one character, so that lines and columns stay the same. Keeps
    /// line ends, but replaces a carriage return that is not part of one.
    fn new(original: &str, ascii: bool) -> Self {
        let mut text = String::with_capacity(original.len());
        let mut shifts = Vec::new();
        for (at, c) in original.char_indices() {
            let line_end = c == '\n' || (c == '\r' && original[at + 1..].starts_with('\n'));
            let keep = line_end || c == '\t';
            let shown = if keep { c } else { replacement(c, ascii) };
            text.push(shown);
            if shown.len_utf8() != c.len_utf8() {
                shifts.push((at + c.len_utf8(), text.len()));
            }
        }
        ShownText { text, shifts }
    }

    /// Maps an offset in the file to one in the shown text, always between two characters.
    fn offset(&self, at: usize) -> usize {
        let passed = self.shifts.partition_point(|&(end, _)| end <= at);
        let (end, shown) = match passed.checked_sub(1) {
            Some(last) => self.shifts[last],
            None => (0, 0),
        };
        let mut offset = (shown + (at - end)).min(self.text.len());
        while !self.text.is_char_boundary(offset) {
            offset -= 1;
        }
        offset
    }

    fn span(&self, span: &Range<usize>) -> Range<usize> {
        let start = self.offset(span.start);
        start..self.offset(span.end.max(span.start)).max(start)
    }

    fn group<'a>(&'a self, item: &'a Diagnostic, origin: &'a str, ascii: bool) -> Group<'a> {
        let level = match item.is_warning {
            true => Level::WARNING.with_name(escaped(words().level_warning(), ascii)),
            false => Level::ERROR.with_name(words().level_error()),
        };
        let title = level.primary_title(escaped(&item.message, ascii));
        let mut group = match &item.primary {
            None => title.element(Origin::path(origin)),
            Some(primary) => {
                let annotation = |kind: AnnotationKind, label: &Label| {
                    let text = escaped(&label.text, ascii);
                    let annotation = kind.span(self.span(&label.span));
                    annotation.label((!text.is_empty()).then_some(text))
                };
                let others = item.others.iter();
                title.element(
                    Snippet::source(self.text.as_str())
                        .path(origin)
                        .annotation(annotation(AnnotationKind::Primary, primary))
                        .annotations(others.map(|l| annotation(AnnotationKind::Context, l))),
                )
            }
        };
        for note in &item.notes {
            let level = Level::NOTE.with_name(words().level_note());
            group = group.element(level.message(lines(note, ascii)));
        }
        for help in &item.suggestions {
            let level = Level::HELP.with_name(escaped(words().level_help(), ascii));
            group = group.element(level.message(lines(help, ascii)));
        }
        group
    }
}

/// Escapes each line of a text; keeps its line feeds, because hints may have several lines.
fn lines(text: &str, ascii: bool) -> String {
    let lines: Vec<String> = text.split('\n').map(|l| escaped(l, ascii)).collect();
    lines.join("\n")
}

/// Returns the text of a file.
///
/// # Errors
/// Returns the diagnostic of a file that is not UTF-8.
pub fn utf8_text<'b>(bytes: &'b [u8], origin: &str) -> Result<&'b str, Diagnostics> {
    std::str::from_utf8(bytes).map_err(|error| not_utf8(bytes, error.valid_up_to(), origin))
}

/// Returns the diagnostic of a file that is not UTF-8. Text before the first invalid byte keeps its
/// offsets in the shown text; invalid bytes become replacement characters.
pub fn not_utf8(bytes: &[u8], at: usize, origin: &str) -> Diagnostics {
    let shown = String::from_utf8_lossy(bytes);
    let end = at + char::REPLACEMENT_CHARACTER.len_utf8();
    let bad = bytes.get(at).copied().unwrap_or_default();
    let fault = Diagnostic::new(words().not_utf8(bad, at))
        .at(at..end, words().not_a_character())
        .help(words().save_as_utf8());
    Diagnostics {
        origin: origin.to_owned(),
        text: shown.into(),
        items: vec![fault],
    }
}
