//! Switches to another assembly and records it in the scene's text.

use super::{App, Mode, View};
use crate::tui::commands::action::Action;
use crate::tui::player::assembly_list::AssemblyList;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Lists the assemblies next to the drawing and pauses playback.
    pub(super) fn list_assemblies(&mut self) {
        self.player.playback.pause();
        match AssemblyList::new(&self.player.open_scene) {
            Some(assemblies) => {
                self.shell.mode = Mode::Assemblies(Box::new(assemblies));
                self.look(View::Motion);
            }
            None => self.shell.say(words().no_other_assembly()),
        }
    }

    /// Switches to the assembly under the cursor.
    pub(super) fn take_assembly(&mut self, now: Duration) {
        let Mode::Assemblies(assemblies) = &self.shell.mode else {
            return;
        };
        let Some(row) = assemblies.list.chosen() else {
            return;
        };
        let (group, pick, wish) = (row.group, row.choice.pick, row.wish());
        if row.choice.is_current {
            self.shell.mode = Mode::Normal;
            return;
        }
        if !row.choice.closes {
            self.shell.say(words().rest_does_not_close(&wish));
            return;
        }
        match self.player.open_scene.switched(group, pick) {
            Ok(open_scene) => {
                self.player.open_scene = open_scene;
                self.views.study_run.forget();
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
