//! The scene and its file: saving, reading again what somebody else has written, keeping unsaved edits
//! for recovery, and asking before they are lost.

use super::super::action::Action;
use super::super::disk::{Disk, News, unmarked};
use super::super::edited;
use super::super::history::Deed;
use super::super::key::Key;
use super::super::recovery::{Found, Recovery};
use super::super::writing::Document;
use super::super::{Opened, Origin, opening, saving};
use super::{App, Effect, Mode};
use crate::scene::Scene;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// A question about unsaved edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unsaved {
    /// Before the program is left.
    Quit,
    /// Before another scene takes the place of this one.
    Open,
    /// Before the file is read again.
    Reload,
    /// Edits of an earlier session were found.
    Found(Found),
}

/// What is to be done once nothing is unsaved.
#[derive(Debug)]
pub(crate) enum Pending {
    /// The program is left.
    Quit,
    /// Another scene is shown.
    Show(Box<Opened>),
}

impl App {
    /// Keeps unsaved edits in a folder from now on, and offers those that are there.
    pub(crate) fn recover_in(&mut self, folder: &Path) {
        self.folder = Some(folder.to_owned());
        self.meet();
    }

    /// A scene was opened: its file is watched, and edits of an earlier session are offered.
    pub(super) fn meet(&mut self) {
        self.watch();
        let (origin, text) = (self.stage.origin(), self.stage.scene().text());
        let folder = self.folder.as_ref();
        self.recovery = folder.map(|folder| Recovery::new(folder, origin, text));
        let found = self.recovery.as_ref().and_then(|r| r.found(text));
        if let Some(found) = found {
            self.mode = Mode::Unsaved(Unsaved::Found(found));
        }
    }

    fn watch(&mut self) {
        self.disk = match self.stage.origin() {
            Origin::File(path) => Some(Disk::new(path, self.now)),
            Origin::Preset(_) | Origin::Stdin => None,
        };
    }

    /// The file to watch.
    pub(crate) fn watched(&self) -> Option<&Path> {
        self.disk.as_ref().map(Disk::path)
    }

    /// After an edit: it is kept, or what was kept is dropped where nothing is unsaved any more.
    pub(super) fn keep(&mut self) {
        let Some(recovery) = &mut self.recovery else {
            return;
        };
        let text = self.stage.scene().text();
        if self.editor.is_changed(self.stage.scene()) {
            let said = recovery.keep(text, self.editor.saved(), SystemTime::now());
            self.message = said.or(self.message.take());
        } else {
            recovery.drop_kept();
        }
    }

    /// Looks whether somebody else has written the file: at once where that was told, else after a while.
    /// Not while something is asked or typed: the next look after it will tell.
    pub(crate) fn look_at_file(&mut self, now: Duration, at_once: bool) {
        if self.mode != Mode::Normal {
            return;
        }
        let news = self.disk.as_mut().and_then(|disk| disk.look(now, at_once));
        let (Some(news), Some(name)) = (news, self.file_name()) else {
            return;
        };
        match news {
            News::Written(bytes) if unmarked(&bytes) == self.editor.saved().as_bytes() => {}
            News::Written(_) if self.is_changed() => {
                let ways = self.ways_out();
                self.message = Some(format!("{name} has changed on disk: {ways}"));
            }
            News::Written(bytes) => self.read_in(&bytes, &name, now),
            News::Gone => self.tell_gone(&name),
            News::Unreadable(error) => {
                self.message = Some(format!("{name} cannot be read: {error}"));
            }
        }
    }

    /// Reads the file again because that was asked for.
    pub(super) fn reload(&mut self, now: Duration) {
        match self.stage.origin() {
            // A file that is gone is no danger to the edits.
            Origin::File(path) if self.is_changed() && path.exists() => {
                self.mode = Mode::Unsaved(Unsaved::Reload);
            }
            Origin::File(_) => self.reload_now(now),
            Origin::Preset(_) | Origin::Stdin => {
                self.message = Some("this scene has no file to read again".into());
            }
        }
    }

