//! `krank report`: writes the solution of one state as a document.

use super::args::ReportArgs;
use super::commands::{note_near_misses, nothing_hidden, out_of_reach, place};
use super::failure::{Failure, note};
use super::output::{file, write_text};
use super::screen::TextScreen;
use super::source::{SolvableScene, keep_file_apart};
use crate::files::read_ready;
use crate::report::{ForeignFigures, NoFigures, Report, ReportFormat, TextEncoding};
use crate::scene::MAX_FILE_SIZE;
use crate::solver::{Condition, Order};
use crate::wording::words;
use std::path::Path;

/// Maximum size of a file with another program's values, in bytes.
const MAX_FOREIGN_SIZE: usize = 16 * MAX_FILE_SIZE;

/// Writes the report. Without an assembly, writes its possible part and returns the reason as an
/// error.
pub(super) fn report(args: &ReportArgs, screen: TextScreen) -> Result<(), Failure> {
    let path = args.output.output.as_deref();
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let format = format(args.format, path)?;
    if let Some(file) = &args.against {
        keep_file_apart(file, path)?;
    }
    let at = place(&args.place, &scene, &solver, screen);
    let mut state = solver.state();
    let condition = solver.solve(at, Order::Force, &mut state);
    solver.enclose(&mut state, Order::Force, &mut solver.enclosure());
    let digits = usize::from(args.digits);
    let mut report = Report::in_notation(&scene, &solver, &state, digits, args.notation);
    if let Some(file) = &args.against {
        report.add_beside(
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
    nothing_hidden(&scene, &state)
}

/// Returns the requested format, or the one of the file's extension, or HTML without an extension.
/// An unknown extension is an error, because the file's contents would not match it.
fn format(asked: Option<ReportFormat>, path: Option<&Path>) -> Result<ReportFormat, Failure> {
    let ending = file(path).and_then(Path::extension);
    match (asked, file(path), ending) {
        (Some(asked), ..) => Ok(asked),
        (None, Some(path), Some(ending)) => ReportFormat::of_ending(path).ok_or_else(|| {
            let ending = ending.to_string_lossy();
            Failure::Usage(words().no_report_has_ending(&ending))
        }),
        _ => Ok(ReportFormat::default()),
    }
}

/// Reads values from a file that another program wrote.
pub(super) fn foreign(path: &Path, screen: TextScreen) -> Result<ForeignFigures, Failure> {
    let shown = path.display().to_string();
    let bytes = read_ready(path, MAX_FOREIGN_SIZE)
        .map_err(|e| Failure::Usage(words().cannot_read(&format!("`{shown}`"), &e)))?;
    let too_long = || Failure::Usage(words().too_many_figures(&shown));
    if bytes.len() > MAX_FOREIGN_SIZE {
        return Err(too_long());
    }
    let name = path.file_name().unwrap_or(path.as_os_str());
    let read = ForeignFigures::read(&name.to_string_lossy(), &bytes);
    let figures = read.map_err(|why| match why {
        NoFigures::Nothing => Failure::Usage(words().holds_no_figures(&shown)),
        NoFigures::TooLong => too_long(),
    })?;
    if figures.encoding() == TextEncoding::Windows1254 {
        let encoding = figures.encoding().name();
        note(&words().file_decoded_as(&shown, encoding), screen);
    }
    Ok(figures)
}
