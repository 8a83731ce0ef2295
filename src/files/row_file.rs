//! Writes a table row by row. Written rows survive a killed program, and the next run resumes the
//! file.
//!
//! The file is locked while it grows. Before each write the program checks that its name still
//! leads to it and that its length is unchanged, so that rows are never lost silently.

use super::lock::{self, LockOutcome, is_at};
use super::{Output, ReplacedFile, WriteError};
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Number of first lines kept for comparison; the last line is kept too.
const FIRST_LINES: u64 = 3;

/// A file to which rows are appended.
#[derive(Debug)]
pub(crate) struct AppendFile {
    name: PathBuf,
    rows: RowTarget,
}

/// The target of rows.
#[derive(Debug)]
enum RowTarget {
    /// A draft next to an older file, until the first rows are on the disk.
    First {
        output: Box<Output>,
        records: Option<PathBuf>,
        length: u64,
    },
    /// The file itself, with its expected length in bytes.
    More {
        file: File,
        length: u64,
        /// The file that it replaced, until all rows are written.
        older: Option<ReplacedFile>,
    },
    /// No target, because rows could not be written.
    Failed,
}

/// An existing output file that can be resumed.
#[derive(Debug)]
pub(crate) struct ResumableFile {
    name: PathBuf,
    file: File,
    /// The end of its last complete line, in bytes.
    end: u64,
    /// The number of complete lines after the head.
    pub(crate) lines: u64,
    /// Some lines of the file with their numbers, from 0.
    pub(crate) samples: Vec<(u64, String)>,
}

impl AppendFile {
    /// Creates a file that begins with `head`. An older file is replaced when the first rows are
    /// written.
    ///
    /// # Errors
    /// Returns an error if another process is writing the file, or an I/O error.
    pub(crate) fn create(
        name: &Path,
        head: &str,
        records: Option<PathBuf>,
    ) -> Result<AppendFile, WriteError> {
        let mut output = Output::to(name, records.as_deref())?;
        output.write_all(head.as_bytes())?;
        Ok(AppendFile {
            name: name.to_owned(),
            rows: RowTarget::First {
                output: Box::new(output),
                records,
                length: length_of(head),
            },
        })
    }

    /// Appends complete lines.
    ///
    /// # Errors
    /// Returns an error if another process has deleted, replaced or changed the file, or an I/O
    /// error; an older file that the rows replaced is then restored.
    pub(crate) fn write(&mut self, lines: &str) -> Result<(), WriteError> {
        self.check()?;
        let written = self.append(lines);
        if written.is_err() {
            self.restore_older();
        }
        written
    }

    fn append(&mut self, lines: &str) -> Result<(), WriteError> {
        match &mut self.rows {
            RowTarget::First { output, length, .. } => {
                output.write_all(lines.as_bytes())?;
                *length += length_of(lines);
                self.take_place()
            }
            RowTarget::More { file, length, .. } => {
                file.write_all(lines.as_bytes())?;
                *length += length_of(lines);
                Ok(())
            }
            RowTarget::Failed => Err(WriteError::Disturbed),
        }
    }

    /// Restores the older file after a failed write, as on a full disk. Rows that replaced no file
    /// stay, and can be resumed.
    fn restore_older(&mut self) {
        if let RowTarget::More { older, .. } = &mut self.rows
            && let Some(older) = older.take()
            && older.restore().is_ok()
        {
            self.rows = RowTarget::Failed;
        }
    }

    /// Ensures that all rows are on the disk, under the name of the file.
    ///
    /// # Errors
    /// Returns an error if another process has deleted, replaced or changed the file, or an I/O
    /// error; an older file that the rows replaced is then restored.
    pub(crate) fn finish(mut self) -> Result<(), WriteError> {
        if let RowTarget::First { .. } = self.rows {
            self.take_place()?;
        }
        self.check()?;
        if let RowTarget::More { file, .. } = &self.rows
            && let Err(error) = file.sync_all()
        {
            self.restore_older();
            return Err(error.into());
        }
        Ok(())
    }

    /// Returns `true` if no other process can add rows in the meantime; some network file systems
    /// have no locks.
    pub(crate) fn is_locked(&self) -> bool {
        match &self.rows {
            RowTarget::First { output, .. } => output.is_locked(),
            RowTarget::More { file, .. } => lock::take(file) == LockOutcome::Ours,
            RowTarget::Failed => false,
        }
    }

