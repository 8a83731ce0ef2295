//! Detects that another program has written the scene's file.

use crate::files::{Stamp, read_file};
use crate::scene::MAX_FILE_SIZE;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The byte order mark that some editors write before a text.
pub(crate) const BYTE_ORDER_MARK: &str = "\u{feff}";
/// Minimum time between checks of the file while frames follow each other.
const PAUSE: Duration = Duration::from_secs(1);

/// The state of the file on disk.
#[derive(Debug)]
pub(crate) enum FileStatus {
    /// The file exists with these contents, changed or not.
    Written(Vec<u8>),
    /// The file does not exist.
    Gone,
    /// The file cannot be read.
    Unreadable(io::Error),
}

impl FileStatus {
    /// Reads the state of a file.
    pub(crate) fn of(path: &Path) -> FileStatus {
        match read_file(path, MAX_FILE_SIZE + BYTE_ORDER_MARK.len()) {
            Ok(bytes) => FileStatus::Written(bytes),
            Err(e) if e.kind() == io::ErrorKind::NotFound => FileStatus::Gone,
            Err(e) => FileStatus::Unreadable(e),
        }
    }
}

/// The file as of its last check.
#[derive(Debug)]
pub(crate) struct Disk {
    path: PathBuf,
    /// The file's path with all links resolved.
    place: Option<PathBuf>,
    /// The stamp of the last check. `None` before the first check, which reports any write since the
    /// file was read.
    stamp: Option<Option<Stamp>>,
    checked_at: Option<Duration>,
    /// `true` while a check is running.
    is_checking: bool,
    /// `true` if the file was written during a check, which may have missed it.
    missed: bool,
}

/// A check of the file, which may take long.
#[derive(Debug)]
pub(crate) struct FileCheck {
    path: PathBuf,
    before: Option<Option<Stamp>>,
}

/// The outcome of a check.
#[derive(Debug)]
pub(crate) struct FileCheckOutcome {
    pub(crate) path: PathBuf,
    place: Option<PathBuf>,
    stamp: Option<Stamp>,
    /// The state of the file, if its stamp has changed.
    pub(crate) news: Option<FileStatus>,
}

impl Disk {
    /// Creates the state of a file that was just read or written.
    pub(crate) fn new(path: &Path) -> Disk {
        Disk {
            path: path.to_owned(),
            place: None,
            stamp: None,
            checked_at: None,
            is_checking: false,
            missed: false,
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the path with all links resolved, after the first check.
    pub(crate) fn place(&self) -> Option<&Path> {
        self.place.as_deref()
    }

    /// Returns a check if one is due: immediately if `at_once`, or else after a pause. During a
    /// running check, an immediate one is postponed.
    pub(crate) fn due_check(&mut self, now: Duration, at_once: bool) -> Option<FileCheck> {
        self.missed |= self.is_checking && at_once;
        let is_due = at_once || self.checked_at.is_none_or(|looked| now >= looked + PAUSE);
        if self.is_checking || !is_due {
            return None;
        }
        self.checked_at = Some(now);
        self.is_checking = true;
        Some(FileCheck {
            path: self.path.clone(),
            before: self.stamp,
        })
    }

    /// Stores the outcome of a check. If it was not `attended`, the next check reports it again.
    /// Returns `true` if another check is due.
    #[must_use]
    pub(crate) fn see(&mut self, seen: &FileCheckOutcome, attended: bool) -> bool {
        self.is_checking = false;
        // A deleted file may reappear, so its path is kept.
        if seen.place.is_some() {
            self.place.clone_from(&seen.place);
        }
        if attended {
            self.stamp = Some(seen.stamp);
        }
        std::mem::take(&mut self.missed)
    }
}

impl FileCheck {
    pub(crate) fn run(self) -> FileCheckOutcome {
        let stamp = Stamp::of(&self.path);
        // A file missing since the first check was not deleted.
        let is_new = self.before.unwrap_or(None) != stamp;
        FileCheckOutcome {
            place: self.path.canonicalize().ok(),
            stamp,
            news: is_new.then(|| FileStatus::of(&self.path)),
            path: self.path,
        }
    }
}

/// Returns a text without its byte order mark.
pub(crate) fn unmarked(bytes: &[u8]) -> &[u8] {
    bytes
        .strip_prefix(BYTE_ORDER_MARK.as_bytes())
        .unwrap_or(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file is removed and rewritten: the second notification arrives during the first check and
    /// is not lost.
    #[test]
    fn change_during_file_check_requests_another() {
        let mut disk = Disk::new(Path::new("no such file"));
        let look = disk.due_check(Duration::ZERO, true).unwrap();
        assert!(disk.due_check(Duration::ZERO, true).is_none());
        assert!(disk.see(&look.run(), true), "one is owed");
        let look = disk.due_check(Duration::ZERO, true).unwrap();
        assert!(!disk.see(&look.run(), true), "none is owed");
    }
}
