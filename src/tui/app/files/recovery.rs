//! Records unsaved edits for recovery and restores those of earlier sessions.

use super::super::Origin;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::action::Action;
use crate::tui::commands::key::Key;
use crate::tui::document::SharedRecovery;
use crate::tui::document::edit_result;
use crate::tui::document::history::Deed;
use crate::tui::document::recovery::{self, OtherSessions, Recovery, UnsavedEdits};
use crate::tui::views::recovery_offer::list::Offer;
use crate::wording::words;
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime};

impl Drop for App {
    /// Closes the recovery record on a background thread, so that a slow disk does not delay
    /// quitting.
    fn drop(&mut self) {
        let kept = self.document.recovery.take();
        self.clerk.submit(move || {
            drop(kept);
            Box::new(|_, _| {})
        });
    }
}

fn locked(kept: &SharedRecovery) -> MutexGuard<'_, Recovery> {
    kept.lock().unwrap_or_else(PoisonError::into_inner)
}

impl App {
    /// Sets the folder for unsaved edits and offers the edits found there.
    pub(crate) fn recover_in(&mut self, folder: &Path) {
        self.document.folder = Some(folder.to_owned());
        self.remember(true);
        self.attend(self.now);
    }

    /// Notes that no folder for unsaved edits exists. The first edit then reports it.
    pub(crate) fn recover_nowhere(&mut self) {
        self.document.has_no_edits_folder = true;
    }

    /// Watches the file of a newly opened scene and offers edits of earlier sessions.
    pub(in crate::tui::app) fn meet(&mut self) {
        self.watch();
        self.remember(true);
    }

    /// Opens a recovery record for the scene and, if `offers`, offers the edits of other sessions.
    pub(in crate::tui::app) fn remember(&mut self, offers: bool) {
        let before = self.document.recovery.take();
        let Some(folder) = self.document.folder.clone() else {
            return;
        };
        let (session, origin) = (
            self.document.session.clone(),
            self.player.open_scene.origin().clone(),
        );
        let text = self.document.editor.saved().to_owned();
        self.clerk.submit(move || {
            drop(before);
            let recovery = Recovery::new(&folder, &session, &origin, &text);
            let others = match offers {
                true => recovery.others(&text),
                false => OtherSessions::default(),
            };
            Box::new(move |app, _| app.met(&origin, recovery, others))
        });
    }

    fn met(&mut self, origin: &Origin, recovery: Recovery, others: OtherSessions) {
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
            self.shell.open_prompt(Mode::Recovery(Box::new(offer)));
        } else {
            self.set_message(words().others_have_edits());
        }
    }

    /// Records the edits for recovery after a change, or removes the record if nothing is unsaved.
    pub(in crate::tui::app) fn keep(&mut self) {
        if self.has_edits() && std::mem::take(&mut self.document.has_no_edits_folder) {
            let message = words().edits_kept_nowhere().to_owned();
            self.clerk
                .submit(|| Box::new(|app, _| app.shell.message = Some(message)));
        }
        let Some(kept) = self.document.recovery.clone() else {
            return;
        };
        let text = self.player.open_scene.scene().text().to_owned();
        // The restored edits may have been undone.
        self.document.older &= self.is_changed();
        let waiting = self.document.editor.staged.clone().unwrap_or_default();
        let edits = UnsavedEdits { text, waiting };
        let edits = self
            .has_edits()
            .then(|| (edits, self.document.editor.saved().to_owned()));
        self.clerk.submit(move || {
            let mut kept = locked(&kept);
            let message = match edits {
                Some((edits, saved)) => kept.keep(edits, &saved, SystemTime::now()),
                None => {
                    kept.rest();
                    None
                }
            };
            Box::new(move |app, _| app.shell.message = message.or(app.shell.message.take()))
        });
    }

    /// Updates the recovery record after a save: keeps later edits and drops restored ones.
    pub(in crate::tui::app) fn keep_saved(&mut self) {
        if !self.has_edits() {
            self.release();
            return;
        }
        self.keep();
        if let Some(kept) = self.document.recovery.clone() {
            self.clerk.submit(move || {
                locked(&kept).drop_taken();
                Box::new(|_, _| {})
            });
        }
    }

    /// Removes the recovery record because the edits are saved or discarded.
    pub(in crate::tui::app) fn release(&mut self) {
        if let Some(kept) = self.document.recovery.clone() {
            self.clerk.submit(move || {
                locked(&kept).release();
                Box::new(|_, _| {})
            });
        }
    }

    /// Handles a key while edits are offered. Returns `None` for keys with the same meaning
    /// everywhere. Keys typed before the offer was readable are ignored.
    pub(in crate::tui::app) fn handle_offer_key(
        &mut self,
        key: Key,
        now: Duration,
    ) -> Option<Effect> {
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
            _ if let Some(rows) = key.rows_or_letter(page) => offer.move_by(rows),
            Key::Char(' ') => offer.move_by(page),
            Key::Escape | Key::Backspace if offer.page.is_some() => offer.page = None,
            Key::Escape => self.shell.mode = Mode::Normal,
            Key::Enter if offer.others.left.is_empty() => self.shell.mode = Mode::Normal,
            // This offer only informs, so the key keeps its usual meaning.
            Key::Char(_) if offer.others.left.is_empty() => {
                self.shell.mode = Mode::Normal;
                return None;
            }
            Key::Enter if offer.page.is_none() => offer.open_page(),
            Key::Char('c') => offer.compare(self.player.open_scene.scene().text()),
            Key::Char('t') => self.take_offered(now),
            Key::Char('d') if is_asked => self.drop_offered(),
            Key::Char('d') => offer.asks = offer.page.is_none() && offer.chosen().is_some(),
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Restores the edits of an earlier session as an edit that can be undone.
    fn take_offered(&mut self, now: Duration) {
        let Mode::Recovery(offer) = &self.shell.mode else {
            return;
        };
        let Some(found) = offer.chosen().cloned() else {
            return;
        };
        match edit_result::reopened(&self.player.open_scene, &found.edits.text) {
            Ok(edited) => {
                self.shell.mode = Mode::Normal;
                if let Some(kept) = self.document.recovery.clone() {
                    // The text of the reopened scene, which includes its start positions.
                    let text = edited.opened.scene.text().to_owned();
                    self.clerk.submit(move || {
                        locked(&kept).take(found.file, text);
                        Box::new(|_, _| {})
                    });
                }
                self.change(edited, Deed::Other(words().recovered_edits().into()), now);
                self.document.older |= found.is_stale;
                let key = self.shell.keymap.key_label(Action::Undo);
                self.set_message(match found.is_stale {
                    true => words().older_edits_are_back(&key),
                    false => words().edits_are_back(&key),
                });
                self.restore_staged(found.edits.waiting);
            }
            Err(why) => self.set_message(words().edits_cannot_be_shown(&why)),
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
        self.set_message(words().edits_deleted());
        self.clerk.submit(move || {
            recovery::delete(&file);
            Box::new(|_, _| {})
        });
    }
}
