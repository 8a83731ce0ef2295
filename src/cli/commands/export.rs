//! `krank export`: writes a script that solves the positions of a scene on its own.

use crate::cli::choice::{OptionValue, one_of};
use crate::cli::failure::Failure;
use crate::cli::output::{OutputArgs, file, write_text};
use crate::cli::place::note_near_misses;
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::script_export::{ScriptLanguage, script};
use crate::wording::words;
use clap::Args;

/// Returns the languages of scripts.
fn languages() -> [OptionValue<ScriptLanguage>; 2] {
    [
        ("python", words().format_python(), ScriptLanguage::Python),
        (
            "matlab|octave",
            words().format_matlab(),
            ScriptLanguage::Matlab,
        ),
    ]
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ExportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_parser = one_of(languages()))]
    format: ScriptLanguage,
    #[command(flatten)]
    output: OutputArgs,
}

pub(in crate::cli) fn export(args: &ExportArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    note_near_misses(&scene, &solver, screen);
    let text = script(&scene, &solver, args.format, &called(args));
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
