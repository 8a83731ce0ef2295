//! What is to be written to a file while its name is asked for, and what is asked about that.

use crate::files::Trouble;
use crate::page::{Page, TextStyle};
use crate::report::{Report, ReportFormat};
use crate::tui::commands::line::EditLine;
use crate::tui::document::saving::Leave;
use crate::wording::words;
use std::path::{Path, PathBuf};

/// What is to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum SavedContent {
    /// The scene, with the start positions of the assembly that is shown.
    Scene,
    /// A text as it was when it was asked for.
    Text(Text),
}

/// Figures, or a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Text {
    /// What it is, in the words of the message: `the screen`.
    pub(crate) what: String,
    text: String,
    /// The same in other formats, for names that ask for one of them.
    others: Vec<(FileEnding, String)>,
}

/// What the ending of a name asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileEnding {
    /// A text to be read.
    Report(ReportFormat),
    /// Figures.
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

    /// A report in every format.
    pub(crate) fn of_report(what: &str, report: &Report) -> Text {
        let written = |format| (FileEnding::Report(format), report.written(format, false));
        Text {
            what: what.to_owned(),
            text: report.written(ReportFormat::default(), false),
            others: ReportFormat::ALL.map(written).into(),
        }
    }

    /// Lines that are read, as text or as Markdown; and the figures that stand in them, for a name that asks for CSV.
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

    /// As it is written to a file of this name.
    pub(crate) fn for_file(&self, path: &Path) -> &str {
        let asked = FileEnding::of(path);
        let mut others = self.others.iter();
        let other = others.find(|(format, _)| Some(*format) == asked);
        other.map_or(&self.text, |(_, text)| text)
    }
}

/// The line in which the name of a file is typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) content: SavedContent,
    pub(crate) name: EditLine,
}

/// The question whether to write to a file nevertheless.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Question {
    pub(crate) content: SavedContent,
    pub(crate) to: PathBuf,
    pub(crate) doubt: Doubt,
    /// What was said before.
    pub(crate) leave: Leave,
}

/// Why somebody is asked first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Doubt {
    /// There is such a file.
    Exists,
    /// Somebody else has written it since it was read.
    Changed,
    /// The edits that were taken up are older than what it holds.
    Older,
    /// It says that it is not to be written to.
    ReadOnly,
}

impl Doubt {
    /// What a person can say to it; `None` where nothing that is said would help.
    pub(crate) fn of(trouble: &Trouble) -> Option<Doubt> {
        match trouble {
            Trouble::Exists => Some(Doubt::Exists),
            Trouble::Changed => Some(Doubt::Changed),
            Trouble::ReadOnly => Some(Doubt::ReadOnly),
            Trouble::NoFile(_)
            | Trouble::Disturbed
            | Trouble::Busy
            | Trouble::NoJournal
            | Trouble::Io(_) => None,
        }
    }

    /// What is asked about a file of this name.
    pub(crate) fn question(self, name: &str) -> String {
        match self {
            Doubt::Exists => words().write_over(name),
            Doubt::Changed => words().write_over_changed(name),
            Doubt::Older => words().write_over_newer(name),
            Doubt::ReadOnly => words().write_read_only(name),
        }
    }
}

impl Question {
    /// What was said, once this is said too.
    pub(crate) fn granted(&self) -> Leave {
        match self.doubt {
            Doubt::Exists | Doubt::Changed | Doubt::Older => Leave {
                over: true,
                ..self.leave
            },
            Doubt::ReadOnly => Leave {
                read_only: true,
                ..self.leave
            },
        }
    }
}
