//! The configuration: found, read, and printed as it is built in.

use super::failure::{Failure, say};
use super::output::write_text;
use super::screen::TextScreen;
use crate::files::{from_home, places, read_file};
use crate::scene::LARGEST_FILE;
use crate::tui::{self, Config};
use crate::wording::{Language, words};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// `krank config`.
pub(super) fn config(screen: TextScreen) -> Result<(), Failure> {
    write_text(None, &screen.shown(&tui::template()))
}

/// The language that is configured, for what is said before anything else is asked of the configuration. What is
/// wrong with it is told by whoever needs it, and what comes through a pipe can be read once.
pub(super) fn language(named: Option<&Path>) -> Option<Language> {
    let path = place(named).filter(|path| path.is_file())?;
    let bytes = read_file(&path, LARGEST_FILE).ok()?;
    Config::language_in(str::from_utf8(&bytes).ok()?)
}

/// Whether a file is not there, be it that its folder is none.
fn is_absent(error: &io::Error) -> bool {
    let kind = error.kind();
    matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory)
}

/// Where the configuration is, if anywhere.
fn place(named: Option<&Path>) -> Option<PathBuf> {
    let env = places::environment;
    // What a shell leaves of `--config=~/krank.toml`.
    let meant = |path: &Path| {
        path.to_str()
            .map_or_else(|| path.to_owned(), |typed| from_home(typed, env))
    };
    named.map(meant).or_else(|| Config::path(env))
}

/// What a person has configured, in the file that is named or where it is looked for. That none is there is
/// no fault, unless it was named.
pub(super) fn load(named: Option<&Path>) -> Result<Config, Failure> {
    let Some(path) = place(named) else {
        return Ok(Config::default());
    };
    let shown = path.display().to_string();
    match read_file(&path, LARGEST_FILE) {
        Ok(bytes) => {
            let config = Config::read(&bytes, &shown).map_err(Failure::Scene)?;
            if let Some(warnings) = &config.warnings {
                let screen = TextScreen::detect();
                say(&warnings.render(screen.ascii, screen.colour));
            }
            Ok(config)
        }
        Err(e) if named.is_none() && is_absent(&e) => Ok(Config::default()),
        Err(e) => Err(Failure::Usage(
            words().cannot_read(&format!("`{shown}`"), &e),
        )),
    }
}
