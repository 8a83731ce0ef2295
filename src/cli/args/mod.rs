//! Defines the command line: its commands, arguments and options.

mod cycle;
mod exercise;
mod export;
mod figures;
mod language;
mod motor;
mod pictures;
mod report;
mod solve;
mod spreadsheet;
mod study;
mod synthesize;
mod tolerance;
mod workbench;

pub(super) use cycle::CycleArgs;
pub(super) use exercise::{ExerciseArgs, GradeArgs, GradeFormat};
pub(super) use export::ExportArgs;
pub(super) use figures::{
    AccuracyArgs, ExplainArgs, OutputFormat, SweepArgs, TableArgs, TextFormat,
};
pub(super) use language::LanguageChoice;
pub(super) use motor::MotorArgs;
pub(super) use pictures::{DrawArgs, GlyphChoice, NamesChoice, PictureFormat, PlotArgs, Size};
pub(super) use report::ReportArgs;
pub(super) use solve::{FoundFormat, SolveArgs};
pub(super) use spreadsheet::CsvArgs;
pub(super) use study::{StudyArgs, StudyFormat};
pub(super) use synthesize::SynthesizeArgs;
pub(super) use tolerance::{BandChoice, ToleranceArgs};
#[cfg(feature = "tui")]
pub(super) use workbench::{Colour, ThemeChoice};
pub(super) use workbench::{USUAL_SCENE, WorkbenchArgs};

use crate::assembly::AssemblyRequest;
use crate::report::WrittenDecimal;
use crate::wording::words;
use clap::{Arg, ArgAction, Args, Parser, Subcommand, ValueEnum, ValueHint};
use std::path::PathBuf;

/// Returns the text after the options in `--help`: examples, after the essential keys if there is a workbench.
fn behind_help() -> String {
    let keys = match cfg!(feature = "tui") {
        true => words().keys_of_workbench(),
        false => "",
    };
    keys.to_owned() + words().examples_of_krank()
}

/// Returns `--long`, the last option in `--help`. It is not a field: `--version` ends the parsing.
fn long_version() -> Arg {
    let long = Arg::new("long").long("long").action(ArgAction::SetTrue);
    let long = long.help(words().add_to_version()).display_order(999);
    long.requires("version")
}

/// A terminal workbench for planar linkages.
#[derive(Debug, Parser)]
#[command(
    name = "krank",
    version,
    about = words().what_krank_is(),
    long_about = words().what_krank_does(),
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    arg = long_version(),
    after_help = behind_help()
)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) workbench: WorkbenchArgs,
    #[arg(help = words().language_to_speak())]
    #[arg(long, global = true, value_enum, default_value_t)]
    pub(super) language: LanguageChoice,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    #[command(about = words().does_list(), after_help = words().examples_of_list())]
    List,
    #[command(about = words().does_check(), after_help = words().examples_of_check())]
    Check(CheckArgs),
    #[command(about = words().does_table(), after_help = words().examples_of_table())]
    Table(TableArgs),
    #[command(about = words().does_explain(), after_help = words().examples_of_explain())]
    Explain(ExplainArgs),
    #[command(about = words().does_report(), after_help = words().examples_of_report())]
    Report(ReportArgs),
    #[command(about = words().does_exercise(), after_help = words().examples_of_exercise())]
    Exercise(ExerciseArgs),
    #[command(about = words().does_grade(), after_help = words().examples_of_grade())]
    Grade(GradeArgs),
    #[command(about = words().does_draw(), after_help = words().examples_of_draw())]
    Draw(DrawArgs),
    #[command(about = words().does_sweep(), after_help = words().examples_of_sweep())]
    Sweep(SweepArgs),
    #[command(about = words().does_plot(), after_help = words().examples_of_plot())]
    Plot(PlotArgs),
    #[command(about = words().does_cycle(), after_help = words().examples_of_cycle())]
    Cycle(CycleArgs),
    #[command(about = words().does_export(), after_help = words().examples_of_export())]
    Export(ExportArgs),
    #[command(about = words().does_study(), after_help = words().examples_of_study())]
    Study(StudyArgs),
    #[command(about = words().does_motor(), after_help = words().examples_of_motor())]
    Motor(MotorArgs),
    #[command(about = words().does_solve(), after_help = words().examples_of_solve())]
    Solve(SolveArgs),
    #[command(about = words().does_synthesize(), after_help = words().examples_of_synthesize())]
    Synthesize(SynthesizeArgs),
    #[command(about = words().does_tolerance(), after_help = words().examples_of_tolerance())]
    Tolerance(ToleranceArgs),
    #[command(about = words().does_start(), after_help = words().examples_of_start())]
    Start(StartArgs),
    #[command(about = words().does_accuracy(), after_help = words().examples_of_accuracy())]
    Accuracy(AccuracyArgs),
    #[cfg(feature = "tui")]
    #[command(about = words().does_config(), after_help = words().examples_of_config())]
    Config,
    #[command(about = words().does_help(), after_help = words().examples_of_help())]
    Help(HelpArgs),
    #[command(hide = true, about = words().does_completions(), after_help = words().examples_of_completions())]
    Completions {
        #[arg(help = words().the_shell())]
        shell: CompletionShell,
    },
    #[command(hide = true, about = words().does_man(), after_help = words().examples_of_man())]
    Man {
        #[arg(help = words().command_of_page())]
        command: Option<String>,
    },
}

/// A shell with completions.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum CompletionShell {
    Bash,
    Elvish,
    Fish,
    Nushell,
    #[value(name = "powershell")]
    PowerShell,
    Zsh,
}

#[derive(Debug, Args)]
pub(super) struct HelpArgs {
    #[arg(help = words().topic_or_command())]
    pub(super) topic: Option<String>,
    #[arg(help = words().write_at_once())]
    #[arg(long)]
    pub(super) no_pager: bool,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = HelpFormat::Text)]
    pub(super) format: HelpFormat,
    #[arg(help = words().folder_of_manual())]
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(super) output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum HelpFormat {
    #[value(help = words().format_for_person())]
    Text,
    #[value(help = words().format_web())]
    Html,
}

#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    #[arg(help = words().how_to_write())]
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub(super) format: CheckFormat,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum CheckFormat {
    #[value(help = words().format_for_person())]
    Text,
    #[value(help = words().format_json())]
    Json,
}

/// A scene, in the assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct SceneArgs {
    #[arg(help = words().name_of_scene())]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
}

/// One place of the motion.
#[derive(Debug, Args)]
pub(super) struct PlaceArgs {
    #[arg(help = words().place_of_driver())]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    at: Option<WrittenDecimal>,
}

impl PlaceArgs {
    /// Returns the typed driver coordinate; `None` if there is none.
    pub(super) fn typed(&self) -> Option<f64> {
        self.at.map(|at| at.value())
    }
}

/// The assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct AssemblyArgs {
    #[arg(help = words().assembly_of_group())]
    #[arg(long = "assembly", value_name = "GROUP=CHOICE", value_delimiter = ',')]
    pub(super) wishes: Vec<AssemblyRequest>,
}

#[derive(Debug, Args)]
pub(super) struct StartArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    #[arg(help = words().write_to_a_file())]
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}
