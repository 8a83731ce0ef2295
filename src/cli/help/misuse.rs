//! Explains an invalid command line by its probable meaning.

use super::args::Cli;
use super::source::meant_command;
use crate::wording::words;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error};
use std::ffi::OsString;

/// Returns a message instead of clap's error if clap's own text would be misleading. `arguments`
/// are those of the program, its own name first.
pub(super) fn explained(mut error: Error, arguments: &[OsString]) -> Result<String, Error> {
    if let Some(message) = second_word(&error, arguments) {
        return Ok(message);
    }
    // Removes "to pass '--at' as a value, use '-- --at'": such a scene name is improbable.
    error.remove(ContextKind::Suggested);
    Err(error)
}

/// Explains a second positional word, which clap takes for a subcommand after a scene: the first
/// word was meant as a command, or the second was.
fn second_word(error: &Error, arguments: &[OsString]) -> Option<String> {
    if error.kind() != ErrorKind::ArgumentConflict {
        return None;
    }
    let Some(ContextValue::String(second)) = error.get(ContextKind::InvalidSubcommand) else {
        return None;
    };
    if Cli::command().find_subcommand(second).is_some() {
        return Some(words().command_comes_first(second));
    }
    let first = arguments.get(1)?.to_string_lossy();
    Some(match meant_command(&first) {
        Some(command) => words().no_such_command(&first, &command),
        None => words().one_scene_alone(second),
    })
}
