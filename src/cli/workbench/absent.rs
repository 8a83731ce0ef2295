//! A stub of the workbench for builds without it.

use super::args::{LanguageChoice, USUAL_SCENE, WorkbenchArgs};
use super::failure::Failure;
use crate::wording::words;
use std::path::Path;

/// Returns an error that names the alternatives.
pub(super) fn open(args: &WorkbenchArgs, _: LanguageChoice) -> Result<(), Failure> {
    let scene = args.scene.as_deref().unwrap_or(Path::new(USUAL_SCENE));
    let scene = scene.display();
    Err(Failure::Usage(words().no_workbench(&scene)))
}
