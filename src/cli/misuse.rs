//! What was probably meant by a command line that cannot be read.

use super::args::Cli;
use super::source::meant_command;
use crate::wording::words;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error};
use std::ffi::OsString;

/// Clap's error as it is to be told, in place of its own text where that would lead astray.
/// `arguments` are those of the program, its own name first.
pub(super) fn explained(mut error: Error, arguments: &[OsString]) -> Result<String, Error> {
    if let Some(message) = second_word(&error, arguments) {
        return Ok(message);
    }
    // "to pass '--at' as a value, use '-- --at'": nobody has a scene of that name.
    error.remove(ContextKind::Suggested);
    Err(error)
}

/// A word behind the first that is read as a scene: the first was meant as a command, or the second.
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
