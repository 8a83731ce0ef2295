//! Switches to another assembly and records it in the scene's text.

use super::{App, Mode, View};
use crate::tui::commands::action::Action;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Lists the assemblies next to the drawing and pauses playback.
    pub(super) fn list_assemblies(&mut self) {
        self.player.playback.pause();
        match self.player.open_scene.compute_assemblies() {
            Some(assembly_list) => {
                self.shell.mode = Mode::Assemblies(assembly_list.first());
                self.look(View::Motion);
            }
            None => self.shell.say(words().no_other_assembly()),
        }
    }

    /// Switches to the assembly under the cursor.
    pub(super) fn take_assembly(&mut self, cursor: usize, now: Duration) {
        let Some(row) = self
            .player
            .open_scene
            .assembly_list()
            .and_then(|p| p.rows().get(cursor))
        else {
            return;
        };
        let (group, choice, wish) = (row.group, &row.choice, row.wish());
        if choice.is_current {
            self.shell.mode = Mode::Normal;
            return;
        }
        if !choice.closes {
            self.shell.say(words().rest_does_not_close(&wish));
            return;
        }
        match self.player.open_scene.switched(group, choice.pick) {
            Ok(open_scene) => {
                self.player.open_scene = open_scene;
                self.study_run.forget();
                self.look(self.shell.view);
                self.shell.mode = Mode::Normal;
                self.player.rebase(now);
                let is_told = self.record_assembly(&wish);
                self.shell.say(match self.shell.keymap.key(Action::Save) {
                    _ if !is_told => words().assembly_now_untold(&wish),
                    Some(key) => words().assembly_now_saved_by(&wish, &key),
                    None => words().assembly_now(&wish),
                });
            }
            Err(why) => self.shell.say(format!("{wish}: {why}")),
        }
    }
}
