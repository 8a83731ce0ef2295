//! Saves a text to a file.

use crate::files::{Saving, WriteError, save};
use crate::scene::MAX_FILE_SIZE;
use crate::tui::document::disk::{BYTE_ORDER_MARK, unmarked};
use crate::wording::words;
use std::io;
use std::path::{Path, PathBuf};

/// The permissions granted by the user.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Leave {
    /// The file's contents may be overwritten.
    pub(crate) over: bool,
    /// The file may be written although it is read-only.
    pub(crate) read_only: bool,
}

/// A request to save a text to a file.
#[derive(Clone, Debug)]
pub(crate) struct SaveRequest {
    pub(crate) text: String,
    pub(crate) to: PathBuf,
    /// The expected contents of the file, if it is the scene's own.
    pub(crate) own: Option<String>,
    pub(crate) leave: Leave,
    /// The folder that holds the old and new text while a file is written in place.
    pub(crate) records: Option<PathBuf>,
}

impl SaveRequest {
    /// Saves the text completely or not at all. The scene's own file keeps its byte order mark.
    ///
    /// # Errors
    /// Returns the reason why nothing was written.
    pub(crate) fn run(&self) -> Result<(), WriteError> {
        let saving = Saving {
            to: &self.to,
            records: self.records.as_deref(),
            overwrites_read_only: self.leave.read_only,
            most: MAX_FILE_SIZE + BYTE_ORDER_MARK.len(),
        };
        save(saving, |old| self.instead_of(old))
    }

    fn instead_of(&self, old: Option<Vec<u8>>) -> Result<Vec<u8>, WriteError> {
        let mut bytes = Vec::new();
        match (&old, &self.own) {
            (Some(old), Some(own)) => {
                if !self.leave.over && unmarked(old) != own.as_bytes() {
                    return Err(WriteError::Changed);
                }
                if old.starts_with(BYTE_ORDER_MARK.as_bytes()) {
                    bytes.extend_from_slice(BYTE_ORDER_MARK.as_bytes());
                }
            }
            (Some(_), None) if !self.leave.over => return Err(WriteError::Exists),
            // A file deleted meanwhile has no contents to lose.
            (Some(_), None) | (None, _) => {}
        }
        bytes.extend_from_slice(self.text.as_bytes());
        Ok(bytes)
    }
}

/// Formats a failed save with the file's name, or the folder's name if the folder does not exist.
pub(crate) fn refused(error: &WriteError, to: &Path) -> String {
    if is_folder(error) {
        return words().add_a_name().into();
    }
    let missing = matches!(error, WriteError::Io(e) if e.kind() == io::ErrorKind::NotFound);
    let named = match to.parent().filter(|_| missing) {
        Some(folder) => folder.to_string_lossy(),
        None => to.file_name().unwrap_or(to.as_os_str()).to_string_lossy(),
    };
    words().not_written_to(&named, &why(error))
}

/// Formats a failed save for display after the file's name.
pub(crate) fn refused_there(error: &WriteError) -> String {
    match is_folder(error) {
        true => words().add_a_name().into(),
        false => words().not_written(&why(error)),
    }
}

fn is_folder(error: &WriteError) -> bool {
    matches!(error, WriteError::Io(e) if e.kind() == io::ErrorKind::IsADirectory)
}

/// Returns the reason of a failed save, in short words for common errors because the line is short.
fn why(trouble: &WriteError) -> String {
    let WriteError::Io(error) = trouble else {
        return trouble.to_string();
    };
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => words().disk_full().into(),
        io::ErrorKind::FileTooLarge => words().file_too_large().into(),
        io::ErrorKind::PermissionDenied => words().no_permission().into(),
        io::ErrorKind::ReadOnlyFilesystem => words().disk_read_only().into(),
        io::ErrorKind::NotFound => words().no_such_folder().into(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn save_request(to: &Path) -> SaveRequest {
        SaveRequest {
            text: "a\nb\n".into(),
            to: to.to_owned(),
            own: None,
            leave: Leave::default(),
            records: None,
        }
    }

    #[test]
    fn existing_or_changed_file_is_not_overwritten_unasked() {
        let folder = std::env::temp_dir().join(format!("krank-saving-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join("scene.toml");
        save_request(&file).run().unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "a\nb\n");
        assert!(matches!(save_request(&file).run(), Err(WriteError::Exists)));
        let own = |text: &str| SaveRequest {
            own: Some(text.into()),
            ..save_request(&file)
        };
        assert!(matches!(own("other").run(), Err(WriteError::Changed)));
        fs::write(&file, "\u{feff}a\nb\n").unwrap();
        own("a\nb\n").run().unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "\u{feff}a\nb\n");
        let over = Leave {
            over: true,
            ..Leave::default()
        };
        let intended = SaveRequest {
            leave: over,
            ..save_request(&file)
        };
        intended.run().unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "a\nb\n");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn write_errors_have_short_messages() {
        let text = |kind: io::ErrorKind| {
            let error = WriteError::Io(kind.into());
            refused(&error, Path::new("/nowhere/scene.toml"))
        };
        assert_eq!(
            text(io::ErrorKind::StorageFull),
            "not written, the disk is full: scene.toml"
        );
        assert_eq!(
            text(io::ErrorKind::NotFound),
            "not written, no such folder: /nowhere"
        );
        let device = save_request(Path::new("/dev/full")).run().unwrap_err();
        assert_eq!(
            refused(&device, Path::new("/dev/full")),
            "not written, it is a device, not a file: full"
        );
    }
}
