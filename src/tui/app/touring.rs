//! The tour.

use super::App;

impl App {
    pub(super) fn tour(&mut self) {
        self.message = Some("not there yet".into());
    }
}
