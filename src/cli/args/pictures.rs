//! Arguments of `krank draw` and `krank plot`.

use super::{BandChoice, OutputArgs, PlaceArgs, SceneArgs};
use crate::cli::draw::{DrawFormat, FORMATS};
use crate::drawing::{Blocks, Glyphs};
use crate::report::WrittenDecimal;
use crate::wording::words;
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::str::FromStr;

/// The characters to draw with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum GlyphChoice {
    #[value(help = words().glyphs_as_allowed())]
    #[default]
    Auto,
    #[value(help = words().glyphs_of_seven_bits())]
    Ascii,
    #[value(help = words().glyphs_of_boxes())]
    Line,
    #[value(help = words().glyphs_of_braille())]
    Braille,
    #[value(help = words().glyphs_of_quadrants())]
    Quadrants,
    #[value(help = words().glyphs_of_sextants())]
    Sextants,
    #[value(help = words().glyphs_of_octants())]
    Octants,
}

impl GlyphChoice {
    /// Returns the requested characters; `None` for `auto`.
    pub(in crate::cli) fn asked(self) -> Option<Glyphs> {
        match self {
            GlyphChoice::Auto => None,
            GlyphChoice::Ascii => Some(Glyphs::Ascii),
            GlyphChoice::Line => Some(Glyphs::Line),
            GlyphChoice::Braille => Some(Glyphs::Braille),
            GlyphChoice::Quadrants => Some(Glyphs::Blocks(Blocks::Quadrants)),
            GlyphChoice::Sextants => Some(Glyphs::Blocks(Blocks::Sextants)),
            GlyphChoice::Octants => Some(Glyphs::Blocks(Blocks::Octants)),
        }
    }
}

/// How a plot is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum PictureFormat {
    #[value(help = words().format_characters())]
    #[default]
    Text,
    #[value(help = words().format_svg())]
    Svg,
}

/// A size in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::cli) struct Size {
    pub(in crate::cli) cols: u16,
    pub(in crate::cli) rows: u16,
}

/// Maximum number of columns or rows; larger pictures only waste memory.
const MAX_SIDE: u16 = 2000;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(['x', 'X']);
        let side = |text: &str| text.parse().ok().filter(|n| (1..=MAX_SIDE).contains(n));
        let size = sides.and_then(|(cols, rows)| {
            Some(Size {
                cols: side(cols)?,
                rows: side(rows)?,
            })
        });
        size.ok_or_else(|| words().size_is_meant(&MAX_SIDE))
    }
}

/// The scale of a drawing on paper: `1:2` is half as large as the linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::cli) struct PaperScale(f64);

impl PaperScale {
    /// Returns the ratio of lengths on paper to lengths of the linkage.
    pub(in crate::cli) fn factor(self) -> f64 {
        self.0
    }
}

impl FromStr for PaperScale {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(':');
        let side = |text: &str| {
            text.trim()
                .parse()
                .ok()
                .filter(|n: &f64| n.is_normal() && *n > 0.0)
        };
        let factor = sides.and_then(|(paper, linkage)| Some(side(paper)? / side(linkage)?));
        let factor = factor.filter(|factor| (1.0 / MAX_SCALE..=MAX_SCALE).contains(factor));
        factor
            .map(PaperScale)
            .ok_or_else(|| words().scale_is_meant(MAX_SCALE))
    }
}

/// Maximum enlargement and reduction: the scales of ISO 5455 end at 1:10000.
const MAX_SCALE: f64 = 10_000.0;

/// Maximum number of ghosts; more would hide each other.
const MAX_GHOSTS: i64 = 360;

/// Maximum width of an image, in pixels; screens are not wider.
const MAX_PIXELS: i64 = 8192;
/// Maximum duration of a turn, in seconds; nobody watches it for longer.
const MAX_SECONDS: i64 = 60;

#[derive(Debug, Args)]
pub(in crate::cli) struct DrawArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    #[arg(help = words().trace_points())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) traces: Option<Vec<String>>,
    #[arg(help = words().draw_velocities())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) velocities: Option<Vec<String>>,
    #[arg(help = words().draw_accelerations())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(in crate::cli) accelerations: Option<Vec<String>>,
    #[arg(help = words().draw_forces())]
    #[arg(long)]
    pub(in crate::cli) forces: bool,
    #[arg(help = words().draw_ghosts())]
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MAX_GHOSTS))]
    pub(in crate::cli) ghosts: u16,
    #[arg(help = words().names_to_write())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) names: NamesChoice,
    #[arg(help = words().mark_centres())]
    #[arg(long)]
    pub(in crate::cli) centres: bool,
    #[arg(help = words().leave_guides_out())]
    #[arg(long)]
    pub(in crate::cli) no_guides: bool,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: GlyphChoice,
    #[arg(help = words().size_of_drawing())]
    #[arg(long, value_name = "COLSxROWS")]
    pub(in crate::cli) size: Option<Size>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value = "text")]
    pub(in crate::cli) format: &'static DrawFormat,
    #[arg(help = words().scale_on_paper())]
    #[arg(long, value_name = "PAPER:LINKAGE")]
    pub(in crate::cli) scale: Option<PaperScale>,
    #[arg(help = words().width_in_pixels())]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u16).range(16..=MAX_PIXELS))]
    pub(in crate::cli) width: Option<u16>,
    #[arg(help = words().on_a_dark_ground())]
    #[arg(long)]
    pub(in crate::cli) dark: bool,
    #[arg(help = words().seconds_of_turn())]
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u16).range(1..=MAX_SECONDS))]
    pub(in crate::cli) seconds: Option<u16>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

/// The values of `--format` are the names and descriptions of the formats.
impl ValueEnum for &'static DrawFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name).help((self.about)(words())))
    }
}

/// The names in a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum NamesChoice {
    #[value(help = words().names_none())]
    None,
    #[value(help = words().names_of_points_alone())]
    #[default]
    Points,
    #[value(help = words().names_all())]
    All,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlotArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().columns_to_plot())]
    #[arg(long, value_name = "PATTERNS", required = true)]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().plot_against())]
    #[arg(long, value_name = "NAME", default_value = "driver")]
    pub(in crate::cli) against: String,
    #[arg(help = words().measured_figures())]
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) measured: Option<PathBuf>,
    #[arg(help = words().driver_begins())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) from: Option<WrittenDecimal>,
    #[arg(help = words().driver_ends())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) to: Option<WrittenDecimal>,
    #[arg(help = words().leave_extrema_out())]
    #[arg(long)]
    pub(in crate::cli) no_extrema: bool,
    #[arg(help = words().band_of_tolerances())]
    #[arg(long, value_enum)]
    pub(in crate::cli) band: Option<BandChoice>,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) glyphs: GlyphChoice,
    #[arg(help = words().size_of_plot())]
    #[arg(long, value_name = "COLSxROWS")]
    pub(in crate::cli) size: Option<Size>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: PictureFormat,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
