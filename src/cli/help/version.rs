//! `krank --version --long`: prints the build configuration.

use crate::wording::words;
use std::env::consts::{ARCH, OS};

/// The option that adds these lines to `--version`.
pub(in crate::cli) const LONG: &str = "--long";

/// Returns the lines: features, target, profile and licence.
pub(in crate::cli) fn details() -> String {
    let features = [
        ("tui", cfg!(feature = "tui")),
        ("pictures", cfg!(feature = "pictures")),
    ];
    let features = features.into_iter().filter(|(_, is_built_in)| *is_built_in);
    let features: Vec<&str> = features.map(|(name, _)| name).collect();
    let features = match features.is_empty() {
        true => "-".to_owned(),
        false => features.join(", "),
    };
    let library = [
        ("-gnu", cfg!(target_env = "gnu")),
        ("-musl", cfg!(target_env = "musl")),
        ("-msvc", cfg!(target_env = "msvc")),
    ];
    let library = library.into_iter().find(|(_, is_linked)| *is_linked);
    let target = format!("{ARCH}-{OS}{}", library.map_or("", |(name, _)| name));
    let profile = match cfg!(debug_assertions) {
        true => "dev",
        false => "release",
    };
    words().build_details(&features, &target, profile, env!("CARGO_PKG_LICENSE")) + "\n"
}
