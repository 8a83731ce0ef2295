//! Writes a table row by row: what is written stays, whatever ends the program, and the next run resumes it.
//!
//! The file is locked while it grows. Before each write the program checks that its name still leads to it and that
//! nobody has changed its length: rows are never lost in silence.

use super::lock::{self, LockOutcome, is_at};
use super::{Output, Trouble};
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Lines at the beginning that are kept to be compared; the last one is, too.
const FIRST_LINES: u64 = 3;

/// A file that grows.
#[derive(Debug)]
pub(crate) struct GrowingFile {
    name: PathBuf,
    rows: Rows,
}

/// Where rows go.
#[derive(Debug)]
enum Rows {
    /// Beside an older file, until the first rows lie on the disk.
    First {
        output: Output,
        records: Option<PathBuf>,
    },
    /// Into the file, whose length is known.
    More { file: File, length: u64 },
    /// Nowhere: the first rows could not take their place.
    Failed,
}

/// What a file has that is to be gone on with.
#[derive(Debug)]
pub(crate) struct GrownFile {
    name: PathBuf,
    file: File,
    /// Where its last whole line ends.
    end: u64,
    /// Whole lines behind the head.
    pub(crate) lines: u64,
    /// Some of them with their number, from 0.
    pub(crate) samples: Vec<(u64, String)>,
}

impl GrowingFile {
    /// Creates a file that begins with `head`. An older one keeps its place until the first rows are written.
    ///
    /// # Errors
    /// Another process is writing the file, or what the system says.
    pub(crate) fn begin(
        name: &Path,
        head: &str,
        records: Option<PathBuf>,
    ) -> Result<GrowingFile, Trouble> {
        let mut output = Output::to(name, records.as_deref())?;
        output.write_all(head.as_bytes())?;
        Ok(GrowingFile {
            name: name.to_owned(),
            rows: Rows::First { output, records },
        })
    }

    /// Appends whole lines.
    ///
    /// # Errors
    /// Somebody has deleted, replaced or changed the file, or what the system says.
    pub(crate) fn write(&mut self, lines: &str) -> Result<(), Trouble> {
        self.check()?;
        match &mut self.rows {
            Rows::First { output, .. } => {
                output.write_all(lines.as_bytes())?;
                self.take_place()
            }
            Rows::More { file, length } => {
                file.write_all(lines.as_bytes())?;
                *length += length_of(lines);
                Ok(())
            }
            Rows::Failed => Err(Trouble::Disturbed),
        }
    }

    /// Ensures that all rows lie on the disk, under the name of the file.
    ///
    /// # Errors
    /// Somebody has deleted, replaced or changed the file, or what the system says.
    pub(crate) fn finish(mut self) -> Result<(), Trouble> {
        if let Rows::First { .. } = self.rows {
            self.take_place()?;
        }
        if let Rows::More { file, .. } = &self.rows {
            file.sync_all()?;
        }
        self.check()
    }

    /// Returns `true` if no other process can add rows meanwhile; some network disks have no locks.
    pub(crate) fn is_locked(&self) -> bool {
        match &self.rows {
            Rows::First { output, .. } => output.is_locked(),
            Rows::More { file, .. } => lock::take(file) == LockOutcome::Ours,
            Rows::Failed => false,
        }
    }

    /// The first rows take the place of an older file.
    fn take_place(&mut self) -> Result<(), Trouble> {
        if let Rows::First { output, records } = std::mem::replace(&mut self.rows, Rows::Failed) {
            let file = output.commit(records.as_deref())?;
            self.rows = Rows::More {
                length: file.metadata()?.len(),
                file: appending(file)?,
            };
        }
        Ok(())
    }

    fn check(&self) -> Result<(), Trouble> {
        match &self.rows {
            Rows::More { file, length }
                if !is_at(file, &self.name) || file.metadata()?.len() != *length =>
            {
                Err(Trouble::Disturbed)
            }
            Rows::First { .. } | Rows::More { .. } | Rows::Failed => Ok(()),
        }
    }
}

