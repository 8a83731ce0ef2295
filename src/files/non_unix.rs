//! Writes files on systems other than Unix: to a temporary file next to the target, which is then
//! renamed. The workbench and its further file operations do not exist there.

use super::WriteError;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file being written. If it is dropped before it is committed, nothing changes.
#[derive(Debug)]
pub(crate) struct Output {
    /// `None` after the commit.
    draft: Option<File>,
    beside: PathBuf,
    target: PathBuf,
}

impl Output {
    /// Starts to write a file.
    ///
    /// # Errors
    /// Returns an I/O error, or an error if the file is read-only.
    pub(crate) fn to(name: &Path, _records: Option<&Path>) -> Result<Output, WriteError> {
        if fs::metadata(name).is_ok_and(|found| found.permissions().readonly()) {
            return Err(WriteError::ReadOnly);
        }
        let mut nearby = OsString::from(name);
        nearby.push(format!(".krank-{}", std::process::id()));
        let nearby = PathBuf::from(nearby);
        Ok(Output {
            draft: Some(File::create_new(&nearby)?),
            beside: nearby,
            target: name.to_owned(),
        })
    }

    /// Returns `true` if a name leads to something other than a regular file, which cannot be
    /// replaced.
    pub(crate) fn is_stream(name: &Path) -> bool {
        fs::metadata(name).is_ok_and(|found| !found.is_file())
    }

    /// Returns `true` if no other process can write the file in the meantime.
    pub(crate) fn is_locked(&self) -> bool {
        false
    }

    /// Replaces the content of the file by the written text. Returns the file.
    ///
    /// # Errors
    /// Returns an I/O error; the file is then unchanged.
    pub(crate) fn commit(mut self, _records: Option<&Path>) -> Result<File, WriteError> {
        if let Some(draft) = &self.draft {
            draft.sync_all()?;
            fs::rename(&self.beside, &self.target)?;
            self.draft = None;
        }
        Ok(File::options().append(true).open(&self.target)?)
    }

    /// Commits; the file that is replaced is not kept.
    ///
    /// # Errors
    /// See [`Output::commit`].
    pub(crate) fn commit_reversibly(
        self,
        records: Option<&Path>,
    ) -> Result<(File, Option<ReplacedFile>), WriteError> {
        Ok((self.commit(records)?, None))
    }
}

/// A replaced file that was kept; never on these systems.
#[derive(Debug)]
pub(crate) enum ReplacedFile {}

impl ReplacedFile {
    /// Gives the old file its name back.
    pub(crate) fn restore(self) -> io::Result<()> {
        match self {}
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if self.draft.take().is_some() {
            // Errors are ignored: the output was abandoned, and drop cannot report them.
            let _ = fs::remove_file(&self.beside);
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.draft {
            Some(draft) => draft.write(bytes),
            None => Ok(0),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Does nothing: files are never written in place on these systems.
pub(crate) fn mend(_records: &Path) -> Vec<PathBuf> {
    Vec::new()
}
