//! `krank import`: converts a file of another linkage program to a scene.

use crate::cli::failure::{Failure, note};
use crate::cli::output::{OutputArgs, file, write_scene};
use crate::cli::screen::TextScreen;
use crate::cli::source::{check_output_differs, converted, foreign_contents};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::wording::words;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(in crate::cli) struct ImportArgs {
    #[arg(help = words().file_to_import())]
    file: PathBuf,
    #[command(flatten)]
    output: OutputArgs,
}

/// Runs `krank import`: writes the scene, and reports whether it opens.
pub(in crate::cli) fn import(args: &ImportArgs, screen: TextScreen) -> Result<(), Failure> {
    let output = args.output.output.as_deref();
    let (source, bytes) = foreign_contents(&args.file)?;
    check_output_differs(&source, output)?;
    let imported = converted(&source, &bytes)?;
    for remark in &imported.remarks {
        note(remark, screen);
    }
    write_scene(output, &imported.text)?;
    // What was left out may be needed: the scene is written, and its fault is an error.
    let origin = match file(output) {
        Some(output) => output.display().to_string(),
        // Lines are counted in the scene.
        None => words().import_scene_made_from(&args.file.display().to_string()),
    };
    let scene = Scene::parse(&imported.text, &origin).map_err(Failure::Scene)?;
    match Solver::new(&scene.mechanism) {
        Ok(_) => Ok(()),
        Err(fault) => Err(Failure::Scene(scene.explain(&fault))),
    }
}
