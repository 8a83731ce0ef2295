//! In place of the line that tells how far a command has come, where krank knows no terminal.

use super::screen::TextScreen;

/// How far a command has come: told to nobody.
pub(super) struct Progress;

impl Progress {
    pub(super) fn new(_: u64, _: &'static str, _: TextScreen, _: bool) -> Progress {
        Progress
    }

    pub(super) fn stoppable(self) -> Progress {
        self
    }

    pub(super) fn is_stopped(&self) -> bool {
        false
    }

    pub(super) fn show_best(&mut self, _: String) {}

    pub(super) fn tell(&mut self, _: u64) {}

    pub(super) fn end(self) {}

    pub(super) fn clear(&self) {}
}
