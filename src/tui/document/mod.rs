//! The scene as text: edits with undo, its file, and recovery of unsaved edits. The `io_thread` module
//! runs file operations on a background thread.

pub(crate) mod difference;
pub(crate) mod disk;
pub(crate) mod edit_result;
pub(crate) mod editor;
pub(crate) mod history;
pub(crate) mod io_thread;
pub(crate) mod job;
pub(crate) mod opening;
pub(crate) mod recovery;
pub(crate) mod saving;
pub(crate) mod staged_edits;
pub(crate) mod writing;

use crate::scene::Scene;
use crate::tui::Origin;
use disk::Disk;
use editor::Editor;
use recovery::SessionRun;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::SystemTime;

/// The recovery record of this session, accessed only by file jobs.
pub(crate) type SharedRecovery = Arc<Mutex<recovery::Recovery>>;

/// The scene as text, with its file and its unsaved edits.
#[derive(Debug)]
pub(crate) struct Document {
    /// The text of the scene as opened.
    pub(crate) original: Arc<str>,
    /// The editor of the scene's values.
    pub(crate) editor: Editor,
    /// The scene's file, if it has one.
    pub(crate) disk: Option<Disk>,
    /// The folder for unsaved edits, if there is one. `session` identifies this run of the program
    /// and `recovery` the record of this scene.
    pub(crate) folder: Option<PathBuf>,
    /// `true` if no folder for unsaved edits exists and the user does not know yet.
    pub(crate) has_no_edits_folder: bool,
    pub(crate) session: SessionRun,
    pub(crate) recovery: Option<SharedRecovery>,
    /// `true` if the restored edits were based on an older text than the file's.
    pub(crate) older: bool,
    /// `true` while a file is being written.
    pub(crate) storing: bool,
}

impl Document {
    /// Creates the document of an opened scene.
    pub(crate) fn new(scene: &Scene) -> Self {
        Document {
            original: scene.text().into(),
            editor: Editor::new(scene),
            disk: None,
            folder: None,
            has_no_edits_folder: false,
            session: SessionRun::started_at(SystemTime::now()),
            recovery: None,
            older: false,
            storing: false,
        }
    }

    /// Replaces the scene by another one without edits. The folder for unsaved edits stays.
    pub(crate) fn open(&mut self, scene: &Scene) {
        self.original = scene.text().into();
        self.editor = Editor::new(scene);
        self.older = false;
    }

    /// Sets the file to that of this origin.
    pub(crate) fn belong_to(&mut self, origin: &Origin) {
        self.disk = match origin {
            Origin::File(path) => Some(Disk::new(path)),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => None,
        };
    }

    /// Returns the name of the scene's file.
    pub(crate) fn file_name(&self) -> Option<String> {
        let path = self.disk.as_ref()?.path();
        let name = path.file_name().unwrap_or(path.as_os_str());
        Some(name.to_string_lossy().into_owned())
    }

    /// Returns the file to watch, with all links resolved.
    pub(crate) fn watched(&self) -> Option<&Path> {
        self.disk.as_ref().and_then(Disk::place)
    }
}
