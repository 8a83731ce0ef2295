//! Moves the driver to a coordinate or by steps.

use super::{App, Mode};
use crate::scene::with_point;
use crate::tui::commands::line::{EditLine, number_of};
use crate::tui::figures::format::coordinate;
use crate::tui::player::driver_range::OutOfRange;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Moves the driver to the typed coordinate, or keeps the line for correction.
    pub(super) fn accept_coordinate(&mut self, line: &EditLine, now: Duration) {
        if !self.accept_input(line.text(), now) {
            self.accept_driver_coordinate(line.text(), now);
        }
    }

    /// Moves the driver to the typed coordinate, which has no name before it.
    pub(super) fn accept_driver_coordinate(&mut self, typed: &str, now: Duration) {
        let unit = self.player.open_scene.unit();
        match number_of(typed, unit) {
            Some(at) => {
                if self.jump(at, now) {
                    self.shell.mode = Mode::Normal;
                }
            }
            None if typed.trim().is_empty() => self.shell.mode = Mode::Normal,
            None if with_point(typed).is_none() => {
                self.shell
                    .set_message(words().typed_two_marks(typed.trim()));
            }
            None => self.shell.set_message(words().no_number_of(unit, typed)),
        }
    }

    /// Moves the driver to a coordinate and returns `true`, or reports that it is out of reach.
    pub(super) fn jump(&mut self, at: f64, now: Duration) -> bool {
        let reached = self.player.jump(at, now);
        let open_scene = &self.player.open_scene;
        let (unit, decimals) = (open_scene.unit(), open_scene.driver_range().decimals());
        let message = match reached {
            Ok(reached) if reached == at => return true,
            Ok(reached) => words().taken_as(&coordinate(reached, decimals), unit),
            Err(OutOfRange { low, high }) => {
                // Rounded inwards, so that the reported limits can be reached.
                let scale = 10.0_f64.powi(i32::try_from(decimals).unwrap_or(0));
                let low = coordinate((low * scale).ceil() / scale, decimals);
                let high = coordinate((high * scale).floor() / scale, decimals);
                words().out_of_reach(&low, &high, unit)
            }
        };
        self.shell.set_message(message);
        reached.is_ok()
    }

    /// Moves the driver by a step, as far as the motion permits.
    pub(super) fn step(&mut self, by: f64, now: Duration) {
        if !self.player.step(by, now) {
            self.shell.set_message(words().motion_ends());
        }
    }
}
