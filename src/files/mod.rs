//! Files: one guard through which every one is opened, one way in which every one is written.
//!
//! | module | what it holds |
//! |---|---|
//! | `reading`, `same` | what the command line has named |
//! | `guard` | opening what is there: of what kind it may be, and how much of it is read |
//! | `target` | where a name leads that is to be written: links followed, descriptors told from files |
//! | `draft` | a file that is written beside the one whose place it takes, with its rights from the first byte on |
//! | `rights` | owner, group, mode and extended attributes of a file, carried over to its draft |
//! | `stamp` | telling one state of a file from another without reading it |
//! | `in_place` | writing into a file that no other may replace, and completing that after a kill |
//! | `lock` | comparing and replacing without somebody else in between |
//! | `output` | all of these together: a file that is whole, or what it was |
//! | `elsewhere` | the little of it that there is where there is no Unix |
//! | `growing` | a table that is written row by row, and resumed |
//! | `places` | folders that belong to krank |

#[cfg(unix)]
mod draft;
#[cfg(not(unix))]
mod elsewhere;
mod growing;
#[cfg(unix)]
mod guard;
#[cfg(unix)]
mod in_place;
#[cfg_attr(not(unix), path = "no_lock.rs")]
mod lock;
#[cfg(unix)]
mod output;
pub(crate) mod places;
mod reading;
#[cfg(unix)]
mod rights;
mod same;
#[cfg(unix)]
mod stamp;
#[cfg(unix)]
mod target;

#[cfg(not(unix))]
pub(crate) use elsewhere::{Output, mend};
pub(crate) use growing::{GrowingFile, GrownFile};
#[cfg(feature = "tui")]
pub(crate) use guard::{from_home, open_to_read, read_file};
pub(crate) use reading::{limited, read_any, read_ready};
pub(crate) use same::is_same_file;
#[cfg(feature = "tui")]
pub(crate) use stamp::Stamp;
#[cfg(feature = "tui")]
pub(crate) use {
    draft::DraftFile, in_place::make_private, lock::is_held, output::Saving, output::save,
};
#[cfg(unix)]
pub(crate) use {in_place::mend, output::Output};

use crate::wording::words;
use std::io;
use thiserror::Error;

/// Why a file is not written. It is then what it was.
#[derive(Debug, Error)]
pub(crate) enum Trouble {
    /// There is a file, and nobody has said that it may go.
    #[error("{}", words().exists_already())]
    Exists,
    /// It no longer holds what it held when work on it began.
    #[error("{}", words().changed_on_disk())]
    Changed,
    /// Rows were being added to it, and it was deleted, replaced or changed meanwhile.
    #[error("{}", words().changed_while_it_grew())]
    Disturbed,
    /// It is not to be written to, and nobody has said that it is meant nevertheless.
    #[error("{}", words().is_read_only())]
    ReadOnly,
    /// It is no file: what it is.
    #[error("{0}")]
    #[cfg(feature = "tui")]
    NoFile(&'static str),
    /// Another process is writing it.
    #[error("{}", words().another_is_writing())]
    Busy,
    /// A rename would lose what the file is, and there is no folder to keep its old text in meanwhile.
    #[cfg(unix)]
    #[error("{}", words().no_journal())]
    NoJournal,
    /// What the system says.
    #[error(transparent)]
    Io(#[from] io::Error),
}

#[cfg(unix)]
impl From<rustix::io::Errno> for Trouble {
    fn from(error: rustix::io::Errno) -> Trouble {
        Trouble::Io(error.into())
    }
}

impl From<Trouble> for io::Error {
    fn from(trouble: Trouble) -> io::Error {
        match trouble {
            Trouble::Io(error) => error,
            other => io::Error::other(other.to_string()),
        }
    }
}

#[cfg(all(test, unix))]
mod tests;
