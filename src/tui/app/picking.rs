//! Choosing a preset or a file.

use super::App;

impl App {
    pub(super) fn pick(&mut self) {
        self.message = Some("not there yet".into());
    }
}
