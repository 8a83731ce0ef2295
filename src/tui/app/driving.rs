//! Moves the driver to a coordinate or by steps.

use super::{App, Mode};
use crate::report::{followed_until, singularity_text, unreached};
use crate::scene::with_point;
use crate::solver::PointLeader;
use crate::tui::commands::line::{EditLine, number_of};
use crate::tui::figures::format::coordinate;
use crate::tui::player::driver_range::OutOfRange;
use crate::tui::player::led_motion::LedMotion;
use crate::wording::words;
use std::time::Duration;

impl App {
    /// Moves the driver to the typed coordinate, or keeps the line for correction.
    pub(super) fn accept_coordinate(&mut self, line: &EditLine, now: Duration) {
        if self.accept_input(line.text(), now) {
            return;
        }
        match self.player.open_scene.led_motion().is_some() {
            true => self.accept_time(line.text(), now),
            false => self.accept_driver_coordinate(line.text(), now),
        }
    }

    /// Lets the leading point lead from the typed time, or reports that the inputs cannot follow it
    /// up to there.
    fn accept_time(&mut self, typed: &str, now: Duration) {
        let Some(time) = number_of(typed, "s") else {
            if typed.trim().is_empty() {
                self.shell.mode = Mode::Normal;
            } else {
                self.set_message(words().no_number_of("s", typed));
            }
            return;
        };
        let Some(led) = self.player.open_scene.led_motion() else {
            return;
        };
        let [first, end] = led.span();
        if !led.is_closed() && !(first..=end).contains(&time) {
            let [_, last] = led.lead().path.span();
            let message = match time > end && end < last {
                true => words().lead_out_of_reach(&time),
                false => {
                    let [first, end] = [first, end].map(|time| led.text(time));
                    words().out_of_reach(&first, &end, "s")
                }
            };
            self.set_message(message);
            return;
        }
        self.player.lead_to_time(time, now);
        self.shell.mode = Mode::Normal;
        self.report_singularity();
    }

    /// Says how far the inputs can follow the leading point, if that is not its whole path.
    pub(super) fn report_lead(&mut self) {
        let open_scene = &self.player.open_scene;
        if open_scene.scene().lead.is_none() || self.shell.message.is_some() {
            return;
        }
        let message = match open_scene.led_motion() {
            None => {
                let lead = open_scene.scene().lead.as_ref();
                let leader =
                    lead.and_then(|lead| PointLeader::new(open_scene.solver(), lead.lead()));
                unreached(leader.is_none_or(|leader| leader.is_independent())).to_owned()
            }
            Some(led) if led.is_complete() => return,
            Some(led) => self.lead_end(led),
        };
        self.set_message(message);
    }

    /// Says up to which time and place the inputs can follow the leading point.
    fn lead_end(&self, led: &LedMotion) -> String {
        let [_, end] = led.span();
        followed_until(
            led.lead(),
            end,
            self.player.open_scene.scene().unit.symbol(),
        )
    }

    /// Describes the present position of the leading point, if it is singular.
    fn report_singularity(&mut self) {
        let open_scene = &self.player.open_scene;
        let led = open_scene.led();
        if let Some((led, singularity)) = led.and_then(|led| Some((led, led.singularity()?))) {
            let text = singularity_text(open_scene.scene(), open_scene.solver(), singularity);
            let message = words().lead_is_singular(&led.text(led.time()), &text);
            self.set_message(message);
        }
    }

    /// Moves the leading point by a step of time, as far as the inputs can follow.
    pub(super) fn step_time(&mut self, by: f64, now: Duration) {
        if self.player.step_time(by, now) {
            return self.report_singularity();
        }
        let message = match self.player.open_scene.led() {
            Some(led) if !led.is_complete() && by > 0.0 => self.lead_end(led),
            _ => words().motion_ends().to_owned(),
        };
        self.set_message(message);
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
                self.set_message(words().typed_two_marks(typed.trim()));
            }
            None => self.set_message(words().no_number_of(unit, typed)),
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
        self.set_message(message);
        reached.is_ok()
    }

    /// Moves the driver by a step, as far as the motion permits.
    pub(super) fn step(&mut self, by: f64, now: Duration) {
        if !self.player.step(by, now) {
            self.set_message(words().motion_ends());
        }
    }
}
