//! Watching the scene's file without a timer: the kernel tells when it was written, replaced or taken away.
//!
//! The folder is watched rather than the file, since most editors put a new file in the place of the old
//! one. Where that cannot be had, on a network home for instance, nothing is told here; time stamp and
//! size are looked at besides whenever something else happens.

use rustix::fd::{AsFd, BorrowedFd, OwnedFd};
use rustix::fs::inotify::{CreateFlags, Reader, WatchFlags, add_watch, init, remove_watch};
use std::ffi::OsString;
use std::mem::MaybeUninit;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};

/// Room for some events with their names.
const ROOM: usize = 4096;

/// What is told about a folder.
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
    /// `None` where the system has no such thing, or no more of it.
    inotify: Option<OwnedFd>,
    file: Option<PathBuf>,
    /// The watch on its folder, and its name there.
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

    /// Watches this file from now on, and no other; whether that begins now. It is behind all links: only
    /// there it is written.
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

    /// What to wait on.
    pub(super) fn descriptor(&self) -> Option<BorrowedFd<'_>> {
        self.inotify.as_ref().map(OwnedFd::as_fd)
    }

    /// Takes in what was told: whether something happened to the file.
    pub(super) fn told(&mut self) -> bool {
        let Some(inotify) = &self.inotify else {
            return false;
        };
        let mut room = [MaybeUninit::uninit(); ROOM];
        let mut events = Reader::new(inotify, &mut room);
        let mut told = false;
        // An error means that there is no more for now.
        while let Ok(event) = events.next() {
            let name = event.file_name().map(|name| name.to_bytes());
            let own = self.watched.as_ref().map(|(_, name)| name.as_bytes());
            told |= name.is_some() && name == own;
        }
        told
    }
}
