//! Moving the driver: to a coordinate, by steps, or by playing.

use super::{App, Mode};
use crate::tui::commands::action::Action;
use crate::tui::commands::line::Line;
use crate::tui::figures::format::coordinate;
use crate::tui::player::driver_range::{OutOfRange, rounded};
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::steps::Steps;
use std::time::Duration;

/// Decimals to which a step is exact.
const STEP_DECIMALS: usize = 9;

impl App {
    /// A coordinate was typed: the driver goes there, or the line stays to be corrected.
    pub(super) fn accept_coordinate(&mut self, line: &Line, now: Duration) {
        match line.number(self.open_scene.unit()) {
            Some(at) => {
                if self.jump(at, now) {
                    self.mode = Mode::Normal;
                }
            }
            None if line.text().trim().is_empty() => self.mode = Mode::Normal,
            None => {
                let unit = self.open_scene.unit();
                self.message = Some(format!("not a number of {unit}: {}", line.text()));
            }
        }
    }

    /// Goes to a coordinate, if it can be reached; says so if not.
    pub(super) fn jump(&mut self, at: f64, now: Duration) -> bool {
        let driver_range = self.open_scene.driver_range();
        match driver_range.reach(at) {
            Ok(reached) => {
                if reached != at {
                    let meant = coordinate(reached, driver_range.decimals());
                    self.message = Some(format!("taken as {meant} {}", self.open_scene.unit()));
                }
                self.arrive(reached, now);
                true
            }
            Err(OutOfRange { low, high }) => {
                // Rounded inwards: what is said can be reached.
                let scale = 10.0_f64.powi(i32::try_from(driver_range.decimals()).unwrap_or(0));
                let low = coordinate((low * scale).ceil() / scale, driver_range.decimals());
                let high = coordinate((high * scale).floor() / scale, driver_range.decimals());
                let unit = self.open_scene.unit();
                self.message = Some(format!("out of reach: {low} to {high} {unit}"));
                false
            }
        }
    }

    /// Goes to where the scene opens.
    pub(super) fn go_to_opening(&mut self, now: Duration) {
        let driver_range = self.open_scene.driver_range();
        self.arrive(driver_range.clamp(driver_range.opening()), now);
    }

    /// Moves on by a step, as far as the motion goes.
    pub(super) fn step(&mut self, by: f64, now: Duration) {
        let wanted = rounded(self.open_scene.at() + by, STEP_DECIMALS);
        let reached = self.open_scene.driver_range().clamp(wanted);
        if reached != wanted {
            self.message = Some("the motion ends here".into());
        }
        self.arrive(reached, now);
    }

    /// The driver is here now, and goes on from here if it is playing.
    pub(super) fn arrive(&mut self, at: f64, now: Duration) {
        self.open_scene.go(at);
        self.playback.rebase(now, at);
    }

    /// Plays, pauses, or plays otherwise.
    pub(super) fn play(&mut self, action: Action, now: Duration) {
        // Pausing leaves the driver where the last frame showed it.
        let at = self.open_scene.at();
        match action {
            Action::Slower => self.playback.slower(now, at),
            Action::Faster => self.playback.faster(now, at),
            Action::Reverse => self.playback.reverse(now, at),
            _ if self.playback.is_playing() => self.playback.pause(),
            _ => {
                self.playback.play(now, at);
                self.frame = now;
            }
        }
    }
}

/// The steps that fit the driver.
pub(super) fn steps_of(open_scene: &OpenScene) -> Steps {
    if open_scene.driver_range().turns() {
        Steps::of_angle()
    } else {
        Steps::of_length(open_scene.driver_range().span())
    }
}
