//! What is wrong with a document, and where.

use super::sanitize::{escaped, replacement};
use crate::wording::words;
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Characters in a line of a rendered message: the width of a plain terminal.
const WIDTH: usize = 80;

/// A part of the file with a word on it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Bytes of the text.
    pub span: Range<usize>,
    /// What is to be said about them.
    pub text: String,
}

/// One fault.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Diagnostic {
    /// Whether the file can be used all the same.
    pub is_warning: bool,
    /// The element, the value and the rule, in one line.
    pub message: String,
    /// Where; `None` for a fault of the file as a whole.
    pub primary: Option<Label>,
    /// Other places that matter.
    pub others: Vec<Label>,
    /// Further facts.
    pub notes: Vec<String>,
    /// What would mend it.
    pub helps: Vec<String>,
}

impl Diagnostic {
    /// A fault of the file as a whole.
    pub fn new(message: impl Into<String>) -> Self {
        Diagnostic {
            message: message.into(),
            ..Diagnostic::default()
        }
    }

    /// Makes it a warning: the file can be used all the same.
    pub fn into_warning(mut self) -> Self {
        self.is_warning = true;
        self
    }

    /// Says where, and what about it.
    pub fn at(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.primary = Some(Label {
            span,
            text: label.into(),
        });
        self
    }

    /// Points at another place.
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

    /// Adds a mend.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.helps.push(help.into());
        self
    }

    /// Adds a mend if there is one.
    pub fn maybe_help(mut self, help: Option<String>) -> Self {
        self.helps.extend(help);
        self
    }
}

/// All faults found in a file, with the text that they point into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// The name of the file.
    pub origin: String,
    /// Its text.
    pub text: Arc<str>,
    /// The faults in the order of the text.
    pub items: Vec<Diagnostic>,
}

impl Diagnostics {
    /// What is wrong first, in one line; nothing where nothing is.
    #[must_use]
    pub fn first_words(&self) -> &str {
        self.items.first().map_or("", |item| &item.message)
    }

    /// The line and the column of a fault, both from 1; columns count characters.
    #[must_use]
    pub fn position(&self, item: &Diagnostic) -> Option<(usize, usize)> {
        let start = item.primary.as_ref()?.span.start;
        let before = self.text.get(..start)?;
        let line = before.matches('\n').count() + 1;
        let begin = before.rfind('\n').map_or(0, |i| i + 1);
        Some((line, before[begin..].chars().count() + 1))
    }

    /// The messages as text for a terminal: harmless whatever the file holds, pure ASCII if asked.
    ///
    /// The frame around them is ASCII in any case: arrows and rounded corners are not in the fonts of
    /// consoles.
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

/// The file's text as it may be shown, and where each of its bytes went.
struct ShownText {
    text: String,
    /// For the characters whose replacement has another length in bytes: where they end in the
    /// file, and where their replacement ends.
    shifts: Vec<(usize, usize)>,
}

impl ShownText {
    /// Each character by one character, so that lines and columns stay. Line ends stay too; a
    /// carriage return that is no line end is replaced.
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

    /// Where a byte of the file is in the shown text; always between two characters.
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
        for help in &item.helps {
            let level = Level::HELP.with_name(escaped(words().level_help(), ascii));
            group = group.element(level.message(lines(help, ascii)));
        }
        group
    }
}

/// Our own line feeds stay, so that a help may be laid out in lines.
fn lines(text: &str, ascii: bool) -> String {
    let lines: Vec<String> = text.split('\n').map(|l| escaped(l, ascii)).collect();
    lines.join("\n")
}

/// The fault of a file that is no text. What comes before the first bad byte keeps its place in the
/// text that is shown; bad bytes become replacement characters.
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
