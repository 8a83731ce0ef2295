//! Replaces the open scene by another one, or by an edited form of the same one.

use crate::tui::OpenedScene;
use crate::tui::app::shell::SceneBefore;
use crate::tui::app::{App, Mode};
use crate::tui::document::opening;
use crate::tui::player::Player;
use crate::tui::player::open_scene::OpenScene;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Opens the preset at a distance from the current one in the list of presets.
    pub(in crate::tui::app) fn open(&mut self, distance: isize) {
        let Some(preset) = self.player.open_scene.preset_at(distance) else {
            self.set_message(words().no_presets());
            return;
        };
        match opening::preset(preset) {
            Ok(opened) => self.show(opened),
            Err(message) => self.set_message(message),
        }
    }

    /// Shows another scene, paused at its initial coordinate, and resets all state of the previous
    /// one.
    pub(in crate::tui::app) fn show_now(&mut self, opened: OpenedScene) {
        self.end_comparison();
        self.end_drag();
        self.document.open(&opened.scene);
        self.player = Player::new(opened);
        self.shell.before = None;
        self.scenes += 1;
        self.views.open();
        self.select_view(self.shell.view);
        self.report_lead();
        self.meet();
    }

    /// Replaces the scene by an edited form of it. The driver keeps its coordinate as far as the
    /// new scene can reach it; view and selections stay.
    pub(crate) fn exchange(&mut self, opened: OpenedScene, now: Duration) {
        let before = self.player.open_scene.scene();
        self.views.followed = self.views.followed.moved(before, &opened.scene);
        self.views.viewport.lens.move_to(before, &opened.scene);
        if let Mode::PlotList(list) = &mut self.shell.mode {
            let plots = &self.views.plots;
            list.move_to(&opened.scene, &opened.solver, |name| plots.is_chosen(name));
        }
        self.shell.before = Some(SceneBefore {
            open_scene: self.player.exchange(OpenScene::new(opened), now),
            is_past: false,
        });
        self.views.study_run.forget();
        self.select_view(self.shell.view);
        self.clamp_positions();
    }
}
