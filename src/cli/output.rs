//! Where results go: standard output or a file.

use super::failure::Failure;
use crate::files::{Output, places};
use crate::scene::sanitized;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write, stdout};
use std::path::{Path, PathBuf};

/// Bytes gathered before they are handed to the system.
const BUFFER: usize = 1 << 16;

/// The file that is meant; `None` is standard output.
pub(super) fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// Whether what is written there is seen as it comes.
pub(super) fn goes_to_terminal(path: Option<&Path>) -> bool {
    file(path).is_none() && stdout().is_terminal()
}

/// Runs `write` on the file, or on standard output where none is named.
///
/// A file is made, or replaced, once all was written: whatever ends the command before that leaves an older
/// one as it was.
pub(super) fn write_to<T>(
    path: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<T>,
) -> Result<T, Failure> {
    match file(path) {
        Some(path) => to_file(path, write).map_err(|e| Failure::Output(Some(path.to_owned()), e)),
        None => through(stdout().lock(), write).map_err(|e| match e.kind() {
            ErrorKind::BrokenPipe => Failure::PipeClosed,
            _ => Failure::Output(None, e),
        }),
    }
}

/// The same for a text that is ready.
pub(super) fn write_text(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    write_to(path, |out| out.write_all(text.as_bytes()))
}

/// The same for the text of a scene, which a terminal is shown without what could act on it.
pub(super) fn write_scene(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match goes_to_terminal(path) {
        true => write_text(None, &shown(text)),
        false => write_text(path, text),
    }
}

/// Where old and new text are kept while a file is written in its place.
pub(super) fn records() -> Option<PathBuf> {
    places::records(places::environment)
}

fn to_file<T>(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<T>) -> io::Result<T> {
    let records = records();
    let mut output = Output::to(path, records.as_deref())?;
    let outcome = through(&mut output, write)?;
    output.commit(records.as_deref())?;
    Ok(outcome)
}

/// A text of somebody else's for the eyes of a reader: what could act on a terminal is replaced.
fn shown(text: &str) -> String {
    let lines = text.split('\n').map(|line| sanitized(line, false));
    lines.collect::<Vec<_>>().join("\n")
}

fn through<T>(
    to: impl Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<T>,
) -> io::Result<T> {
    let mut buffered = BufWriter::with_capacity(BUFFER, to);
    let outcome = write(&mut buffered);
    if outcome.is_err() {
        // What is left must not be tried once more when the buffer is dropped.
        let _ = buffered.into_parts();
        return outcome;
    }
    buffered.flush()?;
    outcome
}
