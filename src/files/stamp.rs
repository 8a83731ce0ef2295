//! Telling one state of a file from another without reading it.

use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// A state of a file: another stamp, another state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stamp {
    device: u64,
    inode: u64,
    size: u64,
    modified: (i64, i64),
    /// When anything of it was changed last.
    changed: (i64, i64),
}

impl Stamp {
    /// `None` where there is no file.
    pub(crate) fn of(path: &Path) -> Option<Stamp> {
        let found = std::fs::metadata(path).ok()?;
        Some(Stamp {
            device: found.dev(),
            inode: found.ino(),
            size: found.size(),
            modified: (found.mtime(), found.mtime_nsec()),
            changed: (found.ctime(), found.ctime_nsec()),
        })
    }
}

impl Stamp {
    /// Returns `true` if both are states of one file with the same text, whatever was done to its rights and names.
    pub(super) fn has_text_of(&self, other: &Stamp) -> bool {
        let text = |stamp: &Stamp| (stamp.device, stamp.inode, stamp.size, stamp.modified);
        text(self) == text(other)
    }
}
