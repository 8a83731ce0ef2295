//! Keeping unsaved edits, and taking up those that earlier sessions have left.

use super::super::Origin;
use super::{App, Effect, Mode};
use crate::tui::commands::action::Action;
use crate::tui::commands::key::Key;
use crate::tui::document::Kept;
use crate::tui::document::edited;
use crate::tui::document::history::Deed;
use crate::tui::document::recovery::{self, KeptEdits, Others, Recovery};
use crate::tui::views::offer::list::Offer;
use crate::wording::words;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

impl Drop for App {
    /// What is kept is seen to apart from the screen: a disk that hangs keeps nobody from leaving.
    fn drop(&mut self) {
        let kept = self.document.recovery.take();
        self.clerk.give(move || {
            drop(kept);
            Box::new(|_, _| {})
        });
    }
}

fn locked(kept: &Kept) -> MutexGuard<'_, Recovery> {
    kept.lock().unwrap_or_else(PoisonError::into_inner)
}

impl App {
    /// Keeps unsaved edits in a folder from now on, and offers those that are there.
    pub(crate) fn recover_in(&mut self, folder: &Path) {
        self.document.folder = Some(folder.to_owned());
        self.remember(true);
        self.attend(self.now);
    }

    /// Nowhere is a folder to keep edits in: this is said with the first edit.
    pub(crate) fn recover_nowhere(&mut self) {
        self.document.is_homeless = true;
    }

    /// A scene was opened: its file is watched, and edits of earlier sessions are offered.
    pub(super) fn meet(&mut self) {
        self.watch();
        self.remember(true);
    }

    /// Edits are kept for the scene that is open now, and those of others offered.
    pub(super) fn remember(&mut self, offers: bool) {
        let before = self.document.recovery.take();
        let Some(folder) = self.document.folder.clone() else {
            return;
        };
        let (session, origin) = (
            self.document.session.clone(),
            self.player.open_scene.origin().clone(),
        );
        let text = self.document.editor.saved().to_owned();
        self.clerk.give(move || {
            drop(before);
            let recovery = Recovery::new(&folder, &session, &origin, &text);
            let others = match offers {
                true => recovery.others(&text),
                false => Others::default(),
            };
            Box::new(move |app, _| app.met(&origin, recovery, others))
        });
    }

    fn met(&mut self, origin: &Origin, recovery: Recovery, others: Others) {
        // Another scene may have been opened meanwhile.
        if self.player.open_scene.origin() != origin {
            return;
        }
        self.document.recovery = Some(Arc::new(Mutex::new(recovery)));
        if self.has_edits() {
            self.keep();
        }
        let Some(offer) = Offer::of(others) else {
            return;
        };
        if matches!(self.shell.mode, Mode::Normal | Mode::Tour(_)) {
            self.player.playback.pause();
            self.shell.ask(Mode::Recovery(Box::new(offer)));
        } else {
            self.shell.say(words().others_have_edits());
        }
    }

    /// After an edit: it is kept, or what was kept is dropped where nothing is unsaved any more.
    pub(super) fn keep(&mut self) {
        if self.has_edits() && std::mem::take(&mut self.document.is_homeless) {
            let said = words().edits_kept_nowhere().to_owned();
            self.clerk
                .give(|| Box::new(|app, _| app.shell.message = Some(said)));
        }
        let Some(kept) = self.document.recovery.clone() else {
            return;
        };
        let text = self.player.open_scene.scene().text().to_owned();
        // Edits that were taken up are taken back.
        self.document.older &= self.is_changed();
        let waiting = self.document.editor.gathered.clone().unwrap_or_default();
        let edits = KeptEdits { text, waiting };
        let edits = self
            .has_edits()
            .then(|| (edits, self.document.editor.saved().to_owned()));
        self.clerk.give(move || {
            let mut kept = locked(&kept);
            let said = match edits {
                Some((edits, saved)) => kept.keep(edits, &saved, SystemTime::now()),
                None => {
                    kept.rest();
                    None
                }
            };
            Box::new(move |app, _| app.shell.message = said.or(app.shell.message.take()))
        });
    }

