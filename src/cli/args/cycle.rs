//! Arguments of `krank cycle`, which lists values over the whole motion.

use super::{CsvArgs, OutputArgs, OutputFormat, SceneArgs};
use crate::cli::args::motor::positive;
use crate::wording::words;
use clap::Args;

#[derive(Debug, Args)]
pub(in crate::cli) struct CycleArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().columns_of_cycle())]
    #[arg(long, value_name = "PATTERNS")]
    pub(in crate::cli) columns: Vec<String>,
    #[arg(help = words().dwell_of_cycle())]
    #[arg(long, value_name = "SIZE", value_parser = positive, allow_negative_numbers = true)]
    pub(in crate::cli) dwell: Option<f64>,
    #[arg(help = words().bounds_of_cycle())]
    #[arg(long)]
    pub(in crate::cli) bounds: bool,
    #[arg(help = words().how_to_write_cycle())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}
