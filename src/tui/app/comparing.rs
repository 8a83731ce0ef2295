//! Comparing with another scene.

use super::App;

impl App {
    pub(super) fn compare(&mut self) {
        self.message = Some("not there yet".into());
    }
}
