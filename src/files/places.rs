//! Folders that belong to krank, as the desktop standard has them (XDG Base Directory Specification 0.8).

use std::path::PathBuf;

/// krank's folder below the one that a variable names, or where it names none, below this one of the home.
/// A path that is not absolute is to be ignored.
pub(crate) fn folder_of(
    variable: &str,
    in_home: &str,
    env: impl Fn(&str) -> Option<PathBuf>,
) -> Option<PathBuf> {
    let absolute = |name: &str| env(name).filter(|path| path.is_absolute());
    let base = absolute(variable).or_else(|| Some(absolute("HOME")?.join(in_home)))?;
    Some(base.join("krank"))
}

/// Where old and new text are kept while a file is written in its place.
pub(crate) fn records(env: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    Some(folder_of("XDG_STATE_HOME", ".local/state", env)?.join("recovery/writing"))
}

/// What the environment of this process holds. Where it has no `HOME`, the home is that of the password database.
pub(crate) fn environment(name: &str) -> Option<PathBuf> {
    let set = std::env::var_os(name).map(PathBuf::from);
    match name {
        "HOME" => set.or_else(std::env::home_dir),
        _ => set,
    }
}
