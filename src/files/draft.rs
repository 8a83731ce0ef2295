//! A file that is written beside the one whose place it takes.
//!
//! Where the system supports it (`O_TMPFILE`), a draft has no name until it takes its place: a process that is killed
//! leaves nothing. Elsewhere it has a name from the start, and a lock that marks it as in use. A draft without a lock
//! was left by a killed process, and the next one that writes in this folder removes it.

use super::lock::{self, LockOutcome};
use super::rights;
use rustix::fs::{AtFlags, CWD, Mode, OFlags, RenameFlags, linkat, open, renameat_with};
use rustix::io::Errno;
use rustix::process::geteuid;
use std::fs::{self, DirEntry, File, Metadata};
use std::io::{self, Seek};
use std::os::fd::AsRawFd;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// What the names of drafts begin and end with. They are no longer than that, whatever the file is called.
const BEGINS: &str = ".krank-";
const ENDS: &str = ".part";
/// Who may what with a draft until it is given the rights of its file.
const PRIVATE: Mode = Mode::RUSR.union(Mode::WUSR);
/// With a new file: what the mask of the process leaves of it, before the first byte.
const NEW: Mode = Mode::from_raw_mode(0o666);
/// So many foreign files have the name that a draft was to have before we think that something is wrong.
const MOST_NAMES: u32 = 1000;
/// A folder with more in it is not searched for what was left.
const MOST_ENTRIES: usize = 10_000;

/// A file on the way; dropped before it has taken its place, it is taken away.
#[derive(Debug)]
pub(crate) struct DraftFile {
    /// To be written and read.
    pub(crate) file: File,
    folder: PathBuf,
    /// `None` while it has no name, and once it has taken its place.
    path: Option<PathBuf>,
}

impl DraftFile {
    /// For a new file in a folder.
    pub(super) fn new(folder: &Path) -> io::Result<DraftFile> {
        DraftFile::make(folder, NEW)
    }

    /// For a file of ours that is nobody else's business.
    pub(crate) fn private(folder: &Path) -> io::Result<DraftFile> {
        DraftFile::make(folder, PRIVATE)
    }

    /// In the place of an old file, with all that this has but its text.
    pub(super) fn like(folder: &Path, old: &File, has: &Metadata) -> io::Result<DraftFile> {
        let draft = DraftFile::make(folder, PRIVATE)?;
        rights::carry_over(old, has, &draft.file)?;
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

    /// A draft that has a name from the start.
    fn make_named(folder: &Path, mode: Mode) -> io::Result<DraftFile> {
        let flags = OFlags::RDWR | OFlags::CREATE | OFlags::EXCL | OFlags::CLOEXEC;
        for _ in 0..MOST_NAMES {
            let path = folder.join(next_name());
            let file = match open(&path, flags | OFlags::NOFOLLOW, mode) {
                Ok(file) => File::from(file),
                // Somebody else's: it stays.
                Err(Errno::EXIST) => continue,
                Err(error) => return Err(error.into()),
            };
            // Who sweeps here may have come before the lock; then this one is gone, or soon.
            if lock::take(&file) != LockOutcome::Others && file.metadata()?.nlink() > 0 {
                return Ok(DraftFile {
                    file,
                    folder: folder.to_owned(),
                    path: Some(path),
                });
            }
        }
        Err(Errno::EXIST.into())
    }

    /// Gives the draft a name, if it has none. Returns the name.
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
        for _ in 0..MOST_NAMES {
            let path = self.folder.join(next_name());
            match link(&self.file, &path) {
                Err(Errno::EXIST) => {}
                done => return done.map(|()| path).map_err(io::Error::from),
            }
        }
        Err(Errno::EXIST.into())
    }

    /// Continues with a named draft of the same content and rights: some systems open files without a name but refuse
    /// to name them later.
    fn copy_to_named(&mut self) -> io::Result<()> {
        let mut named = DraftFile::make_named(&self.folder, PRIVATE)?;
        rights::carry_over(&self.file, &self.file.metadata()?, &named.file)?;
        self.file.rewind()?;
        io::copy(&mut self.file, &mut named.file)?;
        named.file.sync_all()?;
        *self = named;
        Ok(())
    }

    /// Takes the place of an old file. The file that it is now stays open, and locked.
    pub(crate) fn replace(mut self, target: &Path) -> io::Result<File> {
        fs::rename(self.name()?, target)?;
        self.path = None;
        self.file.try_clone()
    }

    /// Takes its place where there is no file yet. The file stays open, and locked.
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
            // Some disks do not know how: under two names for a moment, it does not replace either.
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
            // What cannot be taken away now is swept by the next.
            let _ = fs::remove_file(path);
        }
    }
}

/// Returns two numbers, of this process and of a file, that no other file of ours has now.
pub(super) fn next_numbers() -> String {
    static NUMBER: AtomicU32 = AtomicU32::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    format!("{}-{number}", std::process::id())
}

fn next_name() -> String {
    format!("{BEGINS}{}{ENDS}", next_numbers())
}

/// Opens a file without a name; `None` where the system has no such files, or could not name them later.
#[cfg(any(target_os = "linux", target_os = "android"))]
fn unnamed(folder: &Path, mode: Mode) -> Option<File> {
    let flags = OFlags::RDWR | OFlags::TMPFILE | OFlags::CLOEXEC;
    let file = File::from(open(folder, flags, mode).ok()?);
    let is_linkable = fs::metadata(descriptor(&file)).is_ok();
    (is_linkable && lock::take(&file) != LockOutcome::Others).then_some(file)
}

#[cfg(not(any(target_os = "linux", target_os = "android")))]
fn unnamed(_: &Path, _: Mode) -> Option<File> {
    None
}

/// The name that an open file has in `/proc`.
fn descriptor(file: &File) -> String {
    format!("/proc/self/fd/{}", file.as_raw_fd())
}

/// Gives a file without a name its first one. An existing file is not replaced.
fn link(file: &File, path: &Path) -> Result<(), Errno> {
    linkat(CWD, descriptor(file), CWD, path, AtFlags::SYMLINK_FOLLOW)
}

/// Takes away the drafts of processes that are no more.
fn sweep(folder: &Path) {
    let entries = fs::read_dir(folder).into_iter().flatten();
    for entry in entries.take(MOST_ENTRIES).flatten() {
        let name = entry.file_name();
        if is_name(name.as_encoded_bytes()) {
            sweep_one(&entry);
        }
    }
}

/// Whether a draft is called so: two numbers, of the process and of the draft.
fn is_name(name: &[u8]) -> bool {
    let between = name.strip_prefix(BEGINS.as_bytes());
    let between = between.and_then(|rest| rest.strip_suffix(ENDS.as_bytes()));
    let mut numbers = between.unwrap_or_default().split(|&byte| byte == b'-');
    let is_number = |part: &[u8]| !part.is_empty() && part.iter().all(u8::is_ascii_digit);
    numbers.clone().count() == 2 && numbers.all(is_number)
}

/// Only what is ours beyond doubt: a file of this person's that nobody has locked. Root also leaves what has
/// been given to others already.
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
    // After the lock: whoever had it before may have taken the file away, and the name is another's now.
    let is_locked = lock::take(&file) == LockOutcome::Ours;
    let is_own = file.metadata().is_ok_and(|found| {
        found.nlink() == 1 && (person.is_root() || found.uid() == person.as_raw())
    });
    if is_own && is_locked {
        let _ = fs::remove_file(&path);
    }
}
