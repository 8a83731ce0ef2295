//! Chooses the plotted columns and the x axis.

use super::super::views::max_scroll;
use super::{App, Effect, Mode, View};
use crate::tui::commands::action::PlotsAction;
use crate::tui::commands::key::Key;
use crate::tui::views::plots::list::PlotList;
use crate::wording::words;

impl App {
    pub(super) fn plot(&mut self, action: PlotsAction) {
        match action {
            PlotsAction::Choose => {
                let (scene, solver) = (self.open_scene().scene(), self.open_scene().solver());
                let list = PlotList::new(scene, solver, |name| self.views.plots.is_chosen(name));
                self.shell.mode = Mode::PlotList(list);
            }
            PlotsAction::Abscissa => {
                let along = self
                    .views
                    .plots
                    .next_abscissa(self.player.open_scene.scene());
                self.set_message(along);
            }
            PlotsAction::Extrema => {
                let marked = self.views.plots.toggle_extrema();
                self.set_message(match marked {
                    true => words().extrema_marked(),
                    false => words().extrema_not_marked(),
                });
            }
            PlotsAction::Band => {
                let is_exact = self.player.open_scene.scene().tolerances().is_exact();
                let text = if is_exact {
                    words().no_tolerances()
                } else if self.views.plots.toggle_band() {
                    words().band_drawn()
                } else {
                    words().band_not_drawn()
                };
                self.set_message(text);
            }
        }
        self.sample();
    }

    /// Updates the curves and the motor study while a view needs them. Costs nothing if they are up
    /// to date.
    pub(super) fn sample(&mut self) {
        let visible = self.visible_views();
        if visible.contains(&View::Plots) {
            self.follow();
            let compared = self.comparison.compared();
            self.views.plots.sample(&self.player.open_scene, compared);
            if let Mode::PlotList(list) = &self.shell.mode {
                self.views
                    .plots
                    .note(&self.player.open_scene, list.current());
            }
        }
        if visible.contains(&View::Motor) {
            self.views.motor.study(&self.player.open_scene);
        }
    }

    /// Handles a key of the list. Returns `None` for keys with the same meaning everywhere.
    pub(super) fn list_key(&mut self, key: Key) -> Option<Effect> {
        let (page, maximum) = (self.page(), max_scroll(self));
        let Mode::PlotList(list) = &mut self.shell.mode else {
            return None;
        };
        if list.read().is_some() {
            match key {
                _ if let Some(lines) = key.rows_or_letter(page) => list.scroll_by(lines, maximum),
                Key::Escape | Key::Char('o') => list.set_reading(false),
                _ => return None,
            }
            return Some(Effect::Show);
        }
        match key {
            _ if let Some(rows) = key.rows(page) => list.list.move_by(rows),
            Key::Escape => {
                if !list.end_search() {
                    self.shell.mode = Mode::Normal;
                }
            }
            Key::Enter if list.typing => list.typing = false,
            _ if let Some(is_new) = list.typed().and_then(|line| line.change(key)) => {
                if is_new {
                    list.narrow();
                }
            }
            Key::Char('/') => list.typing = true,
            _ if let Some(rows) = key.rows_or_letter(page) => list.list.move_by(rows),
            Key::Enter | Key::Char(' ') => self.toggle_plot(),
            Key::Char('o') => list.set_reading(true),
            Key::Char('c') => self.views.plots.clear(),
            Key::Char('x') => self.shell.mode = Mode::Normal,
            Key::Char('X') => self.plot(PlotsAction::Abscissa),
            _ => return None,
        }
        if !matches!(key, Key::Char('X')) {
            self.shell.message = None;
        }
        self.sample();
        Some(Effect::Show)
    }

    /// Adds the column under the cursor to the plot, or removes it.
    fn toggle_plot(&mut self) {
        if let Mode::PlotList(list) = &self.shell.mode
            && let Some(name) = list.current()
        {
            self.views
                .plots
                .toggle(name, self.player.open_scene.scene());
        }
    }
}