fn length_of(lines: &str) -> u64 {
    u64::try_from(lines.len()).unwrap_or(u64::MAX)
}

/// Makes every write go to the end of a file: a truncated one never gets a hole.
#[cfg(unix)]
fn appending(file: File) -> io::Result<File> {
    rustix::fs::fcntl_setfl(&file, rustix::fs::OFlags::APPEND)?;
    Ok(file)
}

#[cfg(not(unix))]
fn appending(mut file: File) -> io::Result<File> {
    file.seek(io::SeekFrom::End(0))?;
    Ok(file)
}

impl GrownFile {
    /// What a file holds behind its head; `None` where it has another one. A file that is not there, and one that was
    /// cut off within its head, has no lines.
    ///
    /// # Errors
    /// Another process is writing the file, or what the system says.
    pub(crate) fn open(path: &Path, head: &str) -> Result<Option<GrownFile>, Trouble> {
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let file = options.open(path)?;
        if lock::take(&file) == LockOutcome::Others || !is_at(&file, path) {
            return Err(Trouble::Busy);
        }
        let mut reader = BufReader::new(file);
        let mut begin = Vec::new();
        let most = u64::try_from(head.len()).unwrap_or(u64::MAX);
        reader.by_ref().take(most).read_to_end(&mut begin)?;
        if !head.as_bytes().starts_with(&begin) {
            return Ok(None);
        }
        let mut grown = GrownFile {
            name: path.to_owned(),
            file: reader.get_ref().try_clone()?,
            end: most,
            lines: 0,
            samples: Vec::new(),
        };
        if begin.len() < head.len() {
            grown.file.set_len(0)?;
            grown.file.rewind()?;
            grown.file.write_all(head.as_bytes())?;
            return Ok(Some(grown));
        }
        grown.count(reader)?;
        Ok(Some(grown))
    }

    fn count(&mut self, mut from: impl BufRead) -> io::Result<()> {
        let (mut line, mut last) = (Vec::new(), Vec::new());
        loop {
            line.clear();
            let read = from.read_until(b'\n', &mut line)?;
            if line.last() != Some(&b'\n') {
                break;
            }
            if self.lines < FIRST_LINES {
                let text = String::from_utf8_lossy(&line).into_owned();
                self.samples.push((self.lines, text));
            }
            std::mem::swap(&mut line, &mut last);
            self.lines += 1;
            self.end += u64::try_from(read).unwrap_or_default();
        }
        if let Some(number) = self.lines.checked_sub(1).filter(|&k| k >= FIRST_LINES) {
            let text = String::from_utf8_lossy(&last).into_owned();
            self.samples.push((number, text));
        }
        Ok(())
    }

    /// Goes on behind the last whole line; what was written of another one is cut off.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn go_on(self) -> Result<GrowingFile, Trouble> {
        self.file.set_len(self.end)?;
        Ok(GrowingFile {
            name: self.name,
            rows: Rows::More {
                file: appending(self.file)?,
                length: self.end,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_was_cut_off_is_written_again() {
        let name = format!("krank-growing-{}.csv", std::process::id());
        let path = std::env::temp_dir().join(name);
        let whole = "head\n0\n1\n2\n3\n4\n";
        for cut in 0..=whole.len() {
            fs::write(&path, &whole[..cut]).unwrap();
            let grown = GrownFile::open(&path, "head\n").unwrap().unwrap();
            let lines = whole[..cut].lines().count().saturating_sub(1) as u64;
            let is_cut = cut > 5 && !whole[..cut].ends_with('\n');
            assert_eq!(grown.lines, lines - u64::from(is_cut), "{cut}");
            for (number, line) in &grown.samples {
                assert_eq!(*line, format!("{number}\n"));
            }
            let from = grown.lines;
            let mut file = grown.go_on().unwrap();
            for k in from..5 {
                file.write(&format!("{k}\n")).unwrap();
            }
            file.finish().unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), whole, "{cut}");
        }
        fs::write(&path, "hear\n0\n").unwrap();
        assert!(GrownFile::open(&path, "head\n").unwrap().is_none());
        fs::remove_file(&path).unwrap();
    }
}
