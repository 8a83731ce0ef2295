//! Reads files named on the command line.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Reads any file up to one byte more than `most`, including pipes and devices: the user named them
/// and can interrupt by Ctrl-C.
///
/// # Errors
/// Returns an I/O error.
pub(crate) fn read_any_file(path: &Path, maximum: usize) -> io::Result<Vec<u8>> {
    limited(File::open(path)?, maximum)
}

/// Reads a file up to one byte more than `most`. A pipe without a writer is an error: nothing waits
/// for one.
///
/// # Errors
/// Returns an I/O error, or an error for a pipe without a writer.
#[cfg(unix)]
pub(crate) fn read_without_waiting(path: &Path, maximum: usize) -> io::Result<Vec<u8>> {
    use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl, open};
    use std::os::unix::fs::FileTypeExt;
    let flags = OFlags::RDONLY | OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::CLOEXEC;
    let mut file = File::from(open(path, flags, Mode::empty())?);
    let mut first = [0; 1];
    let mut started = 0;
    if file.metadata()?.file_type().is_fifo() {
        started = match file.read(&mut first) {
            Ok(0) => {
                return Err(io::Error::other(
                    crate::wording::words().pipe_without_writer(),
                ));
            }
            Ok(read) => read,
            // A writer has the pipe open, and may write later.
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => 0,
            Err(error) => return Err(error),
        };
    }
    fcntl_setfl(&file, fcntl_getfl(&file)? - OFlags::NONBLOCK)?;
    limited(first[..started].chain(file), maximum)
}

#[cfg(not(unix))]
pub(crate) use read_any_file as read_without_waiting;

/// Reads up to one byte more than `most`, so that endless input ends.
///
/// # Errors
/// Returns an I/O error.
pub(crate) fn limited(from: impl Read, maximum: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let maximum = u64::try_from(maximum).unwrap_or(u64::MAX);
    from.take(maximum.saturating_add(1))
        .read_to_end(&mut bytes)?;
    Ok(bytes)
}
