//! Selects the view, arranges the panes and scrolls them.

use super::super::views::{self, Listing};
use super::{App, Mode, View};
use crate::report::PositionMethod;
use crate::tui::commands::action::Action;
use crate::tui::commands::line::EditLine;
use crate::tui::commands::list::moved;
use crate::tui::views::accuracy::study_run::Phase;
use crate::wording::words;
use ratatui::layout::Size;
use std::time::Duration;

impl App {
    /// Selects the view `places` tabs ahead, cyclically.
    pub(super) fn turn_view(&mut self, places: usize) {
        let here = View::ALL.iter().position(|view| *view == self.shell.view);
        let there = (here.unwrap_or(0) + places) % View::ALL.len();
        self.select_view_from_tabs(View::ALL[there]);
    }

    /// Selects a view by its key, which also continues or repeats a study.
    pub(super) fn select_view_by_key(&mut self, view: View) {
        self.select_view_from_tabs(view);
        if view == View::Accuracy {
            self.study();
        }
    }

    /// Selects a view and reports why it is empty, if it is.
    fn select_view_from_tabs(&mut self, view: View) {
        self.select_view(view);
        // While a point leads, an empty view itself says why.
        if let Some(why) = view.pane().nothing(self) {
            self.set_message(why);
        }
    }

    /// Selects a view, in its pane or in one assigned to it.
    pub(crate) fn select_view(&mut self, view: View) {
        let (before, size) = (self.shell.view, self.shell.size);
        self.shell.composition.show_view(view, before, size);
        self.shell.view = view;
        if view != before {
            self.views.found = None;
            self.views.searched = None;
        }
        self.update_needs();
    }

    /// Computes the data for the visible views, and only that. A study starts when its view is first
    /// visible.
    pub(super) fn update_needs(&mut self) {
        self.refresh();
        self.relist();
        let studies = self.visible_views().contains(&View::Accuracy);
        if studies && self.views.study_run.phase() == Phase::Idle {
            self.study();
        }
        self.sample();
    }

    /// Brings the results of the visible views to the driver's position.
    pub(super) fn refresh(&mut self) {
        let visible = self.visible_views();
        self.views.refresh(&visible, &mut self.player.open_scene);
    }

    // ---- panes

    /// Selects the next pane.
    pub(super) fn next_pane(&mut self) {
        let (view, size) = (self.shell.view, self.shell.size);
        match self.shell.composition.next_pane(view, size) {
            Some(next) => self.select_view(next),
            None => self.set_message(words().no_other_pane()),
        }
    }

    /// Maximizes the current pane, or restores the others.
    pub(super) fn toggle_alone(&mut self) {
        let (view, size) = (self.shell.view, self.shell.size);
        if !self.shell.composition.toggle_alone(view, size) {
            self.set_message(words().no_other_pane());
        }
        self.rearrange();
    }

    /// Moves the border next to the drawing by a number of steps.
    pub(super) fn move_split(&mut self, steps: i8) {
        let is_split = self.visible_views().contains(&View::Motion);
        if !(is_split && self.shell.composition.move_split(steps)) {
            self.set_message(words().no_split_here());
        }
        self.rearrange();
    }

    /// Switches to the next layout.
    pub(super) fn next_layout(&mut self) {
        let name = self.shell.composition.next_layout().name();
        self.set_message(words().layout_is(name));
        self.rearrange();
    }

    /// Updates everything that depends on the arrangement of the panes.
    pub(super) fn rearrange(&mut self) {
        let (view, size) = (self.shell.view, self.shell.size);
        self.shell.composition.keep(view, size);
        self.update_needs();
        self.clamp_positions();
    }

    /// Watches the next method on the current state. After the last one, the study is shown again.
    pub(super) fn watch_next(&mut self) {
        let all = PositionMethod::WATCHED;
        let here = all
            .iter()
            .position(|method| Some(*method) == self.views.method.method);
        self.watch_method(all.get(here.map_or(0, |index| index + 1)).copied());
        if let Some(why) = View::Accuracy.pane_in(self).nothing(self) {
            self.set_message(why);
        }
    }

