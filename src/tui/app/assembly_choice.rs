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
        self.take_by_hand();
        match AssemblyList::new(&self.player.open_scene) {
            Some(assemblies) => {
                self.shell.mode = Mode::Assemblies(Box::new(assemblies));
                self.select_view(View::Motion);
            }
            None => self.set_message(words().no_other_assembly()),
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
        let (group, choice, request) = (row.group, row.choice.pick, row.option_text());
        if row.choice.is_current {
            self.shell.mode = Mode::Normal;
            return;
        }
        if !row.choice.closes {
            self.set_message(words().rest_does_not_close(&request));
            return;
        }
        match self.player.open_scene.switched(group, choice) {
            Ok(open_scene) => {
                self.player.open_scene = open_scene;
                self.views.study_run.forget();
                self.select_view(self.shell.view);
                self.shell.mode = Mode::Normal;
                self.player.rebase(now);
                let is_shown = self.record_assembly(&request);
                self.set_message(match self.shell.keymap.key(Action::Save) {
                    _ if !is_shown => words().assembly_now_untold(&request),
                    Some(key) => words().assembly_now_saved_by(&request, &key),
                    None => words().assembly_now(&request),
                });
            }
            Err(why) => self.set_message(format!("{request}: {why}")),
        }
    }
}
