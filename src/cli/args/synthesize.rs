//! Arguments of `krank synthesize`, which finds linkages for a wanted motion.

use super::{CsvArgs, OutputFormat};
use crate::synthesis::SynthesisSettings;
use crate::wording::words;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(in crate::cli) struct SynthesizeArgs {
    #[arg(help = words().task_to_do())]
    pub(in crate::cli) task: PathBuf,
    #[arg(help = words().candidates_to_tell())]
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub(in crate::cli) top: u16,
    #[arg(help = words().seed_of_search())]
    #[arg(long, value_name = "N", default_value_t = SynthesisSettings::USUAL_SEED)]
    pub(in crate::cli) seed: u64,
    #[arg(help = words().tolerance_of_candidates())]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    pub(in crate::cli) tolerance: Option<f64>,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = OutputFormat::Text)]
    pub(in crate::cli) format: OutputFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[cfg(feature = "tui")]
    #[arg(help = words().candidates_in_workbench())]
    #[arg(long, conflicts_with_all = ["top", "format", "output"])]
    pub(in crate::cli) view: bool,
    #[arg(help = words().folder_of_candidates())]
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
}
