//! Steps held inputs: each step or typed coordinate is an edit of its value `at`.

use super::{App, Mode};
use crate::Input;
use crate::scene::{Value, with_point};
use crate::tui::document::history::Deed;
use crate::tui::player::led_motion::LedMotion;
use crate::tui::player::steps::StepLadder;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Selects the next input for the step keys: the driver, then each held input. With a leading
    /// point, its time comes first.
    pub(super) fn select_next_input(&mut self) {
        let scene = self.player.open_scene.scene();
        let driver = self.player.open_scene.led_motion();
        let driver = driver.map(|_| scene.input_name(scene.mechanism.driver().input).to_owned());
        let held = self.held_values().into_iter();
        let held = held.map(|(input, _)| scene.input_name(input).to_owned());
        let held: Vec<String> = driver.into_iter().chain(held).collect();
        if held.is_empty() {
            self.set_message(words().no_held_inputs());
            return;
        }
        let selected = self.player.input.as_ref();
        let next = match selected.and_then(|name| held.iter().position(|other| other == name)) {
            None => held.first(),
            Some(at) => held.get(at + 1),
        };
        let next = next.cloned();
        if next.is_none()
            && let Some(time) = self.player.open_scene.led_motion().map(LedMotion::time)
        {
            self.player.lead_to_time(time, self.now);
            self.set_message(words().keys_step_the_time());
            return;
        }
        self.select_input(next);
    }

    /// Takes the inputs by hand where the scene opens, if a point leads.
    pub(in crate::tui::app) fn take_by_hand(&mut self) {
        if self.player.open_scene.led().is_some() {
            let at = self.player.open_scene.at();
            self.player.move_to_coordinate(at, self.now);
        }
    }

    /// Selects a held input for the step keys, or the driver. A leading point stops leading.
    fn select_input(&mut self, name: Option<String>) {
        self.take_by_hand();
        let found = name.and_then(|name| self.held_value(&name));
        let Some((input, value)) = found else {
            let scene = self.player.open_scene.scene();
            let driver = scene.input_name(scene.mechanism.driver().input);
            let has_lead = self.player.open_scene.led_motion().is_some();
            self.player.input = has_lead.then(|| driver.to_owned());
            self.player.reset_steps();
            let scene = self.player.open_scene.scene();
            let driver = scene.input_name(scene.mechanism.driver().input);
            let message = words().keys_step_the_driver(driver);
            self.set_message(message);
            return;
        };
        let scene = self.player.open_scene.scene();
        let name = scene.input_name(input).to_owned();
        let message = words().keys_step_an_input(&name, &value.text(), value.unit);
        self.player.steps = match input {
            Input::Turn(_) => StepLadder::of_angle(),
            Input::Push(_) => StepLadder::of_length(value.number.abs()),
        };
        self.player.input = Some(name);
        self.set_message(message);
    }

    /// Returns the held inputs, each with the value of its coordinate: `at`, or the `phase` of a ratio of 0.
    fn held_values(&self) -> Vec<(Input, Value)> {
        let scene = self.player.open_scene.scene();
        let values = scene.values();
        let held = scene.mechanism.timed().iter();
        held.filter(|timed| timed.law.is_held())
            .filter_map(|timed| {
                let name = scene.input_name(timed.input);
                let names = ["at", "phase"].map(|key| format!("{name} {key}"));
                let value = values.iter().find(|value| names.contains(&value.name))?;
                Some((timed.input, value.clone()))
            })
            .collect()
    }

    /// Returns the held input of this name, with the value of its coordinate.
    fn held_value(&self, name: &str) -> Option<(Input, Value)> {
        let scene = self.player.open_scene.scene();
        let mut held = self.held_values().into_iter();
        held.find(|&(input, _)| scene.input_name(input) == name)
    }

    /// Moves the selected input by a step: the driver, or a held input.
    pub(super) fn step_selected(&mut self, sense: f64, now: Duration) {
        let selected = self.player.input.as_deref();
        let held = selected.and_then(|name| self.held_value(name));
        if self.player.open_scene.led().is_some() {
            let by = sense * self.player.steps.size();
            return self.step_time(by, now);
        }
        let scene = self.player.open_scene.scene();
        let driver = scene.input_name(scene.mechanism.driver().input);
        let is_driver = self.player.input.as_deref() == Some(driver);
        if held.is_none() && !is_driver && self.player.input.take().is_some() {
            // An edit or undo has removed its value: the step is one of the driver.
            self.player.reset_steps();
        }
        let size = self.player.steps.size();
        let Some((_, value)) = held else {
            return self.step(sense * size, now);
        };
        if value.formula.is_some() {
            return self.report_dependencies(&value);
        }
        let step = Deed::Nudge(value.name.clone());
        self.replace_value(&value, value.moved(sense, size), step, now);
    }

    /// Moves the input named on a line, `r7 45`, or selects it for the step keys, `r7`. Returns
    /// `false` for a line without a name.
    pub(super) fn accept_input(&mut self, line: &str, now: Duration) -> bool {
        let line = line.trim();
        let (name, number) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        // A number alone is a coordinate of the driver, even if a link has such a name.
        if number.is_empty() && with_point(name).is_some_and(|name| name.parse::<f64>().is_ok()) {
            return false;
        }
        let scene = self.player.open_scene.scene();
        let input = match scene.input_named(name) {
            Ok(input) => input,
            Err(why) => {
                let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic());
                let names_an_input = is_name && !number.is_empty();
                if names_an_input {
                    self.set_message(why);
                }
                return names_an_input;
            }
        };
        let is_driver = input == scene.mechanism.driver().input;
        let held = self.held_value(name);
        if held.is_none() && !is_driver {
            self.set_message(words().input_is_not_held(name));
            return true;
        }
        if number.trim().is_empty() {
            self.select_input(Some(name.to_owned()));
            self.shell.mode = Mode::Normal;
            return true;
        }
        let Some((_, value)) = held else {
            // The coordinate of the driver, as without its name.
            self.accept_driver_coordinate(number.trim(), now);
            return true;
        };
        self.take_by_hand();
        match value.typed(number) {
            Ok(text) => {
                let edit = Deed::Other(value.name.clone());
                if self.replace_value(&value, text, edit, now) {
                    self.shell.mode = Mode::Normal;
                }
            }
            Err(why) => self.set_message(why.to_string()),
        }
        true
    }

    /// Returns the unit of a step.
    pub(crate) fn step_unit(&self) -> &'static str {
        match self.player.open_scene.led() {
            Some(_) => "s",
            None => self.player.open_scene.unit(),
        }
    }

    /// Returns the selected held input with its coordinate, such as `r7 45 deg`; `None` for the
    /// driver.
    pub(crate) fn selected_input(&self) -> Option<String> {
        let name = self.player.input.as_ref()?;
        let (input, _) = self.held_value(name)?;
        let scene = self.player.open_scene.scene();
        let at = scene
            .mechanism
            .input_coordinate(input, self.player.open_scene.at())?;
        let unit = scene.input_unit(input);
        Some(format!("{name} {at} {unit}"))
    }
}
