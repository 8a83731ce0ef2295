//! Identifies the scene that edits belong to, independent of the path by which it was opened.

use super::record::{seconds, sum};
use crate::tui::Origin;
use std::fs;
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::MetadataExt;
use std::time::UNIX_EPOCH;

/// The identity of a file: device, inode number, and creation time in nanoseconds, because inode
/// numbers are reused.
pub(super) type Identity = [u64; 3];

/// A scene, as the subject of recorded edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RecoverySubject {
    /// `file`, `preset` or `stdin`.
    pub(super) sort: String,
    /// The file's path with all links resolved, the preset's name, or the hash of the text.
    pub(super) name: Vec<u8>,
    /// The file's identity, if the file exists.
    pub(super) file: Option<Identity>,
    /// The time of the last write, in seconds since 1970.
    pub(super) written: Option<u64>,
}

const FILE: &str = "file";

impl RecoverySubject {
    pub(super) fn of(origin: &Origin, text: &str) -> RecoverySubject {
        let plain = |sort: &str, name: Vec<u8>| RecoverySubject {
            sort: sort.into(),
            name,
            file: None,
            written: None,
        };
        match origin {
            Origin::Preset(name) => plain("preset", name.clone().into_bytes()),
            // A scene without a file is identified by its text alone.
            Origin::New(_) | Origin::Stdin => {
                plain("stdin", sum(text.as_bytes()).to_be_bytes().to_vec())
            }
            Origin::File(path) => {
                let place = path.canonicalize().or_else(|_| std::path::absolute(path));
                let place = place.unwrap_or_else(|_| path.clone());
                let found = fs::metadata(&place).ok().filter(|found| found.is_file());
                let made = |found: &fs::Metadata| {
                    let made = found.created().ok()?.duration_since(UNIX_EPOCH).ok()?;
                    u64::try_from(made.as_nanos()).ok()
                };
                let written = found.as_ref().and_then(|found| found.modified().ok());
                RecoverySubject {
                    file: found.map(|f| [f.dev(), f.ino(), made(&f).unwrap_or(0)]),
                    written: written.map(seconds),
                    ..plain(FILE, place.into_os_string().into_vec())
                }
            }
        }
    }

    pub(super) fn is_file(&self) -> bool {
        self.sort == FILE
    }

    /// Returns `true` if two subjects are the same scene: by name, because editors replace files,
    /// or by the file's identity, if its name differs.
    pub(super) fn is(&self, other: &RecoverySubject) -> bool {
        let same_file = self.file.is_some() && self.file == other.file;
        self.sort == other.sort && (self.name == other.name || same_file)
    }
}
