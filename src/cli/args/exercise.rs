//! Arguments of `krank exercise` and `krank grade`.

use super::{AssemblyArgs, CsvArgs, OutputArgs, PlaceArgs, SceneArgs};
use crate::report::ReportFormat;
use crate::wording::words;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(in crate::cli) struct ExerciseArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[arg(help = words().seed_of_exercise())]
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(in crate::cli) seed: u64,
    #[arg(help = words().count_of_exercises())]
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub(in crate::cli) count: u16,
    #[arg(help = words().format_of_sheet())]
    #[arg(long, value_enum)]
    pub(in crate::cli) format: Option<ReportFormat>,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[arg(help = words().folder_of_exercises())]
    #[arg(short, long, value_name = "DIR")]
    pub(in crate::cli) output: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct GradeArgs {
    #[arg(help = words().sheet_to_grade())]
    pub(in crate::cli) sheet: PathBuf,
    #[arg(help = words().files_of_answers())]
    #[arg(required = true)]
    pub(in crate::cli) answers: Vec<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    #[command(flatten)]
    pub(in crate::cli) assembly: AssemblyArgs,
    #[arg(help = words().how_to_write_grades())]
    #[arg(long, value_enum, default_value_t = GradeFormat::Text)]
    pub(in crate::cli) format: GradeFormat,
    #[command(flatten)]
    pub(in crate::cli) csv: CsvArgs,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum GradeFormat {
    #[value(help = words().format_text())]
    Text,
    #[value(help = words().format_csv())]
    Csv,
}