    /// Watches a method, or returns to the study if `None`.
    pub(super) fn watch_method(&mut self, method: Option<PositionMethod>) {
        self.views.method.select(method);
        self.views.found = None;
        self.views.scroll[View::Accuracy as usize] = 0;
        self.update_needs();
    }

    /// Asks for the initial guess of the watched method.
    pub(super) fn prompt_for_guess(&mut self) {
        let watch = &self.views.method;
        match watch.method {
            _ if watch.watched().is_none() => {
                let method = self.shell.keymap.key_label(Action::Method);
                self.set_message(words().no_method_watched(&method));
            }
            Some(method) if method.takes_guess() => {
                self.shell.mode = Mode::Guess(EditLine::for_guess(&watch.guess));
            }
            _ => self.set_message(words().begins_at_no_guess()),
        }
    }

    /// Applies the typed guess, or keeps the line for correction.
    pub(super) fn accept_guess(&mut self, guess: &str) {
        match self.views.method.set_guess(guess, &self.player.open_scene) {
            Ok(()) => {
                self.views.found = None;
                self.shell.mode = Mode::Normal;
            }
            Err(why) => self.set_message(why),
        }
    }

    /// Returns `true` if the current view shows a watched method.
    pub(crate) fn is_watching(&self) -> bool {
        self.views.method.method.is_some() && self.shell.view == View::Accuracy
    }

    /// Starts, continues or repeats a study.
    pub(super) fn study(&mut self) {
        self.views
            .study_run
            .start_or_resume(self.player.open_scene.solver());
    }

    /// Adapts to a new screen size.
    pub(crate) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.shell.resize(size, aspect);
        self.rearrange();
    }

    /// Keeps the cursor and the scroll positions in range after a change of layout.
    pub(super) fn clamp_positions(&mut self) {
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    /// Records that a frame has shown the current prompt and message.
    pub(crate) fn note_frame_shown(&mut self, now: Duration) {
        if views::fits_text(self.shell.size) {
            self.shell.show_question(now);
            self.shell.show_message(now);
        }
    }

    pub(super) fn page(&self) -> isize {
        isize::try_from(views::page(self)).unwrap_or(isize::MAX)
    }

    /// Moves to the next or previous part of the current view, or reports that there is none.
    pub(super) fn go_to_part(&mut self, forward: bool) {
        match self.shell.view.pane_in(self).list() {
            Listing::Values => self.document.editor.go_to_part(forward),
            Listing::Figures => self.place_cursor(|cursor, table| cursor.in_part(table, forward)),
            Listing::Lines => {
                let parts = views::current_part_starts(self);
                let here = self.views.scroll[self.shell.view as usize];
                let next = match forward {
                    true => parts.into_iter().find(|line| *line > here),
                    false => parts.into_iter().rfind(|line| *line < here),
                };
                let maximum = views::max_scroll(self);
                match next.filter(|line| !forward || (*line <= maximum || here < maximum)) {
                    Some(line) => self.views.scroll[self.shell.view as usize] = line.min(maximum),
                    None => self.set_message(words().no_further_part()),
                }
            }
        }
    }

    /// Scrolls the topmost list or text, within its limits.
    pub(super) fn scroll_by(&mut self, lines: isize) {
        self.relayout_help();
        let maximum = views::max_scroll(self);
        let scroll = match &mut self.shell.mode {
            Mode::Help(help) => &mut help.scroll,
            Mode::Assemblies(assemblies) => return assemblies.list.move_by(lines),
            _ => match self.shell.view.pane_in(self).list() {
                Listing::Lines => &mut self.views.scroll[self.shell.view as usize],
                Listing::Figures => {
                    return self.place_cursor(|cursor, table| cursor.moved(table, lines));
                }
                Listing::Values => return self.document.editor.move_by(lines),
            },
        };
        *scroll = moved(*scroll, lines, maximum + 1);
    }
}
