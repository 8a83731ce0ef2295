//! The help, and searching it.

use super::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::views::help::text::Help;

impl App {
    /// Shows the help, or takes it away.
    pub(super) fn toggle_help(&mut self) {
        self.shell.mode = match self.shell.mode {
            Mode::Help(_) => Mode::Normal,
            _ => Mode::Help(Help::default()),
        };
    }

    /// Keys of the line in which words are typed; `None` for those that mean the same everywhere.
    pub(super) fn search_help(&mut self, key: Key) -> Option<Effect> {
        let Mode::Help(help) = &mut self.shell.mode else {
            return None;
        };
        let line = help.typed()?;
        match key {
            Key::Backspace if line.text().is_empty() => {
                help.show_all();
            }
            Key::Enter => help.accept(),
            Key::Escape => {
                help.show_all();
            }
            _ if line.edit(key) => {}
            _ => return None,
        }
        help.scroll = 0;
        Some(Effect::Show)
    }
}
