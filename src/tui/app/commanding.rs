//! Lists all commands, filters the list and runs one.

use super::{App, Effect, Mode};
use crate::tui::commands::action::KeyContext;
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
            Key::Backspace if palette.typed().is_empty() => self.shell.mode = Mode::Normal,
            Key::Escape => self.shell.mode = Mode::Normal,
            Key::Up => palette.move_by(-1),
            Key::Down => palette.move_by(1),
            Key::PageUp => palette.move_by(-page),
            Key::PageDown => palette.move_by(page),
            Key::Home => palette.move_by(isize::MIN),
            Key::End => palette.move_by(isize::MAX),
            _ => match palette.line().change(key) {
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
        let (chosen, typed) = (palette.chosen(), palette.typed().to_owned());
        self.shell.mode = Mode::Normal;
        let row = match chosen {
            Some(Listed::Command(row)) => row,
            Some(Listed::Topic(at, _)) => {
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
