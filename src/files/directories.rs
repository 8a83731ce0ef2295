//! Finds krank's own folders according to the XDG Base Directory Specification 0.8.

use std::path::PathBuf;

/// Returns krank's folder below the one given by an environment variable, or else below `in_home`
/// in the home folder; `None` without a home folder. A path that is not absolute is ignored, as the
/// specification requires.
pub(crate) fn folder_of(
    variable: &str,
    in_home: &str,
    env: impl Fn(&str) -> Option<PathBuf>,
) -> Option<PathBuf> {
    let absolute = |name: &str| env(name).filter(|path| path.is_absolute());
    let base = absolute(variable).or_else(|| Some(absolute("HOME")?.join(in_home)))?;
    Some(base.join("krank"))
}

/// Returns the folder for records of files written in place.
pub(crate) fn records(env: impl Fn(&str) -> Option<PathBuf>) -> Option<PathBuf> {
    Some(folder_of("XDG_STATE_HOME", ".local/state", env)?.join("recovery/writing"))
}

/// Returns a variable of this process's environment. Without `HOME`, the home folder comes from the
/// password database.
pub(crate) fn environment(name: &str) -> Option<PathBuf> {
    let set = std::env::var_os(name).map(PathBuf::from);
    match name {
        "HOME" => set.or_else(std::env::home_dir),
        _ => set,
    }
}
