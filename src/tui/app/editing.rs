//! Editing the scene.

use super::super::action::{Action, SceneAction};
use super::App;

impl App {
    pub(super) fn edit(&mut self, _action: SceneAction) {
        self.message = Some("not there yet".into());
    }

    pub(super) fn edit_history(&mut self, _action: Action) {
        self.message = Some("not there yet".into());
    }
}
