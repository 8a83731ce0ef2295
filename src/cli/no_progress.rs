//! A stub of the progress line for builds without terminal support.

use crate::cli::screen::TextScreen;

/// The progress of a command, which is never shown.
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

    pub(super) fn report_progress(&mut self, _: u64) {}

    pub(super) fn end(self) {}

    pub(super) fn clear(&self) {}
}