    /// Replaces the older file once the first rows are written.
    fn take_place(&mut self) -> Result<(), WriteError> {
        let first = std::mem::replace(&mut self.rows, RowTarget::Failed);
        if let RowTarget::First {
            output,
            records,
            length,
        } = first
        {
            let (file, older) = output.commit_reversibly(records.as_deref())?;
            self.rows = RowTarget::More {
                file: appending(file)?,
                length,
                older,
            };
        }
        Ok(())
    }

    fn check(&self) -> Result<(), WriteError> {
        match &self.rows {
            RowTarget::More { file, length, .. }
                if !is_at(file, &self.name) || file.metadata()?.len() != *length =>
            {
                Err(WriteError::Disturbed)
            }
            RowTarget::First { .. } | RowTarget::More { .. } | RowTarget::Failed => Ok(()),
        }
    }
}

fn length_of(lines: &str) -> u64 {
    u64::try_from(lines.len()).unwrap_or(u64::MAX)
}

/// Makes every write append to the file: if another process truncates it, no hole results.
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

impl ResumableFile {
    /// Opens a file and reads the lines after its head; returns `None` if it has another head. A
    /// missing file, or one truncated within its head, has no lines.
    ///
    /// # Errors
    /// Returns an error if another process is writing the file, or an I/O error.
    pub(crate) fn open(path: &Path, head: &str) -> Result<Option<ResumableFile>, WriteError> {
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let file = options.open(path)?;
        if lock::take(&file) == LockOutcome::HeldElsewhere || !is_at(&file, path) {
            return Err(WriteError::Busy);
        }
        let mut reader = BufReader::new(file);
        let mut start = Vec::new();
        let maximum = u64::try_from(head.len()).unwrap_or(u64::MAX);
        reader.by_ref().take(maximum).read_to_end(&mut start)?;
        if !head.as_bytes().starts_with(&start) {
            return Ok(None);
        }
        let mut grown = ResumableFile {
            name: path.to_owned(),
            file: reader.get_ref().try_clone()?,
            end: maximum,
            lines: 0,
            samples: Vec::new(),
        };
        if start.len() < head.len() {
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

    /// Resumes after the last complete line; an incomplete one is removed.
    ///
    /// # Errors
    /// Returns an I/O error.
    pub(crate) fn resume(self) -> Result<AppendFile, WriteError> {
        self.file.set_len(self.end)?;
        Ok(AppendFile {
            name: self.name,
            rows: RowTarget::More {
                file: appending(self.file)?,
                length: self.end,
                older: None,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn place(name: &str) -> PathBuf {
        let name = format!("krank-growing-{name}-{}.csv", std::process::id());
        std::env::temp_dir().join(name)
    }

    #[test]
    fn old_file_stays_until_first_rows_are_written() {
        let path = place("old");
        for is_linked in [false, true] {
            let records = place("records");
            let second = place("second");
            fs::write(&path, "old").unwrap();
            if is_linked {
                fs::hard_link(&path, &second).unwrap();
            }
            let start = || AppendFile::create(&path, "head\n", Some(records.clone())).unwrap();
            drop(start());
            assert_eq!(fs::read_to_string(&path).unwrap(), "old");
            let mut file = start();
            assert_eq!(fs::read_to_string(&path).unwrap(), "old");
            file.write("0\n").unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), "head\n0\n");
            file.write("1\n").unwrap();
            assert!(file.is_locked());
            file.finish().unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), "head\n0\n1\n");
            if is_linked {
                assert_eq!(fs::read_to_string(&second).unwrap(), "head\n0\n1\n");
                fs::remove_file(&second).unwrap();
                fs::remove_dir_all(&records).unwrap();
            }
        }
        write_without_rows(&path);
        fs::remove_file(&path).unwrap();
    }

    /// Writes a file without rows, as a study without designs does.
    fn write_without_rows(path: &Path) {
        let file = AppendFile::create(path, "head\n", None).unwrap();
        file.finish().unwrap();
        assert_eq!(fs::read_to_string(path).unwrap(), "head\n");
    }

    /// Regression: a disk that filled while rows were appended cost the older file. The error here
    /// is that of a file that is open for reading only.
    #[test]
    fn failed_write_restores_the_older_file() {
        let folder = place("restored").with_extension("folder");
        fs::create_dir(&folder).unwrap();
        let path = folder.join("rows.csv");
        let fail = |file: &mut AppendFile| {
            let RowTarget::More { file, .. } = &mut file.rows else {
                panic!("no rows were written");
            };
            *file = File::open(&path).unwrap();
        };
        for is_old in [true, false] {
            if is_old {
                fs::write(&path, "old").unwrap();
            }
            let mut file = AppendFile::create(&path, "head\n", None).unwrap();
            file.write("0\n").unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), "head\n0\n");
            fail(&mut file);
            assert!(matches!(file.write("1\n"), Err(WriteError::Io(_))));
            drop(file);
            // Rows of a new file stay for a later run.
            let left = if is_old { "old" } else { "head\n0\n" };
            assert_eq!(fs::read_to_string(&path).unwrap(), left);
            fs::remove_file(&path).unwrap();
            assert_eq!(fs::read_dir(&folder).unwrap().count(), 0, "{is_old}");
        }
        fs::write(&path, "old").unwrap();
        let mut file = AppendFile::create(&path, "head\n", None).unwrap();
        file.write("0\n").unwrap();
        file.finish().unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "head\n0\n");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    /// Regression: rows were written to a deleted file, or after a hole in a truncated one.
    #[test]
    fn disturbed_file_gets_no_more_rows() {
        type FileOperation = fn(&Path);
        let actions: [(FileOperation, Option<&str>); 4] = [
            (|path| fs::write(path, "").unwrap(), Some("")),
            (|path| fs::remove_file(path).unwrap(), None),
            (
                |path| {
                    fs::remove_file(path).unwrap();
                    fs::write(path, "head\n0\n").unwrap();
                },
                Some("head\n0\n"),
            ),
            (
                |path| {
                    let mut file = OpenOptions::new().append(true).open(path).unwrap();
                    file.write_all(b"foreign\n").unwrap();
                },
                Some("head\n0\nforeign\n"),
            ),
        ];
        for (number, (deed, left)) in actions.into_iter().enumerate() {
            for is_resumed in [false, true] {
                let path = place(&format!("disturbed-{number}-{is_resumed}"));
                let mut file = AppendFile::create(&path, "head\n", None).unwrap();
                file.write("0\n").unwrap();
                if is_resumed {
                    file.finish().unwrap();
                    let grown = ResumableFile::open(&path, "head\n").unwrap().unwrap();
                    assert_eq!(grown.lines, 1);
                    file = grown.resume().unwrap();
                }
                deed(&path);
                let refused = file.write("1\n");
                assert!(matches!(refused, Err(WriteError::Disturbed)), "{refused:?}");
                let refused = file.finish();
                assert!(matches!(refused, Err(WriteError::Disturbed)), "{refused:?}");
                assert_eq!(fs::read_to_string(&path).ok().as_deref(), left);
                let _ = fs::remove_file(&path);
            }
        }
    }

    #[test]
    fn truncated_file_resumes_after_last_complete_row() {
        let path = place("cut");
        let text = "head\n0\n1\n2\n3\n4\n";
        for cut in 0..=text.len() {
            fs::write(&path, &text[..cut]).unwrap();
            let grown = ResumableFile::open(&path, "head\n").unwrap().unwrap();
            let lines = text[..cut].lines().count().saturating_sub(1) as u64;
            let is_cut = cut > 5 && !text[..cut].ends_with('\n');
            assert_eq!(grown.lines, lines - u64::from(is_cut), "{cut}");
            for (number, line) in &grown.samples {
                assert_eq!(*line, format!("{number}\n"));
            }
            let from = grown.lines;
            let mut file = grown.resume().unwrap();
            for k in from..5 {
                file.write(&format!("{k}\n")).unwrap();
            }
            file.finish().unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text, "{cut}");
        }
        fs::write(&path, "hear\n0\n").unwrap();
        assert!(ResumableFile::open(&path, "head\n").unwrap().is_none());
        fs::remove_file(&path).unwrap();
    }
}
