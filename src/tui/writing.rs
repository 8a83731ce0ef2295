//! What is to be written to a file while its name is asked for, and writing it.

use super::line::Line;
use crate::replace::replace_file;
use std::io;
use std::path::{Path, PathBuf};

/// What is to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Document {
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
    pub(crate) text: String,
}

/// The line in which the name of a file is typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) document: Document,
    pub(crate) name: Line,
}

/// The question whether to write over a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Question {
    pub(crate) document: Document,
    pub(crate) to: PathBuf,
}

impl Text {
    /// Writes it at once or not at all: what was done, or why nothing was, in words. These stand behind
    /// the name.
    pub(crate) fn write(&self, to: &Path) -> Result<String, String> {
        match replace_file(to, self.text.as_bytes()) {
            Ok(()) => Ok(format!("{} written to {}", self.what, to.display())),
            Err(error) => Err(format!("not written: {}", why(&error))),
        }
    }
}

/// Why a file cannot be written, shorter than the system says it where that is usual: the line is short.
pub(crate) fn why(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => "the disk is full".into(),
        io::ErrorKind::FileTooLarge => "a file may not be so large".into(),
        io::ErrorKind::PermissionDenied => "no permission".into(),
        io::ErrorKind::ReadOnlyFilesystem => "the disk is read-only".into(),
        io::ErrorKind::NotFound => "no such folder".into(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn screen() -> Text {
        Text {
            what: "the screen".into(),
            text: "a\nb\n".into(),
        }
    }

    #[test]
    fn what_was_written_is_said_and_why_nothing_was() {
        let folder = std::env::temp_dir().join(format!("krank-writing-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("screen.txt");
        let said = screen().write(&file).unwrap();
        assert_eq!(said, format!("the screen written to {}", file.display()));
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "a\nb\n");
        let nowhere = folder.join("nowhere").join("screen.txt");
        let said = screen().write(&nowhere).unwrap_err();
        assert_eq!(said, "not written: no such folder");
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_in_short() {
        let said = screen().write(Path::new("/dev/full")).unwrap_err();
        assert_eq!(said, "not written: the disk is full");
    }
}
