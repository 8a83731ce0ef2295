//! Errors of commands, with their exit codes.

use crate::cli::screen::TextScreen;
use crate::scene::{Diagnostics, sanitized};
use crate::wording::words;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

/// The reason why a command failed.
#[derive(Debug)]
pub(super) enum Failure {
    /// The command line is invalid.
    Usage(String),
    /// The command line names a scene that is neither a preset nor a file.
    NoScene(String),
    /// The scene is invalid.
    Scene(Diagnostics),
    /// The mechanism or the terminal makes the request impossible.
    Cannot(String),
    /// The results cannot be written to this file; `None` is standard output.
    Output(Option<PathBuf>, io::Error),
    /// The reader of the results closed the pipe.
    PipeClosed,
}

impl Failure {
    /// Returns the exit code: 1 if the request is impossible or the output cannot be written, 2 if
    /// the command line or the scene is invalid. A closed pipe is a success.
    pub(super) fn code(&self) -> ExitCode {
        match self {
            Failure::PipeClosed => ExitCode::SUCCESS,
            Failure::Cannot(_) | Failure::Output(..) => ExitCode::from(1),
            Failure::Usage(_) | Failure::NoScene(_) | Failure::Scene(_) => ExitCode::from(2),
        }
    }

    /// Prints the error on standard error.
    pub(super) fn print_error(&self, screen: TextScreen) {
        let text = match self {
            Failure::PipeClosed => return,
            Failure::Scene(diagnostics) => diagnostics.render(screen.ascii, screen.colour),
            Failure::Usage(message) | Failure::Cannot(message) => error(message, screen),
            Failure::NoScene(name) => {
                let help = words().list_names_presets();
                error(&words().no_preset_and_no_file(name, help), screen)
            }
            Failure::Output(None, e) => error(&words().cannot_write_results(e), screen),
            Failure::Output(Some(path), e) => {
                error(&words().cannot_write(&path.display(), e), screen)
            }
        };
        print_text(&text);
    }
}

fn error(message: &str, screen: TextScreen) -> String {
    words().error(&sanitized(message, screen.ascii)) + "\n"
}

/// Prints a note for the reader of the results on standard error.
pub(super) fn note(message: &str, screen: TextScreen) {
    print_text(&(words().note(&sanitized(message, screen.ascii)) + "\n"));
}

/// Prints a text on standard error.
pub(super) fn print_text(text: &str) {
    // An error of standard error cannot be reported anywhere.
    let _ = io::stderr().write_all(text.as_bytes());
}
