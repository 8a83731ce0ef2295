//! `krank --diagnose`: reports the detected terminal and the reasons, for bug reports about wrong
//! or missing characters.

use super::args::WorkbenchArgs;
use super::open::options;
use crate::capability::{Colours, Detected, PictureChoice, TerminalProfile};
use crate::cli::choice::OrAuto;
use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::screen::judgement;
use crate::drawing::Glyphs;
use crate::files::directories;
use crate::scene::sanitized;
use crate::tui::{Options, Terminal, Theme};
use crate::wording::{Language, words};
use std::env;
use std::io::{IsTerminal, stderr, stdin, stdout};
use std::path::PathBuf;

/// Prints the diagnosis. Works in a pipe and without a terminal.
pub(in crate::cli) fn diagnose(
    args: &WorkbenchArgs,
    language: OrAuto<Language>,
) -> Result<(), Failure> {
    let (judgement, options) = (judgement(), options(args, language)?);
    let mut rows = Vec::new();
    for (name, value) in judgement.variables() {
        rows.push((name, value.map_or_else(|| words().not_set().into(), quoted)));
    }
    rows.extend(streams());
    rows.extend(Terminal::find().map_or_else(no_terminal, |found| about(&found)));
    rows.extend(chosen(&judgement, &options));
    rows.push((
        words().row_configuration(),
        place("XDG_CONFIG_HOME", ".config", "config.toml"),
    ));
    rows.push((
        words().row_state(),
        place("XDG_STATE_HOME", ".local/state", ""),
    ));
    let mut text = format!("krank {}\n", env!("CARGO_PKG_VERSION"));
    let longest = rows.iter().map(|(name, _)| name.chars().count()).max();
    let names = longest.unwrap_or(0) + 2;
    for (name, what) in rows {
        let [name, what] = [name, &what].map(|text| sanitized(text, true));
        text += &format!("{name:names$}{what}\n");
    }
    write_text(None, &text)
}

fn quoted(value: &str) -> String {
    format!("\"{value}\"")
}

type DiagnosisRow = (&'static str, String);

fn streams() -> [DiagnosisRow; 3] {
    let of = |is_terminal: bool| {
        let what = if is_terminal {
            words().a_terminal()
        } else {
            words().no_terminal()
        };
        what.to_owned()
    };
    [
        (words().standard_input(), of(stdin().is_terminal())),
        (words().standard_output(), of(stdout().is_terminal())),
        (words().standard_error(), of(stderr().is_terminal())),
    ]
}

fn no_terminal() -> Vec<DiagnosisRow> {
    vec![(words().row_screen(), words().no_screen().into())]
}

fn about(found: &Terminal) -> Vec<DiagnosisRow> {
    let size = match found.size {
        (0, _) | (_, 0) => words().no_size_told().to_owned(),
        (columns, rows) => words().size_in_characters(columns, rows),
    };
    let cell = match found.cell {
        Some((width, height)) => words().size_in_pixels(width, height),
        None => words().no_pixels_told().to_owned(),
    };
    let line = match found.baud {
        Some(baud) => words().serial_line(baud, baud / 40),
        None if found.console => words().console_here().to_owned(),
        None => words().pseudo_terminal().to_owned(),
    };
    vec![
        (words().row_screen(), size),
        (words().row_cells(), cell),
        (words().row_line(), line),
    ]
}

/// Returns the settings that the workbench would use, with the reasons.
fn chosen(judgement: &TerminalProfile, options: &Options) -> Vec<DiagnosisRow> {
    let glyphs = requested_or_detected(options.glyphs, judgement.glyphs(), Glyphs::name);
    let plain = (options.theme == Theme::Plain).then_some(Colours::None);
    let colours = options.colours.or(plain);
    let colours = requested_or_detected(colours, judgement.colours(), Colours::name);
    let modern = judgement.capability(None, None).map(|c| c.modern);
    let frames = match modern {
        None => words().frames_none(),
        Some(true) => words().frames_whole(),
        Some(false) => words().frames_plain(),
    };
    vec![
        (words().glyphs(), glyphs),
        (words().colours(), colours),
        (
            words().row_language(),
            Language::current_language().name().to_owned(),
        ),
        (words().row_theme(), options.theme.name().to_owned()),
        (words().row_frames(), frames.to_owned()),
        (words().row_pictures(), pictures(judgement, options)),
    ]
}

fn pictures(judgement: &TerminalProfile, options: &Options) -> String {
    let found = judgement.pictures(options.picture);
    let by = found.value.map_or(PictureChoice::Never, PictureChoice::By);
    format!("{}: {}", by.name(), found.why)
}

fn requested_or_detected<T: Copy + PartialEq>(
    requested: Option<T>,
    found: Detected<T>,
    name: impl Fn(T) -> &'static str,
) -> String {
    match requested {
        None => format!("{}: {}", name(found.value), found.why),
        Some(requested) => words().asked_for(name(requested), name(found.value), &found.why),
    }
}

/// Returns the path of one of krank's files, with a remark if it does not exist.
fn place(variable: &str, below_home: &str, file: &str) -> String {
    let set = env::var_os(variable).map(PathBuf::from);
    // The XDG specification requires relative paths to be ignored.
    let folder = set.filter(|path| path.is_absolute()).or_else(|| {
        let home = directories::environment("HOME").filter(|home| home.is_absolute())?;
        Some(home.join(below_home))
    });
    let Some(folder) = folder else {
        return words().nowhere_to_be(variable);
    };
    let path = folder.join("krank").join(file);
    let shown = path.display().to_string();
    match path.exists() {
        true => shown,
        false => words().there_is_none(&shown),
    }
}
