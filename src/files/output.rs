//! Writing a file: it is whole, or what it was.

use super::Trouble;
use super::draft::DraftFile;
use super::guard::open_file;
use super::in_place::{make_private, write_into};
use super::target::Target;
#[cfg(feature = "tui")]
use super::{Stamp, guard, lock};
use rustix::fs::OFlags;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Write};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

/// A file that is being written. Dropped before it is committed, it leaves everything as it was.
#[derive(Debug)]
pub(crate) struct Output(OutputWay);

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
        Ok(Output(match target {
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
        }))
    }

    /// Everything was written: it becomes what the file holds.
    ///
    /// # Errors
    /// What the system says; then nothing has changed.
    pub(crate) fn commit(self, records: Option<&Path>) -> Result<(), Trouble> {
        self.sync()?;
        self.take_place(records)
    }

    /// A draft that is to take the place of a file lies on the disk.
    fn sync(&self) -> io::Result<()> {
        match &self.0 {
            // What is written into a file lies on the disk in its record.
            OutputWay::Stream(_) | OutputWay::Into { .. } => Ok(()),
            OutputWay::New { draft, .. } | OutputWay::Over { draft, .. } => draft.file.sync_all(),
        }
    }

    fn take_place(self, records: Option<&Path>) -> Result<(), Trouble> {
        match self.0 {
            OutputWay::Stream(mut file) => file.flush()?,
            OutputWay::New { draft, target } => {
                draft.appear(&target)?;
                sync_folder_of(&target);
            }
            OutputWay::Over { draft, target } => {
                let mut kept = draft.file.try_clone()?;
                match draft.replace(&target) {
                    Ok(_) => sync_folder_of(&target),
                    // Somebody else's in a sticky folder; a file that is itself a mount.
                    Err(e) if is_denied(&e) => {
                        let records = records.ok_or(Trouble::NoJournal)?;
                        write_into(&target, &mut kept, records)?;
                    }
                    Err(e) => return Err(e.into()),
                }
            }
            OutputWay::Into {
                mut draft,
                target,
                folder,
            } => write_into(&target, &mut draft.file, &folder)?,
        }
        Ok(())
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
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
    output.take_place(saving.records)
}
