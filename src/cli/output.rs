//! Writes results to standard output or to a file.

use crate::cli::failure::Failure;
use crate::files::{Output, directories};
use crate::scene::sanitized;
use crate::wording::words;
use clap::Args;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write, stdout};
use std::path::{Path, PathBuf};

#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    #[arg(help = words().write_to_a_file())]
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}

/// Size of the output buffer, in bytes.
const BUFFER: usize = 1 << 16;

/// Returns the file that a path means; `None` for standard output.
pub(super) fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// Returns `true` if the output goes directly to a terminal.
pub(super) fn writes_to_terminal(path: Option<&Path>) -> bool {
    file(path).is_none() && stdout().is_terminal()
}

/// Runs `write` on the file, or on standard output if there is none.
///
/// A file is created or replaced only after the complete output was written. If the command ends
/// earlier, an existing file is unchanged.
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

/// Writes a text to the file, or to standard output if there is none.
pub(super) fn write_text(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    write_to(path, |out| out.write_all(text.as_bytes()))
}

/// Writes the text of a scene. On a terminal, it is sanitized.
pub(super) fn write_scene(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match writes_to_terminal(path) {
        true => write_text(None, &shown(text)),
        false => write_text(path, text),
    }
}

/// Returns the folder that holds the old and new text while a file is written in place.
pub(super) fn records() -> Option<PathBuf> {
    directories::records(directories::environment)
}

fn to_file<T>(path: &Path, write: impl FnOnce(&mut dyn Write) -> io::Result<T>) -> io::Result<T> {
    let records = records();
    let mut output = Output::to(path, records.as_deref())?;
    let outcome = through(&mut output, write)?;
    output.commit(records.as_deref())?;
    Ok(outcome)
}

/// Sanitizes a foreign text: replaces everything that could affect a terminal.
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
        // Dropping the buffer would try to write the rest again.
        let _ = buffered.into_parts();
        return outcome;
    }
    buffered.flush()?;
    outcome
}
