//! A file that grows line by line: what is written stays, whatever ends the program, and the next run goes on with it.

use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Lines at the beginning that are kept to be compared; the last one is, too.
const FIRST_LINES: u64 = 3;

/// A file that grows.
#[derive(Debug)]
pub(crate) struct GrowingFile(File);

/// What a file has that is to be gone on with.
#[derive(Debug)]
pub(crate) struct GrownFile {
    file: File,
    /// Where its last whole line ends.
    end: u64,
    /// Whole lines behind the head.
    pub(crate) lines: u64,
    /// Some of them with their number, from 0.
    pub(crate) samples: Vec<(u64, String)>,
}

impl GrowingFile {
    /// A file that begins with `head`; what it held is gone.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn begin(path: &Path, head: &str) -> io::Result<GrowingFile> {
        let mut file = GrowingFile(File::create(path)?);
        file.write(head)?;
        Ok(file)
    }

    /// Some whole lines more.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn write(&mut self, lines: &str) -> io::Result<()> {
        self.0.write_all(lines.as_bytes())
    }

    /// What is written lies on the disk.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn finish(self) -> io::Result<()> {
        self.0.sync_all()
    }
}

impl GrownFile {
    /// What a file holds behind its head; `None` where it has another one. A file that is not there, and one that was
    /// cut off within its head, has no lines.
    ///
    /// # Errors
    /// What the system says.
    pub(crate) fn open(path: &Path, head: &str) -> io::Result<Option<GrownFile>> {
        let mut options = OpenOptions::new();
        let options = options.read(true).write(true).create(true).truncate(false);
        let mut reader = BufReader::new(options.open(path)?);
        let mut begin = Vec::new();
        let most = u64::try_from(head.len()).unwrap_or(u64::MAX);
        reader.by_ref().take(most).read_to_end(&mut begin)?;
        if !head.as_bytes().starts_with(&begin) {
            return Ok(None);
        }
        let mut grown = GrownFile {
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
    pub(crate) fn go_on(mut self) -> io::Result<GrowingFile> {
        self.file.set_len(self.end)?;
        self.file.seek(SeekFrom::Start(self.end))?;
        Ok(GrowingFile(self.file))
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
