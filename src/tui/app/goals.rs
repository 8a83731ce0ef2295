//! Finds values of the scene that meet typed goals and applies a chosen solution as one edit.

use super::goal_run::{GoalRequest, GoalRun};
use super::{App, Effect, Mode};
use crate::parallel;
use crate::quantity::Catalogue;
use crate::scene::Value;
use crate::study::{DesignSpace, Goal, PlanAxis};
use crate::tui::commands::action::{Action, TablesAction};
use crate::tui::commands::key::Key;
use crate::tui::commands::line::EditLine;
use crate::tui::document::history::Deed;
use std::sync::Arc;
use std::time::Duration;

impl App {
    pub(super) fn type_goal(&mut self) {
        if self.document.editor.value().is_some() {
            self.shell.mode = Mode::Goal(EditLine::for_goal(""));
        }
    }

    /// Returns the designs for a goal, while they are searched or browsed.
    pub(crate) fn goal_run(&self) -> Option<&GoalRun> {
        self.goal_run.as_ref()
    }

    /// Parses the typed goals and starts a background search for designs that meet them.
    pub(super) fn take_goal(&mut self, typed: &str) {
        if typed.trim().is_empty() {
            self.shell.mode = Mode::Normal;
            return;
        }
        let wish = match self.wish(typed) {
            Ok(wish) => wish,
            Err(why) => return self.shell.say(why),
        };
        let run = GoalRun::new(wish.clone());
        let progress = Arc::clone(run.progress());
        self.goal_run = Some(run);
        self.shell.mode = Mode::GoalRun;
        self.clerk.search(move || {
            let found = wish.search(parallel::cores(), &progress);
            Box::new(move |app, now| {
                // The user may have left this search and started another one.
                let is_awaited = app.shell.mode == Mode::GoalRun;
                let own = |run: &&mut GoalRun| is_awaited && Arc::ptr_eq(run.progress(), &progress);
                if let Some(run) = app.goal_run.as_mut().filter(own) {
                    run.take(found);
                    app.see_goal_run(now);
                }
            })
        });
        self.drain_results(self.now);
    }

    /// Handles the end of a search: applies a single design, lets the user choose among several, or
    /// reopens the typed goal if there is none.
    fn see_goal_run(&mut self, now: Duration) {
        let Some(run) = &self.goal_run else {
            return;
        };
        match run.count() {
            0 => {
                self.shell.say(run.not_met());
                self.shell.mode = Mode::Goal(EditLine::for_goal(&run.wish.typed));
                self.goal_run = None;
            }
            1 => self.take_design(now),
            _ => {}
        }
    }

    /// Applies the selected design as one edit.
    fn take_design(&mut self, now: Duration) {
        let Some(run) = self.goal_run.take() else {
            return;
        };
        self.shell.mode = Mode::Normal;
        let (Some(texts), Some(said)) = (run.texts(), run.is_met()) else {
            return;
        };
        let names: Vec<&str> = texts.iter().map(|(value, _)| value.name.as_str()).collect();
        let deed = Deed::Other(names.join(", "));
        if self.put_all(texts, deed, now) {
            self.shell.say(said);
        }
    }

    /// Handles a key while designs are searched or browsed. Returns `None` for keys with the same
    /// meaning everywhere.
    pub(super) fn goal_run_key(&mut self, key: Key, now: Duration) -> Option<Effect> {
        self.shell.message = None;
        let run = self.goal_run.as_mut()?;
        if key == Key::Enter {
            if run.percent().is_none() {
                self.take_design(now);
            }
            return Some(Effect::Show);
        }
        match self.shell.keymap.action_in_list(key)? {
            Action::Quit | Action::Leave | Action::Suspend | Action::Redraw => return None,
            Action::Back => {
                run.progress().leave();
                self.shell.mode = Mode::Goal(EditLine::for_goal(&run.wish.typed));
                self.goal_run = None;
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
    fn wish(&self, typed: &str) -> Result<GoalRequest, String> {
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
        let axes = names.split(',').map(str::parse::<PlanAxis>);
        let axes = axes.collect::<Result<Vec<_>, _>>();
        let axes = axes.map_err(|why| why.to_string())?;
        Ok(GoalRequest {
            typed: typed.to_owned(),
            goals: goals.map_err(|why| why.to_string())?,
            space: DesignSpace::of_axes(open_scene.scene(), open_scene.solver(), &axes)?,
            axes,
        })
    }
}
