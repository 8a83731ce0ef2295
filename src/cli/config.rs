//! The configuration: found, read, and printed as it is built in.

use super::failure::Failure;
use super::output::write_text;
use crate::files::{from_home, read_file};
use crate::scene::LARGEST_FILE;
use crate::tui::{self, Config};
use crate::wording::words;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// `krank config`.
pub(super) fn config() -> Result<(), Failure> {
    write_text(None, &tui::template())
}

/// Whether a file is not there, be it that its folder is none.
fn is_absent(error: &io::Error) -> bool {
    let kind = error.kind();
    matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory)
}

/// What a person has configured, in the file that is named or where it is looked for. That none is there is
/// no fault, unless it was named.
pub(super) fn load(named: Option<&Path>) -> Result<Config, Failure> {
    let env = |name: &str| std::env::var_os(name).map(PathBuf::from);
    // What a shell leaves of `--config=~/krank.toml`.
    let meant = |path: &Path| {
        path.to_str()
            .map_or_else(|| path.to_owned(), |typed| from_home(typed, env))
    };
    let Some(path) = named.map(meant).or_else(|| Config::path(env)) else {
        return Ok(Config::default());
    };
    let shown = path.display().to_string();
    match read_file(&path, LARGEST_FILE) {
        Ok(bytes) => Config::read(&bytes, &shown).map_err(Failure::Scene),
        Err(e) if named.is_none() && is_absent(&e) => Ok(Config::default()),
        Err(e) => Err(Failure::Usage(
            words().cannot_read(&format!("`{shown}`"), &e),
        )),
    }
}
