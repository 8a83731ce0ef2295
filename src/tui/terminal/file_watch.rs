//! Watches the scene's file without a timer: the kernel reports when it is written, replaced or
//! deleted.
//!
//! The folder is watched instead of the file, because most editors replace the old file by a new
//! one. Where inotify is unavailable, for example on a network home, this module reports nothing.
//! In addition, time stamp and size are checked at every other event.

use rustix::fd::{AsFd, BorrowedFd, OwnedFd};
use rustix::fs::inotify::{CreateFlags, Reader, WatchFlags, add_watch, init, remove_watch};
use std::ffi::OsString;
use std::mem::MaybeUninit;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};

/// Size of a buffer for several events with their names.
const ROOM: usize = 4096;

/// Returns the events of a folder to watch for.
fn flags() -> WatchFlags {
    WatchFlags::CLOSE_WRITE
        | WatchFlags::MOVED_TO
        | WatchFlags::MOVED_FROM
        | WatchFlags::DELETE
        | WatchFlags::ONLYDIR
}

/// A watch on at most one file.
#[derive(Debug)]
pub(super) struct Watch {
    /// `None` if the system has no inotify, or no more instances of it.
    inotify: Option<OwnedFd>,
    file: Option<PathBuf>,
    /// The watch on the file's folder, and the file's name in it.
    watched: Option<(i32, OsString)>,
}

impl Watch {
    pub(super) fn new() -> Watch {
        Watch {
            inotify: init(CreateFlags::NONBLOCK | CreateFlags::CLOEXEC).ok(),
            file: None,
            watched: None,
        }
    }

    /// Watches this file and no other. Returns `true` if a new watch was started. The path must
    /// have all links resolved, because only there the file is written.
    pub(super) fn follow(&mut self, file: Option<&Path>) -> bool {
        if self.file.as_deref() == file {
            return false;
        }
        self.file = file.map(Path::to_owned);
        let Some(inotify) = &self.inotify else {
            return false;
        };
        if let Some((watch, _)) = self.watched.take() {
            let _ = remove_watch(inotify, watch);
        }
        self.watched = file.and_then(|file| {
            let name = file.file_name()?.to_owned();
            let watch = add_watch(inotify, file.parent()?, flags()).ok()?;
            Some((watch, name))
        });
        self.watched.is_some()
    }

    /// Returns the descriptor to wait on.
    pub(super) fn descriptor(&self) -> Option<BorrowedFd<'_>> {
        self.inotify.as_ref().map(OwnedFd::as_fd)
    }

    /// Reads the pending events. Returns `true` if any of them concerns the file.
    pub(super) fn has_changes(&mut self) -> bool {
        let Some(inotify) = &self.inotify else {
            return false;
        };
        let mut space = [MaybeUninit::uninit(); ROOM];
        let mut events = Reader::new(inotify, &mut space);
        let mut is_shown = false;
        // An error means that no more events are pending.
        while let Ok(event) = events.next() {
            let name = event.file_name().map(|name| name.to_bytes());
            let own = self.watched.as_ref().map(|(_, name)| name.as_bytes());
            is_shown |= name.is_some() && name == own;
        }
        is_shown
    }
}
