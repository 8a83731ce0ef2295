//! The scene as a text: edits and taking them back, its file, and what is kept of edits that are not saved.
//! What is done to files is done apart from the screen's thread, by the `clerk`.

pub(crate) mod clerk;
pub(crate) mod difference;
pub(crate) mod disk;
pub(crate) mod edited;
pub(crate) mod editor;
pub(crate) mod gathered;
pub(crate) mod history;
pub(crate) mod opening;
pub(crate) mod recovery;
pub(crate) mod saving;
pub(crate) mod search_progress;
pub(crate) mod writing;

use crate::scene::Scene;
use crate::tui::Origin;
use disk::Disk;
use editor::Editor;
use recovery::SessionRun;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::SystemTime;

/// The edits of this session, which only the clerk looks at.
pub(crate) type Kept = Arc<Mutex<recovery::Recovery>>;

/// The scene as a text, in its file and beside it.
#[derive(Debug)]
pub(crate) struct Document {
    /// The text of the scene as it was opened.
    pub(crate) original: Arc<str>,
    /// What is edited.
    pub(crate) editor: Editor,
    /// Its file, if it has one.
    pub(crate) disk: Option<Disk>,
    /// Where unsaved edits are kept, if they are: the folder, this run of the program, and the place of this
    /// scene.
    pub(crate) folder: Option<PathBuf>,
    /// Whether there is no folder for it, and nobody has been told.
    pub(crate) is_homeless: bool,
    pub(crate) session: SessionRun,
    pub(crate) recovery: Option<Kept>,
    /// Whether edits were taken up that were made on an older text than the file has.
    pub(crate) older: bool,
    /// Whether a file is being written.
    pub(crate) storing: bool,
}

impl Document {
    /// Of a scene that has just been opened.
    pub(crate) fn new(scene: &Scene) -> Self {
        Document {
            original: scene.text().into(),
            editor: Editor::new(scene),
            disk: None,
            folder: None,
            is_homeless: false,
            session: SessionRun::begun(SystemTime::now()),
            recovery: None,
            older: false,
            storing: false,
        }
    }

    /// Another scene: nothing of the one before is edited. Where edits are kept stays.
    pub(crate) fn open(&mut self, scene: &Scene) {
        self.original = scene.text().into();
        self.editor = Editor::new(scene);
        self.older = false;
    }

    /// The file is that of this scene from now on.
    pub(crate) fn belong_to(&mut self, origin: &Origin) {
        self.disk = match origin {
            Origin::File(path) => Some(Disk::new(path)),
            Origin::Preset(_) | Origin::New(_) | Origin::Stdin => None,
        };
    }

    /// What its file is called.
    pub(crate) fn file_name(&self) -> Option<String> {
        let path = self.disk.as_ref()?.path();
        let name = path.file_name().unwrap_or(path.as_os_str());
        Some(name.to_string_lossy().into_owned())
    }

    /// The file behind all links, to be watched.
    pub(crate) fn watched(&self) -> Option<&Path> {
        self.disk.as_ref().and_then(Disk::place)
    }
}
