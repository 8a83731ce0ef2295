//! Writing a file: it is whole, or what it was.

use super::Trouble;
use super::draft::DraftFile;
#[cfg(feature = "tui")]
use super::guard;
use super::guard::open_file;
use super::in_place::{make_private, write_into};
use super::lock::{self, LockOutcome};
use super::stamp::Stamp;
use super::target::Target;
use rustix::fs::OFlags;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// A file that is being written. Dropped before it is committed, it leaves everything as it was.
#[derive(Debug)]
pub(crate) struct Output {
    way: OutputWay,
    old: Option<OldFile>,
}

/// An existing file that is to be replaced. It is locked, so that a process that adds rows to it is not disturbed, and
/// a second one that would replace it is refused.
#[derive(Debug)]
struct OldFile {
    file: File,
    path: PathBuf,
    stamp: Option<Stamp>,
}

#[derive(Debug)]
enum OutputWay {
    /// To what is no file: there is nothing to keep.
    Stream(File),
    /// To a file that is not there yet.
    New { draft: DraftFile, target: PathBuf },
    /// In the place of a file.
    Over { draft: DraftFile, target: PathBuf },
    /// Into a file that keeps its place.
    Into {
        draft: DraftFile,
        target: PathBuf,
        folder: PathBuf,
    },
}

impl Output {
    /// Begins to write to what a name leads to, pipes and devices too. In `records` is kept what is not to be
    /// lost while a file is written in its place.
    ///
    /// # Errors
    /// What the system says, or that it is a read-only file.
    pub(crate) fn to(name: &Path, records: Option<&Path>) -> Result<Output, Trouble> {
        let target = Target::find(name)?;
        if target.is_read_only() {
            return Err(Trouble::ReadOnly);
        }
        Output::of(target, records)
    }

    fn of(target: Target, records: Option<&Path>) -> Result<Output, Trouble> {
        let old = match &target {
            Target::File(path, _) => Some(OldFile {
                file: lock::hold(path)?,
                path: path.clone(),
                stamp: Stamp::of(path),
            }),
            Target::New(_) | Target::Stream(_) => None,
        };
        let way = OutputWay::to(target, records)?;
        Ok(Output { way, old })
    }

    /// Returns `true` if a name leads to a pipe, a device or an open descriptor, which no file replaces.
    pub(crate) fn is_stream(name: &Path) -> bool {
        matches!(Target::find(name), Ok(Target::Stream(_)))
    }

    /// Returns `true` if no other process of krank writes the file meanwhile; some network disks have no locks.
    pub(crate) fn is_locked(&self) -> bool {
        let file = match (&self.old, &self.way) {
            (Some(old), _) => &old.file,
            (None, OutputWay::New { draft, .. }) => &draft.file,
            (None, OutputWay::Stream(_) | OutputWay::Over { .. } | OutputWay::Into { .. }) => {
                return false;
            }
        };
        lock::take(file) == LockOutcome::Ours
    }

    /// Everything was written: it becomes what the file holds. Returns the file, which stays locked while it is open.
    ///
    /// # Errors
    /// What the system says, or that the file has changed meanwhile; then nothing has changed.
    pub(crate) fn commit(self, records: Option<&Path>) -> Result<File, Trouble> {
        self.sync()?;
        if let Some(OldFile { path, stamp, .. }) = &self.old
            && let (Some(then), Some(now)) = (stamp, Stamp::of(path))
            && !now.has_text_of(then)
        {
            return Err(Trouble::Changed);
        }
        self.take_place(records)
    }

    /// A draft that is to take the place of a file lies on the disk.
    fn sync(&self) -> io::Result<()> {
        match &self.way {
            // What is written into a file lies on the disk in its record.
            OutputWay::Stream(_) | OutputWay::Into { .. } => Ok(()),
            OutputWay::New { draft, .. } | OutputWay::Over { draft, .. } => draft.file.sync_all(),
        }
    }

    fn take_place(self, records: Option<&Path>) -> Result<File, Trouble> {
        let Output { way, old } = self;
        let kept = || old.map(|old| old.file).ok_or(Trouble::Changed);
        match way {
            OutputWay::Stream(mut file) => {
                file.flush()?;
                Ok(file)
            }
            OutputWay::New { draft, target } => {
                let file = draft.appear(&target).map_err(|e| match e.kind() {
                    ErrorKind::AlreadyExists => Trouble::Exists,
                    _ => e.into(),
                })?;
                sync_folder_of(&target);
                Ok(file)
            }
            OutputWay::Over { draft, target } => {
                let mut text = draft.file.try_clone()?;
                match draft.replace(&target) {
                    Ok(file) => {
                        sync_folder_of(&target);
                        Ok(file)
                    }
                    // Somebody else's in a sticky folder; a file that is itself a mount.
                    Err(e) if is_denied(&e) => {
                        let records = records.ok_or(Trouble::NoJournal)?;
                        write_into(&target, &mut text, records)?;
                        kept()
                    }
                    Err(e) => Err(e.into()),
                }
            }
            OutputWay::Into {
                mut draft,
                target,
                folder,
            } => {
                write_into(&target, &mut draft.file, &folder)?;
                kept()
            }
        }
    }
}

