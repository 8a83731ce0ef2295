//! Leaving the program, or the scene for another: what is unsaved is asked about first.

use super::super::Opened;
use super::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use std::time::Duration;

/// A question about unsaved edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unsaved {
    /// Before the program is left.
    Quit,
    /// Before another scene takes the place of this one.
    Open,
    /// Before the file is read again.
    Reload,
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
    /// Whether something was edited that no file holds, be it made or not.
    pub(super) fn has_edits(&self) -> bool {
        self.is_changed() || self.is_waiting()
    }

    /// Whether something would be lost with the scene.
    fn would_lose(&self) -> bool {
        self.is_unsaved() || self.is_waiting()
    }

    /// Leaves, or asks first where something would be lost.
    pub(super) fn quit(&mut self) -> Effect {
        if !self.would_lose() {
            return Effect::Quit;
        }
        self.player.playback.pause();
        self.pending = Some(Pending::Quit);
        self.ask_about_edits(Unsaved::Quit);
        Effect::Show
    }

    /// Shows another scene, or asks first where something would be lost.
    pub(crate) fn show(&mut self, opened: Opened) {
        if !self.would_lose() {
            self.show_now(opened);
            return;
        }
        self.player.playback.pause();
        self.pending = Some(Pending::Show(Box::new(opened)));
        self.ask_about_edits(Unsaved::Open);
    }

    /// Asks what is to become of unsaved edits.
    pub(super) fn ask_about_edits(&mut self, question: Unsaved) {
        self.shell.ask(Mode::Unsaved(question));
    }

    /// Keys of a question about unsaved edits; `None` for those that mean the same everywhere.
    pub(super) fn answer(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let Mode::Unsaved(question) = &self.shell.mode else {
            return None;
        };
        let question = question.clone();
        match key {
            Key::Escape => self.shell.mode = Mode::Normal,
            Key::Ctrl(_) => return None,
            _ if !self.shell.can_be_answered(now) => return Some(Effect::Show),
            _ => {}
        }
        match (key, question) {
            (Key::Char('w'), Unsaved::Quit | Unsaved::Open) => {
                self.shell.mode = Mode::Normal;
                self.save_own();
            }
            (Key::Char('q'), Unsaved::Quit) | (Key::Char('d'), Unsaved::Open) => {
                self.release();
                self.shell.mode = Mode::Normal;
                return Some(self.go_on());
            }
            (Key::Enter, Unsaved::Reload) => {
                self.shell.mode = Mode::Normal;
                self.reload(true);
            }
            _ => {}
        }
        Some(Effect::Show)
    }

    /// After a key: what was to follow on saving is done once nothing is unsaved, and forgotten where the
    /// person has gone back.
    pub(super) fn settle(&mut self, effect: Effect) -> Effect {
        if self.shell.mode != Mode::Normal || self.pending.is_none() || self.document.storing {
            return effect;
        }
        if self.would_lose() {
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
