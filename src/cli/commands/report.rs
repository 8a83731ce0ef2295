//! `krank report`: writes the solution of one state as a document.

use crate::cli::choice::{OptionValue, one_of, option_values};
use crate::cli::external_values::foreign;
use crate::cli::failure::Failure;
use crate::cli::output::{OutputArgs, file, write_text};
use crate::cli::place::{PlaceArgs, check_nothing_hidden, note_near_misses, out_of_reach, place};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene, check_output_differs_from_input};
use crate::report::{Report, ReportFormat, WorkingNotation};
use crate::solver::{Condition, Order};
use crate::wording::words;
use clap::{Args, ValueHint};
use std::path::{Path, PathBuf};

/// Returns the formats of reports.
pub(in crate::cli) fn formats() -> Vec<OptionValue<ReportFormat>> {
    let about = [
        words().format_html(),
        words().format_latex(),
        words().format_markdown(),
        words().format_plain(),
    ];
    option_values(ReportFormat::ALL, ReportFormat::name, about)
}

/// Returns the notations of unit vectors in the working.
pub(in crate::cli) fn notations() -> [OptionValue<WorkingNotation>; 2] {
    [
        (
            "lecture",
            words().notation_lecture(),
            WorkingNotation::Lecture,
        ),
        ("krank", words().notation_krank(), WorkingNotation::Krank),
    ]
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    place: PlaceArgs,
    #[arg(help = words().notation_of_working())]
    #[arg(long, value_parser = one_of(notations()), default_value = "lecture")]
    notation: WorkingNotation,
    #[arg(help = words().format_of_report())]
    #[arg(long, value_parser = one_of(formats()))]
    format: Option<ReportFormat>,
    #[arg(help = words().digits())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    digits: u8,
    #[arg(help = words().against_figures())]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    against: Option<PathBuf>,
    #[command(flatten)]
    output: OutputArgs,
}

/// Writes the report. Without an assembly, writes its possible part and returns the reason as an
/// error.
pub(in crate::cli) fn report(args: &ReportArgs, screen: TextScreen) -> Result<(), Failure> {
    let path = args.output.output.as_deref();
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let format = format(args.format, path)?;
    if let Some(file) = &args.against {
        check_output_differs_from_input(file, path)?;
    }
    let at = place(&args.place, &scene, &solver, screen);
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    let digits = usize::from(args.digits);
    let mut report = Report::in_notation(&scene, &solver, &state, digits, args.notation);
    if let Some(file) = &args.against {
        report.add_comparison(
            &foreign(file, screen)?,
            (&scene, &solver, state.state()),
            digits,
        );
    }
    write_text(path, &report.written(format, screen.ascii))?;
    if condition == Condition::NoAssembly {
        return Err(out_of_reach(&scene, &solver, at));
    }
    note_near_misses(&scene, &solver, screen);
    check_nothing_hidden(&scene, &state)
}

/// Returns the requested format, or the one of the file's extension, or HTML without an extension.
/// An unknown extension is an error, because the file's contents would not match it.
fn format(requested: Option<ReportFormat>, path: Option<&Path>) -> Result<ReportFormat, Failure> {
    let ending = file(path).and_then(Path::extension);
    match (requested, file(path), ending) {
        (Some(requested), ..) => Ok(requested),
        (None, Some(path), Some(ending)) => ReportFormat::of_ending(path).ok_or_else(|| {
            let ending = ending.to_string_lossy();
            Failure::Usage(words().no_report_has_ending(&ending))
        }),
        _ => Ok(ReportFormat::default()),
    }
}
