//! Compares measurements in a file with computed values.

use super::args::SweepArgs;
use super::failure::{Failure, note};
use super::output::write_to;
use super::report::foreign;
use super::screen::TextScreen;
use super::source::{SolvableScene, keep_file_apart};
use super::sweep::figures;
use crate::quantity::{Catalogue, Quantity};
use crate::report::{Measured, RowFormat};
use crate::wording::words;
use std::path::Path;

/// Reads the measurements of these quantities, or of all in the file.
pub(super) fn measured(
    file: &Path,
    output: Option<&Path>,
    catalogue: &Catalogue,
    of: Option<&[Quantity]>,
    screen: TextScreen,
) -> Result<Measured, Failure> {
    keep_file_apart(file, output)?;
    let found = foreign(file, screen)?.measured(catalogue, of);
    let shown = file.display().to_string();
    found.ok_or_else(|| Failure::Usage(words().no_measurements(&shown)))
}

/// Runs `krank sweep --measured`: writes a row for each row of the file.
pub(super) fn beside(
    file: &Path,
    args: &SweepArgs,
    format: RowFormat,
    opened: &SolvableScene,
    screen: TextScreen,
) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = opened;
    let output = args.output.output.as_deref();
    let mut catalogue = Catalogue::new(scene);
    let of = match args.columns.is_empty() {
        true => None,
        false => Some(figures(&mut catalogue, &args.columns)?),
    };
    let found = measured(file, output, &catalogue, of.as_deref(), screen)?;
    let is_told = matches!(format, RowFormat::Text { .. });
    if !(is_told || found.strangers().is_empty()) {
        note(&words().not_compared(&found.strangers().join(", ")), screen);
    }
    if let Some(left_out) = found.left_out().filter(|_| !is_told) {
        note(&left_out, screen);
    }
    let written = (format, !args.figures.no_units);
    let outcome = write_to(output, |out| {
        found.write((scene, solver), written, screen.ascii, out)
    })?;
    match outcome.valued {
        0 => Err(Failure::Cannot(words().no_row_in_motion(
            &crate::report::limits_text(solver.motion().range, catalogue.driver()),
        ))),
        _ => Ok(()),
    }
}
