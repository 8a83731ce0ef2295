//! Chooses the output format by the extension of the output file, if the command line names no format.

use crate::cli::failure::Failure;
use crate::files::foreign_extension;
use crate::wording::words;
use clap::Command;
use clap::parser::ValueSource;
use std::ffi::OsString;
use std::path::PathBuf;

/// Extensions that differ from the names of their formats.
const EXTENSIONS: [(&str, &str); 6] = [
    ("htm", "html"),
    ("m", "matlab"),
    ("md", "markdown"),
    ("py", "python"),
    ("tex", "latex"),
    ("txt", "text"),
];

/// The commands that refuse any extension without a format: other programs open their files.
const PICTURES: [&str; 2] = ["draw", "plot"];

/// The extensions that other commands write, but that are refused where the command has no such format.
const OF_OTHER_COMMANDS: [&str; 6] = ["cast", "dxf", "htm", "html", "svg", "tex"];

/// The command whose output file is a scene, and whose format is that of standard output.
const SOLVE: &str = "solve";

/// Adds `--format` to the arguments of a command that writes to a file, if the file's extension belongs to a format
/// of the command and the arguments name no format.
///
/// # Errors
/// Returns an error for an extension that promises another format than the command writes.
pub(super) fn add_format(
    arguments: &mut Vec<OsString>,
    krank: fn() -> Command,
) -> Result<(), Failure> {
    let is_output = |word: &OsString| {
        let word = word.to_string_lossy();
        word.starts_with("-o") || word.starts_with("--output")
    };
    if !arguments.iter().any(is_output) {
        return Ok(());
    }
    if let Some((command, format)) = format_of_file(krank().ignore_errors(true), arguments)? {
        // Directly behind the command, it cannot become the value of an option.
        let place = arguments.iter().position(|word| *word == *command);
        let place = place.map_or(arguments.len(), |place| place + 1);
        arguments.insert(place, format!("--format={format}").into());
    }
    Ok(())
}

/// Returns the command and its format for the extension of the output file; `None` if the arguments name a format, or if
/// the command has no format for the extension.
fn format_of_file(
    krank: Command,
    arguments: &[OsString],
) -> Result<Option<(String, String)>, Failure> {
    let Some(file) = OutputFile::of(krank, arguments) else {
        return Ok(None);
    };
    let known = EXTENSIONS
        .iter()
        .find(|(known, _)| *known == file.extension);
    let format = known.map_or(&*file.extension, |(_, format)| *format);
    if file.formats.iter().any(|name| name == format) {
        return Ok(Some((file.command, format.to_owned())));
    }
    let is_refused = PICTURES.contains(&&*file.command)
        || OF_OTHER_COMMANDS.contains(&&*file.extension)
        || file.is_foreign;
    if !is_refused {
        return Ok(None);
    }
    let extension_of = |format: &String| {
        let other = EXTENSIONS.iter().find(|(_, name)| name == format);
        format!(".{}", other.map_or(&**format, |(extension, _)| extension))
    };
    let known: Vec<String> = file.formats.iter().map(extension_of).collect();
    Err(Failure::Usage(
        words().no_format_of_extension(&file.extension, &known.join(", ")),
    ))
}

/// The output file of a command that has formats, if the command line names no format.
struct OutputFile {
    command: String,
    /// The names of the command's formats.
    formats: Vec<String>,
    /// The extension in lower case.
    extension: String,
    /// The extension belongs to a format that no command writes as text.
    is_foreign: bool,
}

impl OutputFile {
    fn of(krank: Command, arguments: &[OsString]) -> Option<OutputFile> {
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
        let formats = formats.iter().map(|format| format.get_name().to_owned());
        Some(OutputFile {
            command: command.get_name().to_owned(),
            formats: formats.collect(),
            extension: output.extension()?.to_str()?.to_ascii_lowercase(),
            is_foreign: foreign_extension(output).is_some(),
        })
    }
}
