//! `krank explain`: writes the solution of one state step by step.

use crate::cli::choice::{OptionValue, one_of, option_values};
use crate::cli::commands::report::notations;
use crate::cli::failure::Failure;
use crate::cli::output::{OutputArgs, write_text};
use crate::cli::place::{PlaceArgs, check_nothing_hidden, note_near_misses, out_of_reach, place};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::drawing::{Glyphs, convergence};
use crate::page::Content;
use crate::report::{
    Guess, PositionMethod, Report, ReportFormat, WorkedMethod, Working, WorkingNotation,
};
use crate::solver::{Condition, Order};
use crate::wording::words;
use clap::Args;

/// Returns the ways to fill the position table.
fn methods() -> [OptionValue<PositionMethod>; 4] {
    [
        ("closed", words().method_closed(), PositionMethod::Closed),
        ("newton", words().method_newton(), PositionMethod::Newton),
        (
            "bisection",
            words().method_bisection(),
            PositionMethod::Bisection,
        ),
        (
            "graphical",
            words().method_graphical(),
            PositionMethod::Graphical,
        ),
    ]
}

fn formats() -> Vec<OptionValue<ReportFormat>> {
    let formats = [ReportFormat::Text, ReportFormat::Markdown];
    let about = [words().format_plain(), words().format_markdown()];
    option_values(formats, ReportFormat::name, about)
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExplainArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    place: PlaceArgs,
    #[arg(help = words().method_of_positions())]
    #[arg(long, value_parser = one_of(methods()), default_value = "closed")]
    method: PositionMethod,
    #[arg(help = words().guess_of_vectors())]
    #[arg(long, value_name = "NAME=VALUE")]
    guess: Vec<String>,
    #[arg(help = words().notation_of_working())]
    #[arg(long, value_parser = one_of(notations()), default_value = "krank")]
    notation: WorkingNotation,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_parser = one_of(formats()), default_value = "text")]
    format: ReportFormat,
    #[arg(help = words().digits())]
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    digits: u8,
    #[command(flatten)]
    output: OutputArgs,
}

/// Size of the chart of errors below the tables of iterations, in columns and rows.
const CHART: (u16, u16) = (80, 16);

/// Writes the solution. Without an assembly, writes its possible part and returns the reason as an
/// error.
pub(in crate::cli) fn explain(args: &ExplainArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let at = place(&args.place, &scene, &solver, screen);
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    let working = Working::new(&scene, &solver);
    let (method, digits) = (args.method, usize::from(args.digits));
    let driver_state = (&scene, &solver, state.state());
    let wrong = |why: String| Failure::Usage(format!("--guess: {why}"));
    let guesses = Guess::listed(&args.guess.join(",")).map_err(|why| wrong(why.to_string()))?;
    let computed = working.by(method, driver_state, &guesses, digits, args.notation);
    let WorkedMethod { mut page, curves } = computed.map_err(wrong)?;
    if !curves.is_empty() {
        let (cols, rows) = CHART;
        let chart = convergence(&curves)
            .render(cols, rows, Glyphs::Ascii)
            .text();
        page.part(words().errors_by_iteration());
        page.add(Content::Characters(
            chart.lines().map(str::to_owned).collect(),
        ));
    }
    let text = Report { page }.written(args.format, screen.ascii);
    write_text(args.output.output.as_deref(), &text)?;
    if condition == Condition::NoAssembly {
        return Err(out_of_reach(&scene, &solver, at));
    }
    note_near_misses(&scene, &solver, screen);
    check_nothing_hidden(&scene, &state)
}
