//! Questions whose answer can lose something: no key answers one that was typed before it could be read.

use super::{App, Mode};
use std::time::Duration;

/// Who has not seen a question for so long has typed for something else.
const REACTION: Duration = Duration::from_millis(300);

impl App {
    /// What is asked is on the screen, if anything is.
    pub(crate) fn show_question(&mut self, now: Duration) {
        if let Mode::Recovery(_) | Mode::Confirm(_) | Mode::Unsaved(_) = self.mode {
            self.seen.get_or_insert(now);
        }
    }

    /// Whether a key that comes now can be meant for what is asked. Who leaves knows what is asked then, and
    /// need not read it.
    pub(super) fn can_be_answered(&self, now: Duration) -> bool {
        let reading = match self.mode {
            Mode::Unsaved(_) => Duration::ZERO,
            _ => REACTION,
        };
        self.seen.is_some_and(|seen| now >= seen + reading)
    }
}
