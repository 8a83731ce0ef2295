//! A stub of the workbench for builds without it.

use super::args::{DEFAULT_SCENE, WorkbenchArgs};
use crate::cli::choice::OrAuto;
use crate::cli::failure::Failure;
use crate::cli::screen::TextScreen;
use crate::wording::{Language, words};
use std::path::Path;

/// Returns an error that names the alternatives.
pub(in crate::cli) fn open(
    args: &WorkbenchArgs,
    _: OrAuto<Language>,
    _: TextScreen,
) -> Result<(), Failure> {
    let scene = args.scene.as_deref().unwrap_or(Path::new(DEFAULT_SCENE));
    let scene = scene.display();
    Err(Failure::Usage(words().no_workbench(&scene)))
}
