//! Opens the workbench.

use super::args::{DEFAULT_SCENE, WorkbenchArgs};
use super::config;
use crate::cli::choice::OrAuto;
use crate::cli::failure::Failure;
use crate::cli::output::write_text;
use crate::cli::picture::{self, Size};
use crate::cli::place::{normalize_coordinate, out_of_reach};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneSource, SolvableScene, find, is_foreign, load};
use crate::scene::{Scene, stem};
use crate::solver::{Condition, Order, Solver};
use crate::tui::{self, Options, Origin, TaskOrder};
use crate::wording::Language;
use std::path::Path;

/// Opens a scene in the workbench and returns when the user quits, or prints the initial screen.
pub(in crate::cli) fn open(
    args: &WorkbenchArgs,
    language: OrAuto<Language>,
    screen: TextScreen,
) -> Result<(), Failure> {
    let options = options(args, language)?;
    let named = args.scene.as_deref();
    let source = find(named.unwrap_or(Path::new(DEFAULT_SCENE)))?;
    let SolvableScene { scene, solver } = load(&source, &args.assembly.wishes)?;
    let origin = match source {
        SceneSource::Stdin => Origin::Stdin,
        SceneSource::Preset(preset) => Origin::Preset(preset.name.to_owned()),
        // A pipe cannot be read again or saved to.
        SceneSource::File(path) if !path.is_file() => Origin::Stdin,
        // Another program's file is never overwritten with a scene.
        SceneSource::File(path) if is_foreign(&path) => {
            Origin::New(stem(&path.display().to_string()))
        }
        SceneSource::Address(_) => Origin::New(scene.name.clone()),
        SceneSource::File(path) => Origin::File(path),
    };
    let opened = tui::OpenedScene {
        scene,
        solver,
        origin,
    };
    if args.print {
        if let Some(typed) = options.at {
            check_reach(&opened.scene, &opened.solver, typed, screen)?;
        }
        let Size { cols, rows } = args.size.unwrap_or(picture::DEFAULT_SIZE);
        return write_text(None, &tui::picture(opened, &options, cols, rows));
    }
    run(opened, &options)
}

/// Returns an error if the driver cannot reach a typed coordinate: the printed screen would show another state.
fn check_reach(
    scene: &Scene,
    solver: &Solver,
    typed: f64,
    screen: TextScreen,
) -> Result<(), Failure> {
    let at = normalize_coordinate(typed, scene, solver, screen);
    match solver.solve(at, Order::Position, &mut solver.state()) {
        Condition::NoAssembly => Err(out_of_reach(scene, solver, at)),
        _ => Ok(()),
    }
}

/// Opens the default scene, with the list of linkages for a task over it.
pub(in crate::cli) fn open_task(task: TaskOrder) -> Result<(), Failure> {
    let config = config::load(None)?;
    let options = Options {
        glyphs: config.glyphs,
        colours: config.colours,
        theme: config.theme,
        picture: config.picture,
        task: Some(task),
        config,
        ..Options::default()
    };
    let source = find(Path::new(DEFAULT_SCENE))?;
    let SolvableScene { scene, solver } = load(&source, &[])?;
    let origin = Origin::Preset(DEFAULT_SCENE.into());
    let opened = tui::OpenedScene {
        scene,
        solver,
        origin,
    };
    run(opened, &options)
}

fn run(opened: tui::OpenedScene, options: &Options) -> Result<(), Failure> {
    tui::run(opened, options).map_err(|error| {
        if error.is_usage() {
            Failure::Usage(error.to_string())
        } else {
            Failure::Cannot(error.to_string())
        }
    })
}

/// Merges the options of the command line with the configuration; the former take precedence.
pub(in crate::cli) fn options(
    args: &WorkbenchArgs,
    language: OrAuto<Language>,
) -> Result<Options, Failure> {
    let config = config::load(args.config.as_deref())?;
    // A configuration from a pipe was not read before, so its language is not yet selected.
    if let (None, Some(language)) = (language, config.language) {
        language.speak();
    }
    Ok(Options {
        at: args.at.map(|at| at.value()),
        glyphs: args.glyphs.or(config.glyphs),
        colours: args.colour.or(config.colours),
        theme: args.theme.unwrap_or(config.theme),
        picture: args.picture.unwrap_or(config.picture),
        view: args.view,
        task: None,
        config,
        idle: args.scene.is_none() && args.at.is_none() && args.assembly.wishes.is_empty(),
    })
}
