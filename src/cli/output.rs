//! Where results go: standard output or a file.

use super::failure::Failure;
use crate::replace::replace_file;
use crate::scene::harmless;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write, stdout};
use std::path::Path;

/// Bytes gathered before they are handed to the system.
const BUFFER: usize = 1 << 16;

/// The file that is meant; `None` is standard output.
fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// Whether what is written there is seen as it comes.
pub(super) fn goes_to_terminal(path: Option<&Path>) -> bool {
    file(path).is_none() && stdout().is_terminal()
}

/// Runs `write` on the file, or on standard output where none is named.
///
/// The file is made only now, when everything that can be wrong with the command line and the
/// scene has been found: a refused command leaves an older file as it was.
pub(super) fn write_to<T>(
    path: Option<&Path>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<T>,
) -> Result<T, Failure> {
    match file(path) {
        Some(path) => File::create(path)
            .and_then(|file| through(file, write))
            .map_err(|e| Failure::Output(Some(path.to_owned()), e)),
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

/// Puts a text in the place of a file, at once or not at all; without a file it is printed.
pub(super) fn replace(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match file(path) {
        None if stdout().is_terminal() => write_text(None, &shown(text)),
        None => write_text(None, text),
        Some(path) => replace_file(path, text.as_bytes())
            .map_err(|e| Failure::Output(Some(path.to_owned()), e)),
    }
}

/// A text of somebody else's for the eyes of a reader: what could act on a terminal is replaced.
fn shown(text: &str) -> String {
    let lines = text.split('\n').map(|line| harmless(line, false));
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
