//! Asks for file names and for permission to write.

use crate::files::{directories, foreign_extension, from_home};
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::document::saving::Leave;
use crate::tui::document::writing::{Prompt, SavedContent};
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Handles the key that permits a write. Returns `None` for keys with the same meaning
    /// everywhere.
    pub(in crate::tui::app) fn confirm_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let Mode::Confirm(question) = &self.shell.mode else {
            return None;
        };
        if key != Key::Enter {
            return None;
        }
        let question = question.clone();
        if !self.shell.can_be_answered(now) {
            return Some(Effect::Show);
        }
        self.shell.mode = Mode::Normal;
        let leave = question.granted();
        self.store(question.content, question.to, leave);
        Some(Effect::Show)
    }

    /// Writes to the typed file, without permission to overwrite an existing one.
    pub(in crate::tui::app) fn accept_file(&mut self, prompt: Prompt) {
        let typed = prompt.name.text().trim();
        let to = from_home(typed, directories::environment);
        if let Some(extension) = foreign_extension(&to) {
            self.set_message(words().is_no_text_file(&extension));
            self.shell.mode = Mode::FileName(prompt);
            return;
        }
        self.shell.mode = Mode::Normal;
        if !typed.is_empty() {
            self.store(prompt.content, to, Leave::default());
        }
    }

    /// Asks for a file name, with a proposal.
    pub(in crate::tui::app) fn prompt_for_file(&mut self, content: SavedContent, proposal: &str) {
        let name = EditLine::for_file(proposal);
        self.shell.mode = Mode::FileName(Prompt { content, name });
    }
}
