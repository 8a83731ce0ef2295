//! Choosing another assembly, and saving the one that is shown.

use super::super::action::Action;
use super::super::line::Line;
use super::super::{Origin, saving};
use super::{App, Mode, View};
use std::path::{Path, PathBuf};
use std::time::Duration;

impl App {
    /// Lists the assemblies beside the drawing, which stands still meanwhile.
    pub(super) fn list_assemblies(&mut self) {
        self.playback.pause();
        match self.stage.look_around() {
            Some(panel) => {
                self.mode = Mode::Assemblies(panel.first());
                self.view = View::Motion;
            }
            None => self.message = Some("there is no other assembly here".into()),
        }
    }

    /// Takes the assembly under the cursor.
    pub(super) fn take_assembly(&mut self, cursor: usize, now: Duration) {
        let Some(row) = self.stage.panel().and_then(|p| p.rows().get(cursor)) else {
            return;
        };
        let (group, choice, wish) = (row.group, &row.choice, row.wish());
        if choice.is_current {
            self.mode = Mode::Normal;
            return;
        }
        if !choice.closes {
            self.message = Some(format!("the rest does not close with {wish}"));
            return;
        }
        match self.stage.switched(group, choice.pick) {
            Ok(stage) => {
                self.stage = stage;
                self.opened += 1;
                self.survey.forget();
                self.look(self.view);
                self.mode = Mode::Normal;
                let at = self.stage.at();
                self.playback.rebase(now, at);
                let mut message = format!("{wish} now");
                if let Some(key) = self.keymap.key(Action::Save) {
                    message += &format!("; {key} saves it");
                }
                self.message = Some(message);
            }
            Err(why) => self.message = Some(format!("{wish}: {why}")),
        }
    }

    /// Asks whether to write to the scene's own file, or to which.
    pub(super) fn ask(&mut self) {
        self.playback.pause();
        self.mode = match self.stage.origin() {
            Origin::File(path) => Mode::Confirm(path.clone()),
            Origin::Preset(name) => Mode::SaveAs(Line::for_file(&format!("{name}.toml"))),
            Origin::Stdin => Mode::SaveAs(Line::for_file("scene.toml")),
        };
    }

    /// The name of a new file was typed; an old one is not written over unasked.
    pub(super) fn accept_file(&mut self, line: &Line) {
        let to = PathBuf::from(line.text().trim());
        if to.as_os_str().is_empty() {
            self.mode = Mode::Normal;
        } else if to.exists() {
            self.mode = Mode::Confirm(to);
        } else {
            self.write(&to);
        }
    }

    pub(super) fn write(&mut self, to: &Path) {
        self.mode = Mode::Normal;
        let done = saving::save(&mut self.stage, to);
        self.message = Some(done.unwrap_or_else(|why| why));
    }
}
