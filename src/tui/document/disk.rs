//! The scene's file on the disk: whether somebody else has written it since.

use crate::files::{Stamp, read_file};
use crate::scene::LARGEST_FILE;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What some editors put in front of a text.
pub(crate) const BYTE_ORDER_MARK: &str = "\u{feff}";
/// While frames follow each other the file is looked at no more often.
const PAUSE: Duration = Duration::from_secs(1);

/// What has become of the file.
#[derive(Debug)]
pub(crate) enum News {
    /// It holds these bytes, which may be others than before.
    Written(Vec<u8>),
    /// It is there no more.
    Gone,
    /// It cannot be read, and why.
    Unreadable(io::Error),
}

impl News {
    /// What a file holds now.
    pub(crate) fn of(path: &Path) -> News {
        match read_file(path, LARGEST_FILE + BYTE_ORDER_MARK.len()) {
            Ok(bytes) => News::Written(bytes),
            Err(e) if e.kind() == io::ErrorKind::NotFound => News::Gone,
            Err(e) => News::Unreadable(e),
        }
    }
}

/// The file as it was when it was last looked at.
#[derive(Debug)]
pub(crate) struct Disk {
    path: PathBuf,
    /// The file behind all links.
    place: Option<PathBuf>,
    /// `None` before the first look: that tells what was written between reading the file and now.
    stamp: Option<Option<Stamp>>,
    looked: Option<Duration>,
    /// Whether somebody is looking.
    looking: bool,
    /// Whether something was written meanwhile, which that look may not have seen.
    missed: bool,
}

/// A look at the file, which may take long.
#[derive(Debug)]
pub(crate) struct DiskLook {
    path: PathBuf,
    before: Option<Option<Stamp>>,
}

/// What was seen.
#[derive(Debug)]
pub(crate) struct SeenFile {
    pub(crate) path: PathBuf,
    place: Option<PathBuf>,
    stamp: Option<Stamp>,
    /// Where it is another than before.
    pub(crate) news: Option<News>,
}

impl Disk {
    /// A file that was just read or written.
    pub(crate) fn new(path: &Path) -> Disk {
        Disk {
            path: path.to_owned(),
            place: None,
            stamp: None,
            looked: None,
            looking: false,
            missed: false,
        }
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// The file behind all links, once it was looked at.
    pub(crate) fn place(&self) -> Option<&Path> {
        self.place.as_deref()
    }

    /// A look at it, where one is due: `at_once`, or after a while. While somebody is looking it is owed.
    pub(crate) fn look(&mut self, now: Duration, at_once: bool) -> Option<DiskLook> {
        self.missed |= self.looking && at_once;
        let is_due = at_once || self.looked.is_none_or(|looked| now >= looked + PAUSE);
        if self.looking || !is_due {
            return None;
        }
        self.looked = Some(now);
        self.looking = true;
        Some(DiskLook {
            path: self.path.clone(),
            before: self.stamp,
        })
    }

    /// Takes in what was seen. What was not attended to the next look will tell again. Whether one is owed.
    #[must_use]
    pub(crate) fn see(&mut self, seen: &SeenFile, attended: bool) -> bool {
        self.looking = false;
        // Where a file is gone, one may come again.
        if seen.place.is_some() {
            self.place.clone_from(&seen.place);
        }
        if attended {
            self.stamp = Some(seen.stamp);
        }
        std::mem::take(&mut self.missed)
    }
}

impl DiskLook {
    pub(crate) fn run(self) -> SeenFile {
        let stamp = Stamp::of(&self.path);
        // What was not there from the beginning is not gone.
        let is_new = self.before.unwrap_or(None) != stamp;
        SeenFile {
            place: self.path.canonicalize().ok(),
            stamp,
            news: is_new.then(|| News::of(&self.path)),
            path: self.path,
        }
    }
}

/// The text of a scene, without the mark in front of it.
pub(crate) fn unmarked(bytes: &[u8]) -> &[u8] {
    bytes
        .strip_prefix(BYTE_ORDER_MARK.as_bytes())
        .unwrap_or(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file that is taken away and written anew: the second piece of news comes while the first is looked
    /// at, and is not lost.
    #[test]
    fn what_is_written_while_somebody_looks_is_looked_at_again() {
        let mut disk = Disk::new(Path::new("no such file"));
        let look = disk.look(Duration::ZERO, true).unwrap();
        assert!(disk.look(Duration::ZERO, true).is_none());
        assert!(disk.see(&look.run(), true), "one is owed");
        let look = disk.look(Duration::ZERO, true).unwrap();
        assert!(!disk.see(&look.run(), true), "none is owed");
    }
}
