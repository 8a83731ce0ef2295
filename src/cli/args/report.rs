//! Arguments of `krank report`.

use super::{OutputArgs, PlaceArgs, SceneArgs};
use crate::report::{ReportFormat, WorkingNotation};
use crate::wording::words;
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum, ValueHint};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(in crate::cli) struct ReportArgs {
    #[command(flatten)]
    pub(in crate::cli) scene: SceneArgs,
    #[command(flatten)]
    pub(in crate::cli) place: PlaceArgs,
    #[arg(help = words().notation_of_working())]
    #[arg(long, value_enum, default_value_t = WorkingNotation::Lecture)]
    pub(in crate::cli) notation: WorkingNotation,
    #[arg(help = words().format_of_report())]
    #[arg(long, value_enum)]
    pub(in crate::cli) format: Option<ReportFormat>,
    #[arg(help = words().digits())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(in crate::cli) digits: u8,
    #[arg(help = words().against_figures())]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(in crate::cli) against: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) output: OutputArgs,
}

/// The values of `--format`, with translated descriptions.
impl ValueEnum for ReportFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &ReportFormat::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let about = match self {
            ReportFormat::Html => words().format_html(),
            ReportFormat::Latex => words().format_latex(),
            ReportFormat::Markdown => words().format_markdown(),
            ReportFormat::Text => words().format_plain(),
        };
        Some(PossibleValue::new(self.name()).help(about))
    }
}

/// The values of `--notation`: the notation of unit vectors in the working.
impl ValueEnum for WorkingNotation {
    fn value_variants<'a>() -> &'a [Self] {
        &[WorkingNotation::Lecture, WorkingNotation::Krank]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            WorkingNotation::Lecture => {
                PossibleValue::new("lecture").help(words().notation_lecture())
            }
            WorkingNotation::Krank => PossibleValue::new("krank").help(words().notation_krank()),
        })
    }
}
