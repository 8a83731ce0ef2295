//! Starts the tour and turns its pages.

use crate::files::directories;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::views::tour::screens::{SCREENS, is_first_start};

impl App {
    /// Starts the tour.
    pub(in crate::tui::app) fn tour(&mut self) {
        self.shell.mode = Mode::Tour(0);
    }

    /// Starts the tour if the state folder shows no earlier start of krank.
    pub(in crate::tui) fn tour_on_first_start(&mut self) {
        self.clerk.submit(|| {
            let is_first = is_first_start(directories::environment);
            Box::new(move |app, _| {
                if is_first && app.shell.mode.is_normal() {
                    app.tour();
                }
            })
        });
        self.drain_results(self.now);
    }

    /// Handles the keys that turn the tour's pages. Returns `None` for all others.
    pub(in crate::tui::app) fn turn_page(&mut self, key: Key) -> Option<Effect> {
        let Mode::Tour(number) = self.shell.mode else {
            return None;
        };
        self.shell.mode = match key {
            Key::Enter | Key::Right | Key::Char(' ') if number + 1 < SCREENS => {
                Mode::Tour(number + 1)
            }
            Key::Enter | Key::Right | Key::Char(' ') => Mode::Normal,
            Key::Left | Key::Backspace => Mode::Tour(number.saturating_sub(1)),
            _ => return None,
        };
        self.shell.message = None;
        Some(Effect::Show)
    }
}
