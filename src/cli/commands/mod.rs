//! The commands. Each has a file with its arguments, which runs it, and two lines here.

mod accuracy;
mod check;
mod cycle;
mod draw;
mod exercise;
mod explain;
mod export;
mod grade;
mod import;
mod motor;
mod plot;
mod report;
mod solve;
mod study;
mod sweep;
mod synthesize;
mod table;
mod tolerance;

use super::failure::Failure;
use super::help::{self, completions, man};
use super::screen::TextScreen;
#[cfg(feature = "tui")]
use super::workbench;
use crate::wording::words;
use clap::Subcommand;

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    #[command(about = words().does_list(), after_help = words().examples_of_list())]
    List,
    #[command(about = words().does_check(), after_help = words().examples_of_check())]
    Check(check::CheckArgs),
    #[command(about = words().does_table(), after_help = words().examples_of_table())]
    Table(table::TableArgs),
    #[command(about = words().does_explain(), after_help = words().examples_of_explain())]
    Explain(explain::ExplainArgs),
    #[command(about = words().does_report(), after_help = words().examples_of_report())]
    Report(report::ReportArgs),
    #[command(about = words().does_exercise(), after_help = words().examples_of_exercise())]
    Exercise(exercise::ExerciseArgs),
    #[command(about = words().does_grade(), after_help = words().examples_of_grade())]
    Grade(grade::GradeArgs),
    #[command(about = words().does_draw(), after_help = words().examples_of_draw())]
    Draw(draw::DrawArgs),
    #[command(about = words().does_sweep(), after_help = words().examples_of_sweep())]
    Sweep(sweep::SweepArgs),
    #[command(about = words().does_plot(), after_help = words().examples_of_plot())]
    Plot(plot::PlotArgs),
    #[command(about = words().does_cycle(), after_help = words().examples_of_cycle())]
    Cycle(cycle::CycleArgs),
    #[command(about = words().does_export(), after_help = words().examples_of_export())]
    Export(export::ExportArgs),
    #[command(about = words().does_import(), after_help = words().examples_of_import())]
    Import(import::ImportArgs),
    #[command(about = words().does_study(), after_help = words().examples_of_study())]
    Study(study::StudyArgs),
    #[command(about = words().does_motor(), after_help = words().examples_of_motor())]
    Motor(motor::MotorArgs),
    #[command(about = words().does_solve(), after_help = words().examples_of_solve())]
    Solve(solve::SolveArgs),
    #[command(about = words().does_synthesize(), after_help = words().examples_of_synthesize())]
    Synthesize(synthesize::SynthesizeArgs),
    #[command(about = words().does_tolerance(), after_help = words().examples_of_tolerance())]
    Tolerance(tolerance::ToleranceArgs),
    #[command(about = words().does_start(), after_help = words().examples_of_start())]
    Start(check::StartArgs),
    #[command(about = words().does_accuracy(), after_help = words().examples_of_accuracy())]
    Accuracy(accuracy::AccuracyArgs),
    #[cfg(feature = "tui")]
    #[command(about = words().does_config(), after_help = words().examples_of_config())]
    Config,
    #[command(about = words().does_help(), after_help = words().examples_of_help())]
    Help(help::HelpArgs),
    #[command(hide = true, about = words().does_completions(), after_help = words().examples_of_completions())]
    Completions {
        #[arg(help = words().the_shell())]
        shell: completions::CompletionShell,
    },
    #[command(hide = true, about = words().does_man(), after_help = words().examples_of_man())]
    Man {
        #[arg(help = words().command_of_page())]
        command: Option<String>,
    },
}

impl Command {
    /// Runs the command; `krank` returns the command line with all commands.
    pub(super) fn run(
        &self,
        screen: TextScreen,
        krank: fn() -> clap::Command,
    ) -> Result<(), Failure> {
        match self {
            Command::List => check::list(screen),
            Command::Check(args) => check::check(args, screen),
            Command::Table(args) => table::table(args, screen),
            Command::Explain(args) => explain::explain(args, screen),
            Command::Report(args) => report::report(args, screen),
            Command::Exercise(args) => exercise::exercise(args, screen),
            Command::Grade(args) => grade::grade(args, screen),
            Command::Draw(args) => draw::draw(args, screen),
            Command::Sweep(args) => sweep::sweep(args, screen),
            Command::Plot(args) => plot::plot(args, screen),
            Command::Solve(args) => solve::solve(args, screen),
            Command::Synthesize(args) => synthesize::synthesize(args, screen),
            Command::Start(args) => check::start(args),
            Command::Cycle(args) => cycle::cycle(args, screen),
            Command::Export(args) => export::export(args, screen),
            Command::Import(args) => import::import(args, screen),
            Command::Tolerance(args) => tolerance::tolerance(args, screen),
            Command::Study(args) => study::study(args, screen),
            Command::Motor(args) => motor::motor(args, screen),
            Command::Accuracy(args) => accuracy::accuracy(args, screen),
            #[cfg(feature = "tui")]
            Command::Config => workbench::config(screen),
            Command::Help(args) => help::help(args, krank),
            Command::Completions { shell } => completions::completions(*shell, &krank(), screen),
            Command::Man { command } => man::man(&mut krank(), command.as_deref(), screen),
        }
    }
}
