//! Arguments of the commands that list values, and of `krank accuracy`.

use super::{AssemblyArgs, CsvArgs, OutputArgs, PlaceArgs, SceneArgs};
use crate::report::{Guess, PositionMethod, WorkingNotation, WrittenDecimal};
use crate::study::USUAL_POSITIONS;
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum OutputFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
    #[value(help = words().format_json())]
    Json,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct FigureArgs {
    #[arg(help = words().digits_of_tables())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[arg(help = words().leave_units_out())]
    #[arg(long)]
    pub(in crate::cli) no_units: bool,
    #[arg(help = words().add_bounds())]
    #[arg(long)]
    pub(in crate::cli) bounds: bool,
    #[arg(help = words().add_sensitivity())]
    #[arg(long)]
    pub(in crate::cli) sensitivity: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct TableArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    #[arg(help = words().moment_of_motion())]
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true, conflicts_with_all = ["at", "sensitivity"])]
    pub(in crate::cli) time: Option<WrittenDecimal>,
    #[arg(help = words().columns_of_table())]
    #[arg(long, value_name = "PATTERNS")]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) figures: FigureArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TextFormat {
    #[value(help = words().format_plain())]
    Text,
    #[value(help = words().format_markdown())]
    Markdown,
}

/// A way to fill the position table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum MethodChoice {
    #[value(help = words().method_closed())]
    Closed,
    #[value(help = words().method_newton())]
    Newton,
    #[value(help = words().method_bisection())]
    Bisection,
    #[value(help = words().method_graphical())]
    Graphical,
}

impl MethodChoice {
    pub(in crate::cli) fn method(self) -> PositionMethod {
        match self {
            MethodChoice::Closed => PositionMethod::Closed,
            MethodChoice::Newton => PositionMethod::Newton,
            MethodChoice::Bisection => PositionMethod::Bisection,
            MethodChoice::Graphical => PositionMethod::Graphical,
        }
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExplainArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    #[arg(help = words().method_of_positions())]
    #[arg(long, value_enum, default_value_t = MethodChoice::Closed)]
    pub(in crate::cli) method: MethodChoice,
    #[arg(help = words().guess_of_vectors())]
    #[arg(long, value_name = "NAME=VALUE", value_delimiter = ',')]
    pub(in crate::cli) guess: Vec<Guess>,
    #[arg(help = words().notation_of_working())]
    #[arg(long, value_enum, default_value_t = WorkingNotation::Krank)]
    pub(in crate::cli) notation: WorkingNotation,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = TextFormat::Text)]
    pub(in crate::cli) format: TextFormat,
    #[arg(help = words().digits())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SweepArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().first_row())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) from: Option<WrittenDecimal>,
    #[arg(help = words().last_row())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) to: Option<WrittenDecimal>,
    #[arg(help = words().row_to_row())]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(in crate::cli) step: Option<WrittenDecimal>,
    #[arg(help = words().rows_over_time())]
    #[arg(long, conflicts_with_all = ["measured", "sensitivity"])]
    pub(in crate::cli) time: bool,
    #[arg(help = words().columns_or_all())]
    #[arg(long, value_name = "PATTERNS")]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().measured_figures())]
    #[arg(long, value_name = "FILE", conflicts_with_all = ["from", "to", "step", "bounds", "sensitivity"])]
    pub(in crate::cli) measured: Option<PathBuf>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Csv)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) figures: FigureArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

/// Maximum number of positions; more take minutes and find no larger error.
const MAX_POSITIONS: i64 = 1_000_000;

#[derive(Debug, Args)]
pub(in crate::cli) struct AccuracyArgs {
    #[arg(help = words().name_of_scene())]
    #[arg(default_value = "four-bar")]
    pub(in crate::cli) scene: PathBuf,
    #[arg(help = words().positions_to_compare())]
    #[arg(long, value_name = "N", default_value_t = USUAL_POSITIONS, value_parser = clap::value_parser!(u32).range(1..=MAX_POSITIONS))]
    pub(in crate::cli) positions: u32,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
