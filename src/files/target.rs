//! Where a name leads that is to be written.

use crate::wording::words;
use rustix::fs::{Access, AtFlags, CWD, accessat};
use rustix::io::Errno;
use std::fs::{self, Metadata};
use std::io;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

/// More links after each other the system does not follow either.
const MOST_LINKS: usize = 40;
/// Who may write, in a mode.
const WRITERS: u32 = 0o222;

/// What is at the end of a name.
#[derive(Debug)]
pub(super) enum Target {
    /// Nothing so far; the file is to be made here, which may be behind a link that leads nowhere yet.
    New(PathBuf),
    /// A file that is there.
    File(PathBuf, Metadata),
    /// No file but a pipe or a device; or what somebody has opened for us, as the shell has
    /// `/dev/stdout` and `/dev/fd/3`, which is written to as it stands.
    Stream(PathBuf),
}

impl Target {
    /// Follows a name to its end.
    ///
    /// # Errors
    /// What the system says: its folder is not there, it is itself a folder, it leads in a circle.
    pub(super) fn find(name: &Path) -> io::Result<Target> {
        let mut name = name.to_owned();
        for _ in 0..MOST_LINKS {
            let place = placed(&name)?;
            if is_of_descriptors(&place) {
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

    /// What it is that cannot be saved to.
    #[cfg(feature = "tui")]
    pub(super) fn no_file(path: &Path) -> super::Trouble {
        let kind = fs::metadata(path).map(|found| found.file_type());
        super::Trouble::NoFile(match kind {
            Ok(kind) if !kind.is_file() => super::guard::no_file(kind),
            _ => words().is_no_file_of_its_own(),
        })
    }

    /// Whether it is a file that says that it is not to be written to, or does not let us.
    pub(super) fn is_read_only(&self) -> bool {
        let Target::File(path, found) = self else {
            return false;
        };
        let may = || accessat(CWD, path, Access::WRITE_OK, AtFlags::EACCESS);
        found.permissions().mode() & WRITERS == 0
            || matches!(may(), Err(Errno::ACCESS | Errno::PERM))
    }
}

/// The name in its true folder.
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

/// Whether it stands in a folder of a process that lists what it has opened.
fn is_of_descriptors(place: &Path) -> bool {
    let folder = place.parent();
    folder.is_some_and(|folder| folder.starts_with("/proc") && folder.ends_with("fd"))
}
