//! Writes files atomically: afterwards a file is complete or unchanged.

use super::WriteError;
#[cfg(feature = "tui")]
use super::bounded_read;
use super::bounded_read::open_file;
use super::fingerprint::Stamp;
use super::in_place::{create_private_folder, write_into};
use super::lock::{self, LockOutcome};
use super::target::Target;
use super::temporary::{DraftFile, ReplacedFile};
use rustix::fs::OFlags;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// A file being written. If it is dropped before it is committed, nothing changes.
#[derive(Debug)]
pub(crate) struct Output {
    way: OutputMode,
    old: Option<OldFile>,
}

/// An existing file to be replaced. It is locked, so that a process that appends rows to it is not
/// disturbed, and a second process that would replace it fails.
#[derive(Debug)]
struct OldFile {
    file: File,
    path: PathBuf,
    stamp: Option<Stamp>,
}

#[derive(Debug)]
enum OutputMode {
    /// Not a regular file: written directly, because there is nothing to preserve.
    Stream(File),
    /// A new file.
    New { draft: DraftFile, target: PathBuf },
    /// A draft that will replace an existing file.
    Over { draft: DraftFile, target: PathBuf },
    /// An existing file that will be written in place.
    Into {
        draft: DraftFile,
        target: PathBuf,
        folder: PathBuf,
    },
}

impl Output {
    /// Starts to write to the target of a name; pipes and devices are allowed. `records` is the
    /// folder for records of files written in place.
    ///
    /// # Errors
    /// Returns an I/O error, or an error if the file is read-only.
    pub(crate) fn to(name: &Path, records: Option<&Path>) -> Result<Output, WriteError> {
        let target = Target::find(name)?;
        if target.is_read_only() {
            return Err(WriteError::ReadOnly);
        }
        Output::of(target, records)
    }

    fn of(target: Target, records: Option<&Path>) -> Result<Output, WriteError> {
        let old = match &target {
            Target::File(path, _) => Some(OldFile {
                file: lock::hold(path)?,
                path: path.clone(),
                stamp: Stamp::of(path),
            }),
            Target::New(_) | Target::Stream(_) => None,
        };
        let way = OutputMode::to(target, records)?;
        Ok(Output { way, old })
    }

    /// Returns `true` if a name leads to a pipe, a device or an open descriptor, which cannot be
    /// replaced.
    pub(crate) fn is_stream(name: &Path) -> bool {
        matches!(Target::find(name), Ok(Target::Stream(_)))
    }

    /// Returns `true` if no other process of krank can write the file in the meantime; some network
    /// file systems have no locks.
    pub(crate) fn is_locked(&self) -> bool {
        let file = match (&self.old, &self.way) {
            (Some(old), _) => &old.file,
            (None, OutputMode::New { draft, .. }) => &draft.file,
            (None, OutputMode::Stream(_) | OutputMode::Over { .. } | OutputMode::Into { .. }) => {
                return false;
            }
        };
        lock::take(file) == LockOutcome::Ours
    }

    /// Replaces the content of the file by the written text. Returns the file, which stays locked
    /// while it is open.
    ///
    /// # Errors
    /// Returns an I/O error, or an error if the file was changed in the meantime; it is then
    /// unchanged.
    pub(crate) fn commit(self, records: Option<&Path>) -> Result<File, WriteError> {
        self.prepare()?;
        self.take_place(records, false)
            .map(|(file, _)| file)
            .map_err(appeared)
    }

    /// Commits, and keeps the file that is replaced. The second value is `None` if there is none,
    /// or if the file system cannot keep it.
    ///
    /// # Errors
    /// See [`Output::commit`].
    pub(crate) fn commit_reversibly(
        self,
        records: Option<&Path>,
    ) -> Result<(File, Option<ReplacedFile>), WriteError> {
        self.prepare()?;
        self.take_place(records, true).map_err(appeared)
    }

    /// Ensures that the draft is on the disk, and that the file to be replaced has not changed.
    fn prepare(&self) -> Result<(), WriteError> {
        self.sync()?;
        if let Some(OldFile { path, stamp, .. }) = &self.old
            && let (Some(then), Some(now)) = (stamp, Stamp::of(path))
            && !now.has_text_of(then)
        {
            return Err(WriteError::Changed);
        }
        Ok(())
    }

    /// Ensures that a draft that will replace a file is on the disk.
    fn sync(&self) -> io::Result<()> {
        match &self.way {
            // A text written in place is on the disk in its record.
            OutputMode::Stream(_) | OutputMode::Into { .. } => Ok(()),
            OutputMode::New { draft, .. } | OutputMode::Over { draft, .. } => draft.file.sync_all(),
        }
    }

