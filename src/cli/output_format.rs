//! Chooses the output format by the extension of the output file, if the command line names no format.

use clap::Command;
use clap::parser::ValueSource;
use std::ffi::OsString;
use std::path::PathBuf;

/// Extensions that differ from the names of their formats.
const EXTENSIONS: [(&str, &str); 5] = [
    ("htm", "html"),
    ("m", "matlab"),
    ("md", "markdown"),
    ("py", "python"),
    ("tex", "latex"),
];

/// The command whose output file is a scene, and whose format is that of standard output.
const SOLVE: &str = "solve";

/// Adds `--format` to the arguments of a command that writes to a file, if the file's extension belongs to a format
/// of the command and the arguments name no format.
pub(super) fn add_format(arguments: &mut Vec<OsString>, krank: fn() -> Command) {
    let is_output = |word: &OsString| {
        let word = word.to_string_lossy();
        word.starts_with("-o") || word.starts_with("--output")
    };
    if !arguments.iter().any(is_output) {
        return;
    }
    if let Some((command, format)) = format_of_file(krank().ignore_errors(true), arguments) {
        // Directly behind the command, it cannot become the value of an option.
        let place = arguments.iter().position(|word| *word == *command);
        let place = place.map_or(arguments.len(), |place| place + 1);
        arguments.insert(place, format!("--format={format}").into());
    }
}

/// Returns the command and its format for the extension of the output file; `None` if the arguments name a format, or if
/// the command has no format for the extension.
fn format_of_file(krank: Command, arguments: &[OsString]) -> Option<(String, String)> {
    let matches = krank.clone().try_get_matches_from(arguments).ok()?;
    let (name, matches) = matches.subcommand().filter(|(name, _)| *name != SOLVE)?;
    let command = krank.find_subcommand(name)?;
    let option = |id: &str| command.get_arguments().find(|option| option.get_id() == id);
    let formats = option("format")?.get_possible_values();
    let is_file = option("output")?
        .get_value_names()?
        .iter()
        .any(|name| name == "FILE");
    if !is_file || matches.value_source("format") == Some(ValueSource::CommandLine) {
        return None;
    }
    let output: &PathBuf = matches.try_get_one("output").ok()??;
    let extension = output.extension()?.to_str()?.to_ascii_lowercase();
    let known = EXTENSIONS.iter().find(|(known, _)| *known == extension);
    let format = known.map_or(extension.as_str(), |(_, format)| *format);
    let mut names = formats.iter().map(clap::builder::PossibleValue::get_name);
    names
        .any(|name| name == format)
        .then(|| (command.get_name().to_owned(), format.to_owned()))
}