    /// What to do where the file is another than was opened.
    fn ways_out(&self) -> String {
        let key = |action| self.keymap.told(action);
        let [reload, elsewhere] = [Action::Reload, Action::SaveAs].map(key);
        format!("{reload} reads it, {elsewhere} saves elsewhere")
    }

    fn tell_gone(&mut self, name: &str) {
        let key = self.keymap.told(Action::Save);
        self.message = Some(format!("{name} is gone: {key} writes it again"));
    }

    fn reload_now(&mut self, now: Duration) {
        let (Some(disk), Some(name)) = (&self.disk, self.file_name()) else {
            return;
        };
        match disk.read() {
            News::Written(bytes) => self.read_in(&bytes, &name, now),
            News::Gone => self.tell_gone(&name),
            News::Unreadable(error) => {
                self.message = Some(format!("{name} cannot be read: {error}"));
            }
        }
    }

    /// Shows what the file holds now; what is broken leaves the last good state on the screen. The edits
    /// before it can be had back by taking this one back.
    fn read_in(&mut self, bytes: &[u8], name: &str, now: Duration) {
        let origin = self.stage.scene().origin().to_owned();
        let scene = Scene::read(bytes, &origin);
        let opened = scene.and_then(opening::assembled);
        match opened {
            Ok((scene, solver)) => {
                let origin = self.stage.origin().clone();
                let (before, after) = (self.stage.scene().text(), scene.text().to_owned());
                let deed = Deed::Other("reading the file".into());
                self.editor.history.record(before, &after, deed);
                self.editor.filed(&after);
                let opened = Opened {
                    scene,
                    solver,
                    origin,
                };
                self.exchange(opened, now);
                self.keep();
                self.watch();
                self.message = Some(format!("{name} was read again"));
            }
            Err(faults) => {
                let fault = opening::first_words(&faults);
                self.message = Some(format!("{name} is broken, not shown: {fault}"));
            }
        }
    }

    fn file_name(&self) -> Option<String> {
        let path = self.disk.as_ref()?.path();
        let name = path.file_name().unwrap_or(path.as_os_str());
        Some(name.to_string_lossy().into_owned())
    }

    /// Writes the scene to its own file, or asks to which.
    pub(super) fn save_own(&mut self) {
        self.playback.pause();
        let Origin::File(path) = self.stage.origin() else {
            self.ask_where();
            return;
        };
        let path = path.clone();
        if !self.needs_saving(&path) {
            self.message = Some("nothing has changed since it was saved".into());
            return;
        }
        let done = self.save(&path, false);
        self.message = Some(done.unwrap_or_else(|why| why));
    }

    /// Asks for the name of another file.
    pub(super) fn ask_where(&mut self) {
        self.playback.pause();
        let proposal = match self.stage.origin() {
            Origin::File(path) => path.to_string_lossy().into_owned(),
            Origin::Preset(name) => format!("{name}.toml"),
            Origin::Stdin => "scene.toml".into(),
        };
        self.ask_for_file(Document::Scene, &proposal);
    }

    /// Whether the file says something else than the screen, or is there no more.
    fn needs_saving(&self, file: &Path) -> bool {
        self.is_changed() || !file.exists() || !edited::says_what_is_shown(&self.stage)
    }

    /// Writes the scene to a file, which is then its own: what was done, or why nothing was. What somebody
    /// else has written to its own file meanwhile is written `over` only if that was asked for.
    pub(super) fn save(&mut self, to: &Path, over: bool) -> Result<String, String> {
        if !edited::says_what_is_shown(&self.stage) && !self.record_assembly("assembly") {
            return Err(
                "not written: no start positions tell this assembly from the others".into(),
            );
        }
        let own = matches!(self.stage.origin(), Origin::File(own) if own == to);
        let text = self.stage.scene().text().to_owned();
        let expected = (own && !over).then(|| self.editor.saved());
        let said = saving::save(&text, own, expected, to, &self.ways_out())?;
        if let Some(recovery) = &mut self.recovery {
            recovery.drop_kept();
        }
        if !own {
            let name = to.display().to_string();
            if let Ok(scene) = Scene::parse(&text, &name) {
                self.stage.rename(scene, to.to_owned());
            }
            let (folder, origin) = (self.folder.as_ref(), self.stage.origin());
            self.recovery = folder.map(|folder| Recovery::new(folder, origin, &text));
        }
        self.editor.filed(&text);
        self.relist();
        self.watch();
        Ok(said)
    }