impl OutputWay {
    fn to(target: Target, records: Option<&Path>) -> Result<OutputWay, Trouble> {
        Ok(match target {
            Target::Stream(path) => {
                // Where the shell has opened a file for us, what it holds so far stays.
                OutputWay::Stream(File::options().append(true).open(path)?)
            }
            Target::New(target) => OutputWay::New {
                draft: DraftFile::new(folder_of(&target))?,
                target,
            },
            Target::File(target, found) => match beside(&target, &found)? {
                Some(draft) => OutputWay::Over { draft, target },
                None => {
                    let folder = records.ok_or(Trouble::NoJournal)?.to_owned();
                    make_private(&folder)?;
                    let draft = DraftFile::private(&folder)?;
                    OutputWay::Into {
                        draft,
                        target,
                        folder,
                    }
                }
            },
        })
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.way {
            OutputWay::Stream(file) => file.write(bytes),
            OutputWay::New { draft, .. }
            | OutputWay::Over { draft, .. }
            | OutputWay::Into { draft, .. } => draft.file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A draft that has all that the file has; `None` where the file would lose something by it, or where its
/// folder takes none.
fn beside(target: &Path, found: &Metadata) -> Result<Option<DraftFile>, Trouble> {
    if found.nlink() > 1 {
        return Ok(None);
    }
    let old = open_file(target, OFlags::RDONLY | OFlags::NOFOLLOW)?;
    match DraftFile::like(folder_of(target), &old, found) {
        Ok(draft) => Ok(Some(draft)),
        Err(e) if matches!(e.kind(), ErrorKind::StorageFull | ErrorKind::QuotaExceeded) => {
            Err(e.into())
        }
        Err(_) => Ok(None),
    }
}

fn is_denied(error: &io::Error) -> bool {
    let kind = error.kind();
    matches!(kind, ErrorKind::PermissionDenied | ErrorKind::ResourceBusy)
}

fn folder_of(target: &Path) -> &Path {
    target.parent().unwrap_or(Path::new("/"))
}

/// After a loss of power the folder, too, is to know the new file. What cannot be synced is written anyway.
fn sync_folder_of(target: &Path) {
    let _ = File::open(folder_of(target)).and_then(|folder| folder.sync_all());
}

/// What is to be saved, and what a person has said about it.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Saving<'a> {
    pub(crate) to: &'a Path,
    /// Where texts are kept while a file is written in its place.
    pub(crate) records: Option<&'a Path>,
    /// A file that says that it is not to be written to is meant nevertheless.
    pub(crate) though_read_only: bool,
    /// Of a longer file only so much is looked at.
    pub(crate) most: usize,
}

/// Saves: what the file holds now, if there is one, makes what it is to hold, or why it is not written. Nobody
/// else who saves this way comes in between.
///
/// # Errors
/// Why nothing was written.
#[cfg(feature = "tui")]
pub(crate) fn save(
    saving: Saving<'_>,
    compose: impl FnOnce(Option<Vec<u8>>) -> Result<Vec<u8>, Trouble>,
) -> Result<(), Trouble> {
    let path = match Target::find(saving.to)? {
        Target::Stream(path) => return Err(Target::no_file(&path)),
        Target::New(path) | Target::File(path, _) => path,
    };
    let _lock = lock::of_folder(folder_of(&path))?;
    // Whoever had the lock before may have changed what is there.
    let target = Target::find(&path)?;
    let before = Stamp::of(&path);
    let old = match &target {
        Target::File(path, _) => Some(guard::read_file(path, saving.most)?),
        Target::New(_) => None,
        Target::Stream(path) => return Err(Target::no_file(path)),
    };
    let bytes = compose(old)?;
    if target.is_read_only() && !saving.though_read_only {
        return Err(Trouble::ReadOnly);
    }
    let mut output = Output::of(target, saving.records)?;
    output.write_all(&bytes)?;
    // What takes long is behind us when we look whether somebody who knows no lock has come in between.
    output.sync()?;
    if Stamp::of(&path) != before {
        return Err(Trouble::Changed);
    }
    output.take_place(saving.records).map(drop)
}
