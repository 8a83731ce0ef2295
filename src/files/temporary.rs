//! Temporary files that are created next to a file and then replace it.
//!
//! Where the system supports it (`O_TMPFILE`), a draft has no name until it replaces its target: a
//! killed process leaves nothing. On other systems it has a name from the start, and a lock that
//! marks it as in use. A named draft without a lock was left by a killed process; the next process
//! that writes in this folder removes it.

use super::lock::{self, LockOutcome};
use super::metadata;
use rustix::fs::{AtFlags, CWD, Mode, OFlags, RenameFlags, linkat, open, renameat_with};
use rustix::io::Errno;
use rustix::process::geteuid;
use std::fs::{self, DirEntry, File, Metadata};
use std::io::{self, Seek};
use std::os::fd::AsRawFd;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// Prefix and suffix of the names of drafts. Their length does not depend on the name of the
/// target.
const BEGINS: &str = ".krank-";
const ENDS: &str = ".part";
/// Mode of a draft until it gets the mode of its target.
const PRIVATE: Mode = Mode::RUSR.union(Mode::WUSR);
/// Mode of a new file, from the first byte; the process's umask applies.
const NEW: Mode = Mode::from_raw_mode(0o666);
/// Maximum number of names tried. More collisions with foreign files indicate another problem.
const MAX_NAMES: u32 = 1000;
/// Maximum number of folder entries searched for abandoned drafts.
const MAX_ENTRIES: usize = 10_000;

/// A temporary file; removed if it is dropped before it replaces its target.
#[derive(Debug)]
pub(crate) struct DraftFile {
    /// The open file, for reading and writing.
    pub(crate) file: File,
    folder: PathBuf,
    /// `None` if it has no name yet, or after it has replaced its target.
    path: Option<PathBuf>,
}

impl DraftFile {
    /// Creates a draft of a new file in a folder.
    pub(super) fn new(folder: &Path) -> io::Result<DraftFile> {
        DraftFile::make(folder, NEW)
    }

    /// Creates a draft that only its owner can read and write.
    pub(crate) fn private(folder: &Path) -> io::Result<DraftFile> {
        DraftFile::make(folder, PRIVATE)
    }

    /// Creates a draft of an existing file, with all its metadata but not its text.
    pub(super) fn like(folder: &Path, old: &File, has: &Metadata) -> io::Result<DraftFile> {
        let draft = DraftFile::make(folder, PRIVATE)?;
        metadata::carry_over(old, has, &draft.file)?;
        Ok(draft)
    }

    fn make(folder: &Path, mode: Mode) -> io::Result<DraftFile> {
        sweep(folder);
        match unnamed(folder, mode) {
            Some(file) => Ok(DraftFile {
                file,
                folder: folder.to_owned(),
                path: None,
            }),
            None => DraftFile::make_named(folder, mode),
        }
    }

    /// Creates a draft that has a name from the start.
    fn make_named(folder: &Path, mode: Mode) -> io::Result<DraftFile> {
        let flags = OFlags::RDWR | OFlags::CREATE | OFlags::EXCL | OFlags::CLOEXEC;
        for _ in 0..MAX_NAMES {
            let path = folder.join(next_name());
            let file = match open(&path, flags | OFlags::NOFOLLOW, mode) {
                Ok(file) => File::from(file),
                // A foreign file: leave it.
                Err(Errno::EXIST) => continue,
                Err(error) => return Err(error.into()),
            };
            // Another process may have swept the folder before the lock was taken, and removed this
            // file.
            if lock::take(&file) != LockOutcome::HeldElsewhere && file.metadata()?.nlink() > 0 {
                return Ok(DraftFile {
                    file,
                    folder: folder.to_owned(),
                    path: Some(path),
                });
            }
        }
        Err(Errno::EXIST.into())
    }

    /// Gives the draft a name if it has none, and returns the name.
    fn name(&mut self) -> io::Result<PathBuf> {
        if self.path.is_none() {
            match self.link_to_free_name() {
                Ok(path) => self.path = Some(path),
                Err(_) => self.copy_to_named()?,
            }
        }
        self.path.clone().ok_or_else(|| Errno::NOENT.into())
    }

    fn link_to_free_name(&self) -> io::Result<PathBuf> {
        for _ in 0..MAX_NAMES {
            let path = self.folder.join(next_name());
            match link(&self.file, &path) {
                Err(Errno::EXIST) => {}
                done => return done.map(|()| path).map_err(io::Error::from),
            }
        }
        Err(Errno::EXIST.into())
    }

    /// Replaces itself by a named draft of the same content and metadata. Some systems create files
    /// without a name but cannot name them later.
    fn copy_to_named(&mut self) -> io::Result<()> {
        let mut named = DraftFile::make_named(&self.folder, PRIVATE)?;
        metadata::carry_over(&self.file, &self.file.metadata()?, &named.file)?;
        self.file.rewind()?;
        io::copy(&mut self.file, &mut named.file)?;
        named.file.sync_all()?;
        *self = named;
        Ok(())
    }

    /// Replaces an existing file. Returns the new file, still open and locked.
    pub(crate) fn replace(mut self, target: &Path) -> io::Result<File> {
        fs::rename(self.name()?, target)?;
        self.path = None;
        self.file.try_clone()
    }

