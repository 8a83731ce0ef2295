//! What the motion view shows, and how large.

use super::super::action::MotionAction;
use super::App;

impl App {
    pub(super) fn move_lens(&mut self, _action: MotionAction) {
        self.message = Some("not there yet".into());
    }
}
