//! Resolves the name of a file to be written.

use crate::wording::words;
use rustix::fs::{Access, AtFlags, CWD, accessat};
use rustix::io::Errno;
use std::fs::{self, Metadata};
use std::io;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

/// Maximum number of chained symbolic links, as in the system.
const MAX_LINKS: usize = 40;
/// The write permission bits of a mode.
const WRITERS: u32 = 0o222;

/// The object to which a name leads.
#[derive(Debug)]
pub(super) enum Target {
    /// A missing file, to be created at this path, possibly the target of a dangling link.
    New(PathBuf),
    /// An existing regular file.
    File(PathBuf, Metadata),
    /// A pipe or a device, or an open descriptor such as `/dev/stdout` and `/dev/fd/3` in a shell,
    /// which is written to directly.
    Stream(PathBuf),
}

impl Target {
    /// Resolves the symbolic links of a path.
    ///
    /// # Errors
    /// Returns an I/O error: its folder is missing, it is itself a folder, or its links form a
    /// cycle.
    pub(super) fn find(name: &Path) -> io::Result<Target> {
        let mut name = name.to_owned();
        for _ in 0..MAX_LINKS {
            let place = placed(&name)?;
            if is_fd_path(&place) {
                return Ok(Target::Stream(place));
            }
            let found = match fs::symlink_metadata(&place) {
                Ok(found) => found,
                Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Target::New(place)),
                Err(e) => return Err(e),
            };
            let kind = found.file_type();
            if kind.is_symlink() {
                name = place.with_file_name("").join(fs::read_link(&place)?);
            } else if kind.is_file() {
                return Ok(Target::File(place, found));
            } else if kind.is_dir() {
                return Err(Errno::ISDIR.into());
            } else {
                return Ok(Target::Stream(place));
            }
        }
        Err(Errno::LOOP.into())
    }

    /// Returns the error for an object that cannot be saved to.
    #[cfg(feature = "tui")]
    pub(super) fn no_file(path: &Path) -> super::WriteError {
        let kind = fs::metadata(path).map(|found| found.file_type());
        super::WriteError::NoFile(match kind {
            Ok(kind) if !kind.is_file() => super::bounded_read::no_file(kind),
            _ => words().is_no_file_of_its_own(),
        })
    }

    /// Returns `true` for a file marked read-only or not writable by this process.
    pub(super) fn is_read_only(&self) -> bool {
        let Target::File(path, found) = self else {
            return false;
        };
        let may = || accessat(CWD, path, Access::WRITE_OK, AtFlags::EACCESS);
        found.permissions().mode() & WRITERS == 0
            || matches!(may(), Err(Errno::ACCESS | Errno::PERM))
    }
}

/// Returns the path with its folder resolved.
fn placed(name: &Path) -> io::Result<PathBuf> {
    if name.as_os_str().as_bytes().ends_with(b"/") {
        return Err(Errno::ISDIR.into());
    }
    let no_name = || io::Error::other(words().is_no_name_of_a_file());
    let last = name.file_name().ok_or_else(no_name)?;
    let folder = name
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new(".")).canonicalize()?;
    Ok(folder.join(last))
}

/// Returns `true` if a path is in a folder that lists the open descriptors of a process.
fn is_fd_path(place: &Path) -> bool {
    let folder = place.parent();
    folder.is_some_and(|folder| folder.starts_with("/proc") && folder.ends_with("fd"))
}