    /// Replaces an existing file like [`DraftFile::replace`], and keeps that file under the name of
    /// the draft. `held` is the file to be replaced, open and locked. The second value is `None` if
    /// the file system cannot exchange two names: the old file is then lost.
    pub(super) fn exchange(
        mut self,
        target: &Path,
        held: File,
    ) -> io::Result<(File, Option<ReplacedFile>)> {
        let path = self.name()?;
        if renameat_with(CWD, &path, CWD, target, RenameFlags::EXCHANGE).is_err() {
            return Ok((self.replace(target)?, None));
        }
        self.path = None;
        let replaced = ReplacedFile {
            path,
            target: target.to_owned(),
            _held: held,
        };
        Ok((self.file.try_clone()?, Some(replaced)))
    }

    /// Moves to a name that must not exist yet. Returns the file, still open and locked.
    pub(super) fn appear(mut self, target: &Path) -> io::Result<File> {
        if self.path.is_none() {
            match link(&self.file, target) {
                Ok(()) => return self.file.try_clone(),
                Err(Errno::EXIST) => return Err(Errno::EXIST.into()),
                Err(_) => {}
            }
        }
        let path = self.name()?;
        match renameat_with(CWD, &path, CWD, target, RenameFlags::NOREPLACE) {
            // Some file systems do not support this. A hard link followed by a removal does not
            // replace a file either.
            Err(Errno::INVAL | Errno::NOSYS) => {
                fs::hard_link(&path, target)?;
                fs::remove_file(&path)?;
            }
            done => done?,
        }
        self.path = None;
        self.file.try_clone()
    }
}

impl Drop for DraftFile {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            // The next sweep removes what cannot be removed now.
            let _ = fs::remove_file(path);
        }
    }
}

/// An old file that can take its name back from the file that replaced it; removed if it is dropped.
#[derive(Debug)]
pub(crate) struct ReplacedFile {
    path: PathBuf,
    target: PathBuf,
    /// Keeps the lock, without which another process would remove the file as abandoned.
    _held: File,
}

impl ReplacedFile {
    /// Gives the old file its name back. The file that replaced it is removed.
    pub(crate) fn restore(self) -> io::Result<()> {
        // Afterwards nothing is left to be removed by `drop`.
        fs::rename(&self.path, &self.target)
    }
}

impl Drop for ReplacedFile {
    fn drop(&mut self) {
        // The next sweep removes what cannot be removed now.
        let _ = fs::remove_file(&self.path);
    }
}

/// Returns two numbers, of this process and of a file, that no other current file of krank has.
pub(super) fn next_numbers() -> String {
    static NUMBER: AtomicU32 = AtomicU32::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    format!("{}-{number}", std::process::id())
}

fn next_name() -> String {
    format!("{BEGINS}{}{ENDS}", next_numbers())
}

/// Creates a file without a name; returns `None` if the system has no such files or could not name
/// them later.
#[cfg(any(target_os = "linux", target_os = "android"))]
fn unnamed(folder: &Path, mode: Mode) -> Option<File> {
    let flags = OFlags::RDWR | OFlags::TMPFILE | OFlags::CLOEXEC;
    let file = File::from(open(folder, flags, mode).ok()?);
    let is_linkable = fs::metadata(descriptor(&file)).is_ok();
    (is_linkable && lock::take(&file) != LockOutcome::HeldElsewhere).then_some(file)
}

#[cfg(not(any(target_os = "linux", target_os = "android")))]
fn unnamed(_: &Path, _: Mode) -> Option<File> {
    None
}

/// Returns the path of an open file in `/proc`.
fn descriptor(file: &File) -> String {
    format!("/proc/self/fd/{}", file.as_raw_fd())
}

/// Gives a file without a name its first one. An existing file is not replaced.
fn link(file: &File, path: &Path) -> Result<(), Errno> {
    linkat(CWD, descriptor(file), CWD, path, AtFlags::SYMLINK_FOLLOW)
}

/// Removes drafts left by processes that no longer run.
fn sweep(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten();
    for entry in entries.take(MAX_ENTRIES).flatten() {
        let name = entry.file_name();
        if is_name(name.as_encoded_bytes()) {
            sweep_one(&entry);
        }
    }
}

/// Returns `true` for the name of a draft: it contains two numbers, of the process and of the
/// draft.
fn is_name(name: &[u8]) -> bool {
    let between = name.strip_prefix(BEGINS.as_bytes());
    let between = between.and_then(|rest| rest.strip_suffix(ENDS.as_bytes()));
    let mut numbers = between.unwrap_or_default().split(|&byte| byte == b'-');
    let is_number = |part: &[u8]| !part.is_empty() && part.iter().all(u8::is_ascii_digit);
    numbers.clone().count() == 2 && numbers.all(is_number)
}

/// Removes an abandoned draft, identified beyond doubt: an unlocked regular file of this user. As
/// root it also removes drafts of other users, because a draft may already have been given to its
/// future owner.
fn sweep_one(entry: &DirEntry) {
    let path = entry.path();
    let flags = OFlags::RDONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
    let Some(file) = is_file
        .then(|| open(&path, flags, Mode::empty()).ok())
        .flatten()
    else {
        return;
    };
    let file = File::from(file);
    let person = geteuid();
    // The metadata is read after the lock is taken: its previous holder may have removed the file,
    // and another file may have its name now.
    let is_locked = lock::take(&file) == LockOutcome::Ours;
    let is_own = file.metadata().is_ok_and(|found| {
        found.nlink() == 1 && (person.is_root() || found.uid() == person.as_raw())
    });
    if is_own && is_locked {
        let _ = fs::remove_file(&path);
    }
}
