//! Writes into an existing file that cannot be replaced: it has several names, its metadata cannot
//! be given to another file, or its folder accepts no new file.
//!
//! A kill during writing would leave a mixture of both texts. So a record with the old and the new
//! text is on the disk before the first byte is written, and is removed after the last. The next
//! start completes writes whose records it finds.
//!
//! ```text
//! krank-writing 1 OLD NEW NAME      lengths in bytes, the name in hexadecimal digits
//! old text, then new text
//! ```

use super::bounded_read::open_file;
use super::lock::{self, LockOutcome};
use super::temporary::{DraftFile, next_numbers};
use crate::wording::words;
use rustix::fs::OFlags;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::fs::{self, DirBuilder, File};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::os::unix::ffi::{OsStrExt, OsStringExt};
use std::os::unix::fs::{DirBuilderExt, FileExt, MetadataExt};
use std::path::{Path, PathBuf};

/// Prefix of a record's content, and extension of its name.
const MAGIC: &str = "krank-writing 1";
const ENDS: &str = "writing";
/// Maximum length of the first line: a name has up to 4096 bytes.
const MAX_HEADER_LEN: u64 = 16 << 10;
/// Block size for comparing and copying, in bytes.
const BLOCK: usize = 64 << 10;

/// A file on the disk with the old and the new text of a target.
struct RewriteRecord {
    file: File,
    target: PathBuf,
    old: RecordSpan,
    new: RecordSpan,
}

/// A part of a record.
#[derive(Clone, Copy)]
struct RecordSpan {
    from: u64,
    length: u64,
}

/// Writes the content of a draft into a file. The record is kept in `folder`, which is created if
/// missing.
///
/// # Errors
/// Returns an I/O error. The file then has its old content, or the next start completes the write.
pub(super) fn write_into(target: &Path, new: &mut File, folder: &Path) -> io::Result<()> {
    let mut file = open_file(target, OFlags::RDWR | OFlags::NOFOLLOW)?;
    create_private_folder(folder)?;
    let (record, path) = RewriteRecord::keep(folder, target, &mut file, new)?;
    let done = record.write_span(record.new, &file);
    if done.is_err() {
        // The space for the old text is available, because the file occupied it before.
        record.write_span(record.old, &file)?;
    }
    fs::remove_file(path)?;
    done
}

/// Completes interrupted writes. Returns the files that have their new text now.
pub(crate) fn recover_all(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths = entries.map(|entry| entry.path());
    let records = paths.filter(|path| path.extension().is_some_and(|end| end == ENDS));
    records.filter_map(|path| recover(&path).ok()?).collect()
}

/// Completes one interrupted write. A record that cannot be processed now stays for another start.
fn recover(path: &Path) -> io::Result<Option<PathBuf>> {
    let file = open_file(path, OFlags::RDWR | OFlags::NOFOLLOW)?;
    // Without links, the record was already processed by another start.
    if lock::take(&file) != LockOutcome::Ours || file.metadata()?.nlink() == 0 {
        return Ok(None);
    }
    let record = RewriteRecord::read(file)?;
    let torn = match open_file(&record.target, OFlags::RDWR | OFlags::NOFOLLOW) {
        Ok(file) if record.is_torn(&file)? => {
            record.write_span(record.new, &file)?;
            true
        }
        // The file has one of the two texts, or was changed by another program since.
        Ok(_) => false,
        Err(e) if e.kind() == io::ErrorKind::NotFound => false,
        Err(e) => return Err(e),
    };
    fs::remove_file(path)?;
    Ok(torn.then_some(record.target))
}

impl RewriteRecord {
    /// Writes both texts to the disk. The record is locked as long as it is open.
    fn keep(
        folder: &Path,
        target: &Path,
        old: &mut File,
        new: &mut File,
    ) -> io::Result<(RewriteRecord, PathBuf)> {
        let mut draft = DraftFile::private(folder)?;
        let lengths = [old.metadata()?.len(), new.metadata()?.len()];
        let mut head = format!("{MAGIC} {} {} ", lengths[0], lengths[1]);
        for byte in target.as_os_str().as_bytes() {
            let _ = write!(head, "{byte:02x}");
        }
        head.push('\n');
        draft.file.write_all(head.as_bytes())?;
        for (from, length) in [&mut *old, &mut *new].into_iter().zip(lengths) {
            from.seek(SeekFrom::Start(0))?;
            let copied = io::copy(&mut from.take(length), &mut draft.file)?;
            if copied != length {
                return Err(io::Error::other(words().was_cut_while_read()));
            }
        }
        draft.file.sync_all()?;
        let path = folder.join(format!("krank-{}.{ENDS}", next_numbers()));
        let file = draft.replace(&path)?;
        File::open(folder)?.sync_all()?;
        Ok((RewriteRecord::read(file)?, path))
    }

