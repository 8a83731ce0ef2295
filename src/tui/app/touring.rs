//! The tour.

use super::super::key::Key;
use super::super::tour::SCREENS;
use super::{App, Effect, Mode};

impl App {
    /// Begins the tour.
    pub(in crate::tui) fn tour(&mut self) {
        self.mode = Mode::Tour(0);
    }

    /// Keys that lead through the tour; `None` for all others.
    pub(super) fn turn_page(&mut self, key: Key) -> Option<Effect> {
        let Mode::Tour(number) = self.mode else {
            return None;
        };
        self.mode = match key {
            Key::Enter | Key::Right | Key::Char(' ') if number + 1 < SCREENS => {
                Mode::Tour(number + 1)
            }
            Key::Enter | Key::Right | Key::Char(' ') => Mode::Normal,
            Key::Left | Key::Backspace => Mode::Tour(number.saturating_sub(1)),
            _ => return None,
        };
        self.message = None;
        Some(Effect::Show)
    }
}
