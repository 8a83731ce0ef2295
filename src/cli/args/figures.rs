//! Figures: at one place, row by row, and how exact they are.

use super::{AssemblyArgs, OutputArgs, PlaceArgs, SCENE_HELP, SceneArgs};
use crate::report::Decimal;
use crate::study::USUAL_POSITIONS;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Format {
    /// Aligned columns, for a person
    Text,
    /// Comma separated values
    Csv,
    /// One object
    Json,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct FigureArgs {
    /// Significant digits of text tables; CSV and JSON always carry all
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    /// Leave the units out
    #[arg(long)]
    pub(in crate::cli) no_units: bool,
    /// Add what the error of each figure does not exceed; nothing where no bound can be proved
    #[arg(long)]
    pub(in crate::cli) bounds: bool,
    /// Add what the given lengths do to each figure: by how much it changes for one unit of length
    #[arg(long)]
    pub(in crate::cli) sensitivity: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct TableArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(in crate::cli) format: Format,
    #[command(flatten)]
    pub(in crate::cli) figures: FigureArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TextFormat {
    /// Plain text of 80 columns
    Text,
    /// Markdown
    Markdown,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExplainArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    /// How to write it
    #[arg(long, value_enum, default_value_t = TextFormat::Text)]
    pub(in crate::cli) format: TextFormat,
    /// Significant digits
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SweepArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    /// The first row [default: the beginning of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) from: Option<Decimal>,
    /// The last row, where the step hits it [default: the end of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) to: Option<Decimal>,
    /// From row to row, negative to go down [default: 1 deg; for a slide, 100 to 250 rows]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(in crate::cli) step: Option<Decimal>,
    /// Names of figures, * for any characters; separated by commas [default: all vectors and points]
    #[arg(long, value_name = "PATTERNS", value_delimiter = ',')]
    pub(in crate::cli) columns: Vec<String>,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(in crate::cli) format: Format,
    #[command(flatten)]
    pub(in crate::cli) figures: FigureArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

/// More positions take minutes and find no larger error.
const MOST_POSITIONS: i64 = 1_000_000;

#[derive(Debug, Args)]
pub(in crate::cli) struct AccuracyArgs {
    #[arg(help = SCENE_HELP, default_value = "four-bar")]
    pub(in crate::cli) scene: PathBuf,
    /// Positions to compare at, in 360 deg or over the range, by the 360
    #[arg(long, value_name = "N", default_value_t = USUAL_POSITIONS, value_parser = clap::value_parser!(u32).range(1..=MOST_POSITIONS))]
    pub(in crate::cli) positions: u32,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(in crate::cli) format: Format,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