    /// Writes the text to its target. `keeps_old` keeps a file that is replaced.
    fn take_place(
        self,
        records: Option<&Path>,
        keeps_old: bool,
    ) -> Result<(File, Option<ReplacedFile>), WriteError> {
        let Output { way, old } = self;
        let old = old.map(|old| old.file).ok_or(WriteError::Changed);
        match way {
            OutputMode::Stream(mut file) => {
                file.flush()?;
                Ok((file, None))
            }
            OutputMode::New { draft, target } => {
                let file = draft.appear(&target).map_err(|e| match e.kind() {
                    ErrorKind::AlreadyExists => WriteError::Exists,
                    _ => e.into(),
                })?;
                sync_folder_of(&target);
                Ok((file, None))
            }
            OutputMode::Over { draft, target } => {
                let (old, mut text) = (old?, draft.file.try_clone()?);
                let replaced = match keeps_old {
                    true => draft.exchange(&target, old.try_clone()?),
                    false => draft.replace(&target).map(|file| (file, None)),
                };
                match replaced {
                    Ok(written) => {
                        sync_folder_of(&target);
                        Ok(written)
                    }
                    // A file of another user in a sticky folder, or a file that is itself a mount
                    // point.
                    Err(e) if is_denied(&e) => {
                        let records = records.ok_or(WriteError::NoJournal)?;
                        write_into(&target, &mut text, records)?;
                        Ok((old, None))
                    }
                    Err(e) => Err(e.into()),
                }
            }
            OutputMode::Into {
                mut draft,
                target,
                folder,
            } => {
                write_into(&target, &mut draft.file, &folder)?;
                Ok((old?, None))
            }
        }
    }
}

impl OutputMode {
    fn to(target: Target, records: Option<&Path>) -> Result<OutputMode, WriteError> {
        Ok(match target {
            Target::Stream(path) => {
                // Append, because the shell may have opened the file and its content must stay.
                OutputMode::Stream(File::options().append(true).open(path)?)
            }
            Target::New(target) => OutputMode::New {
                draft: DraftFile::new(folder_of(&target))?,
                target,
            },
            Target::File(target, found) => match draft_for(&target, &found)? {
                Some(draft) => OutputMode::Over { draft, target },
                None => {
                    let folder = records.ok_or(WriteError::NoJournal)?.to_owned();
                    create_private_folder(&folder)?;
                    let draft = DraftFile::private(&folder)?;
                    OutputMode::Into {
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
            OutputMode::Stream(file) => file.write(bytes),
            OutputMode::New { draft, .. }
            | OutputMode::Over { draft, .. }
            | OutputMode::Into { draft, .. } => draft.file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Creates a draft with all metadata of the file; returns `None` if the file would lose something
/// by replacement, or if its folder accepts no new file.
fn draft_for(target: &Path, found: &Metadata) -> Result<Option<DraftFile>, WriteError> {
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

/// Names the cause if a file exists that did not exist when the output began.
fn appeared(error: WriteError) -> WriteError {
    match error {
        WriteError::Exists => WriteError::Appeared,
        other => other,
    }
}

fn is_denied(error: &io::Error) -> bool {
    let kind = error.kind();
    matches!(kind, ErrorKind::PermissionDenied | ErrorKind::ResourceBusy)
}

fn folder_of(target: &Path) -> &Path {
    target.parent().unwrap_or(Path::new("/"))
}

/// Syncs the folder, so that the new file survives a power failure. Errors are ignored: the file is
/// written in any case.
fn sync_folder_of(target: &Path) {
    let _ = File::open(folder_of(target)).and_then(|folder| folder.sync_all());
}

/// A request to save a file.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Saving<'a> {
    pub(crate) to: &'a Path,
    /// The folder for records of files written in place.
    pub(crate) records: Option<&'a Path>,
    /// Whether writing a read-only file was confirmed.
    pub(crate) overwrites_read_only: bool,
    /// Maximum number of bytes read from an existing file; one more is read to detect a longer
    /// file.
    pub(crate) most: usize,
}

/// Saves a file. `compose` computes the new content from the current one, if the file exists, or
/// returns the reason not to write. No other process that saves in this way can intervene.
///
/// # Errors
/// Returns the reason why nothing was written.
#[cfg(feature = "tui")]
pub(crate) fn save(
    saving: Saving<'_>,
    compose: impl FnOnce(Option<Vec<u8>>) -> Result<Vec<u8>, WriteError>,
) -> Result<(), WriteError> {
    let path = match Target::find(saving.to)? {
        Target::Stream(path) => return Err(Target::no_file(&path)),
        Target::New(path) | Target::File(path, _) => path,
    };
    let _lock = lock::of_folder(folder_of(&path))?;
    // The previous holder of the lock may have changed the target.
    let target = Target::find(&path)?;
    let before = Stamp::of(&path);
    let old = match &target {
        Target::File(path, _) => Some(bounded_read::read_file(path, saving.most)?),
        Target::New(_) => None,
        Target::Stream(path) => return Err(Target::no_file(path)),
    };
    let bytes = compose(old)?;
    if target.is_read_only() && !saving.overwrites_read_only {
        return Err(WriteError::ReadOnly);
    }
    let mut output = Output::of(target, saving.records)?;
    output.write_all(&bytes)?;
    // The slow part is finished before the check for changes by programs that do not use the lock.
    output.sync()?;
    if Stamp::of(&path) != before {
        return Err(WriteError::Changed);
    }
    output.take_place(saving.records, false).map(drop)
}
