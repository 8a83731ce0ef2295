//! The scene's file on the disk: whether somebody else has written it since.

use super::opening::contents;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// What some editors put in front of a text.
pub(crate) const BYTE_ORDER_MARK: &str = "\u{feff}";
/// While frames follow each other the file is looked at no more often.
const PAUSE: Duration = Duration::from_secs(1);

/// Tells one state of a file from another without reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Stamp {
    modified: Option<SystemTime>,
    size: u64,
}

impl Stamp {
    /// `None` where there is no file.
    fn of(path: &Path) -> Option<Stamp> {
        let data = std::fs::metadata(path).ok()?;
        Some(Stamp {
            modified: data.modified().ok(),
            size: data.len(),
        })
    }
}

/// What has become of the file.
#[derive(Debug)]
pub(crate) enum News {
    /// It holds other bytes than before.
    Written(Vec<u8>),
    /// It is there no more.
    Gone,
    /// It cannot be read, and why.
    Unreadable(io::Error),
}

/// The file as it was when it was last read or written.
#[derive(Debug)]
pub(crate) struct Disk {
    path: PathBuf,
    stamp: Option<Stamp>,
    looked: Duration,
}

impl Disk {
    /// A file that was just read or written.
    pub(crate) fn new(path: &Path, now: Duration) -> Disk {
        Disk {
            path: path.to_owned(),
            stamp: Stamp::of(path),
            looked: now,
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Looks whether it has changed since it was looked at last; `at_once`, or after a while.
    pub(crate) fn look(&mut self, now: Duration, at_once: bool) -> Option<News> {
        if !at_once && now < self.looked + PAUSE {
            return None;
        }
        self.looked = now;
        let stamp = Stamp::of(&self.path);
        if stamp == self.stamp {
            return None;
        }
        self.stamp = stamp;
        Some(self.read())
    }

    /// What it holds now.
    pub(crate) fn read(&self) -> News {
        match contents(&self.path) {
            Ok(bytes) => News::Written(bytes),
            Err(e) if e.kind() == io::ErrorKind::NotFound => News::Gone,
            Err(e) => News::Unreadable(e),
        }
    }
}

/// The text of a scene, without the mark in front of it.
pub(crate) fn unmarked(bytes: &[u8]) -> &[u8] {
    bytes
        .strip_prefix(BYTE_ORDER_MARK.as_bytes())
        .unwrap_or(bytes)
}
