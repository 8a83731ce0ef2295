//! Quits the program or replaces the scene, with a prompt about unsaved edits.

use super::super::OpenedScene;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use std::time::Duration;

/// A prompt about unsaved edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unsaved {
    /// Before quitting the program.
    Quit,
    /// Before showing another scene.
    Open,
    /// Before rereading the file.
    Reload,
}

/// The action to run once all edits are saved or discarded.
#[derive(Debug)]
pub(crate) enum Pending {
    /// Quit the program.
    Quit,
    /// Show another scene.
    Show(Box<OpenedScene>),
}

impl App {
    /// Returns `true` if there are applied or staged edits that no file holds.
    pub(in crate::tui::app) fn has_edits(&self) -> bool {
        self.is_changed() || self.is_waiting()
    }

    /// Returns `true` if closing the scene would lose something.
    fn loses_edits(&self) -> bool {
        self.is_unsaved() || self.is_waiting()
    }

    /// Quits, or asks first if something would be lost.
    pub(in crate::tui::app) fn quit(&mut self) -> Effect {
        if !self.loses_edits() {
            return Effect::Quit;
        }
        self.player.playback.pause();
        self.pending = Some(Pending::Quit);
        self.prompt_about_edits(Unsaved::Quit);
        Effect::Show
    }

    /// Shows another scene, or asks first if something would be lost.
    pub(crate) fn show(&mut self, opened: OpenedScene) {
        if !self.loses_edits() {
            self.show_now(opened);
            return;
        }
        self.player.playback.pause();
        self.pending = Some(Pending::Show(Box::new(opened)));
        self.prompt_about_edits(Unsaved::Open);
    }

    /// Asks whether to save or discard unsaved edits.
    pub(in crate::tui::app) fn prompt_about_edits(&mut self, question: Unsaved) {
        self.shell.open_prompt(Mode::Unsaved(question));
    }

    /// Handles a key of the prompt about unsaved edits. Returns `None` for keys with the same
    /// meaning everywhere.
    pub(in crate::tui::app) fn answer(&mut self, key: Key, now: Duration) -> Option<Effect> {
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
                return Some(self.run_pending());
            }
            (Key::Enter, Unsaved::Reload) => {
                self.shell.mode = Mode::Normal;
                self.reload(true);
            }
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Runs the pending action after a key, once all edits are saved. Drops it if the user returned
    /// to unsaved edits.
    pub(in crate::tui::app) fn settle(&mut self, effect: Effect) -> Effect {
        if !self.shell.mode.is_normal() || self.pending.is_none() || self.document.storing {
            return effect;
        }
        if self.loses_edits() {
            self.pending = None;
            return effect;
        }
        self.run_pending()
    }

    fn run_pending(&mut self) -> Effect {
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
