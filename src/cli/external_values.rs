//! Reads values and measurements of other programs.

use crate::cli::failure::{Failure, note};
use crate::cli::screen::TextScreen;
use crate::cli::source::check_output_differs_from_input;
use crate::files::read_without_waiting;
use crate::quantity::{Catalogue, Quantity};
use crate::report::{ForeignFigures, Measured, NoFigures, TextEncoding};
use crate::scene::MAX_FILE_SIZE;
use crate::wording::words;
use std::path::Path;

/// Maximum size of a file with another program's values, in bytes.
const MAX_FOREIGN_SIZE: usize = 16 * MAX_FILE_SIZE;

/// Reads the measurements of these quantities, or of all in the file.
pub(super) fn measured(
    file: &Path,
    output: Option<&Path>,
    catalogue: &Catalogue,
    of: Option<&[Quantity]>,
    screen: TextScreen,
) -> Result<Measured, Failure> {
    check_output_differs_from_input(file, output)?;
    let found = foreign(file, screen)?.measured(catalogue, of);
    let shown = file.display().to_string();
    found.ok_or_else(|| Failure::Usage(words().no_measurements(&shown)))
}

/// Reads values from a file that another program wrote.
pub(super) fn foreign(path: &Path, screen: TextScreen) -> Result<ForeignFigures, Failure> {
    let shown = path.display().to_string();
    let bytes = read_without_waiting(path, MAX_FOREIGN_SIZE)
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
