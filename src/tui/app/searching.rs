//! Finding rows by name.

use super::super::action::TablesAction;
use super::App;

impl App {
    pub(super) fn search(&mut self) {
        if self.view == super::View::Scene {
            self.search_values();
            return;
        }
        self.message = Some("not there yet".into());
    }

    pub(super) fn browse(&mut self, _action: TablesAction) {
        self.message = Some("not there yet".into());
    }
}
