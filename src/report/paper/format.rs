//! The ways to write a report.

use super::Report;
use crate::page::TextStyle;
use std::path::Path;

/// How a report is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ReportFormat {
    /// One HTML file with its pictures inside.
    #[default]
    Html,
    /// LaTeX with its pictures in TikZ.
    Latex,
    /// Markdown, pictures in characters.
    Markdown,
    /// Plain text, pictures in characters.
    Text,
}

impl ReportFormat {
    /// All that there are.
    pub const ALL: [ReportFormat; 4] = [
        ReportFormat::Html,
        ReportFormat::Latex,
        ReportFormat::Markdown,
        ReportFormat::Text,
    ];

    /// Its name: a promise.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            ReportFormat::Html => "html",
            ReportFormat::Latex => "latex",
            ReportFormat::Markdown => "markdown",
            ReportFormat::Text => "text",
        }
    }

    /// The usual ending of a file's name.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            ReportFormat::Html => "html",
            ReportFormat::Latex => "tex",
            ReportFormat::Markdown => "md",
            ReportFormat::Text => "txt",
        }
    }

    /// The one that a file is to have by the ending of its name.
    #[must_use]
    pub fn of_ending(path: &Path) -> Option<ReportFormat> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match ending.as_str() {
            "html" | "htm" | "xhtml" => ReportFormat::Html,
            "tex" | "latex" => ReportFormat::Latex,
            "md" | "markdown" => ReportFormat::Markdown,
            "txt" | "text" => ReportFormat::Text,
            _ => return None,
        })
    }
}

impl Report {
    /// The report as a text; with `ascii` Greek letters are spelled where it is read as it is.
    #[must_use]
    pub fn written(&self, format: ReportFormat, ascii: bool) -> String {
        match format {
            ReportFormat::Html => self.page.to_html(),
            ReportFormat::Latex => self.page.to_latex(),
            ReportFormat::Markdown => self.page.to_markdown(ascii),
            ReportFormat::Text => self.page.to_text(TextStyle::plain(ascii)),
        }
    }
}
