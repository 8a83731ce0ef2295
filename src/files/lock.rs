//! Advisory file locks (flock), which the system releases when a process ends in any way.

use super::WriteError;
use super::bounded_read::open_file;
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

/// Maximum time to wait for another process that is saving.
#[cfg(feature = "tui")]
const PATIENCE: Duration = Duration::from_secs(3);
/// Pause between two attempts.
#[cfg(feature = "tui")]
const PAUSE: Duration = Duration::from_millis(10);

/// The result of trying to take a lock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LockOutcome {
    /// This process holds the lock until the file is closed.
    Ours,
    /// Another process holds the lock.
    HeldElsewhere,
    /// The file system has no locks, as some network file systems.
    Unknown,
}

/// Takes the lock on an open file if no other process holds it.
pub(crate) fn take(file: &File) -> LockOutcome {
    loop {
        match flock(file, FlockOperation::NonBlockingLockExclusive) {
            Ok(()) => return LockOutcome::Ours,
            Err(Errno::INTR) => {}
            Err(Errno::WOULDBLOCK) => return LockOutcome::HeldElsewhere,
            Err(_) => return LockOutcome::Unknown,
        }
    }
}

/// Maximum number of attempts while the name of a file keeps leading to another one.
const MAX_TRIES: u32 = 100;

/// Opens an existing file, for writing if permitted, and takes its lock.
///
/// # Errors
/// Returns an error if another process holds the lock, or an I/O error.
pub(super) fn hold(path: &Path) -> Result<File, WriteError> {
    for _ in 0..MAX_TRIES {
        let file = open_file(path, OFlags::RDWR).or_else(|_| open_file(path, OFlags::RDONLY))?;
        if take(&file) == LockOutcome::HeldElsewhere {
            return Err(WriteError::Busy);
        }
        // The previous holder of the lock may have replaced the file.
        if is_at(&file, path) {
            return Ok(file);
        }
    }
    Err(WriteError::Changed)
}

/// Returns `true` if a name leads to an open file.
pub(super) fn is_at(file: &File, path: &Path) -> bool {
    let named = path.metadata().ok();
    let both = file.metadata().ok().zip(named);
    both.is_some_and(|(file, named)| (file.dev(), file.ino()) == (named.dev(), named.ino()))
}

/// Takes the lock of a folder, under which its files are compared and replaced. Returns `None` if
/// the folder cannot be locked, and an error if another process keeps the lock.
#[cfg(feature = "tui")]
pub(super) fn of_folder(folder: &Path) -> Result<Option<File>, WriteError> {
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
            LockOutcome::HeldElsewhere if Instant::now() >= end => return Err(WriteError::Busy),
            LockOutcome::HeldElsewhere => sleep(PAUSE),
        }
    }
}

/// Checks whether another process holds the lock on an open file, without disturbing that process.
/// Returns `None` if this cannot be determined.
#[cfg(feature = "tui")]
pub(crate) fn is_held(file: &File) -> Option<bool> {
    match flock(file, FlockOperation::NonBlockingLockShared) {
        Ok(()) => Some(false),
        Err(Errno::WOULDBLOCK) => Some(true),
        Err(_) => None,
    }
}
