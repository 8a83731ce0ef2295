//! Opens the help, turns its pages and searches it.

use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::views::help::text::Help;

impl App {
    /// Opens or closes the help.
    pub(in crate::tui::app) fn toggle_help(&mut self) {
        self.shell.mode = match self.shell.mode {
            Mode::Help(_) => self.below(),
            Mode::Candidates => Mode::Help(Help::over_candidates()),
            _ => Mode::Help(Help::default()),
        };
    }

    /// Returns the mode to restore when an overlay closes.
    pub(in crate::tui::app) fn below(&self) -> Mode {
        match &self.shell.mode {
            Mode::Help(help) if help.returns_to_candidates => Mode::Candidates,
            _ => Mode::Normal,
        }
    }

    /// Wraps the shown topic to the screen's width.
    pub(in crate::tui::app) fn relayout_help(&mut self) {
        if let Mode::Help(help) = &mut self.shell.mode {
            help.layout_topic(self.shell.size.width, &self.shell.keymap);
        }
    }

    /// Handles a key of the search line. Returns `None` for keys with the same meaning everywhere.
    pub(in crate::tui::app) fn handle_search_key(&mut self, key: Key) -> Option<Effect> {
        let (columns, keymap) = (self.shell.size.width, &self.shell.keymap);
        let Mode::Help(help) = &mut self.shell.mode else {
            return None;
        };
        let is_topic = help.topic().is_some();
        let line = help.typed()?;
        self.shell.message = None;
        match key {
            Key::Backspace if line.text().is_empty() => help.end_search_view(),
            Key::Escape => help.end_search_view(),
            Key::Enter if is_topic && line.text().trim().is_empty() => help.end_search_view(),
            Key::Enter if is_topic => help.seek(true, columns, keymap),
            Key::Enter => {
                help.accept();
                help.scroll = 0;
            }
            _ => match line.change(key) {
                None => {
                    help.stay();
                    return None;
                }
                Some(false) => {}
                Some(true) if is_topic => help.seek(false, columns, keymap),
                Some(true) => help.scroll = 0,
            },
        }
        Some(Effect::Show)
    }
}
