//! Starts the tour and turns its pages.

use crate::files::directories;
use crate::tui::app::{App, Effect, Mode};
use crate::tui::commands::key::Key;
use crate::tui::views;
use crate::tui::views::tour::screens::{SCREENS, TourPage, is_first_start};

impl App {
    /// Starts the tour.
    pub(in crate::tui::app) fn tour(&mut self) {
        self.shell.mode = Mode::Tour(TourPage::default());
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
        let Mode::Tour(page) = self.shell.mode else {
            return None;
        };
        let parts = |screen| views::tour_parts(self, screen);
        self.shell.mode = match key {
            Key::Enter | Key::Right | Key::Char(' ') if page.part + 1 < parts(page.screen) => {
                let part = page.part + 1;
                Mode::Tour(TourPage { part, ..page })
            }
            Key::Enter | Key::Right | Key::Char(' ') if page.screen + 1 < SCREENS => {
                let screen = page.screen + 1;
                Mode::Tour(TourPage { screen, part: 0 })
            }
            Key::Enter | Key::Right | Key::Char(' ') => Mode::Normal,
            Key::Left | Key::Backspace if page.part > 0 => {
                // A larger terminal has fewer parts.
                let part = page.part.min(parts(page.screen)) - 1;
                Mode::Tour(TourPage { part, ..page })
            }
            Key::Left | Key::Backspace if page.screen > 0 => {
                let screen = page.screen - 1;
                let part = parts(screen) - 1;
                Mode::Tour(TourPage { screen, part })
            }
            Key::Left | Key::Backspace => Mode::Tour(page),
            _ => return None,
        };
        self.shell.message = None;
        Some(Effect::Show)
    }
}
