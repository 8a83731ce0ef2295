//! What edits belong to: a scene, whatever the name is written like by which it was opened.

use super::record::{seconds, sum};
use crate::tui::Origin;
use std::fs;
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::MetadataExt;
use std::time::UNIX_EPOCH;

/// A file, whatever it is called: device, number, and when it was made, since numbers are used again.
pub(super) type Identity = [u64; 3];

/// A scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RecoverySubject {
    /// `file`, `preset` or `stdin`.
    pub(super) sort: String,
    /// Its path with all links followed, its name, or the sum of its text.
    pub(super) name: Vec<u8>,
    /// The file, where it is there.
    pub(super) file: Option<Identity>,
    /// When it was written last, in seconds.
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
            // Of what no file holds the text alone tells what it is.
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

    /// Whether it is the same scene: under the same name, since editors put a new file in the place of the
    /// old one, or the same file under another name.
    pub(super) fn is(&self, other: &RecoverySubject) -> bool {
        let same_file = self.file.is_some() && self.file == other.file;
        self.sort == other.sort && (self.name == other.name || same_file)
    }
}
