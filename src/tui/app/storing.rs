//! Writes the scene, values and images to files, with a prompt if something would be lost.

use super::{App, Mode};
use crate::files::WriteError;
use crate::scene::Scene;
use crate::tui::Origin;
use crate::tui::commands::action::Action;
use crate::tui::document::disk::FileStatus;
use crate::tui::document::edited;
use crate::tui::document::saving::{Leave, SaveRequest, refused, refused_there};
use crate::tui::document::writing::{ConfirmReason, Question, SavedContent};
use crate::wording::words;
use std::path::{Path, PathBuf};

impl App {
    /// Saves the scene to its own file, or asks for a file.
    pub(super) fn save_own(&mut self) {
        self.player.playback.pause();
        let Origin::File(path) = self.player.open_scene.origin() else {
            self.ask_where();
            return;
        };
        let path = path.clone();
        if self.is_changed() || !edited::says_what_is_shown(&self.player.open_scene) {
            self.store(SavedContent::Scene, path, Leave::default());
            return;
        }
        // The file has the screen's contents, if it still exists.
        let scene = self.scenes;
        self.clerk.give(move || {
            let is_gone = matches!(FileStatus::of(&path), FileStatus::Gone);
            Box::new(move |app, _| match is_gone {
                _ if app.scenes != scene => {}
                true => app.store(SavedContent::Scene, path, Leave::default()),
                false => app.shell.say(words().unchanged_since_saved()),
            })
        });
    }

    /// Asks for the name of another file.
    pub(super) fn ask_where(&mut self) {
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
        self.ask_for_file(SavedContent::Scene, &proposal);
    }

    /// Writes content to a file, within the granted permissions. A saved scene then belongs to that
    /// file.
    pub(super) fn store(&mut self, content: SavedContent, to: PathBuf, leave: Leave) {
        if self.document.storing {
            self.shell.say(words().still_writing());
            return;
        }
        let text = match &content {
            SavedContent::Text(text) => text.for_file(&to).to_owned(),
            SavedContent::Scene => {
                let told = edited::says_what_is_shown(&self.player.open_scene);
                if !told && !self.record_assembly(words().assembly()) {
                    self.shell.say(words().not_written_without_start());
                    return;
                }
                self.player.open_scene.scene().text().to_owned()
            }
        };
        let is_own = content == SavedContent::Scene && self.is_own(&to);
        let errand = SaveRequest {
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
            self.ask(content, errand, ConfirmReason::Older);
            return;
        }
        self.document.storing = true;
        self.shell.say(words().writing_to(&errand.to.display()));
        let scene = self.scenes;
        self.clerk.give(move || {
            let done = errand.run();
            Box::new(move |app, _| app.stored(content, errand, done, scene))
        });
    }

    fn is_own(&self, file: &Path) -> bool {
        matches!(self.player.open_scene.origin(), Origin::File(own) if own == file)
    }

    fn ask(&mut self, content: SavedContent, errand: SaveRequest, doubt: ConfirmReason) {
        self.shell.message = None;
        self.shell.ask(Mode::Confirm(Question {
            content,
            to: errand.to,
            doubt,
            leave: errand.leave,
        }));
    }

    /// Handles the outcome of a write. If another scene is shown meanwhile, only reports it.
    fn stored(
        &mut self,
        content: SavedContent,
        errand: SaveRequest,
        done: Result<(), WriteError>,
        scene: usize,
    ) {
        self.document.storing = false;
        let is_shown = scene == self.scenes;
        let trouble = match done {
            Ok(()) => {
                let to = errand.to.display();
                self.shell.say(match &content {
                    SavedContent::Scene => words().written_to(&to),
                    SavedContent::Text(text) => words().all_written_to(&text.what, &to),
                });
                if content == SavedContent::Scene && is_shown {
                    self.filed(&errand);
                }
                return;
            }
            Err(trouble) => trouble,
        };
        self.shell.say(match &content {
            SavedContent::Scene => refused(&trouble, &errand.to),
            SavedContent::Text(_) => refused_there(&trouble),
        });
        // A late prompt could be answered by a key meant for something else.
        if !self.shell.mode.is_normal() || !is_shown {
            return;
        }
        match ConfirmReason::of(&trouble) {
            Some(doubt) => self.ask(content, errand, doubt),
            // A text is not lost, and correcting a file name is easier than typing it again.
            None if errand.own.is_none() => {
                let message = self.shell.message.take();
                self.ask_for_file(content, &errand.to.to_string_lossy());
                self.shell.message = message;
            }
            None => {
                let key = self.shell.keymap.told(Action::SaveAs);
                if let (WriteError::NoFile(_), Some(message)) = (&trouble, &mut self.shell.message)
                {
                    *message = words().or_save_elsewhere(message, &key);
                }
            }
        }
    }

    /// Notes that the file holds the scene as it was when the write started.
    fn filed(&mut self, errand: &SaveRequest) {
        let is_own = self.is_own(&errand.to);
        if !is_own {
            self.release();
            let name = errand.to.display().to_string();
            if let Ok(scene) = Scene::parse(self.player.open_scene.scene().text(), &name) {
                self.player.open_scene.rename(scene, errand.to.clone());
            }
            self.remember(false);
        }
        self.document.editor.filed(&errand.text);
        self.document.older = false;
        // Edits made meanwhile are recorded before the older record is removed.
        self.keep_saved();
        self.relist();
        self.watch();
    }
}
