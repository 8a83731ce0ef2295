//! Reads and writes files safely.
//!
//! | module | contents |
//! |---|---|
//! | `reading`, `same_file` | files named on the command line |
//! | `bounded_read` | opening existing files: permitted kinds, and limits on the size read |
//! | `target` | resolving the name of a file to write: symbolic links and open descriptors |
//! | `temporary` | temporary files that replace their target, with its permissions from the first byte on |
//! | `metadata` | copying owner, group, mode and extended attributes of a file to its temporary file |
//! | `fingerprint` | detecting changes of a file without reading it |
//! | `in_place` | writing into a file that cannot be replaced, and completing interrupted writes |
//! | `lock` | locks for comparing and replacing without interference |
//! | `output` | atomic writes: a file is complete or unchanged |
//! | `non_unix` | the subset available on systems other than Unix |
//! | `extension` | extensions of other programs' formats |
//! | `row_file` | tables written row by row, which can be resumed |
//! | `directories` | krank's own folders |

#[cfg(unix)]
mod bounded_read;
pub(crate) mod directories;
mod extension;
#[cfg(unix)]
mod fingerprint;
#[cfg(unix)]
mod in_place;
#[cfg_attr(not(unix), path = "no_lock.rs")]
mod lock;
#[cfg(unix)]
mod metadata;
#[cfg(not(unix))]
mod non_unix;
#[cfg(unix)]
mod output;
mod reading;
mod row_file;
mod same_file;
#[cfg(unix)]
mod target;
#[cfg(unix)]
mod temporary;

#[cfg(feature = "tui")]
pub(crate) use bounded_read::{from_home, open_to_read, read_file};
pub(crate) use extension::foreign_extension;
#[cfg(feature = "tui")]
pub(crate) use fingerprint::Stamp;
#[cfg(not(unix))]
pub(crate) use non_unix::{Output, ReplacedFile, recover_all};
pub(crate) use reading::{limited, read_any_file, read_without_waiting};
pub(crate) use row_file::{AppendFile, ResumableFile};
pub(crate) use same_file::is_same_file;
#[cfg(feature = "tui")]
pub(crate) use {
    in_place::create_private_folder, lock::is_held, output::Saving, output::save,
    temporary::DraftFile,
};
#[cfg(unix)]
pub(crate) use {in_place::recover_all, output::Output, temporary::ReplacedFile};

use crate::wording::words;
use std::io;
use thiserror::Error;

/// The reason why a file was not written. It is then unchanged.
#[derive(Debug, Error)]
pub(crate) enum WriteError {
    /// The file exists, and replacing it was not confirmed.
    #[error("{}", words().exists_already())]
    Exists,
    /// Another process has created the file since the output began.
    #[cfg(unix)]
    #[error("{}", words().created_meanwhile())]
    Appeared,
    /// The file has changed since it was read.
    #[error("{}", words().changed_on_disk())]
    Changed,
    /// The file was deleted, replaced or changed while rows were appended.
    #[error("{}", words().changed_while_it_grew())]
    Disturbed,
    /// The file is read-only, and writing it was not confirmed.
    #[error("{}", words().is_read_only())]
    ReadOnly,
    /// Not a regular file; contains the kind of object.
    #[error("{0}")]
    #[cfg(feature = "tui")]
    NoFile(&'static str),
    /// Another process is writing it.
    #[error("{}", words().another_is_writing())]
    Busy,
    /// Replacing it would lose metadata, and there is no folder for a record of its old text.
    #[cfg(unix)]
    #[error("{}", words().no_journal())]
    NoJournal,
    /// An I/O error.
    #[error(transparent)]
    Io(#[from] io::Error),
}

#[cfg(unix)]
impl From<rustix::io::Errno> for WriteError {
    fn from(error: rustix::io::Errno) -> WriteError {
        WriteError::Io(error.into())
    }
}

impl From<WriteError> for io::Error {
    fn from(trouble: WriteError) -> io::Error {
        match trouble {
            WriteError::Io(error) => error,
            other => io::Error::other(other.to_string()),
        }
    }
}

#[cfg(all(test, unix))]
mod tests;
