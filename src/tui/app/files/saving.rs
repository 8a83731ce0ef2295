//! Writes the scene, values and images to files, with a prompt if something would be lost.

use crate::files::WriteError;
use crate::scene::Scene;
use crate::tui::Origin;
use crate::tui::app::{App, Mode};
use crate::tui::commands::action::Action;
use crate::tui::document::disk::FileStatus;
use crate::tui::document::edit_result;
use crate::tui::document::saving::{Leave, SaveRequest, refused, refused_there};
use crate::tui::document::writing::{ConfirmReason, Question, SavedContent};
use crate::wording::words;
use std::path::{Path, PathBuf};

impl App {
    /// Saves the scene to its own file, or asks for a file.
    pub(in crate::tui::app) fn save_own(&mut self) {
        self.player.playback.pause();
        let Origin::File(path) = self.player.open_scene.origin() else {
            self.prompt_for_name();
            return;
        };
        let path = path.clone();
        if self.is_changed() || !edit_result::opens_in_shown_assembly(&self.player.open_scene) {
            self.store(SavedContent::Scene, path, Leave::default());
            return;
        }
        // The file has the screen's contents, if it still exists.
        let scene = self.scenes;
        self.clerk.submit(move || {
            let is_gone = matches!(FileStatus::of(&path), FileStatus::Gone);
            Box::new(move |app, _| match is_gone {
                _ if app.scenes != scene => {}
                true => app.store(SavedContent::Scene, path, Leave::default()),
                false => app.shell.set_message(words().unchanged_since_saved()),
            })
        });
    }

    /// Asks for the name of another file.
    pub(in crate::tui::app) fn prompt_for_name(&mut self) {
        self.player.playback.pause();
        let proposal = match self.player.open_scene.origin() {
            Origin::File(path) => path.to_string_lossy().into_owned(),
            Origin::Preset(name) => format!("{name}.toml"),
            Origin::New(name) => {
                let name = format!("{name}.toml");
                let folder = self.folder_of_task().map(|folder| folder.join(&name));
                folder.map_or(name, |path| path.to_string_lossy().into_owned())
            }
            Origin::Stdin => "scene.toml".into(),
        };
        self.prompt_for_file(SavedContent::Scene, &proposal);
    }

    /// Writes content to a file, within the granted permissions. A saved scene then belongs to that
    /// file.
    pub(in crate::tui::app) fn store(&mut self, content: SavedContent, to: PathBuf, leave: Leave) {
        if self.document.storing {
            self.set_message(words().still_writing());
            return;
        }
        let text = match &content {
            SavedContent::Text(text) => text.for_file(&to).to_owned(),
            SavedContent::Scene => {
                let is_shown = edit_result::opens_in_shown_assembly(&self.player.open_scene);
                if !is_shown && !self.record_assembly(words().assembly()) {
                    self.set_message(words().not_written_without_start());
                    return;
                }
                self.player.open_scene.scene().text().to_owned()
            }
        };
        let is_own = content == SavedContent::Scene && self.is_own(&to);
        let request = SaveRequest {
            text,
            own: is_own.then(|| self.document.editor.saved().to_owned()),
            leave,
            records: self
                .document
                .folder
                .as_ref()
                .map(|folder| folder.join("writing")),
            to,
        };
        if is_own && self.document.older && self.is_changed() && !leave.over {
            self.ask_to_confirm(content, request, ConfirmReason::Older);
            return;
        }
        self.document.storing = true;
        self.set_message(words().writing_to(&request.to.display()));
        let scene = self.scenes;
        self.clerk.submit(move || {
            let done = request.run();
            Box::new(move |app, _| app.stored(content, request, done, scene))
        });
    }

    fn is_own(&self, file: &Path) -> bool {
        matches!(self.player.open_scene.origin(), Origin::File(own) if own == file)
    }

    fn ask_to_confirm(
        &mut self,
        content: SavedContent,
        request: SaveRequest,
        confirm_reason: ConfirmReason,
    ) {
        self.shell.message = None;
        self.shell.open_prompt(Mode::Confirm(Question {
            content,
            to: request.to,
            reason: confirm_reason,
            leave: request.leave,
        }));
    }

    /// Handles the outcome of a write. If another scene is shown meanwhile, only reports it.
    fn stored(
        &mut self,
        content: SavedContent,
        request: SaveRequest,
        done: Result<(), WriteError>,
        scene: usize,
    ) {
        self.document.storing = false;
        let is_shown = scene == self.scenes;
        let error = match done {
            Ok(()) => {
                let to = request.to.display();
                self.set_message(match &content {
                    SavedContent::Scene => words().written_to(&to),
                    SavedContent::Text(text) => words().all_written_to(&text.what, &to),
                });
                if content == SavedContent::Scene && is_shown {
                    self.filed(&request);
                }
                return;
            }
            Err(error) => error,
        };
        self.set_message(match &content {
            SavedContent::Scene => refused(&error, &request.to),
            SavedContent::Text(_) => refused_there(&error),
        });
        // A late prompt could be answered by a key meant for something else.
        if !self.shell.mode.is_normal() || !is_shown {
            return;
        }
        match ConfirmReason::of(&error) {
            Some(confirm_reason) => self.ask_to_confirm(content, request, confirm_reason),
            // A text is not lost, and correcting a file name is easier than typing it again.
            None if request.own.is_none() => {
                let message = self.shell.message.take();
                self.prompt_for_file(content, &request.to.to_string_lossy());
                self.shell.message = message;
            }
            None => {
                let key = self.shell.keymap.key_label(Action::SaveAs);
                if let (WriteError::NoFile(_), Some(message)) = (&error, &mut self.shell.message) {
                    *message = words().or_save_elsewhere(message, &key);
                }
            }
        }
    }

    /// Notes that the file holds the scene as it was when the write started.
    fn filed(&mut self, request: &SaveRequest) {
        let is_own = self.is_own(&request.to);
        if !is_own {
            self.release();
            let name = request.to.display().to_string();
            if let Ok(scene) = Scene::parse(self.player.open_scene.scene().text(), &name) {
                self.player.open_scene.rename(scene, request.to.clone());
            }
            self.remember(false);
        }
        self.document.editor.filed(&request.text);
        self.document.older = false;
        // Edits made meanwhile are recorded before the older record is removed.
        self.keep_saved();
        self.relist();
        self.watch();
    }
}
