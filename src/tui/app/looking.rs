//! What is seen: the view, how far it is scrolled, and with which characters and colours.

use super::super::views::{self, List, Need};
use super::{App, Mode, View};
use crate::capability::Colours;
use crate::drawing::Glyphs;
use crate::tui::views::accuracy::study_run::Phase;
use ratatui::layout::Size;

/// The height of a cell for its width in most fonts.
pub(super) const USUAL_ASPECT: f64 = 2.0;

impl App {
    pub(super) fn next_view(&mut self) {
        let views = View::ALL.iter().cycle();
        let next = views.skip_while(|view| **view != self.view).nth(1);
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
        self.view = view;
        self.open_scene.answer(false);
        self.open_scene.balance_forces(false);
        self.open_scene.explain(false);
        match view.pane().needs() {
            Need::Nothing => {}
            Need::Lengths => self.open_scene.answer(true),
            Need::Forces => self.open_scene.balance_forces(true),
            Need::Working => self.open_scene.explain(true),
            Need::Values => self.relist(),
            Need::Study if self.study_run.phase() == Phase::Idle => self.study(),
            Need::Study => {}
            Need::Curves | Need::Motor => self.sample(),
        }
    }

    /// Begins a study, goes on with it or repeats it.
    pub(super) fn study(&mut self) {
        self.study_run.go_on(self.open_scene.solver());
    }

    /// The screen has another size.
    pub(crate) fn resize(&mut self, size: Size, aspect: Option<f64>) {
        self.size = size;
        self.aspect = aspect.unwrap_or(USUAL_ASPECT);
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    pub(super) fn page(&self) -> isize {
        isize::try_from(views::page(self)).unwrap_or(isize::MAX)
    }

    /// Scrolls what is on top, within its limits.
    pub(super) fn scroll_by(&mut self, lines: isize) {
        let most = match self.mode {
            Mode::Assemblies(_) => self
                .open_scene
                .assembly_list()
                .map_or(0, |p| p.rows().len() - 1),
            _ => views::most_scroll(self),
        };
        let scroll = match &mut self.mode {
            Mode::Help(help) => &mut help.scroll,
            Mode::Assemblies(scroll) => scroll,
            _ => match self.view.pane().list() {
                List::Lines => &mut self.scroll[self.view as usize],
                List::Figures => {
                    return self.place_cursor(|cursor, table| cursor.moved(table, lines));
                }
                List::Values => return self.editor.move_by(lines),
            },
        };
        *scroll = scroll.saturating_add_signed(lines).min(most);
    }

    pub(super) fn next_glyphs(&mut self) {
        let (glyphs, name) = match self.capability.glyphs {
            Glyphs::Ascii => (Glyphs::Line, "lines"),
            Glyphs::Line => (Glyphs::Braille, "Braille"),
            Glyphs::Braille => (Glyphs::Ascii, "ASCII"),
        };
        self.capability.glyphs = glyphs;
        self.message = Some(format!("drawn with {name}"));
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }

    pub(super) fn next_colours(&mut self) {
        let colours = self.capability.colours.next();
        self.capability.colours = colours;
        self.message = Some(match colours {
            Colours::None => "no colours".into(),
            Colours::Sixteen => "the 16 colours of the terminal's palette".into(),
            Colours::Indexed => "colours of the 256".into(),
            Colours::True => "colours of 24 bits".into(),
        });
    }
}
