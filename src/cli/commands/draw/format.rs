//! Lists the drawing formats; each has its own file.

use super::{DrawArgs, DrawnScene, NamesChoice};
use crate::cli::failure::Failure;
use crate::wording::Wording;

/// A drawing format.
#[derive(Debug)]
pub(in crate::cli) struct DrawFormat {
    /// The name in `--format`, which must not change.
    pub(in crate::cli) name: &'static str,
    pub(in crate::cli) about: Wording,
    /// The options that it supports beyond those of all images.
    pub(super) takes: &'static [&'static str],
    /// `true` if the output is an image for viewing, which supports all display options.
    pub(super) is_picture: bool,
    /// `true` if the output is binary, which is never sent to a terminal.
    pub(super) is_binary: bool,
    pub(super) write: fn(&DrawnScene<'_>) -> Result<Vec<u8>, Failure>,
}

/// An option that not every format supports: its name, and whether a command line has it.
type FormatOption = (&'static str, fn(&DrawArgs) -> bool);

/// The options that only some formats support.
const OPTIONS_OF_FORMATS: [FormatOption; 5] = [
    ("--glyphs", |args| args.glyphs.is_some()),
    ("--width", |args| args.width.is_some()),
    ("--dark", |args| args.dark),
    ("--seconds", |args| args.seconds.is_some()),
    ("--scale", |args| args.scale.is_some()),
];

/// The options that only affect an image's contents and size; every image format supports them.
const OPTIONS_OF_IMAGES: [FormatOption; 8] = [
    ("--size", |args| args.size.is_some()),
    ("--velocities", |args| args.velocities.is_some()),
    ("--accelerations", |args| args.accelerations.is_some()),
    ("--forces", |args| args.forces),
    ("--ghosts", |args| args.ghosts > 0),
    ("--names", |args| args.names != NamesChoice::Points),
    ("--centres", |args| args.centres),
    ("--no-guides", |args| args.no_guides),
];

impl DrawFormat {
    pub(super) fn takes_it(&self, option: &str) -> bool {
        let is_of_images = || OPTIONS_OF_IMAGES.iter().any(|(name, _)| *name == option);
        self.takes.contains(&option) || self.is_picture && is_of_images()
    }
}

/// Returns the names of the options of a command line that not every format supports.
pub(super) fn requested(args: &DrawArgs) -> impl Iterator<Item = &'static str> {
    let options = OPTIONS_OF_FORMATS.iter().chain(&OPTIONS_OF_IMAGES);
    let requested = options.filter(|(_, is_requested)| is_requested(args));
    requested.map(|(name, _)| *name)
}

#[cfg(test)]
mod tests {
    use super::super::FORMATS;
    use super::*;

    #[test]
    fn formats_take_known_options() {
        for format in FORMATS {
            for option in format.takes {
                let is_known = OPTIONS_OF_FORMATS
                    .iter()
                    .chain(&OPTIONS_OF_IMAGES)
                    .any(|(name, _)| name == option);
                assert!(is_known, "{} {option}", format.name);
            }
        }
    }
}
