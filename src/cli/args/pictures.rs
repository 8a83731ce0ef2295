//! Drawings and plots.

use super::{OutputArgs, PlaceArgs, SceneArgs};
use crate::report::Decimal;
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::str::FromStr;

/// The characters to draw with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Glyphs {
    /// As the locale and the terminal allow
    #[default]
    Auto,
    /// 7-bit characters
    Ascii,
    /// Box-drawing characters, which console fonts have too
    Line,
    /// Braille patterns
    Braille,
}

/// How a drawing is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum PictureFormat {
    /// Characters
    #[default]
    Text,
    /// Scalable vector graphics, for a browser or a report
    Svg,
}

/// A size in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) struct Size {
    pub(in crate::cli) cols: u16,
    pub(in crate::cli) rows: u16,
}

/// Nobody looks at more characters than this; memory is for something else.
const LARGEST_SIDE: u16 = 2000;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(['x', 'X']);
        let side = |text: &str| text.parse().ok().filter(|n| (1..=LARGEST_SIDE).contains(n));
        let size = sides.and_then(|(cols, rows)| {
            Some(Size {
                cols: side(cols)?,
                rows: side(rows)?,
            })
        });
        size.ok_or_else(|| words().size_is_meant(&LARGEST_SIDE))
    }
}

/// More positions would hide each other.
const MOST_GHOSTS: i64 = 360;

#[derive(Debug, Args)]
pub(in crate::cli) struct DrawArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    /// Trace points over the whole motion
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) traces: Option<Vec<String>>,
    /// Arrows of velocity
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) velocities: Option<Vec<String>>,
    /// Arrows of acceleration
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) accelerations: Option<Vec<String>>,
    /// Show the linkage at so many places of its motion
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MOST_GHOSTS))]
    pub(in crate::cli) ghosts: u16,
    /// Which names to write
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) names: Names,
    /// Mark centres of mass
    #[arg(long)]
    pub(in crate::cli) centres: bool,
    /// Leave out guides and supports
    #[arg(long)]
    pub(in crate::cli) no_guides: bool,
    /// The characters to draw with
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: Glyphs,
    /// How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100 wide for an SVG]
    #[arg(long, value_name = "COLSxROWS")]
    pub(in crate::cli) size: Option<Size>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: PictureFormat,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

/// The names in a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Names {
    /// None
    None,
    /// Of points
    #[default]
    Points,
    /// Of points and links
    All,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    /// Names of figures, * for any characters; separated by commas
    #[arg(long, value_name = "PATTERNS", value_delimiter = ',', required = true)]
    pub(in crate::cli) columns: Vec<String>,
    /// What stands along x: driver, time, or the name of a figure
    #[arg(long, value_name = "NAME", default_value = "driver")]
    pub(in crate::cli) against: String,
    /// Where the driver begins [default: the beginning of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) from: Option<Decimal>,
    /// Where the driver ends [default: the end of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) to: Option<Decimal>,
    /// Leave out the marks at maxima and minima
    #[arg(long)]
    pub(in crate::cli) no_extrema: bool,
    /// The characters to draw with
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: Glyphs,
    /// How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100x40 for an SVG]
    #[arg(long, value_name = "COLSxROWS")]
    pub(in crate::cli) size: Option<Size>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: PictureFormat,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
