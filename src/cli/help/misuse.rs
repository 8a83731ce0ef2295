//! Explains an invalid command line by its probable meaning.

use crate::nearest::nearest;
use crate::scene::presets;
use crate::task_file::ExampleTask;
use crate::wording::words;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};
use std::ffi::OsString;

/// Returns a message instead of clap's error if clap's own text would be misleading. `arguments`
/// are those of the program, its own name first.
pub(in crate::cli) fn explained(
    mut error: Error,
    arguments: &[OsString],
    krank: &Command,
) -> Result<String, Error> {
    if let Some(message) = second_word(&error, arguments, krank) {
        return Ok(message);
    }
    // Removes "to pass '--at' as a value, use '-- --at'": such a scene name is improbable.
    error.remove(ContextKind::Suggested);
    Err(error)
}

/// Explains a second positional word, which clap takes for a subcommand after a scene: the first
/// word was meant as a command, or the second was.
fn second_word(error: &Error, arguments: &[OsString], krank: &Command) -> Option<String> {
    if error.kind() != ErrorKind::ArgumentConflict {
        return None;
    }
    let Some(ContextValue::String(second)) = error.get(ContextKind::InvalidSubcommand) else {
        return None;
    };
    if krank.find_subcommand(second).is_some() {
        return Some(words().command_comes_first(second));
    }
    let first = arguments.get(1)?.to_string_lossy();
    Some(match suggest_command(&first, krank) {
        Some(command) => words().no_such_command(&first, &command),
        None => words().one_scene_alone(second),
    })
}

/// Explains a name that is neither a preset nor a file, with the probable meaning.
pub(in crate::cli) fn no_scene(name: &str, krank: &Command) -> String {
    let task = ExampleTask::find(name).map(|task| words().example_is_a_task(task.name));
    let command =
        || suggest_command(name, krank).map(|command| words().did_you_mean_command(&command));
    let fix = task
        .or_else(command)
        .or_else(|| suggest_preset(name).map(|p| words().did_you_mean_preset(p)))
        .unwrap_or_else(|| words().list_names_presets().into());
    words().no_preset_and_no_file(name, &fix)
}

/// Returns the command that a mistyped name probably means; the parser takes it for the name of a
/// scene.
fn suggest_command(name: &str, krank: &Command) -> Option<String> {
    nearest(name, krank.get_subcommands().map(Command::get_name)).map(str::to_owned)
}

/// Returns the preset that a name probably means: a similar one, or one with this prefix.
fn suggest_preset(name: &str) -> Option<&'static str> {
    let names = || presets::all().iter().map(|preset| preset.name);
    let started = |preset: &&str| !name.is_empty() && preset.starts_with(name);
    nearest(name, names()).or_else(|| names().find(started))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_name_gets_nearest_preset() {
        let krank = Command::new("krank").subcommand(Command::new("check"));
        let found = |name| no_scene(name, &krank);
        assert_eq!(
            found("forbar"),
            "no preset or file is named `forbar`; did you mean the preset `four-bar`?"
        );
        assert!(found("slider").ends_with("did you mean the preset `slider-crank`?"));
        assert!(found("hatch").ends_with("it is a task: krank synthesize hatch"));
        assert!(found("chek").ends_with("did you mean the command `check`?"));
        assert!(found("zzzzzzzzzzzzzzzzzzz").contains("krank list"));
    }
}