    /// The scene was saved: what was edited since is kept, and what was taken up goes.
    pub(super) fn keep_saved(&mut self) {
        if !self.has_edits() {
            self.release();
            return;
        }
        self.keep();
        if let Some(kept) = self.document.recovery.clone() {
            self.clerk.give(move || {
                locked(&kept).drop_taken();
                Box::new(|_, _| {})
            });
        }
    }

    /// What was kept is saved, or not wanted any more.
    pub(super) fn release(&mut self) {
        if let Some(kept) = self.document.recovery.clone() {
            self.clerk.give(move || {
                locked(&kept).release();
                Box::new(|_, _| {})
            });
        }
    }

    /// Keys while edits are offered; `None` for those that mean the same everywhere. What was typed before
    /// the offer could be read was meant for something else, and answers nothing.
    pub(super) fn offer_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let (page, is_readable) = (self.page(), self.shell.can_be_answered(now));
        let Mode::Recovery(offer) = &mut self.shell.mode else {
            return None;
        };
        if let Key::Ctrl(_) = key {
            return None;
        }
        if !is_readable {
            return Some(Effect::Show);
        }
        self.shell.message = None;
        let is_asked = std::mem::take(&mut offer.asks);
        match key {
            Key::Up | Key::Char('k') => offer.move_by(-1),
            Key::Down | Key::Char('j') => offer.move_by(1),
            Key::PageUp => offer.move_by(-page),
            Key::PageDown | Key::Char(' ') => offer.move_by(page),
            Key::Home => offer.move_by(isize::MIN),
            Key::End => offer.move_by(isize::MAX),
            Key::Escape | Key::Backspace if offer.page.is_some() => offer.page = None,
            Key::Escape => self.shell.mode = Mode::Normal,
            Key::Enter if offer.others.left.is_empty() => self.shell.mode = Mode::Normal,
            // It tells something and asks nothing: a key does what it does without it.
            Key::Char(_) if offer.others.left.is_empty() => {
                self.shell.mode = Mode::Normal;
                return None;
            }
            Key::Enter if offer.page.is_none() => offer.look(),
            Key::Char('c') => offer.compare(self.player.open_scene.scene().text()),
            Key::Char('t') => self.take_offered(now),
            Key::Char('d') if is_asked => self.drop_offered(),
            Key::Char('d') => offer.asks = offer.page.is_none() && offer.chosen().is_some(),
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Edits of an earlier session come back, as a step that can be taken back.
    fn take_offered(&mut self, now: Duration) {
        let Mode::Recovery(offer) = &self.shell.mode else {
            return;
        };
        let Some(found) = offer.chosen().cloned() else {
            return;
        };
        match edited::reopened(&self.player.open_scene, &found.edits.text) {
            Ok(edited) => {
                self.shell.mode = Mode::Normal;
                if let Some(kept) = self.document.recovery.clone() {
                    // As the scene says them now, with its start positions.
                    let text = edited.opened.scene.text().to_owned();
                    self.clerk.give(move || {
                        locked(&kept).take(found.file, text);
                        Box::new(|_, _| {})
                    });
                }
                self.change(edited, Deed::Other(words().recovered_edits().into()), now);
                self.document.older |= found.is_stale;
                let key = self.shell.keymap.told(Action::Undo);
                self.shell.say(match found.is_stale {
                    true => words().older_edits_are_back(&key),
                    false => words().edits_are_back(&key),
                });
                self.let_wait(found.edits.waiting);
            }
            Err(why) => self.shell.say(words().edits_cannot_be_shown(&why)),
        }
    }

    fn drop_offered(&mut self) {
        let Mode::Recovery(offer) = &mut self.shell.mode else {
            return;
        };
        let Some(file) = offer.chosen().map(|chosen| chosen.file.clone()) else {
            return;
        };
        if !offer.forget() {
            self.shell.mode = Mode::Normal;
        }
        self.shell.say(words().edits_deleted());
        self.clerk.give(move || {
            recovery::delete(&file);
            Box::new(|_, _| {})
        });
    }
}
