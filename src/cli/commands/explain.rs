//! `krank explain`: writes the solution of one state step by step.

use super::args::{ExplainArgs, TextFormat};
use super::commands::{note_near_misses, nothing_hidden, out_of_reach, place};
use super::failure::Failure;
use super::output::write_text;
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::drawing::{Glyphs, convergence};
use crate::page::{Content, TextStyle};
use crate::report::{WorkedMethod, Working};
use crate::solver::{Condition, Order};
use crate::wording::words;

/// Size of the chart of errors below the tables of iterations, in columns and rows.
const CHART: (u16, u16) = (80, 16);

/// Writes the solution. Without an assembly, writes its possible part and returns the reason as an
/// error.
pub(super) fn explain(args: &ExplainArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let at = place(&args.place, &scene, &solver, screen);
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    let working = Working::new(&scene, &solver);
    let (method, digits) = (args.method.method(), usize::from(args.digits));
    let stand = (&scene, &solver, state.state());
    let worked = working.by(method, stand, &args.guess, digits, args.notation);
    let WorkedMethod { mut page, curves } =
        worked.map_err(|why| Failure::Usage(format!("--guess: {why}")))?;
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
    let text = match args.format {
        TextFormat::Text => page.to_text(TextStyle::plain(screen.ascii)),
        TextFormat::Markdown => page.to_markdown(screen.ascii),
    };
    write_text(args.output.output.as_deref(), &text)?;
    if condition == Condition::NoAssembly {
        return Err(out_of_reach(&scene, &solver, at));
    }
    note_near_misses(&scene, &solver, screen);
    nothing_hidden(&scene, &state)
}
