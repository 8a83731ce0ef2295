//! Another scene, or the same one in another form.

use super::super::chosen::Chosen;
use super::super::cursor::Cursor;
use super::super::editor::Editor;
use super::super::playback::Playback;
use super::super::plots::Plots;
use super::super::stage::Stage;
use super::super::{Opened, opening};
use super::driving::steps_of;
use super::{App, View};
use std::time::Duration;

impl App {
    /// Opens the preset that is so far from the present one.
    pub(super) fn open(&mut self, distance: isize) {
        let Some(preset) = self.stage.preset_at(distance) else {
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
        self.stage = Stage::new(opened);
        self.opened += 1;
        self.scenes += 1;
        self.steps = steps_of(&self.stage);
        self.editor = Editor::new(self.stage.scene());
        self.playback = Playback::new();
        self.survey.forget();
        self.plots = Plots::default();
        self.look(self.view);
        self.scroll = [0; View::ALL.len()];
        self.chosen = Chosen::default();
        self.lens.fit();
        self.cursor = Cursor::default();
        self.meet();
    }

    /// The same scene in another form: the driver stands where it stood, as far as it can be
    /// there, and what is looked at and chosen stays.
    pub(crate) fn exchange(&mut self, opened: Opened, now: Duration) {
        let (at, turned) = (self.stage.at(), self.stage.course().turns());
        self.chosen = self.chosen.moved(self.stage.scene(), &opened.scene);
        self.stage = Stage::new(opened);
        // A file that was read again may have a slide for a driver where it had a link.
        if turned != self.stage.course().turns() {
            self.steps = steps_of(&self.stage);
        }
        self.opened += 1;
        self.survey.forget();
        self.look(self.view);
        self.arrive(self.stage.course().clamp(at), now);
        self.place_cursor(|cursor, _| cursor);
        self.scroll_by(0);
    }
}
