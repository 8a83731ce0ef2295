//! Detects changes of a file without reading it.

use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// A fingerprint of a file's state: different stamps mean different states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stamp {
    device: u64,
    inode: u64,
    size: u64,
    modified: (i64, i64),
    /// The time of the last change of content or metadata.
    changed: (i64, i64),
}

impl Stamp {
    /// Returns the stamp of a file; `None` if there is no file.
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
    /// Returns `true` if both are states of the same file with the same text; permissions and names
    /// may differ.
    pub(super) fn has_text_of(&self, other: &Stamp) -> bool {
        let text = |stamp: &Stamp| (stamp.device, stamp.inode, stamp.size, stamp.modified);
        text(self) == text(other)
    }
}
