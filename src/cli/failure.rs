//! How a command fails, and the exit code that says so.

use super::screen::TextScreen;
use crate::scene::{Diagnostics, sanitized};
use crate::wording::words;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

/// Why a command did not do what was asked.
#[derive(Debug)]
pub(super) enum Failure {
    /// The command line is wrong.
    Usage(String),
    /// The scene is wrong.
    Scene(Diagnostics),
    /// What was asked cannot be done, by the mechanism or by the terminal.
    Cannot(String),
    /// The results cannot be written; `None` is standard output.
    Output(Option<PathBuf>, io::Error),
    /// Whoever read the results has enough of them.
    PipeClosed,
}

impl Failure {
    /// 1: it cannot be done, or the output cannot be written; 2: the command line or the scene is
    /// wrong. A reader that closes the pipe is no failure.
    pub(super) fn code(&self) -> ExitCode {
        match self {
            Failure::PipeClosed => ExitCode::SUCCESS,
            Failure::Cannot(_) | Failure::Output(..) => ExitCode::from(1),
            Failure::Usage(_) | Failure::Scene(_) => ExitCode::from(2),
        }
    }

    /// Says it on standard error.
    pub(super) fn tell(&self, screen: TextScreen) {
        let text = match self {
            Failure::PipeClosed => return,
            Failure::Scene(diagnostics) => diagnostics.render(screen.ascii, screen.colour),
            Failure::Usage(message) | Failure::Cannot(message) => error(message, screen),
            Failure::Output(None, e) => error(&words().cannot_write_results(e), screen),
            Failure::Output(Some(path), e) => {
                error(&words().cannot_write(&path.display(), e), screen)
            }
        };
        say(&text);
    }
}

fn error(message: &str, screen: TextScreen) -> String {
    words().error(&sanitized(message, screen.ascii)) + "\n"
}

/// A note on standard error: something the reader of the results should know.
pub(super) fn note(message: &str, screen: TextScreen) {
    say(&(words().note(&sanitized(message, screen.ascii)) + "\n"));
}

/// Text for standard error.
pub(super) fn say(text: &str) {
    // Where nobody listens to errors there is nobody to tell it.
    let _ = io::stderr().write_all(text.as_bytes());
}
