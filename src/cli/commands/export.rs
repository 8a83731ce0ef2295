//! `krank export`: writes a script that solves the positions of a scene on its own.

use super::args::ExportArgs;
use super::commands::note_near_misses;
use super::failure::Failure;
use super::output::{file, write_text};
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::handover::script;

pub(super) fn export(args: &ExportArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    note_near_misses(&scene, &solver, screen);
    let text = script(&scene, &solver, args.format.language(), &called(args));
    write_text(args.output.output.as_deref(), &text)
}

/// Returns the script's name in MATLAB, from its file or from the scene's.
fn called(args: &ExportArgs) -> String {
    let file = file(args.output.output.as_deref()).unwrap_or(&args.scene.scene);
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let allowed = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().map(allowed).collect();
    match name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        true => name,
        false => format!("krank_{name}"),
    }
}
