//! The command line: parses and runs it, and reports errors.

mod choice;
mod columns;
mod commands;
mod external_values;
mod failure;
mod formats;
mod help;
mod language;
mod lead;
mod output;
mod output_format;
mod picture;
mod place;
#[cfg(feature = "tui")]
mod progress;
#[cfg(not(feature = "tui"))]
#[path = "no_progress.rs"]
mod progress;
mod rows;
mod screen;
mod source;
mod workbench;

use crate::files::recover_all;
use crate::scene::sanitized;
use crate::wording::{Language, words};
use choice::{OrAuto, one_of};
use clap::error::ErrorKind;
use clap::{Arg, ArgAction, CommandFactory, Parser};
use commands::Command;
use failure::Failure;
use help::{misuse, version};
use language::languages;
use screen::TextScreen;
use std::ffi::OsString;
use std::process::ExitCode;
use workbench::WorkbenchArgs;

/// Returns the text after the options in `--help`: examples, after the essential keys if there is a
/// workbench.
fn behind_help() -> String {
    let keys = match cfg!(feature = "tui") {
        true => words().keys_of_workbench(),
        false => "",
    };
    keys.to_owned() + words().examples_of_krank()
}

/// Returns `--long`, the last option in `--help`. It is not a field: `--version` ends the parsing.
fn long_version() -> Arg {
    let long = Arg::new("long").long("long").action(ArgAction::SetTrue);
    let long = long.help(words().add_to_version()).display_order(999);
    long.requires("version")
}

/// A terminal workbench for planar linkages.
#[derive(Debug, Parser)]
#[command(
    name = "krank",
    version,
    about = words().what_krank_is(),
    long_about = words().what_krank_does(),
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    arg = long_version(),
    after_help = behind_help()
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    workbench: WorkbenchArgs,
    #[arg(help = words().language_to_speak())]
    #[arg(long, global = true, value_parser = one_of(languages()), default_value = "auto")]
    language: OrAuto<Language>,
}

/// Runs the program with these arguments, its own name first. Results go to standard output,
/// messages to standard error.
///
/// The exit code is 0 on success, 1 if the mechanism makes the request impossible or the results
/// cannot be written, and 2 if the command line or the scene is invalid.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let mut arguments = language::settle(arguments.into_iter().collect(), |word| {
        let krank = Cli::command();
        krank
            .get_subcommands()
            .any(|command| word == command.get_name())
    });
    let screen = TextScreen::detect();
    if let Err(failure) = output_format::add_format(&mut arguments, Cli::command) {
        failure.print_error(screen);
        return failure.code();
    }
    finish_interrupted_writes(screen);
    let done = match Cli::try_parse_from(&arguments) {
        Ok(cli) => obey(&cli, screen).map_err(explained),
        Err(error) => match misuse::explained(error, &arguments, &Cli::command()) {
            Ok(message) => Err(Failure::Usage(message)),
            Err(error) => return refuse(&error, &arguments, screen),
        },
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print_error(screen);
            failure.code()
        }
    }
}

/// Completes in-place writes that an earlier process did not finish because it was killed.
fn finish_interrupted_writes(screen: TextScreen) {
    for file in output::records()
        .iter()
        .flat_map(|folder| recover_all(folder))
    {
        failure::note(&words().file_was_mended(&file.display()), screen);
    }
}

/// Prints help and version on standard output, and parser errors on standard error.
fn refuse(error: &clap::Error, arguments: &[OsString], screen: TextScreen) -> ExitCode {
    let mut text = words().of_parser(&error.render().to_string());
    // The parser stops at `--version` and does not report later options.
    if error.kind() == ErrorKind::DisplayVersion && arguments.iter().any(|it| it == version::LONG) {
        text += &version::details();
    }
    if error.use_stderr() {
        failure::print_text(&lines_made_harmless(&text, screen));
        return ExitCode::from(2);
    }
    match output::write_text(None, &screen.shown(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print_error(screen);
            failure.code()
        }
    }
}

/// Sanitizes an error message, which may quote typed or pasted text.
fn lines_made_harmless(text: &str, screen: TextScreen) -> String {
    let lines = text
        .lines()
        .map(|line| sanitized(line, screen.ascii) + "\n");
    lines.collect()
}

/// Explains a name that is neither a preset nor a file.
fn explained(failure: Failure) -> Failure {
    match failure {
        Failure::NoScene(name) => Failure::Usage(misuse::no_scene(&name, &Cli::command())),
        other => other,
    }
}

fn obey(cli: &Cli, screen: TextScreen) -> Result<(), Failure> {
    match &cli.command {
        #[cfg(feature = "tui")]
        None if cli.workbench.diagnose => workbench::diagnose(&cli.workbench, cli.language),
        None => workbench::open(&cli.workbench, cli.language, screen),
        Some(command) => command.run(screen, Cli::command),
    }
}
