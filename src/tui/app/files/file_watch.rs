//! Watches the scene's file and rereads it after changes by other programs.

use crate::scene::Scene;
use crate::tui::app::{App, Effect, Unsaved};
use crate::tui::commands::action::Action;
use crate::tui::document::disk::{FileCheckOutcome, FileStatus, unmarked};
use crate::tui::document::history::Deed;
use crate::tui::document::io_thread::JobOwner;
use crate::tui::document::opening;
use crate::tui::{OpenedScene, Origin};
use crate::wording::words;
use std::io;
use std::path::Path;
use std::time::Duration;

impl JobOwner for App {
    fn fail(&mut self, error: &io::Error) {
        self.document.storing = false;
        self.set_message(error.to_string());
    }
}

impl App {
    /// Handles the results of finished file operations and returns the resulting effect.
    pub(crate) fn attend(&mut self, now: Duration) -> Effect {
        self.drain_results(now);
        self.settle(Effect::Show)
    }

    /// Handles the results of finished file operations where the caller cannot quit the program. A
    /// pending quit is left to the next call that can.
    pub(in crate::tui::app) fn drain_results(&mut self, now: Duration) {
        while let Some(then) = self.clerk.next() {
            then(self, now);
        }
    }

    /// Starts watching the scene's file.
    pub(in crate::tui::app) fn watch(&mut self) {
        let origin = self.player.open_scene.origin();
        self.document.belong_to(origin);
        self.check_file(self.now, true);
    }

    /// Returns the watched file.
    pub(crate) fn watched(&self) -> Option<&Path> {
        self.document.watched()
    }

    /// Checks whether another program has written the file: immediately if `at_once`, or else when
    /// the next check is due.
    pub(crate) fn check_file(&mut self, now: Duration, at_once: bool) {
        let look = self
            .document
            .disk
            .as_mut()
            .and_then(|disk| disk.due_check(now, at_once));
        if let Some(look) = look {
            self.clerk.submit(move || {
                let seen = look.run();
                Box::new(move |app, now| app.handle_file_check(seen, now))
            });
        }
    }

    /// Handles the outcome of a file check. It is ignored while a prompt is open or a save is
    /// running; the next check reports it.
    fn handle_file_check(&mut self, seen: FileCheckOutcome, now: Duration) {
        let is_free = self.shell.mode.is_normal() && !self.document.storing;
        let Some(disk) = self
            .document
            .disk
            .as_mut()
            .filter(|disk| disk.path() == seen.path)
        else {
            return;
        };
        if disk.see(&seen, is_free || seen.news.is_none()) {
            self.check_file(now, true);
        }
        let Some(news) = seen.news.filter(|_| is_free) else {
            return;
        };
        let Some(name) = self.document.file_name() else {
            return;
        };
        self.compare_file(&news);
        match news {
            _ if !self.document.editor.is_file_other => {}
            FileStatus::Written(_) if self.is_changed() => {
                let key = |action| self.shell.keymap.key_label(action);
                let [reload, elsewhere] = [Action::Reload, Action::SaveAs].map(key);
                self.set_message(words().file_changed(&name, &reload, &elsewhere));
            }
            FileStatus::Written(bytes) => self.load_changed_file(&bytes, &name, now),
            FileStatus::Gone => self.report_missing(&name),
            FileStatus::Unreadable(error) => {
                self.set_message(words().name_cannot_be_read(&name, &error));
            }
        }
    }

    /// Records whether the file has other contents than the text last opened or saved. The status
    /// line then marks its name.
    fn compare_file(&mut self, news: &FileStatus) {
        let editor = &mut self.document.editor;
        editor.is_file_other = match news {
            FileStatus::Written(bytes) => unmarked(bytes) != editor.saved().as_bytes(),
            FileStatus::Gone | FileStatus::Unreadable(_) => true,
        };
    }

    /// Rereads the file on request; replaces unsaved edits only if `over`.
    pub(in crate::tui::app) fn reload(&mut self, over: bool) {
        let Origin::File(path) = self.player.open_scene.origin().clone() else {
            self.set_message(words().no_file_to_read());
            return;
        };
        self.clerk.submit(move || {
            let news = FileStatus::of(&path);
            Box::new(move |app, now| app.reread(news, over, now))
        });
    }

    fn reread(&mut self, news: FileStatus, over: bool, now: Duration) {
        let Some(name) = self.document.file_name() else {
            return;
        };
        self.compare_file(&news);
        match news {
            FileStatus::Written(_) if self.is_changed() && !over => {
                self.prompt_about_edits(Unsaved::Reload);
            }
            FileStatus::Written(bytes) => self.load_changed_file(&bytes, &name, now),
            // A deleted file does not endanger the edits.
            FileStatus::Gone => self.report_missing(&name),
            FileStatus::Unreadable(error) => {
                self.set_message(words().name_cannot_be_read(&name, &error));
            }
        }
    }

    fn report_missing(&mut self, name: &str) {
        let key = self.shell.keymap.key_label(Action::Save);
        self.set_message(words().file_is_gone(name, &key));
    }

    /// Shows the file's new contents as an edit that can be undone. If they are invalid, the last
    /// valid scene stays on the screen.
    fn load_changed_file(&mut self, bytes: &[u8], name: &str, now: Duration) {
        let origin = self.player.open_scene.scene().origin().to_owned();
        let scene = Scene::read(bytes, &origin);
        let opened = scene.and_then(opening::assembled);
        match opened {
            Ok((scene, solver)) => {
                let origin = self.player.open_scene.origin().clone();
                let (before, after) = (
                    self.player.open_scene.scene().text(),
                    scene.text().to_owned(),
                );
                let action = Deed::Other(words().reading_the_file().into());
                self.document.editor.history.record(before, &after, action);
                self.document.editor.filed(&after);
                let opened = OpenedScene {
                    scene,
                    solver,
                    origin,
                };
                self.exchange(opened, now);
                self.keep();
                self.watch();
                self.set_message(words().was_read_again(name));
            }
            Err(faults) => {
                let fault = faults.first_words();
                self.set_message(words().is_broken_not_shown(name, fault));
            }
        }
    }
}
