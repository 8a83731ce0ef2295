//! The content to write while the user chooses a file, and the prompts about that file.

use crate::files::WriteError;
use crate::page::{Page, TextStyle};
use crate::report::{Report, ReportFormat};
use crate::tui::commands::line::EditLine;
use crate::tui::document::saving::Leave;
use crate::wording::words;
use std::path::{Path, PathBuf};

/// The content to write to a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum SavedContent {
    /// The scene, with the start positions of the shown assembly.
    Scene,
    /// A text, fixed at the time of the request.
    Text(Text),
}

/// Values, a report or an image as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Text {
    /// The name of the content in messages: `the screen`.
    pub(crate) what: String,
    text: String,
    /// Alternative formats, selected by the file name's extension.
    others: Vec<(FileEnding, String)>,
}

/// The format selected by a file name's extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileEnding {
    /// A report format.
    Report(ReportFormat),
    /// Values as CSV.
    Csv,
}

impl FileEnding {
    fn of(path: &Path) -> Option<FileEnding> {
        let is_csv = path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("csv"));
        match is_csv {
            true => Some(FileEnding::Csv),
            false => ReportFormat::of_ending(path).map(FileEnding::Report),
        }
    }
}

impl Text {
    pub(crate) fn new(what: String, text: String) -> Text {
        let others = Vec::new();
        Text { what, text, others }
    }

    /// Creates a report in every format.
    pub(crate) fn of_report(what: &str, report: &Report) -> Text {
        let written = |format| (FileEnding::Report(format), report.written(format, false));
        Text {
            what: what.to_owned(),
            text: report.written(ReportFormat::default(), false),
            others: ReportFormat::ALL.map(written).into(),
        }
    }

    /// Creates a page of lines as text and Markdown. `figures` are its values in CSV format, if it
    /// has any.
    pub(crate) fn of_page(what: &str, page: &Page, figures: Option<String>) -> Text {
        let markdown = FileEnding::Report(ReportFormat::Markdown);
        let csv = figures.map(|figures| (FileEnding::Csv, figures));
        let others = [(markdown, page.to_markdown(false))];
        Text {
            what: what.to_owned(),
            text: page.to_text(TextStyle::plain(false)),
            others: others.into_iter().chain(csv).collect(),
        }
    }

    /// Returns the text in the format for a file name.
    pub(crate) fn for_file(&self, path: &Path) -> &str {
        let requested = FileEnding::of(path);
        let mut others = self.others.iter();
        let other = others.find(|(format, _)| Some(*format) == requested);
        other.map_or(&self.text, |(_, text)| text)
    }
}

/// The prompt for a file name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) content: SavedContent,
    pub(crate) name: EditLine,
}

/// A prompt for permission to write to a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Question {
    pub(crate) content: SavedContent,
    pub(crate) to: PathBuf,
    pub(crate) reason: ConfirmReason,
    /// The permissions granted so far.
    pub(crate) leave: Leave,
}

/// The reason for asking before a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ConfirmReason {
    /// The file exists.
    Exists,
    /// Another program has written the file since it was read.
    Changed,
    /// The restored edits are older than the file's contents.
    Older,
    /// The file is read-only.
    ReadOnly,
}

impl ConfirmReason {
    /// Returns the reason to ask about a failed write; `None` if no permission would help.
    pub(crate) fn of(error: &WriteError) -> Option<ConfirmReason> {
        match error {
            WriteError::Exists | WriteError::Appeared => Some(ConfirmReason::Exists),
            WriteError::Changed => Some(ConfirmReason::Changed),
            WriteError::ReadOnly => Some(ConfirmReason::ReadOnly),
            WriteError::NoFile(_)
            | WriteError::Disturbed
            | WriteError::Busy
            | WriteError::NoJournal
            | WriteError::Io(_) => None,
        }
    }

    /// Returns the question about a file of this name.
    pub(crate) fn question(self, name: &str) -> String {
        match self {
            ConfirmReason::Exists => words().write_over(name),
            ConfirmReason::Changed => words().write_over_changed(name),
            ConfirmReason::Older => words().write_over_newer(name),
            ConfirmReason::ReadOnly => words().write_read_only(name),
        }
    }
}

impl Question {
    /// Returns the permissions after the user confirms.
    pub(crate) fn granted(&self) -> Leave {
        match self.reason {
            ConfirmReason::Exists | ConfirmReason::Changed | ConfirmReason::Older => Leave {
                over: true,
                ..self.leave
            },
            ConfirmReason::ReadOnly => Leave {
                read_only: true,
                ..self.leave
            },
        }
    }
}
