//! The command line: parses and runs it, and reports errors.

mod accuracy;
mod args;
mod commands;
mod completions;
#[cfg(feature = "tui")]
mod config;
mod cycle;
#[cfg(feature = "tui")]
mod diagnose;
mod draw;
mod exercise;
mod explain;
mod export;
mod failure;
mod grade;
mod help;
mod language;
mod lookup;
mod measured;
mod misuse;
mod motor;
mod output;
mod pager;
mod picture;
mod plot;
#[cfg(feature = "tui")]
mod progress;
#[cfg(not(feature = "tui"))]
#[path = "no_progress.rs"]
mod progress;
mod report;
mod screen;
mod solve;
mod source;
mod study;
mod study_chart;
mod study_rows;
mod sweep;
mod synthesize;
mod tolerance;
mod version;
#[cfg(feature = "tui")]
mod workbench;
#[cfg(not(feature = "tui"))]
#[path = "no_workbench.rs"]
mod workbench;

use crate::files::mend;
use crate::scene::sanitized;
use crate::wording::words;
use args::{Cli, Command};
use clap::Parser;
use clap::error::ErrorKind;
use failure::Failure;
use screen::TextScreen;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the program with these arguments, its own name first. Results go to standard output,
/// messages to standard error.
///
/// The exit code is 0 on success, 1 if the mechanism makes the request impossible or the results
/// cannot be written, and 2 if the command line or the scene is invalid.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments = language::settle(arguments.into_iter().collect());
    let screen = TextScreen::detect();
    finish_interrupted_writes(screen);
    let done = match Cli::try_parse_from(&arguments) {
        Ok(cli) => obey(&cli, screen),
        Err(error) => match misuse::explained(error, &arguments) {
            Ok(message) => Err(Failure::Usage(message)),
            Err(error) => return refuse(&error, &arguments, screen),
        },
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell(screen);
            failure.code()
        }
    }
}

/// Completes in-place writes that an earlier process did not finish because it was killed.
fn finish_interrupted_writes(screen: TextScreen) {
    for file in output::records().iter().flat_map(|folder| mend(folder)) {
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
        failure::say(&lines_made_harmless(&text, screen));
        return ExitCode::from(2);
    }
    match output::write_text(None, &screen.shown(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell(screen);
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

fn obey(cli: &Cli, screen: TextScreen) -> Result<(), Failure> {
    match &cli.command {
        #[cfg(feature = "tui")]
        None if cli.workbench.diagnose => diagnose::diagnose(&cli.workbench, cli.language),
        None => workbench::open(&cli.workbench, cli.language),
        Some(Command::List) => commands::list(screen),
        Some(Command::Check(args)) => commands::check(args, screen),
        Some(Command::Table(args)) => commands::table(args, screen),
        Some(Command::Explain(args)) => explain::explain(args, screen),
        Some(Command::Report(args)) => report::report(args, screen),
        Some(Command::Exercise(args)) => exercise::exercise(args, screen),
        Some(Command::Grade(args)) => grade::grade(args, screen),
        Some(Command::Draw(args)) => draw::draw(args, screen),
        Some(Command::Sweep(args)) => sweep::sweep(args, screen),
        Some(Command::Plot(args)) => plot::plot(args, screen),
        Some(Command::Solve(args)) => solve::solve(args, screen),
        Some(Command::Synthesize(args)) => synthesize::synthesize(args, screen),
        Some(Command::Start(args)) => commands::start(args),
        Some(Command::Cycle(args)) => cycle::cycle(args, screen),
        Some(Command::Export(args)) => export::export(args, screen),
        Some(Command::Tolerance(args)) => tolerance::tolerance(args, screen),
        Some(Command::Study(args)) => study::study(args, screen),
        Some(Command::Motor(args)) => motor::motor(args, screen),
        Some(Command::Accuracy(args)) => accuracy::accuracy(args, screen),
        #[cfg(feature = "tui")]
        Some(Command::Config) => config::config(screen),
        Some(Command::Help(args)) => help::help(args),
        Some(Command::Completions { shell }) => completions::completions(*shell, screen),
        Some(Command::Man { command }) => commands::man(command.as_deref(), screen),
    }
}
