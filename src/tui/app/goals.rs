//! Goals: values of the scene are found that meet them, and put as one edit.

use super::{App, Mode};
use crate::quantity::Catalogue;
use crate::scene::Value;
use crate::study::{DesignFigures, DesignSpace, FoundDesign, Goal, GoalSearch, PlanAxis};
use crate::tui::commands::line::EditLine;
use crate::tui::document::history::Deed;
use crate::tui::figures::format::coordinate;
use crate::wording::words;
use std::time::Duration;

/// Digits of what is found, and decimals of what is said of it.
const DIGITS: i32 = 12;
const DECIMALS: usize = 3;

impl App {
    pub(super) fn type_goal(&mut self) {
        if self.document.editor.value().is_some() {
            self.shell.mode = Mode::Goal(EditLine::for_goal());
        }
    }

    /// Goals were typed: from what is given, values are found that meet them.
    pub(super) fn take_goal(&mut self, typed: &str, now: Duration) {
        if typed.trim().is_empty() {
            self.shell.mode = Mode::Normal;
            return;
        }
        match self.values_for(typed) {
            Ok(texts) => {
                let said = texts
                    .iter()
                    .map(|(value, text)| format!("{} {text}", value.name));
                let said = said.collect::<Vec<_>>().join(", ");
                let names: Vec<&str> = texts.iter().map(|(value, _)| value.name.as_str()).collect();
                let deed = Deed::Other(names.join(", "));
                if self.put_all(texts, deed, now) {
                    self.shell.mode = Mode::Normal;
                    self.shell.say(words().goal_is_met(&said));
                }
            }
            Err(why) => self.shell.say(why),
        }
    }

    /// The values that meet what was typed; in words why there are none.
    fn values_for(&self, typed: &str) -> Result<Vec<(Value, String)>, String> {
        let (goals, axes) = self.wish(typed)?;
        let open_scene = &self.player.open_scene;
        let space = DesignSpace::of_axes(open_scene.scene(), open_scene.solver(), &axes)?;
        let figures = goals.iter().map(|goal| goal.figure.clone()).collect();
        let figures = DesignFigures::new(&space, figures, None);
        let outcome = GoalSearch::new(figures, goals.clone(), &axes).run(0, 0, 1, &mut |_| true);
        match (outcome.solutions.first(), &outcome.nearest) {
            (Some(found), _) => {
                let texts = space.values().iter().zip(&found.numbers);
                let text = |(value, number): (&Value, &f64)| {
                    (value.clone(), value.with_number(to_digits(*number)))
                };
                Ok(texts.map(text).collect())
            }
            (None, Some(nearest)) => Err(words().goal_not_met(&told(&goals, nearest))),
            (None, None) => Err(words().goal_needs_opening().into()),
        }
    }

    /// Goals, divided by `;`, and behind `by` the values; without it the one under the cursor.
    fn wish(&self, typed: &str) -> Result<(Vec<Goal>, Vec<PlanAxis>), String> {
        let (goals, names) = match typed.split_once(" by ") {
            Some((goals, names)) => (goals, Some(names)),
            None => (typed, None),
        };
        let scene = self.player.open_scene.scene();
        let catalogue = Catalogue::new(scene);
        let goals = goals.split(';').map(|goal| Goal::parse(goal, &catalogue));
        let goals = goals.collect::<Result<Vec<_>, _>>();
        let under_cursor = || self.document.editor.value().map(Value::dotted);
        let names = names
            .map(str::to_owned)
            .or_else(under_cursor)
            .unwrap_or_default();
        let axes = names.split(',').map(str::parse::<PlanAxis>);
        let axes = axes.collect::<Result<Vec<_>, _>>();
        Ok((
            goals.map_err(|why| why.to_string())?,
            axes.map_err(|why| why.to_string())?,
        ))
    }
}

/// The figures of a design that misses its goals.
fn told(goals: &[Goal], design: &FoundDesign) -> String {
    let figures = goals
        .iter()
        .zip(&design.figures)
        .filter_map(|(goal, figure)| {
            let value = coordinate((*figure).ok()?, DECIMALS);
            Some(format!(
                "{} {value} {}",
                goal.figure.name(),
                goal.figure.unit()
            ))
        });
    figures
        .map(|figure| figure.trim_end().to_owned())
        .collect::<Vec<_>>()
        .join(", ")
}

/// A number to so many digits: what lies behind them changes no goal.
fn to_digits(number: f64) -> f64 {
    let places = usize::try_from(DIGITS - 1).unwrap_or(0);
    format!("{number:.places$e}").parse().unwrap_or(number)
}
