//! Asking for the name of a file, and writing it.

use super::super::edited;
use super::super::key::Key;
use super::super::line::Line;
use super::super::writing::{Document, Prompt, Question};
use super::{App, Effect, Mode};
use std::path::PathBuf;

impl App {
    /// Keys that answer whether to write over a file; `None` for those that mean the same everywhere.
    pub(super) fn confirm_key(&mut self, key: Key) -> Option<Effect> {
        let Mode::Confirm(question) = &self.mode else {
            return None;
        };
        if key != Key::Enter {
            return None;
        }
        let question = question.clone();
        self.write(question);
        Some(Effect::Show)
    }

    /// The name of a file was typed; an old one is not written over unasked.
    pub(super) fn accept_file(&mut self, prompt: Prompt) {
        let to = PathBuf::from(prompt.name.text().trim());
        let document = prompt.document;
        if to.as_os_str().is_empty() {
            self.mode = Mode::Normal;
        } else if to.is_dir() {
            self.message = Some("that is a folder: add a name".into());
        } else if to.exists() {
            self.mode = Mode::Confirm(Question { document, to });
        } else {
            self.write(Question { document, to });
        }
    }

    /// Writes what was asked for. Where that cannot be, the line asks for another name: a text is not
    /// lost, and a name is mended rather than typed again.
    fn write(&mut self, question: Question) {
        self.mode = Mode::Normal;
        let Question { document, to } = question;
        let done = match &document {
            // Whoever named an old file was asked.
            Document::Scene => self.save(&to, true),
            Document::Text(text) => text.write(&to),
        };
        self.message = Some(match done {
            Ok(said) => said,
            Err(why) => {
                // No name would help an assembly that no start positions tell from the others.
                if edited::says_what_is_shown(&self.stage) || document != Document::Scene {
                    self.ask_for_file(document, &to.to_string_lossy());
                }
                why
            }
        });
    }

    /// Asks for the name of a file, with a proposal.
    pub(super) fn ask_for_file(&mut self, document: Document, proposal: &str) {
        let name = Line::for_file(proposal);
        self.mode = Mode::FileName(Prompt { document, name });
    }
}
