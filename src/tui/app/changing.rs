//! Another scene, or the same one in another form.

use super::driving::steps_of;
use super::{App, View};
use crate::tui::Opened;
use crate::tui::document::editor::Editor;
use crate::tui::document::opening;
use crate::tui::figures::cursor::Cursor;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::playback::Playback;
use crate::tui::views::motion::followed::FollowedPoints;
use crate::tui::views::plots::curves::Plots;
use std::time::Duration;

impl App {
    /// Opens the preset that is so far from the present one.
    pub(super) fn open(&mut self, distance: isize) {
        let Some(preset) = self.open_scene.preset_at(distance) else {
            self.message = Some("there are no presets".into());
            return;
        };
        match opening::preset(preset) {
            Ok(opened) => self.show(opened),
            Err(message) => self.message = Some(message),
        }
    }

    /// Another scene, paused where it opens: nothing is left of the one before.
    pub(super) fn show_now(&mut self, opened: Opened) {
        self.original = opened.scene.text().into();
        self.end_comparison();
        self.open_scene = OpenScene::new(opened);
        self.scenes += 1;
        self.steps = steps_of(&self.open_scene);
        self.editor = Editor::new(self.open_scene.scene());
        self.playback = Playback::new();
        self.study_run.forget();
        self.plots = Plots::default();
        self.look(self.view);
        self.scroll = [0; View::ALL.len()];
        self.followed = FollowedPoints::default();
        self.viewport.fit();
        self.cursor = Cursor::default();
        self.meet();
    }

    /// The same scene in another form: the driver stands where it stood, as far as it can be
    /// there, and what is looked at and chosen stays.
    pub(crate) fn exchange(&mut self, opened: Opened, now: Duration) {
        let (at, turned) = (self.open_scene.at(), self.open_scene.driver_range().turns());
        self.followed = self.followed.moved(self.open_scene.scene(), &opened.scene);
        self.open_scene = OpenScene::new(opened);
        // A file that was read again may have a slide for a driver where it had a link.
        if turned != self.open_scene.driver_range().turns() {
            self.steps = steps_of(&self.open_scene);
        }
        self.study_run.forget();
        self.look(self.view);
        self.arrive(self.open_scene.driver_range().clamp(at), now);
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }
}
