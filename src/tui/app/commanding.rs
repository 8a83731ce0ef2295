//! Lists all commands, filters the list and runs one.

use super::{App, Effect, Mode};
use crate::tui::commands::action::{KeyContext, entry_of};
use crate::tui::commands::key::Key;
use crate::tui::views::help::text::Help;
use crate::tui::views::palette::list::{CommandList, Listed};
use std::time::Duration;

impl App {
    /// Opens the list of commands.
    pub(super) fn list_commands(&mut self) {
        self.shell.mode = Mode::Palette(CommandList::new());
    }

    /// Handles a key of the list. Returns `None` for keys with the same meaning everywhere.
    pub(super) fn palette_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        let page = self.page();
        let Mode::Palette(palette) = &mut self.shell.mode else {
            return None;
        };
        match key {
            Key::Enter => return Some(self.command(now)),
            Key::Backspace if palette.line.text().is_empty() => self.shell.mode = Mode::Normal,
            Key::Escape => self.shell.mode = Mode::Normal,
            _ if let Some(rows) = key.rows(page) => palette.list.move_by(rows),
            _ => match palette.line.change(key) {
                Some(true) => palette.narrow(),
                None if matches!(key, Key::Ctrl(_)) => return None,
                Some(false) | None => {}
            },
        }
        self.shell.message = None;
        Some(Effect::Show)
    }

    /// Runs the command under the cursor in its own view, or opens the topic under the cursor.
    fn command(&mut self, now: Duration) -> Effect {
        let Mode::Palette(palette) = &self.shell.mode else {
            return Effect::Show;
        };
        let (chosen, typed) = (
            palette.list.chosen().copied(),
            palette.line.text().to_owned(),
        );
        self.shell.mode = Mode::Normal;
        let row = match chosen {
            Some(Listed::Command(action)) => entry_of(action),
            Some(Listed::Topic(at)) => {
                let columns = self.shell.size.width;
                let help = Help::telling(at, &typed, columns, &self.shell.keymap);
                self.shell.mode = Mode::Help(help);
                return Effect::Show;
            }
            None => return Effect::Show,
        };
        if let KeyContext::In(view) = row.place {
            self.look(view);
        }
        self.update(row.action, now)
    }
}
