//! Taking figures and pictures out of the workbench.

use super::super::action::Action;
use super::App;

impl App {
    pub(super) fn take_out(&mut self, _action: Action) {
        self.message = Some("not there yet".into());
    }
}
