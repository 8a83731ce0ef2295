//! Arguments of `krank tolerance`: length errors and clearance in pins.

use super::{CsvArgs, OutputArgs, OutputFormat, SceneArgs};
use crate::report::WrittenDecimal;
use crate::study::{BandKind, Distribution};
use crate::wording::words;
use clap::{Args, ValueEnum};

/// How lengths are spread among the samples.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum SpreadChoice {
    #[default]
    #[value(help = words().spread_choice_normal())]
    Normal,
    #[value(help = words().spread_choice_even())]
    Even,
}

impl SpreadChoice {
    pub(in crate::cli) fn distribution(self) -> Distribution {
        match self {
            SpreadChoice::Normal => Distribution::Normal,
            SpreadChoice::Even => Distribution::Even,
        }
    }
}

/// Which limits are drawn beside a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum BandChoice {
    #[value(help = words().band_worst())]
    Worst,
    #[value(help = words().band_root_sum_square())]
    Rss,
}

impl BandChoice {
    pub(in crate::cli) fn kind(self) -> BandKind {
        match self {
            BandChoice::Worst => BandKind::Worst,
            BandChoice::Rss => BandKind::RootSumSquare,
        }
    }
}

/// Maximum number of samples; more take memory and add no information.
const MAX_SAMPLES: i64 = 10_000_000;

#[derive(Debug, Args)]
pub(in crate::cli) struct ToleranceArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().columns_of_tolerances())]
    #[arg(long, value_name = "PATTERNS")]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().place_of_tolerances())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(in crate::cli) at: Option<WrittenDecimal>,
    #[arg(help = words().first_row())]
    #[arg(
        long,
        value_name = "COORDINATE",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    pub(in crate::cli) from: Option<WrittenDecimal>,
    #[arg(help = words().last_row())]
    #[arg(
        long,
        value_name = "COORDINATE",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    pub(in crate::cli) to: Option<WrittenDecimal>,
    #[arg(help = words().row_to_row_of_tolerances())]
    #[arg(
        long,
        value_name = "STEP",
        allow_hyphen_values = true,
        conflicts_with = "at"
    )]
    pub(in crate::cli) step: Option<WrittenDecimal>,
    #[arg(help = words().tolerance_of_all())]
    #[arg(long, value_name = "TOLERANCE", allow_negative_numbers = true)]
    pub(in crate::cli) tolerance: Option<String>,
    #[arg(help = words().machines_by_chance())]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MAX_SAMPLES))]
    pub(in crate::cli) samples: Option<u32>,
    #[arg(help = words().seed_of_samples())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(in crate::cli) seed: u64,
    #[arg(help = words().spread_of_lengths())]
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) distribution: SpreadChoice,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
