//! Opens scenes from inside the workbench. Errors are reduced to one line.

use crate::files::read_file;
use crate::quantity::check_figures;
use crate::scene::presets::Preset;
use crate::scene::{Diagnostics, MAX_FILE_SIZE, Scene};
use crate::solver::Solver;
use crate::task_file::{ExampleTask, TaskFile};
use crate::tui::{OpenedScene, Origin, TaskOrder};
use crate::wording::words;
use std::path::Path;

/// The reason why a file cannot be opened.
#[derive(Debug)]
pub(crate) enum OpenFileError {
    /// The file cannot be read; the message says why.
    Unread(String),
    /// The file's contents are no valid scene or task.
    Wrong(Diagnostics),
}

impl OpenFileError {
    /// Returns the first error message, with the typed name of a file that cannot be read.
    pub(crate) fn naming(self, name: &str) -> String {
        match self {
            OpenFileError::Unread(why) => words().name_cannot_be_read(name, &why),
            OpenFileError::Wrong(_) => self.first_words(),
        }
    }

    /// Returns the first error message.
    pub(crate) fn first_words(self) -> String {
        match self {
            OpenFileError::Unread(why) => words().cannot_be_read(&why),
            OpenFileError::Wrong(diagnostics) => diagnostics.first_words().to_owned(),
        }
    }
}

/// Opens a preset. The error is a message; a test checks that all presets open.
pub(crate) fn preset(preset: &Preset) -> Result<OpenedScene, String> {
    let origin = Origin::Preset(preset.name.to_owned());
    let fault = |d: Diagnostics| words().preset_cannot_be_opened(preset.name, &d.first_words());
    text(preset.text, origin).map_err(fault)
}

/// Opens a task that comes with krank. The error is a message; a test checks that all can be read.
pub(crate) fn task(task: &ExampleTask) -> Result<TaskOrder, String> {
    let file = TaskFile::parse(task.text, task.name);
    let file = file.map_err(|d| d.first_words().to_owned())?;
    Ok(TaskOrder::new(file, task.name.to_owned()))
}

/// The contents of an opened file.
#[derive(Debug)]
pub(crate) enum OpenedFile {
    /// A scene.
    Scene(Box<OpenedScene>),
    /// A synthesis task.
    Task(Box<TaskOrder>),
}

/// Opens a file as a scene or a task.
pub(crate) fn file(path: &Path) -> Result<OpenedFile, OpenFileError> {
    let bytes = read_file(path, MAX_FILE_SIZE).map_err(|e| OpenFileError::Unread(e.to_string()))?;
    let shown = path.display().to_string();
    if TaskFile::is_task(&bytes) {
        let file = TaskFile::read(&bytes, &shown).map_err(OpenFileError::Wrong)?;
        let name = path.file_stem().unwrap_or(path.as_os_str());
        let order = TaskOrder {
            folder: path.parent().map(Path::to_owned),
            ..TaskOrder::new(file, name.to_string_lossy().into_owned())
        };
        return Ok(OpenedFile::Task(Box::new(order)));
    }
    let scene = Scene::read(&bytes, &shown);
    let (scene, solver) = scene.and_then(assembled).map_err(OpenFileError::Wrong)?;
    let origin = Origin::File(path.to_owned());
    Ok(OpenedFile::Scene(Box::new(OpenedScene {
        scene,
        solver,
        origin,
    })))
}

/// Parses and assembles a text of the given origin.
pub(crate) fn text(text: &str, origin: Origin) -> Result<OpenedScene, Diagnostics> {
    let name = match &origin {
        Origin::Preset(name) | Origin::New(name) => name.clone(),
        Origin::File(path) => path.display().to_string(),
        Origin::Stdin => "stdin".into(),
    };
    let (scene, solver) = Scene::parse(text, &name).and_then(assembled)?;
    Ok(OpenedScene {
        scene,
        solver,
        origin,
    })
}

/// Checks a scene and creates its solver.
pub(crate) fn assembled(scene: Scene) -> Result<(Scene, Solver), Diagnostics> {
    check_figures(&scene)?;
    match Solver::new(&scene.mechanism) {
        Ok(solver) => Ok((scene, solver)),
        Err(fault) => Err(scene.explain(&fault)),
    }
}
