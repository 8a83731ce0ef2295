//! Opening files to read them: nothing that keeps whoever opens it waiting, nothing without an end.

use crate::wording::words;
use rustix::fs::{Mode, OFlags, open};
use std::fs::{self, File, FileType};
use std::io;
use std::os::unix::fs::FileTypeExt;
use std::path::Path;
#[cfg(feature = "tui")]
use std::path::PathBuf;

/// What a regular file holds, up to one byte more than `most`. Anything else, which could keep its reader
/// waiting for ever, is refused unopened.
///
/// # Errors
/// What the system says, or in words of what kind it is.
#[cfg(feature = "tui")]
pub(crate) fn read_file(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    super::limited(open_to_read(path)?, most)
}

/// A regular file, to be read.
///
/// # Errors
/// What the system says, or in words of what kind it is.
#[cfg(feature = "tui")]
pub(crate) fn open_to_read(path: &Path) -> io::Result<File> {
    open_file(path, OFlags::RDONLY)
}

/// Opens a regular file, and nothing else. It is looked at before, since opening alone makes some devices
/// move, and after, since the name may lead elsewhere by then.
pub(super) fn open_file(path: &Path, access: OFlags) -> io::Result<File> {
    regular(fs::metadata(path)?.file_type())?;
    let flags = access | OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::CLOEXEC;
    let file = File::from(open(path, flags, Mode::empty())?);
    regular(file.metadata()?.file_type())?;
    Ok(file)
}

fn regular(kind: FileType) -> io::Result<()> {
    match kind.is_file() {
        true => Ok(()),
        false => Err(io::Error::other(no_file(kind))),
    }
}

/// What it is that is no regular file.
pub(super) fn no_file(kind: FileType) -> &'static str {
    if kind.is_dir() {
        words().is_a_folder()
    } else if kind.is_fifo() {
        words().is_a_pipe()
    } else if kind.is_socket() {
        words().is_a_socket()
    } else {
        words().is_a_device()
    }
}

/// The path that a person has typed: `~` in front is the home that `env` tells.
#[cfg(feature = "tui")]
pub(crate) fn from_home(typed: &str, env: impl Fn(&str) -> Option<PathBuf>) -> PathBuf {
    let below = match typed.strip_prefix('~') {
        Some("") => Some(""),
        Some(rest) => rest.strip_prefix('/'),
        None => None,
    };
    match below.zip(env("HOME")) {
        Some((below, home)) => home.join(below.trim_start_matches('/')),
        None => PathBuf::from(typed),
    }
}
