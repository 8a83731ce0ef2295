//! Checks whether input and output are the same file, under any name.

use std::path::Path;

/// Returns `true` if two names lead to the same file. A name of `None` means standard input or
/// output.
#[cfg(unix)]
pub(crate) fn is_same_file(read: Option<&Path>, written: Option<&Path>) -> bool {
    use rustix::fs::{FileType, fstat, stat};

    let read = read.map_or_else(|| fstat(std::io::stdin()), stat);
    let written = written.map_or_else(|| fstat(std::io::stdout()), stat);
    let (Ok(read), Ok(written)) = (read, written) else {
        return false;
    };
    FileType::from_raw_mode(read.st_mode).is_file()
        && (read.st_dev, read.st_ino) == (written.st_dev, written.st_ino)
}

/// Returns `true` if two names lead to the same file; this system cannot compare the standard
/// streams.
#[cfg(not(unix))]
pub(crate) fn is_same_file(read: Option<&Path>, written: Option<&Path>) -> bool {
    let place = |path: Option<&Path>| path.and_then(|path| path.canonicalize().ok());
    place(read).is_some_and(|read| place(written) == Some(read))
}
