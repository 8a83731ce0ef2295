//! Whether what is read and what is written are one file, whatever it is called there.

use std::path::Path;

/// Whether two names lead to one file; `None` is standard input, and standard output.
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

/// Whether two names lead to one file; of the standard streams this system does not tell it.
#[cfg(not(unix))]
pub(crate) fn is_same_file(read: Option<&Path>, written: Option<&Path>) -> bool {
    let place = |path: Option<&Path>| path.and_then(|path| path.canonicalize().ok());
    place(read).is_some_and(|read| place(written) == Some(read))
}
