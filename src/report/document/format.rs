//! Output formats of a report.

use super::Report;
use crate::page::TextStyle;
use std::path::Path;

/// The output format of a report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ReportFormat {
    /// One HTML file with embedded pictures.
    #[default]
    Html,
    /// LaTeX with pictures in TikZ.
    Latex,
    /// Markdown with text drawings.
    Markdown,
    /// Plain text with text drawings.
    Text,
}

impl ReportFormat {
    /// All formats.
    pub const ALL: [ReportFormat; 4] = [
        ReportFormat::Html,
        ReportFormat::Latex,
        ReportFormat::Markdown,
        ReportFormat::Text,
    ];

    /// Returns the name, which must stay stable.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            ReportFormat::Html => "html",
            ReportFormat::Latex => "latex",
            ReportFormat::Markdown => "markdown",
            ReportFormat::Text => "text",
        }
    }

    /// Returns the usual extension of a file name.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            ReportFormat::Html => "html",
            ReportFormat::Latex => "tex",
            ReportFormat::Markdown => "md",
            ReportFormat::Text => "txt",
        }
    }

    /// Returns the format for the extension of a path; `None` for an unknown one.
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
    /// Formats the report; with `ascii`, Greek letters are spelled out in Markdown and text.
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
