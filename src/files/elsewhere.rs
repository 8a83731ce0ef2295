//! Writing files where there is no Unix: beside the one whose place the new one takes, and no more than that.
//! There is no workbench there, and what it asks of files beyond this neither.

use super::Trouble;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file that is being written. Dropped before it is committed, it leaves everything as it was.
#[derive(Debug)]
pub(crate) struct Output {
    /// `None` once it has its place.
    draft: Option<File>,
    beside: PathBuf,
    target: PathBuf,
}

impl Output {
    /// Begins to write to a file.
    ///
    /// # Errors
    /// What the system says, or that it is a read-only file.
    pub(crate) fn to(name: &Path, _records: Option<&Path>) -> Result<Output, Trouble> {
        if fs::metadata(name).is_ok_and(|found| found.permissions().readonly()) {
            return Err(Trouble::ReadOnly);
        }
        let mut beside = OsString::from(name);
        beside.push(format!(".krank-{}", std::process::id()));
        let beside = PathBuf::from(beside);
        Ok(Output {
            draft: Some(File::create_new(&beside)?),
            beside,
            target: name.to_owned(),
        })
    }

    /// Returns `true` if a name leads to something that no file replaces.
    pub(crate) fn is_stream(name: &Path) -> bool {
        fs::metadata(name).is_ok_and(|found| !found.is_file())
    }

    /// Returns `true` if no other process writes the file meanwhile.
    pub(crate) fn is_locked(&self) -> bool {
        false
    }

    /// Everything was written: it becomes what the file holds. Returns the file.
    ///
    /// # Errors
    /// What the system says; then nothing has changed.
    pub(crate) fn commit(mut self, _records: Option<&Path>) -> Result<File, Trouble> {
        if let Some(draft) = &self.draft {
            draft.sync_all()?;
            fs::rename(&self.beside, &self.target)?;
            self.draft = None;
        }
        Ok(File::options().append(true).open(&self.target)?)
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if self.draft.take().is_some() {
            // It was not wanted; there is nobody to tell.
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

/// Nothing is ever written into a file in its place here.
pub(crate) fn mend(_records: &Path) -> Vec<PathBuf> {
    Vec::new()
}
