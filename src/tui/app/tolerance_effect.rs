//! Shows the effect of all tolerances on one quantity, in the view of lengths.

use super::super::views;
use super::{App, BackTarget, View};
use crate::quantity::Catalogue;
use crate::tui::views::lengths::tolerance_report;
use crate::wording::words;

impl App {
    /// Shows the effect of tolerances on the last found quantity, or on the first visible one; or
    /// returns to all quantities.
    pub(super) fn show_tolerance(&mut self) {
        if self.back_target() == BackTarget::Tolerance {
            return self.close_tolerance();
        }
        if self.player.open_scene.scene().tolerances().is_exact() {
            self.set_message(words().no_tolerances());
            return;
        }
        let first = self
            .found_line()
            .unwrap_or(self.views.scroll[View::Lengths as usize]);
        let lines = views::current_view_lines(self);
        let catalogue = Catalogue::new(self.player.open_scene.scene());
        let named = |line: &String| catalogue.find(line.split_whitespace().next()?);
        let quantity = lines.iter().skip(first).find_map(named);
        let text = match quantity {
            Some(quantity) => tolerance_report(&self.player.open_scene, quantity),
            None => Err(words().no_figure_in_line().into()),
        };
        match (text, self.views.lengths.get_mut()) {
            (Ok(text), Some(study)) => {
                study.told = Some(text);
                self.reset_lengths();
            }
            (Err(why), _) => self.set_message(why),
            (Ok(_), None) => {}
        }
    }

    /// Closes the tolerance page of one quantity.
    pub(super) fn close_tolerance(&mut self) {
        if let Some(study) = self.views.lengths.get_mut() {
            study.told = None;
            self.reset_lengths();
        }
    }

    /// Resets search and scrolling after the view's lines have changed.
    fn reset_lengths(&mut self) {
        self.views.found = None;
        self.views.scroll[View::Lengths as usize] = 0;
    }
}
