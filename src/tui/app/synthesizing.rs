//! Searches linkages for a task, lists them and opens one.

use super::{App, Effect, Mode};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::key::Key;
use crate::tui::document::job::{BackgroundJob, JobProgress};
use crate::tui::document::opening;
use crate::tui::views::candidates;
use crate::tui::views::candidates::curve_cursor::WalkStep;
use crate::tui::views::candidates::list::{CandidateList, CandidatesPage, FoundCandidates};
use crate::tui::{Origin, TaskOrder};
use crate::wording::words;
use std::path::Path;
use std::time::Duration;

impl App {
    /// Starts a background search for linkages that solve a task, and lists the results.
    pub(crate) fn synthesize(&mut self, order: TaskOrder) {
        let task = order.clone();
        let work = move |progress: &JobProgress| FoundCandidates::search(&task, progress);
        let job = BackgroundJob::start(&mut self.clerk, work, |app: &mut App, found, _| {
            if let Some(list) = &mut app.candidates {
                list.job.result = Some(found);
            }
        });
        self.candidates = Some(CandidateList::new(order, job));
        self.shell.mode = Mode::Candidates;
        self.drain_results(self.now);
    }

    /// Returns the candidates of the last task.
    pub(crate) fn candidates(&self) -> Option<&CandidateList> {
        self.candidates.as_ref()
    }

    /// Shows the list of candidates again.
    pub(super) fn list_candidates(&mut self) {
        if self.candidates.is_some() {
            self.shell.mode = Mode::Candidates;
        }
    }

    /// Returns to the open scene and resumes its playback. Finished results are kept, and an
    /// unfinished search is cancelled.
    fn close_candidates(&mut self, now: Duration) {
        self.shell.mode = Mode::Normal;
        self.candidates.take_if(|list| list.percent().is_some());
        self.player.resume(now);
    }

    /// Returns the folder of the task that produced the open scene, if known.
    pub(super) fn folder_of_task(&self) -> Option<&Path> {
        let list = self.candidates.as_ref();
        let own = list.filter(|list| list.taken == Some(self.scenes))?;
        own.order().folder.as_deref()
    }

    /// Handles a key of the list of candidates. Returns `None` for keys with the same meaning
    /// everywhere.
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
        let sees_both = candidates::fits_both(self.shell.size);
        let list = self.candidates.as_mut()?;
        if let (true, Some((step, forward))) = (is_walking, walk_step(action)) {
            list.walk(step, forward);
            return Some(Effect::Show);
        }
        match action {
            Action::Leave | Action::Suspend | Action::Redraw | Action::Help => {
                return None;
            }
            Action::Back | Action::Quit if list.step_out() => {}
            Action::Back | Action::Quit | Action::Open => self.close_candidates(now),
            Action::NextView | Action::PreviousView => list.turn_page(sees_both),
            _ if let Some(rows) = action.rows(page) => list.move_by(rows),
            Action::StepBack | Action::Tables(TablesAction::Left) => list.step(false),
            Action::StepForward | Action::Tables(TablesAction::Right) => list.step(true),
            Action::Play => list.toggle(now),
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Picks the pivot and pin under the cursor. Two picked dyads are listed as a linkage.
    fn pick_dyad(&mut self) {
        let picks = self.candidates.as_mut().map(CandidateList::pick);
        if picks == Some(false) {
            self.set_message(words().dyads_make_nothing().to_owned());
        }
    }

    /// Opens the candidate under the cursor as a new, unsaved scene. Reports the reasons if the
    /// candidate does not solve the task.
    fn take_candidate(&mut self, now: Duration) {
        let Some(list) = &self.candidates else {
            return;
        };
        let Some((_, row)) = list.chosen() else {
            return;
        };
        let Some((text, name)) = list.scene() else {
            self.set_message(row.reasons.clone());
            return;
        };
        match opening::text(&text, Origin::New(name)) {
            Ok(opened) => {
                self.close_candidates(now);
                // An unedited scene taken earlier from the list is still listed there, so it may be
                // replaced without a prompt.
                let list = self.candidates.as_mut();
                let before = list.and_then(|list| list.taken.replace(self.scenes + 1));
                let is_new = matches!(self.player.open_scene.origin(), Origin::New(_));
                match is_new && before == Some(self.scenes) && !self.has_edits() {
                    true => self.show_now(opened),
                    false => self.show(opened),
                }
            }
            // Not expected: the search already opened this scene to drive it through the task.
            Err(faults) => self.set_message(faults.first_words()),
        }
    }
}

/// Returns the step along a curve for an action, and `true` if it goes forward.
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
