//! Shows the effect of all tolerances on one quantity, in the view of lengths.

use super::super::views;
use super::{App, BackTarget, View};
use crate::quantity::Catalogue;
use crate::tui::views::lengths::tolerance_report;
use crate::wording::words;

impl App {
    /// Shows the effect of tolerances on the last found quantity, or on the first visible one; or
    /// returns to all quantities.
    pub(super) fn tell_tolerance(&mut self) {
        if self.back_target() == BackTarget::Tolerance {
            return self.leave_tolerance();
        }
        if self.player.open_scene.scene().tolerances().is_exact() {
            self.shell.say(words().no_tolerances());
            return;
        }
        let first = self
            .found_line()
            .unwrap_or(self.views.scroll[View::Lengths as usize]);
        let lines = views::lines_looked_at(self);
        let catalogue = Catalogue::new(self.player.open_scene.scene());
        let named = |line: &String| catalogue.find(line.split_whitespace().next()?);
        let figure = lines.iter().skip(first).find_map(named);
        let told = match figure {
            Some(figure) => tolerance_report(&self.player.open_scene, figure),
            None => Err(words().no_figure_in_line().into()),
        };
        match (told, self.views.lengths.get_mut()) {
            (Ok(told), Some(study)) => {
                study.told = Some(told);
                self.begin_lengths_anew();
            }
            (Err(why), _) => self.shell.say(why),
            (Ok(_), None) => {}
        }
    }

    /// Closes the tolerance page of one quantity.
    pub(super) fn leave_tolerance(&mut self) {
        if let Some(study) = self.views.lengths.get_mut() {
            study.told = None;
            self.begin_lengths_anew();
        }
    }

    /// Resets search and scrolling after the view's lines have changed.
    fn begin_lengths_anew(&mut self) {
        self.views.found = None;
        self.views.scroll[View::Lengths as usize] = 0;
    }
}
