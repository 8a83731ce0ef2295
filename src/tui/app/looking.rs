//! What is seen: the view, how far it is scrolled.

use super::super::views::{self, Listing, Need};
use super::{App, Mode, View};
use crate::tui::views::accuracy::study_run::Phase;
use ratatui::layout::Size;
use std::time::Duration;

impl App {
    pub(super) fn next_view(&mut self) {
        let views = View::ALL.iter().cycle();
        let next = views.skip_while(|view| **view != self.shell.view).nth(1);
        self.look(next.copied().unwrap_or_default());
    }

    /// Its key was pressed: a study goes on, or is repeated.
    pub(super) fn look_at(&mut self, view: View) {
        self.look(view);
        if view.pane().needs() == Need::Study {
            self.study();
        }
    }

    /// Looks at a view. What it needs is found while it is looked at, and only then; a study begins when it is
    /// looked at for the first time.
    pub(crate) fn look(&mut self, view: View) {
        self.shell.view = view;
        self.player.open_scene.answer(false);
        self.player.open_scene.balance_forces(false);
        self.player.open_scene.explain(false);
        match view.pane().needs() {
            Need::Nothing => {}
            Need::Lengths => self.player.open_scene.answer(true),
            Need::Forces => self.player.open_scene.balance_forces(true),
            Need::Working => self.player.open_scene.explain(true),
            Need::Values => self.relist(),
            Need::Study if self.study_run.phase() == Phase::Idle => self.study(),
            Need::Study => {}
            Need::Curves | Need::Motor => self.sample(),
        }
    }

    /// Begins a study, goes on with it or repeats it.
    pub(super) fn study(&mut self) {
        self.study_run.go_on(self.player.open_scene.solver());
    }

    /// The screen has another size.
    pub(crate) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.shell.resize(size, aspect);
        self.lay_out();
    }

    /// What is shown takes another room: the cursor and what is scrolled stay within it.
    pub(super) fn lay_out(&mut self) {
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    /// What is asked is on the screen, if anything is.
    pub(crate) fn be_seen(&mut self, now: Duration) {
        self.shell.show_question(now);
        self.shell.show_message(now);
    }

    pub(super) fn page(&self) -> isize {
        isize::try_from(views::page(self)).unwrap_or(isize::MAX)
    }

    /// Scrolls what is on top, within its limits.
    pub(super) fn scroll_by(&mut self, lines: isize) {
        self.lay_out_help();
        let most = match self.shell.mode {
            Mode::Assemblies(_) => self
                .player
                .open_scene
                .assembly_list()
                .map_or(0, |p| p.rows().len() - 1),
            _ => views::most_scroll(self),
        };
        let scroll = match &mut self.shell.mode {
            Mode::Help(help) => &mut help.scroll,
            Mode::Assemblies(scroll) => scroll,
            _ => match self.shell.view.pane().list() {
                Listing::Lines => &mut self.shell.scroll[self.shell.view as usize],
                Listing::Figures => {
                    return self.place_cursor(|cursor, table| cursor.moved(table, lines));
                }
                Listing::Values => return self.document.editor.move_by(lines),
            },
        };
        *scroll = scroll.saturating_add_signed(lines).min(most);
    }
}
