//! Linkages for a task: looked for, gone through, and one of them taken.

use super::{App, Effect, Mode};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::key::Key;
use crate::tui::document::opening;
use crate::tui::views::candidates;
use crate::tui::views::candidates::list::{CandidateList, CandidatesPage};
use crate::tui::views::candidates::walk::WalkStep;
use crate::tui::{Origin, TaskOrder};
use crate::wording::words;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

impl App {
    /// Looks for linkages that do a task, and lists them.
    pub(crate) fn synthesize(&mut self, order: TaskOrder) {
        let list = CandidateList::new(order.clone());
        let search = Arc::clone(list.search());
        self.drop_search();
        self.candidates = Some(list);
        self.shell.mode = Mode::Candidates;
        self.clerk.search(move || {
            let found = search.run(&order);
            Box::new(move |app, _| {
                // Another task may be looked at meanwhile.
                let own = |list: &&mut CandidateList| Arc::ptr_eq(list.search(), &search);
                if let Some(list) = app.candidates.as_mut().filter(own) {
                    list.take(found);
                }
            })
        });
        self.take_in(self.now);
    }

    /// The candidates of the task that was looked at last.
    pub(crate) fn candidates(&self) -> Option<&CandidateList> {
        self.candidates.as_ref()
    }

    /// Lists them again.
    pub(super) fn list_candidates(&mut self) {
        if self.candidates.is_some() {
            self.shell.mode = Mode::Candidates;
        }
    }

    /// Back to the open scene, which goes on from where it was. What was found is kept.
    fn leave_candidates(&mut self, now: Duration) {
        self.shell.mode = Mode::Normal;
        self.drop_search();
        self.player.resume(now);
    }

    /// A search that has not come to its end ends.
    fn drop_search(&mut self) {
        let searching = |list: &mut CandidateList| list.percent().is_some();
        if let Some(left) = self.candidates.take_if(searching) {
            left.leave();
        }
    }

    /// The folder of the task that the open scene was taken from, where it is known.
    pub(super) fn folder_of_task(&self) -> Option<&Path> {
        let list = self.candidates.as_ref();
        let own = list.filter(|list| list.taken == Some(self.scenes))?;
        own.order().folder.as_deref()
    }

    /// Keys of the list of candidates; `None` for those that mean the same everywhere.
    pub(super) fn candidates_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        self.shell.message = None;
        let walks = |list: &CandidateList| matches!(list.page(), CandidatesPage::Curves(_));
        let is_walking = self.candidates.as_ref().is_some_and(walks);
        if key == Key::Enter {
            match is_walking {
                true => self.pick_dyad(),
                false => self.take_candidate(now),
            }
            return Some(Effect::Show);
        }
        let page = self.page();
        let action = self.shell.keymap.action_in_list(key)?;
        let sees_both = candidates::sees_both(self.shell.size);
        let list = self.candidates.as_mut()?;
        if let (true, Some((step, forward))) = (is_walking, walk_step(action)) {
            list.walk(step, forward);
            return Some(Effect::Show);
        }
        match action {
            Action::Quit | Action::Leave | Action::Suspend | Action::Redraw | Action::Help => {
                return None;
            }
            Action::Back if list.step_out() => {}
            Action::Back | Action::Open => self.leave_candidates(now),
            Action::NextView | Action::PreviousView => list.turn_page(sees_both),
            Action::LineUp => list.move_by(-1),
            Action::LineDown => list.move_by(1),
            Action::PageUp => list.move_by(-page),
            Action::PageDown => list.move_by(page),
            Action::HalfUp => list.move_by(-(page / 2).max(1)),
            Action::HalfDown => list.move_by((page / 2).max(1)),
            Action::Top => list.move_by(isize::MIN),
            Action::End => list.move_by(isize::MAX),
            Action::StepBack | Action::Tables(TablesAction::Left) => list.step(false),
            Action::StepForward | Action::Tables(TablesAction::Right) => list.step(true),
            Action::Play => list.toggle(now),
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Picks the pivot and pin under the cursor; two of them are listed as a linkage.
    fn pick_dyad(&mut self) {
        let picks = self.candidates.as_mut().map(CandidateList::pick);
        if picks == Some(false) {
            self.shell.say(words().dyads_make_nothing().to_owned());
        }
    }

    /// Opens the candidate under the cursor as a new scene, which no file holds yet. One that does not do the task is
    /// not taken, and says why.
    fn take_candidate(&mut self, now: Duration) {
        let Some(list) = &self.candidates else {
            return;
        };
        let Some((_, row)) = list.chosen() else {
            return;
        };
        let Some((text, name)) = list.scene() else {
            self.shell.say(row.reasons.clone());
            return;
        };
        match opening::text(&text, Origin::New(name)) {
            Ok(opened) => {
                self.leave_candidates(now);
                // One that was taken from the list before, and not edited, stands in it still.
                let list = self.candidates.as_mut();
                let before = list.and_then(|list| list.taken.replace(self.scenes + 1));
                let is_new = matches!(self.player.open_scene.origin(), Origin::New(_));
                match is_new && before == Some(self.scenes) && !self.has_edits() {
                    true => self.show_now(opened),
                    false => self.show(opened),
                }
            }
            // It was opened before, to be driven through the task.
            Err(faults) => self.shell.say(faults.first_words()),
        }
    }
}

/// What a key of a list means on a curve, and whether it goes on.
fn walk_step(action: Action) -> Option<(WalkStep, bool)> {
    let step = match action {
        Action::StepForward | Action::Tables(TablesAction::Right) => (WalkStep::Next, true),
        Action::StepBack | Action::Tables(TablesAction::Left) => (WalkStep::Next, false),
        Action::LineDown | Action::HalfDown => (WalkStep::Long, true),
        Action::LineUp | Action::HalfUp => (WalkStep::Long, false),
        Action::PageDown | Action::End => (WalkStep::Curve, true),
        Action::PageUp | Action::Top => (WalkStep::Curve, false),
        _ => return None,
    };
    Some(step)
}
