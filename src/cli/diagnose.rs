//! `krank --diagnose`: what was found of the terminal, and why, so that whoever sees a wrong character or
//! none can say what their terminal says.

use super::args::WorkbenchArgs;
use super::failure::Failure;
use super::output::write_text;
use super::screen::judgement;
use super::workbench::options;
use crate::capability::{Colours, Found, Judgement};
use crate::drawing::Glyphs;
use crate::scene::sanitized;
use crate::tui::{Options, Terminal, Theme};
use std::env;
use std::io::{IsTerminal, stderr, stdin, stdout};
use std::path::PathBuf;

/// Columns of the names.
const NAMES: usize = 17;

/// Prints it; it works in a pipe as well, and without any terminal.
pub(super) fn diagnose(args: &WorkbenchArgs) -> Result<(), Failure> {
    let (judgement, options) = (judgement(), options(args)?);
    let mut rows = Vec::new();
    for (name, value) in judgement.variables() {
        rows.push((name, value.map_or_else(|| "not set".into(), quoted)));
    }
    rows.extend(streams());
    rows.extend(Terminal::find().map_or_else(no_terminal, |found| about(&found)));
    rows.extend(chosen(&judgement, &options));
    rows.push((
        "configuration",
        place("XDG_CONFIG_HOME", ".config", "config.toml"),
    ));
    rows.push(("state", place("XDG_STATE_HOME", ".local/state", "")));
    let mut text = format!("krank {}\n", env!("CARGO_PKG_VERSION"));
    for (name, what) in rows {
        text += &format!("{name:NAMES$}{}\n", sanitized(&what, true));
    }
    write_text(None, &text)
}

fn quoted(value: &str) -> String {
    format!("\"{value}\"")
}

type Row = (&'static str, String);

fn streams() -> [Row; 3] {
    let of = |is_terminal: bool| {
        let what = if is_terminal {
            "a terminal"
        } else {
            "no terminal"
        };
        what.to_owned()
    };
    [
        ("standard input", of(stdin().is_terminal())),
        ("standard output", of(stdout().is_terminal())),
        ("standard error", of(stderr().is_terminal())),
    ]
}

fn no_terminal() -> Vec<Row> {
    vec![("screen", "there is none, and no /dev/tty either".into())]
}

fn about(found: &Terminal) -> Vec<Row> {
    let size = match found.size {
        (0, _) | (_, 0) => "no size is told; 80 x 24 is assumed".to_owned(),
        (columns, rows) => format!("{columns} x {rows} characters"),
    };
    let cell = match found.cell {
        Some((width, height)) => format!("{width} x {height} pixels"),
        None => "no pixels are told; twice as high as wide is assumed".to_owned(),
    };
    let line = match found.baud {
        Some(baud) => format!("serial, {baud} baud: at most {} bytes a frame", baud / 40),
        None if found.console => "a console of this machine".to_owned(),
        None => "a pseudo-terminal; its speed is measured while frames are sent".to_owned(),
    };
    vec![("screen", size), ("cells", cell), ("line", line)]
}

/// What the workbench would use, and why.
fn chosen(judgement: &Judgement, options: &Options) -> Vec<Row> {
    let glyphs = wished(options.glyphs, judgement.glyphs(), glyphs_name);
    let plain = (options.theme == Theme::Plain).then_some(Colours::None);
    let colours = options.colours.or(plain);
    let colours = wished(colours, judgement.colours(), Colours::name);
    let modern = judgement.capability(None, None).map(|c| c.modern);
    let frames = match modern {
        None => "none: TERM=dumb cannot show the workbench",
        Some(true) => "whole at once (?2026), pasted text is marked (?2004)",
        Some(false) => "plain; pasted text cannot be told from keys",
    };
    vec![
        ("glyphs", glyphs),
        ("colours", colours),
        ("theme", options.theme.name().to_owned()),
        ("frames", frames.to_owned()),
    ]
}

fn wished<T: Copy + PartialEq>(
    wish: Option<T>,
    found: Found<T>,
    name: impl Fn(T) -> &'static str,
) -> String {
    match wish {
        None => format!("{}: {}", name(found.value), found.why),
        Some(wish) => format!(
            "{}: asked for; else {}: {}",
            name(wish),
            name(found.value),
            found.why
        ),
    }
}

fn glyphs_name(glyphs: Glyphs) -> &'static str {
    match glyphs {
        Glyphs::Ascii => "ascii",
        Glyphs::Line => "line",
        Glyphs::Braille => "braille",
    }
}

/// Where a file of ours would be, and whether there is one.
fn place(variable: &str, below_home: &str, file: &str) -> String {
    let set = env::var_os(variable).map(PathBuf::from);
    // The specification has relative paths ignored.
    let folder = set.filter(|path| path.is_absolute()).or_else(|| {
        let home = env::var_os("HOME").filter(|home| !home.is_empty())?;
        Some(PathBuf::from(home).join(below_home))
    });
    let Some(folder) = folder else {
        return format!("nowhere: neither {variable} nor HOME is set");
    };
    let path = folder.join("krank").join(file);
    let there = if path.exists() {
        ""
    } else {
        " (there is none)"
    };
    format!("{}{there}", path.display())
}
