//! In place of file locks, where there is no Unix: nothing is locked.

use std::fs::File;
use std::path::Path;

/// Whether a lock was had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LockOutcome {
    /// It is ours until the file is closed.
    Ours,
    /// Somebody else has it.
    Others,
    /// There are no locks here.
    Unknown,
}

/// Takes no lock.
pub(super) fn take(_: &File) -> LockOutcome {
    LockOutcome::Unknown
}

/// Returns `true` if a name may lead to an open file: this system does not tell which.
pub(super) fn is_at(_: &File, path: &Path) -> bool {
    path.is_file()
}
