//! Finds values of the scene that meet typed goals and applies a chosen solution as one edit.

use super::goal_run::{GoalOutcome, GoalRequest, GoalRun};
use super::{App, Effect, Mode};
use crate::parallel;
use crate::quantity::Catalogue;
use crate::scene::Value;
use crate::study::{DesignSpace, Goal, PlanAxis};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::document::history::Deed;
use crate::tui::document::job::{BackgroundJob, JobProgress};
use std::time::Duration;

impl App {
    pub(super) fn type_goal(&mut self) {
        if self.document.editor.value().is_some() {
            self.shell.mode = Mode::Goal(EditLine::for_goal(""));
        }
    }

    /// Parses the typed goals and starts a background search for designs that meet them.
    pub(super) fn take_goal(&mut self, typed: &str) {
        if typed.trim().is_empty() {
            self.shell.mode = Mode::Normal;
            return;
        }
        let request = match self.parse_goals(typed) {
            Ok(request) => request,
            Err(why) => return self.set_message(why),
        };
        let order = request.clone();
        let work = move |progress: &JobProgress| order.search(parallel::cores(), progress);
        let job = BackgroundJob::start(&mut self.clerk, work, App::handle_goal_outcome);
        self.shell.mode = Mode::GoalRun(Box::new(GoalRun::new(request, job)));
        self.drain_results(self.now);
    }

    /// Handles the end of a search: applies a single design, lets the user choose among several, or
    /// reopens the typed goal if there is none.
    fn handle_goal_outcome(&mut self, found: GoalOutcome, now: Duration) {
        let Mode::GoalRun(run) = &mut self.shell.mode else {
            return;
        };
        run.job.result = Some(found);
        match run.count() {
            0 => {
                let (why, line) = (run.not_met(), EditLine::for_goal(&run.request.typed));
                self.shell.mode = Mode::Goal(line);
                self.set_message(why);
            }
            1 => self.take_design(now),
            _ => {}
        }
    }

    /// Applies the selected design as one edit.
    fn take_design(&mut self, now: Duration) {
        let Mode::GoalRun(run) = std::mem::take(&mut self.shell.mode) else {
            return;
        };
        let (Some(texts), Some(text)) = (run.texts(), run.is_met()) else {
            return;
        };
        let names: Vec<&str> = texts.iter().map(|(value, _)| value.name.as_str()).collect();
        let action = Deed::Other(names.join(", "));
        if self.replace_values(texts, action, now) {
            self.set_message(text);
        }
    }

    /// Handles a key while designs are searched or browsed. Returns `None` for keys with the same
    /// meaning everywhere.
    pub(super) fn goal_run_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        self.shell.message = None;
        let Mode::GoalRun(run) = &mut self.shell.mode else {
            return None;
        };
        if key == Key::Enter {
            if run.percent().is_none() {
                self.take_design(now);
            }
            return Some(Effect::Show);
        }
        match self.shell.keymap.action_in_list(key)? {
            Action::Leave | Action::Suspend | Action::Redraw => return None,
            Action::Back | Action::Quit => {
                let line = EditLine::for_goal(&run.request.typed);
                self.shell.mode = Mode::Goal(line);
            }
            Action::LineUp | Action::StepBack | Action::Tables(TablesAction::Left) => {
                run.step(false);
            }
            Action::LineDown | Action::StepForward | Action::Tables(TablesAction::Right) => {
                run.step(true);
            }
            _ => {}
        }
        Some(Effect::Show)
    }

    /// Parses goals separated by `;`, with the values to vary after `by`. Without `by`, the value
    /// under the cursor is varied.
    fn parse_goals(&self, typed: &str) -> Result<GoalRequest, String> {
        let (goals, names) = match typed.split_once(" by ") {
            Some((goals, names)) => (goals, Some(names)),
            None => (typed, None),
        };
        let open_scene = &self.player.open_scene;
        let catalogue = Catalogue::new(open_scene.scene());
        let goals = goals.split(';').map(|goal| Goal::parse(goal, &catalogue));
        let goals = goals.collect::<Result<Vec<_>, _>>();
        let under_cursor = || self.document.editor.value().map(Value::dotted);
        let names = names
            .map(str::to_owned)
            .or_else(under_cursor)
            .unwrap_or_default();
        let axes = PlanAxis::listed(&names).map_err(|why| why.to_string())?;
        Ok(GoalRequest {
            typed: typed.to_owned(),
            goals: goals.map_err(|why| why.to_string())?,
            space: DesignSpace::of_axes(open_scene.scene(), open_scene.solver(), &axes)?,
            axes,
        })
    }
}
