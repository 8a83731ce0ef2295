//! Opens files for reading, without blocking and without endless input.

use crate::wording::words;
use rustix::fs::{Mode, OFlags, open};
use std::fs::{self, File, FileType};
use std::io;
use std::os::unix::fs::FileTypeExt;
use std::path::Path;
#[cfg(feature = "tui")]
use std::path::PathBuf;

/// Reads a regular file up to one byte more than `most`. Rejects anything else before opening it,
/// because it could block its reader forever.
///
/// # Errors
/// Returns an I/O error, or a message with the kind of file.
#[cfg(feature = "tui")]
pub(crate) fn read_file(path: &Path, maximum: usize) -> io::Result<Vec<u8>> {
    super::limited(open_to_read(path)?, maximum)
}

/// Opens a regular file for reading.
///
/// # Errors
/// Returns an I/O error, or a message with the kind of file.
#[cfg(feature = "tui")]
pub(crate) fn open_to_read(path: &Path) -> io::Result<File> {
    open_file(path, OFlags::RDONLY)
}

/// Opens a regular file, and nothing else. The kind is checked before, because opening some devices
/// has side effects, and after, because the name may lead elsewhere by then.
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

/// Returns the description of an object that is not a regular file.
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

/// Expands a typed path: a leading `~` becomes the home folder given by `env`.
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
