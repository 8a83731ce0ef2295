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
    /// The format-specific options that it supports.
    pub(super) takes: &'static [FormatOption],
    /// `true` if the output is an image for viewing, which supports all display options.
    pub(super) is_picture: bool,
    /// `true` if the output is binary, which is never sent to a terminal.
    pub(super) is_binary: bool,
    pub(super) write: fn(&DrawnScene<'_>) -> Result<Vec<u8>, Failure>,
}

/// An option that not every format supports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FormatOption {
    Glyphs,
    Width,
    Dark,
    Seconds,
    Scale,
    Size,
    Velocities,
    Accelerations,
    Forces,
    Ghosts,
    Names,
    Centres,
    NoGuides,
}

impl DrawFormat {
    pub(super) fn takes_it(&self, option: FormatOption) -> bool {
        self.takes.contains(&option) || self.is_picture && option.only_shows()
    }
}

impl FormatOption {
    pub(super) const ALL: [FormatOption; 13] = [
        FormatOption::Glyphs,
        FormatOption::Width,
        FormatOption::Dark,
        FormatOption::Seconds,
        FormatOption::Scale,
        FormatOption::Size,
        FormatOption::Velocities,
        FormatOption::Accelerations,
        FormatOption::Forces,
        FormatOption::Ghosts,
        FormatOption::Names,
        FormatOption::Centres,
        FormatOption::NoGuides,
    ];

    /// Returns `true` if the option only affects an image's contents and size, so that every image
    /// format supports it.
    fn only_shows(self) -> bool {
        !matches!(
            self,
            FormatOption::Glyphs
                | FormatOption::Width
                | FormatOption::Dark
                | FormatOption::Seconds
                | FormatOption::Scale
        )
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            FormatOption::Glyphs => "--glyphs",
            FormatOption::Width => "--width",
            FormatOption::Dark => "--dark",
            FormatOption::Seconds => "--seconds",
            FormatOption::Scale => "--scale",
            FormatOption::Size => "--size",
            FormatOption::Velocities => "--velocities",
            FormatOption::Accelerations => "--accelerations",
            FormatOption::Forces => "--forces",
            FormatOption::Ghosts => "--ghosts",
            FormatOption::Names => "--names",
            FormatOption::Centres => "--centres",
            FormatOption::NoGuides => "--no-guides",
        }
    }

    pub(super) fn is_requested(self, args: &DrawArgs) -> bool {
        match self {
            FormatOption::Glyphs => args.glyphs.is_some(),
            FormatOption::Width => args.width.is_some(),
            FormatOption::Dark => args.dark,
            FormatOption::Seconds => args.seconds.is_some(),
            FormatOption::Scale => args.scale.is_some(),
            FormatOption::Size => args.size.is_some(),
            FormatOption::Velocities => args.velocities.is_some(),
            FormatOption::Accelerations => args.accelerations.is_some(),
            FormatOption::Forces => args.forces,
            FormatOption::Ghosts => args.ghosts > 0,
            FormatOption::Names => args.names != NamesChoice::Points,
            FormatOption::Centres => args.centres,
            FormatOption::NoGuides => args.no_guides,
        }
    }
}
