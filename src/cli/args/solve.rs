//! Arguments of `krank solve`, which searches for the best design.

use super::{OutputArgs, SceneArgs};
use crate::study::PlanAxis;
use crate::wording::words;
use clap::{Args, ValueEnum};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum FoundFormat {
    #[value(help = words().format_for_person())]
    Text,
    #[value(help = words().format_json())]
    Json,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SolveArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().values_to_vary())]
    #[arg(
        long,
        value_name = "NAME[=LOW..HIGH]",
        value_delimiter = ',',
        required = true
    )]
    pub(in crate::cli) vary: Vec<PlanAxis>,
    #[arg(help = words().goal_to_meet())]
    #[arg(long, value_name = "GOAL")]
    pub(in crate::cli) goal: Vec<String>,
    #[arg(help = words().limit_to_keep())]
    #[arg(long, value_name = "GOAL")]
    pub(in crate::cli) keep: Vec<String>,
    #[arg(help = words().figure_to_minimize())]
    #[arg(long, value_name = "FIGURE", conflicts_with = "maximize")]
    pub(in crate::cli) minimize: Option<String>,
    #[arg(help = words().figure_to_maximize())]
    #[arg(long, value_name = "FIGURE")]
    pub(in crate::cli) maximize: Option<String>,
    #[arg(help = words().starts_of_search())]
    #[arg(long, value_name = "N", default_value_t = 24, value_parser = clap::value_parser!(u32).range(0..=100_000))]
    pub(in crate::cli) starts: u32,
    #[arg(help = words().generations_of_search())]
    #[arg(long, value_name = "N", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(in crate::cli) generations: u32,
    #[arg(help = words().seed_of_search())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(in crate::cli) seed: u64,
    #[arg(help = words().design_to_write())]
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub(in crate::cli) pick: u32,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = FoundFormat::Text)]
    pub(in crate::cli) format: FoundFormat,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
