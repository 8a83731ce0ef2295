//! In place of the workbench, where krank is built without it.

use super::args::{LanguageChoice, USUAL_SCENE, WorkbenchArgs};
use super::failure::Failure;
use crate::wording::words;
use std::path::Path;

/// Says that there is none, and what to use instead.
pub(super) fn open(args: &WorkbenchArgs, _: LanguageChoice) -> Result<(), Failure> {
    let scene = args.scene.as_deref().unwrap_or(Path::new(USUAL_SCENE));
    let scene = scene.display();
    Err(Failure::Usage(words().no_workbench(&scene)))
}
