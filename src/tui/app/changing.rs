//! Another scene, or the same one in another form.

use super::shell::SceneBefore;
use super::{App, Mode, View};
use crate::tui::Opened;
use crate::tui::document::opening;
use crate::tui::figures::cursor::Cursor;
use crate::tui::player::Player;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::motion::followed::FollowedPoints;
use crate::tui::views::plots::curves::Plots;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Opens the preset that is so far from the present one.
    pub(super) fn open(&mut self, distance: isize) {
        let Some(preset) = self.player.open_scene.preset_at(distance) else {
            self.shell.say(words().no_presets());
            return;
        };
        match opening::preset(preset) {
            Ok(opened) => self.show(opened),
            Err(message) => self.shell.say(message),
        }
    }

    /// Another scene, paused where it opens: nothing is left of the one before.
    pub(super) fn show_now(&mut self, opened: Opened) {
        self.end_comparison();
        self.let_go();
        self.document.open(&opened.scene);
        self.player = Player::new(opened);
        self.shell.before = None;
        self.scenes += 1;
        self.study_run.forget();
        self.plots = Plots::default();
        self.look(self.shell.view);
        self.shell.scroll = [0; View::ALL.len()];
        self.followed = FollowedPoints::default();
        self.viewport.lens.reset();
        self.cursor = Cursor::default();
        self.meet();
    }

    /// The same scene in another form: the driver stands where it stood, as far as it can be
    /// there, and what is looked at and chosen stays.
    pub(crate) fn exchange(&mut self, opened: Opened, now: Duration) {
        let before = self.player.open_scene.scene();
        self.followed = self.followed.moved(before, &opened.scene);
        self.viewport.lens.move_to(before, &opened.scene);
        if let Mode::PlotList(list) = &mut self.shell.mode {
            let plots = &self.plots;
            list.move_to(&opened.scene, &opened.solver, |name| plots.is_chosen(name));
        }
        self.shell.before = Some(SceneBefore {
            open_scene: self.player.exchange(OpenScene::new(opened), now),
            is_past: false,
        });
        self.study_run.forget();
        self.look(self.shell.view);
        self.lay_out();
    }
}