    fn read(mut file: File) -> io::Result<RewriteRecord> {
        let broken = || io::Error::other(words().is_no_record());
        file.seek(SeekFrom::Start(0))?;
        let mut head = String::new();
        BufReader::new((&file).take(MAX_HEADER_LEN)).read_line(&mut head)?;
        let rest = head
            .strip_prefix(MAGIC)
            .and_then(|rest| rest.strip_suffix('\n'));
        let mut words = rest.ok_or_else(broken)?.split_whitespace();
        let mut number = || words.next().and_then(|word| word.parse::<u64>().ok());
        let lengths = number().zip(number());
        let target = words.next().and_then(name_of_digits);
        let ((old, new), target) = lengths.zip(target).ok_or_else(broken)?;
        let from = u64::try_from(head.len()).unwrap_or(u64::MAX);
        let complete = from.checked_add(old).and_then(|n| n.checked_add(new));
        if complete != Some(file.metadata()?.len()) {
            return Err(broken());
        }
        let spans = [(from, old), (from + old, new)];
        let [old, new] = spans.map(|(from, length)| RecordSpan { from, length });
        Ok(RewriteRecord {
            file,
            target,
            old,
            new,
        })
    }

    /// Writes one of the texts into a file.
    fn write_span(&self, text: RecordSpan, file: &File) -> io::Result<()> {
        // Reserve space first, so that a full disk is detected before anything changes.
        reserve(file, text.length.max(1))?;
        let mut block = vec![0; BLOCK];
        let mut at = 0;
        while at < text.length {
            let bytes = &mut block[..piece(text.length - at)];
            self.file.read_exact_at(bytes, text.from + at)?;
            file.write_all_at(bytes, at)?;
            at += length(bytes);
        }
        file.set_len(text.length)?;
        file.sync_all()
    }

    /// Checks whether a file holds parts of both texts, and neither completely.
    fn is_torn(&self, file: &File) -> io::Result<bool> {
        let size = file.metadata()?.len();
        let (shorter, longer) = (
            self.old.length.min(self.new.length),
            self.old.length.max(self.new.length),
        );
        if size < shorter || size > longer {
            return Ok(false);
        }
        let (mut is_old, mut is_new) = (size == self.old.length, size == self.new.length);
        let mut at = 0;
        let mut block = vec![0; BLOCK];
        while at < size {
            let bytes = &mut block[..piece(size - at)];
            file.read_exact_at(bytes, at)?;
            let (old, new) = (self.bytes(self.old, at)?, self.bytes(self.new, at)?);
            for (i, byte) in bytes.iter().enumerate() {
                let [of_old, of_new] = [old.get(i), new.get(i)].map(|of| of == Some(byte));
                // Space reserved but not written reads as zeros.
                let is_room = *byte == 0 && i >= old.len();
                if !(of_old || of_new || is_room) {
                    return Ok(false);
                }
                is_old &= of_old;
                is_new &= of_new;
            }
            at += length(bytes);
        }
        Ok(!is_old && !is_new)
    }

    /// Reads a block of a text, shorter at its end.
    fn bytes(&self, text: RecordSpan, at: u64) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; piece(text.length.saturating_sub(at))];
        self.file.read_exact_at(&mut bytes, text.from + at)?;
        Ok(bytes)
    }
}

/// Returns the size of the next block.
fn piece(rest: u64) -> usize {
    usize::try_from(rest).unwrap_or(BLOCK).min(BLOCK)
}

fn length(bytes: &[u8]) -> u64 {
    u64::try_from(bytes.len()).unwrap_or(u64::MAX)
}

fn name_of_digits(digits: &str) -> Option<PathBuf> {
    let pairs = digits.as_bytes().chunks(2);
    let bytes = pairs.map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok());
    let name = bytes.collect::<Option<Vec<u8>>>()?;
    Some(PathBuf::from(OsString::from_vec(name)))
}

/// Creates a folder that other users cannot read.
pub(crate) fn create_private_folder(folder: &Path) -> io::Result<()> {
    DirBuilder::new().recursive(true).mode(0o700).create(folder)
}

/// Reserves space, so that a full disk is detected before anything changes.
#[cfg(any(target_os = "linux", target_os = "android"))]
fn reserve(file: &File, length: u64) -> io::Result<()> {
    use rustix::fs::{FallocateFlags, fallocate};
    use rustix::io::Errno;

    match fallocate(file, FallocateFlags::KEEP_SIZE, 0, length) {
        Ok(()) | Err(Errno::OPNOTSUPP | Errno::NOSYS) => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Does nothing: other systems cannot reserve space without changing the length, and the record has
/// both texts.
#[cfg(not(any(target_os = "linux", target_os = "android")))]
fn reserve(_file: &File, _length: u64) -> io::Result<()> {
    Ok(())
}
