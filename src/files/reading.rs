//! Reads files named on the command line.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Reads any file up to one byte more than `most`, including pipes and devices: the user named them
/// and can interrupt by Ctrl-C.
///
/// # Errors
/// Returns an I/O error.
pub(crate) fn read_any(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    limited(File::open(path)?, most)
}

/// Reads a file up to one byte more than `most`. A pipe without a writer is an error: nothing waits
/// for one.
///
/// # Errors
/// Returns an I/O error, or an error for a pipe without a writer.
#[cfg(unix)]
pub(crate) fn read_ready(path: &Path, most: usize) -> io::Result<Vec<u8>> {
    use rustix::fs::{Mode, OFlags, fcntl_getfl, fcntl_setfl, open};
    use std::os::unix::fs::FileTypeExt;
    let flags = OFlags::RDONLY | OFlags::NONBLOCK | OFlags::NOCTTY | OFlags::CLOEXEC;
    let mut file = File::from(open(path, flags, Mode::empty())?);
    let mut first = [0; 1];
    let mut begun = 0;
    if file.metadata()?.file_type().is_fifo() {
        begun = match file.read(&mut first) {
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
    limited(first[..begun].chain(file), most)
}

#[cfg(not(unix))]
pub(crate) use read_any as read_ready;

/// Reads up to one byte more than `most`, so that endless input ends.
///
/// # Errors
/// Returns an I/O error.
pub(crate) fn limited(from: impl Read, most: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = u64::try_from(most).unwrap_or(u64::MAX);
    from.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(bytes)
}
