//! Finds and reads the configuration, and prints the default one.

use crate::cli::failure::{Failure, print_text};
use crate::cli::output::write_text;
use crate::cli::screen::TextScreen;
use crate::files::{directories, from_home, read_file};
use crate::scene::MAX_FILE_SIZE;
use crate::tui::{self, Config};
use crate::wording::{Language, words};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Runs `krank config`: prints the default configuration.
pub(in crate::cli) fn config(screen: TextScreen) -> Result<(), Failure> {
    write_text(None, &screen.shown(&tui::template()))
}

/// Returns the configured language, for messages before the configuration is loaded. Ignores
/// errors, which `load` reports, and pipes, which can be read only once.
pub(in crate::cli) fn language(named: Option<&Path>) -> Option<Language> {
    let path = place(named).filter(|path| path.is_file())?;
    let bytes = read_file(&path, MAX_FILE_SIZE).ok()?;
    Config::language_in(str::from_utf8(&bytes).ok()?)
}

/// Returns `true` if the error means that the file does not exist, or that its folder is not a
/// folder.
fn is_absent(error: &io::Error) -> bool {
    let kind = error.kind();
    matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory)
}

/// Returns the path of the configuration, if any.
fn place(named: Option<&Path>) -> Option<PathBuf> {
    let env = directories::environment;
    // The shell does not expand `~` in `--config=~/krank.toml`.
    let intended = |path: &Path| {
        path.to_str()
            .map_or_else(|| path.to_owned(), |typed| from_home(typed, env))
    };
    named.map(intended).or_else(|| Config::path(env))
}

/// Loads the configuration from the named file or its default path. A missing file is an error only
/// if it was named.
pub(in crate::cli) fn load(named: Option<&Path>) -> Result<Config, Failure> {
    let Some(path) = place(named) else {
        return Ok(Config::default());
    };
    let shown = path.display().to_string();
    match read_file(&path, MAX_FILE_SIZE) {
        Ok(bytes) => {
            let config = Config::read(&bytes, &shown).map_err(Failure::Scene)?;
            if let Some(warnings) = &config.warnings {
                let screen = TextScreen::detect();
                print_text(&warnings.render(screen.ascii, screen.colour));
            }
            Ok(config)
        }
        Err(e) if named.is_none() && is_absent(&e) => Ok(Config::default()),
        Err(e) => Err(Failure::Usage(
            words().cannot_read(&format!("`{shown}`"), &e),
        )),
    }
}
