//! What is plotted.

use super::super::action::PlotsAction;
use super::App;

impl App {
    pub(super) fn plot(&mut self, _action: PlotsAction) {
        self.message = Some("not there yet".into());
    }
}
