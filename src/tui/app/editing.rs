//! Edits the scene: values are typed or nudged, the text is changed, and the linkage is solved
//! again at once.

use super::shell::SceneBefore;
use super::{App, Mode, View};
use crate::scene::{Measure, Value, coordinate_key};
use crate::tui::commands::action::{Action, SceneAction};
use crate::tui::commands::line::EditLine;
use crate::tui::document::edit_result::{self, EditedScene};
use crate::tui::document::history::Deed;
use crate::tui::figures::format::coordinate;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Handles the actions of the scene view.
    pub(super) fn edit(&mut self, action: SceneAction, now: Duration) {
        match action {
            SceneAction::Edit => self.type_value(),
            SceneAction::NudgeDown => self.nudge(-1.0, now),
            SceneAction::NudgeUp => self.nudge(1.0, now),
            SceneAction::FinerNudge => self.document.editor.finer(),
            SceneAction::CoarserNudge => self.document.editor.coarser(),
            SceneAction::Gather => self.toggle_staging(now),
            SceneAction::Goal => self.type_goal(),
        }
    }

    fn type_value(&mut self) {
        if self.document.editor.value().is_some() {
            self.shell.mode = Mode::Value(EditLine::for_value());
        }
    }

    /// Applies the typed value, or keeps the line for correction.
    pub(super) fn take_value(&mut self, typed: &str, now: Duration) {
        let Some(value) = self.document.editor.value().cloned() else {
            return;
        };
        if typed.trim().is_empty() {
            self.shell.mode = Mode::Normal;
            return;
        }
        match value.typed(typed) {
            Ok(text) => {
                if self.stage_edit(&value, text.clone())
                    || self.replace_value(&value, text, Deed::Other(value.name.clone()), now)
                {
                    self.shell.mode = Mode::Normal;
                }
            }
            Err(why) => self.set_message(why.to_string()),
        }
    }

    /// Moves the value under the cursor by a step.
    fn nudge(&mut self, steps: f64, now: Duration) {
        let Some(value) = self.document.editor.value().cloned() else {
            return;
        };
        let size = self.document.editor.notch().size();
        let gathered = self.document.editor.staged.as_ref();
        let waiting = gathered.and_then(|gathered| gathered.text(&value.name));
        let waiting = waiting.map(|text| value.with_text(text));
        let from = waiting.as_ref().unwrap_or(&value);
        if from.formula.is_none() && self.stage_edit(&value, from.moved(steps, size)) {
            return;
        }
        if value.formula.is_some() {
            self.report_dependencies(&value);
            return;
        }
        self.replace_value(
            &value,
            value.moved(steps, size),
            Deed::Nudge(value.name.clone()),
            now,
        );
    }

    /// Reports the formula and parameters that determine a value, because the value itself cannot
    /// be moved.
    pub(super) fn report_dependencies(&mut self, value: &Value) {
        let Some(formula) = &value.formula else {
            return;
        };
        let names = value.follows_from();
        self.set_message(match names.is_empty() {
            true => words().follows_from_formula(&value.name, formula),
            false => words().follows_from_parameters(&value.name, formula, &names.join(", ")),
        });
    }

    /// Replaces the text of a value. If the scene would be invalid, reports why and returns
    /// `false`.
    pub(super) fn replace_value(
        &mut self,
        value: &Value,
        text: String,
        action: Deed,
        now: Duration,
    ) -> bool {
        self.replace_values(vec![(value.clone(), text)], action, now)
    }

    /// Replaces the texts of several values in one edit. If the scene would be invalid, reports why
    /// and returns `false`.
    pub(super) fn replace_values(
        &mut self,
        texts: Vec<(Value, String)>,
        action: Deed,
        now: Duration,
    ) -> bool {
        let editor = &self.document.editor;
        let filed = texts.into_iter().map(|(value, text)| {
            let text = editor.in_file_notation(&value, text);
            (value, text)
        });
        let changed: Vec<_> = filed
            .filter(|(value, text)| *text != value.text())
            .collect();
        if changed.is_empty() {
            return true;
        }
        self.record_shown_assembly();
        // Recording the shown assembly may have moved the values in the text.
        let values = self.player.open_scene.scene().values();
        let there = |(value, text): (Value, String)| {
            let found = values.iter().find(|other| other.name == value.name);
            Some((found?.clone(), text))
        };
        let Some(changed) = changed.into_iter().map(there).collect::<Option<Vec<_>>>() else {
            return false;
        };
        let whole_text = self.player.open_scene.scene().with_values(&changed);
        // A changed start value selects another assembly.
        let reopens = changed
            .iter()
            .any(|(value, _)| value.measure == Measure::Start);
        let edited = match reopens {
            true => edit_result::reopened(&self.player.open_scene, &whole_text),
            false => edit_result::keeping(&self.player.open_scene, &whole_text),
        };
        match edited {
            Ok(edited) => {
                let opens = changed.iter().any(|(value, _)| self.is_opening(value));
                self.change(edited, action, now);
                if opens {
                    self.player.go_to_opening(now);
                }
                true
            }
            Err(why) => {
                let shown_text = changed
                    .iter()
                    .map(|(value, text)| format!("{} {text}", value.name));
                let shown_text: Vec<String> = shown_text.collect();
                self.set_message(format!("{}: {why}", shown_text.join(", ")));
                false
            }
        }
    }

    /// Returns `true` if a value is the driver's initial coordinate; the linkage then follows it.
    fn is_opening(&self, value: &Value) -> bool {
        let key = coordinate_key(&self.player.open_scene.scene().mechanism);
        value.name.strip_prefix("driver ") == Some(key)
    }

    /// Records the shown assembly in the text before the first edit, if the command line chose
    /// another one than the text. The record is an edit of its own.
    fn record_shown_assembly(&mut self) {
        if self.document.editor.history.is_empty()
            && !edit_result::opens_in_shown_assembly(&self.player.open_scene)
        {
            self.record_assembly(words().assembly());
        }
    }

    /// Records the shown assembly in the scene's text. Returns `false` if no text can express it.
    pub(super) fn record_assembly(&mut self, name: &str) -> bool {
        let before = self.player.open_scene.scene().text().to_owned();
        let shown_text = self.player.open_scene.saved_text();
        let scene = shown_text.and_then(|text| self.player.open_scene.scene().reparse(&text));
        let Some(scene) = scene else {
            return false;
        };
        let action = Deed::Other(name.to_owned());
        self.document
            .editor
            .history
            .record(&before, scene.text(), action);
        self.player.open_scene.replace_text(scene);
        self.relist();
        self.keep();
        true
    }

    /// Replaces the scene by an edited one and records the edit for undo.
    pub(super) fn change(&mut self, edited: EditedScene, action: Deed, now: Duration) {
        let before = self.player.open_scene.scene().text();
        let after = edited.opened.scene.text();
        let continues = self.document.editor.history.record(before, after, action);
        let first = self.shell.before.take().filter(|_| continues);
        self.take_edit(edited, now);
        // Several steps of one edit keep the scene from before the first of them.
        if let Some(SceneBefore { open_scene, .. }) = first {
            self.shell.before = Some(SceneBefore {
                open_scene,
                is_past: false,
            });
        }
    }

    /// Shows an edited scene at the driver's coordinate, as far as the scene can reach it.
    fn take_edit(&mut self, edited: EditedScene, now: Duration) {
        let before = self.player.out_of_reach();
        self.exchange(edited.opened, now);
        let lost = self.player.out_of_reach();
        if let Some(at) = lost.filter(|_| lost != before) {
            let (decimals, unit) = (
                self.player.open_scene.driver_range().decimals(),
                self.player.open_scene.unit(),
            );
            let at = coordinate(at, decimals);
            self.set_message(words().no_longer_in_reach(&at, unit));
        } else if edited.started {
            self.set_message(words().start_follows());
        }
        self.report_lead();
        self.keep();
    }

    /// Lists the values again, if a view needs them.
    pub(super) fn relist(&mut self) {
        if self.visible_views().contains(&View::Scene) {
            self.document.editor.list(self.player.open_scene.scene());
        }
    }

    /// Undoes or redoes an edit.
    pub(super) fn edit_history(&mut self, action: Action, now: Duration) {
        let is_undo = action == Action::Undo;
        if is_undo && self.restore_dropped_edits() {
            return;
        }
        let text = self.player.open_scene.scene().text();
        let history = &self.document.editor.history;
        let step = if is_undo {
            history.before(text)
        } else {
            history.after(text)
        };
        let Some((text, name)) = step else {
            let nothing = if is_undo {
                words().nothing_to_undo()
            } else {
                words().nothing_to_redo()
            };
            self.set_message(nothing);
            return;
        };
        let name = name.to_owned();
        match edit_result::reopened(&self.player.open_scene, &text) {
            Ok(edited) => {
                let history = &mut self.document.editor.history;
                if is_undo {
                    history.mark_undone();
                } else {
                    history.mark_redone();
                }
                self.take_edit(edited, now);
                let message = match is_undo {
                    true => words().undone(&name),
                    false => words().redone(&name),
                };
                // Keeps the message that the driver had to move.
                let more = self
                    .shell
                    .message
                    .take()
                    .map_or(String::new(), |m| format!("; {m}"));
                self.set_message(format!("{message}{more}"));
            }
            // Not expected: every text of the history was opened before.
            Err(why) => self.set_message(format!("{name}: {why}")),
        }
    }
}