    /// Leaves, or asks first where something would be lost.
    pub(super) fn quit(&mut self) -> Effect {
        if !self.is_changed() {
            return Effect::Quit;
        }
        self.playback.pause();
        self.pending = Some(Pending::Quit);
        self.mode = Mode::Unsaved(Unsaved::Quit);
        Effect::Show
    }

    /// Shows another scene, or asks first where something would be lost.
    pub(crate) fn show(&mut self, opened: Opened) {
        if !self.is_changed() {
            self.show_now(opened);
            return;
        }
        self.playback.pause();
        self.pending = Some(Pending::Show(Box::new(opened)));
        self.mode = Mode::Unsaved(Unsaved::Open);
    }

    /// Keys of a question about unsaved edits; `None` for those that mean the same everywhere.
    pub(super) fn answer(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let Mode::Unsaved(question) = &self.mode else {
            return None;
        };
        let question = question.clone();
        match (key, question) {
            (Key::Escape, _) => self.mode = Mode::Normal,
            (Key::Char('w'), Unsaved::Quit | Unsaved::Open) => {
                self.mode = Mode::Normal;
                self.save_own();
            }
            (Key::Char('q'), Unsaved::Quit) | (Key::Char('d'), Unsaved::Open) => {
                if let Some(recovery) = &mut self.recovery {
                    recovery.drop_kept();
                }
                self.mode = Mode::Normal;
                return Some(self.go_on());
            }
            (Key::Enter, Unsaved::Reload) => {
                self.mode = Mode::Normal;
                self.reload_now(now);
            }
            (Key::Enter, Unsaved::Found(found)) => {
                self.mode = Mode::Normal;
                self.take_found(&found, now);
            }
            (Key::Char('d'), Unsaved::Found(_)) => {
                self.mode = Mode::Normal;
                if let Some(recovery) = &mut self.recovery {
                    recovery.delete();
                }
                self.message = Some("the edits of the earlier session are deleted".into());
            }
            // Nothing of this session would be lost.
            (_, Unsaved::Found(_)) | (Key::Ctrl(_), _) => return None,
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Edits of an earlier session come back, as a step that can be taken back.
    fn take_found(&mut self, found: &Found, now: Duration) {
        match edited::reopened(&self.stage, &found.text) {
            Ok(edited) => {
                if let Some(recovery) = &mut self.recovery {
                    recovery.take();
                }
                self.change(edited, Deed::Other("recovered edits".into()), now);
                let key = self.keymap.told(Action::Undo);
                self.message = Some(match found.stale {
                    true => format!(
                        "they are back, made on another text than the file has; {key} drops them"
                    ),
                    false => format!("the unsaved edits are back; {key} takes them away"),
                });
            }
            Err(why) => self.message = Some(format!("they cannot be shown: {why}")),
        }
    }

    /// After a key: what was to follow on saving is done once nothing is unsaved, and forgotten where the
    /// person has gone back.
    pub(super) fn settle(&mut self, effect: Effect) -> Effect {
        if self.mode != Mode::Normal || self.pending.is_none() {
            return effect;
        }
        if self.is_changed() {
            self.pending = None;
            return effect;
        }
        self.go_on()
    }

    fn go_on(&mut self) -> Effect {
        match self.pending.take() {
            Some(Pending::Quit) => Effect::Quit,
            Some(Pending::Show(opened)) => {
                self.show_now(*opened);
                Effect::Show
            }
            None => Effect::Show,
        }
    }
}
