//! Stages edits and applies them together, for changes that close the linkage only in combination.

use super::{App, View};
use crate::scene::Value;
use crate::tui::commands::action::{Action, SceneAction};
use crate::tui::document::history::Deed;
use crate::tui::document::staged_edits::StagedEdits;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Starts staging edits, or applies the staged edits as one.
    pub(super) fn toggle_staging(&mut self, now: Duration) {
        let Some(gathered) = self.document.editor.staged.take() else {
            self.document.editor.staged = Some(StagedEdits::default());
            self.report_staged_edits();
            return;
        };
        let values = gathered.list().iter().filter_map(|(name, text)| {
            let value = self.document.editor.named(name)?;
            Some((value.clone(), text.clone()))
        });
        let texts: Vec<_> = values.collect();
        let names: Vec<&str> = texts.iter().map(|(value, _)| value.name.as_str()).collect();
        let action = Deed::Other(names.join(", "));
        let count = texts.len();
        if !self.replace_values(texts, action, now) {
            // The rejected edits stay staged, to be corrected.
            self.document.editor.staged = Some(gathered);
        } else if self.shell.message.is_none() {
            self.set_message(words().gathered_made(count));
        }
        self.keep();
    }

    fn report_staged_edits(&mut self) {
        let key = self
            .shell
            .keymap
            .key_label(Action::Scene(SceneAction::Gather));
        self.set_message(words().edits_wait(&key));
    }

    /// Stages another text for a value. Returns `false` if no staging is active.
    pub(super) fn stage_edit(&mut self, value: &Value, text: String) -> bool {
        let Some(gathered) = &mut self.document.editor.staged else {
            return false;
        };
        gathered.stage(&value.name, text, &value.text());
        self.keep();
        true
    }

    /// Restores the staged edits of an earlier session and opens the scene view.
    pub(super) fn restore_staged(&mut self, edits: StagedEdits) {
        if edits.is_empty() {
            return;
        }
        self.select_view(View::Scene);
        self.document.editor.staged = Some(edits);
        self.keep();
        self.report_staged_edits();
    }

    /// Returns `true` if staged edits are pending.
    pub(super) fn is_waiting(&self) -> bool {
        let gathered = self.document.editor.staged.as_ref();
        gathered.is_some_and(|gathered| !gathered.is_empty())
    }

    /// Returns `true` and reports it if staged edits block an action that depends on the text.
    pub(super) fn is_blocked_by_staging(&mut self, action: Action) -> bool {
        let waits = self.is_waiting();
        let takes_text = matches!(
            action,
            Action::Save
                | Action::SaveAs
                | Action::Undo
                | Action::Redo
                | Action::Open
                | Action::Reload
                | Action::NextPreset
                | Action::PreviousPreset
                | Action::Quit
        );
        let is_held_up = waits && takes_text && self.shell.mode.is_normal();
        if is_held_up {
            self.report_staged_edits();
        }
        is_held_up
    }

    /// Drops the staged edits; undo restores them.
    pub(super) fn drop_staged(&mut self) {
        let text = self.player.open_scene.scene().text();
        let Some(dropped) = self.document.editor.drop_staged(text) else {
            return;
        };
        self.keep();
        self.set_message(match dropped {
            0 => words().gathered_made(0),
            _ => words().gathered_dropped(&self.shell.keymap.key_label(Action::Undo)),
        });
    }

    /// Restores dropped staged edits. Returns `false` if there are none, or if a later edit must be
    /// undone first.
    pub(super) fn restore_dropped_edits(&mut self) -> bool {
        let text = self.player.open_scene.scene().text();
        let is_back = self.document.editor.restore_dropped_edits(text);
        if is_back {
            self.keep();
            self.report_staged_edits();
        }
        is_back
    }
}
