//! Locks of the system (flock), which end with the process that holds them, however it ends.

use super::Trouble;
use super::guard::open_file;
use rustix::fs::{FlockOperation, OFlags, flock};
use rustix::io::Errno;
use std::fs::File;
use std::os::unix::fs::MetadataExt;
use std::path::Path;
#[cfg(feature = "tui")]
use {
    rustix::fs::{Mode, open},
    std::thread::sleep,
    std::time::{Duration, Instant},
};

/// How long somebody else may take to save before we give up.
#[cfg(feature = "tui")]
const PATIENCE: Duration = Duration::from_secs(3);
/// Between two attempts.
#[cfg(feature = "tui")]
const PAUSE: Duration = Duration::from_millis(10);

/// Whether a lock was had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LockOutcome {
    /// It is ours until the file is closed.
    Ours,
    /// Somebody else has it.
    Others,
    /// There are no locks here: some network disks have none.
    Unknown,
}

/// Takes the lock on an open file if nobody else has it.
pub(crate) fn take(file: &File) -> LockOutcome {
    loop {
        match flock(file, FlockOperation::NonBlockingLockExclusive) {
            Ok(()) => return LockOutcome::Ours,
            Err(Errno::INTR) => {}
            Err(Errno::WOULDBLOCK) => return LockOutcome::Others,
            Err(_) => return LockOutcome::Unknown,
        }
    }
}

/// How often the name of a file may lead to another one while its lock is taken.
const MOST_TRIES: u32 = 100;

/// Opens an existing file, for writing where that is permitted, and takes its lock.
///
/// # Errors
/// Another process holds the lock, or what the system says.
pub(super) fn hold(path: &Path) -> Result<File, Trouble> {
    for _ in 0..MOST_TRIES {
        let file = open_file(path, OFlags::RDWR).or_else(|_| open_file(path, OFlags::RDONLY))?;
        if take(&file) == LockOutcome::Others {
            return Err(Trouble::Busy);
        }
        // Whoever held the lock before may have put another file there.
        if is_at(&file, path) {
            return Ok(file);
        }
    }
    Err(Trouble::Changed)
}

/// Returns `true` if a name leads to an open file.
pub(super) fn is_at(file: &File, path: &Path) -> bool {
    let named = path.metadata().ok();
    let both = file.metadata().ok().zip(named);
    both.is_some_and(|(file, named)| (file.dev(), file.ino()) == (named.dev(), named.ino()))
}

/// Takes the lock of a folder, under which files of it are compared and replaced; `None` where it has none
/// to give, and an error where somebody else keeps it.
#[cfg(feature = "tui")]
pub(super) fn of_folder(folder: &Path) -> Result<Option<File>, Trouble> {
    let flags = OFlags::RDONLY | OFlags::DIRECTORY | OFlags::CLOEXEC;
    let Ok(folder) = open(folder, flags, Mode::empty()) else {
        return Ok(None);
    };
    let folder = File::from(folder);
    let end = Instant::now() + PATIENCE;
    loop {
        match take(&folder) {
            LockOutcome::Ours => return Ok(Some(folder)),
            LockOutcome::Unknown => return Ok(None),
            LockOutcome::Others if Instant::now() >= end => return Err(Trouble::Busy),
            LockOutcome::Others => sleep(PAUSE),
        }
    }
}

/// Whether somebody else holds the lock on an open file, which is not disturbed by being asked; `None` where
/// that cannot be told.
#[cfg(feature = "tui")]
pub(crate) fn is_held(file: &File) -> Option<bool> {
    match flock(file, FlockOperation::NonBlockingLockShared) {
        Ok(()) => Some(false),
        Err(Errno::WOULDBLOCK) => Some(true),
        Err(_) => None,
    }
}
