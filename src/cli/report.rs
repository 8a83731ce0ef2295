//! `krank report`: the working of one state as it is handed in.

use super::args::ReportArgs;
use super::commands::{nothing_hidden, out_of_reach, place, tell_of_near_misses};
use super::failure::Failure;
use super::output::{file, write_text};
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::report::{Report, ReportFormat};
use crate::solver::{Condition, Order};

/// Writes the report; where there is no assembly, what can still be said, and why there is none.
pub(super) fn report(args: &ReportArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let at = place(&args.place, &scene, &solver, screen);
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    let report = Report::in_notation(
        &scene,
        &solver,
        &state,
        usize::from(args.digits),
        args.notation,
    );
    let path = args.output.output.as_deref();
    let of_file = || file(path).and_then(ReportFormat::of_ending);
    let format = args.format.or_else(of_file).unwrap_or_default();
    write_text(path, &report.written(format, screen.ascii))?;
    if condition == Condition::NoAssembly {
        return Err(out_of_reach(&scene, &solver, at));
    }
    tell_of_near_misses(&scene, &solver, screen);
    nothing_hidden(&scene, &state)
}
