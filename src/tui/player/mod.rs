//! Solves the open scene at its driver coordinate and plays its motion.

pub(crate) mod assembly_list;
pub(crate) mod compared_scene;
pub(crate) mod cost;
pub(crate) mod current_results;
pub(crate) mod driver_range;
pub(crate) mod led_motion;
pub(crate) mod next_singularity;
pub(crate) mod open_scene;
pub(crate) mod playback;
pub(crate) mod scene_version;
pub(crate) mod solution_cache;
pub(crate) mod steps;
pub(crate) mod timetable;
pub(crate) mod watched_method;

use super::OpenedScene;
use crate::tui::figures::format::rounded;
use driver_range::OutOfRange;
use led_motion::LedMotion;
use open_scene::OpenScene;
use playback::{Playback, Track};
use scene_version::SceneRevision;
use std::time::Duration;
use steps::StepLadder;

/// Time between two frames during playback.
pub(crate) const FRAME: Duration = Duration::from_millis(33);
/// Decimals to which a step is rounded.
const STEP_DECIMALS: usize = 9;

/// The open scene with its driver coordinate, step size and playback.
#[derive(Debug)]
pub(crate) struct Player {
    pub(crate) open_scene: OpenScene,
    pub(crate) steps: StepLadder,
    /// The name of the input that the step keys move; `None` for the time of a leading point, or
    /// for the driver.
    pub(crate) input: Option<String>,
    pub(crate) playback: Playback,
    /// The coordinate that an edit put out of reach, and where the driver stands since then.
    out_of_reach: Option<(f64, f64)>,
    /// The time when the last frame was due.
    frame: Duration,
    /// The time, scene and coordinate of the last cost measurement; `None` before the first one.
    cost_measured: Option<(Duration, SceneRevision, f64)>,
}

impl Player {
    /// Creates a player with a scene, paused at its initial coordinate.
    pub(crate) fn new(opened: OpenedScene) -> Self {
        let open_scene = OpenScene::new(opened);
        Player {
            steps: steps_of(&open_scene),
            input: None,
            playback: Playback::new(),
            open_scene,
            out_of_reach: None,
            frame: Duration::ZERO,
            cost_measured: None,
        }
    }

    /// Replaces the scene by an edited form of it and returns the previous form. The driver keeps
    /// its coordinate or time as far as the new form can reach it, and returns to it with the first
    /// form that can, for example after undo, unless it is moved in between.
    pub(crate) fn exchange(&mut self, open_scene: OpenScene, now: Duration) -> OpenScene {
        let (at, turned) = (self.open_scene.at(), self.turns());
        let out_of_reach = self.out_of_reach.take().filter(|(_, since)| *since == at);
        let at = out_of_reach.map_or(at, |(wanted, _)| wanted);
        let time = self.open_scene.time();
        let led = self.open_scene.led().map(LedMotion::time);
        let mut open_scene = open_scene;
        if self.open_scene.led_motion().is_some() && led.is_none() {
            open_scene.take_by_hand();
        }
        let before = std::mem::replace(&mut self.open_scene, open_scene);
        // A reread file may have a slide as its driver instead of a link.
        if turned != self.turns() {
            self.reset_steps();
        }
        if self.open_scene.led().is_some() {
            match led {
                Some(time) => {
                    self.lead_to_time(time, now);
                }
                // The edit has added the leading point.
                None => self.reset_steps(),
            }
            return before;
        }
        if led.is_some() {
            self.reset_steps();
        }
        match time.filter(|_| self.open_scene.timetable().is_some()) {
            Some(time) => self.move_to_time(time, now),
            None => {
                self.move_to_coordinate(self.open_scene.driver_range().clamp(at), now);
                let reached = self.open_scene.at();
                self.out_of_reach = (reached != at).then_some((at, reached));
            }
        }
        before
    }

    /// Returns the coordinate that the last edit left out of reach.
    pub(crate) fn out_of_reach(&self) -> Option<f64> {
        self.out_of_reach.map(|(wanted, _)| wanted)
    }

    /// Restores the initial step of the driver.
    pub(crate) fn reset_steps(&mut self) {
        self.steps = steps_of(&self.open_scene);
    }

    fn turns(&self) -> bool {
        self.open_scene.driver_range().turns()
    }

    // ---- the driver's position

    /// Moves the driver to a coordinate and continues playback from it. A point that leads stops
    /// leading.
    pub(crate) fn move_to_coordinate(&mut self, at: f64, now: Duration) {
        let was_led = self.open_scene.led().is_some();
        self.open_scene.go(at);
        if was_led {
            self.playback.pause();
            self.reset_steps();
        }
        self.rebase(now);
    }

    /// Lets the leading point lead, at a time of its motion or the nearest one, and continues
    /// playback from it. Returns `false` if there is no such motion.
    pub(crate) fn lead_to_time(&mut self, time: f64, now: Duration) -> bool {
        let was_led = self.open_scene.led().is_some();
        let is_led = self.open_scene.lead_to_time(time);
        if is_led && !was_led {
            self.input = None;
            self.reset_steps();
        }
        self.rebase(now);
        is_led
    }

    /// Moves the leading point by a step of time. Returns `true` if the whole step was possible.
    pub(crate) fn step_time(&mut self, by: f64, now: Duration) -> bool {
        let Some(led) = self.open_scene.led() else {
            return false;
        };
        let wanted = rounded(led.time() + by, STEP_DECIMALS);
        let reached = led.within(wanted);
        let is_whole = led.is_closed() || reached == wanted;
        self.lead_to_time(reached, now) && is_whole
    }

    /// Moves the driver to a time of its motion and continues playback from it.
    pub(crate) fn move_to_time(&mut self, time: f64, now: Duration) {
        self.open_scene.go_to_time(time);
        self.rebase(now);
    }

    /// Moves the driver to a time under the mouse, rounded as in playback.
    pub(crate) fn move_to_pointed_time(&mut self, time: f64, now: Duration) {
        if let Some(timetable) = self.open_scene.timetable() {
            self.move_to_time(timetable.on_grid(time), now);
        }
    }

    /// Returns the playback track: the motion over time, or the driver coordinate.
    pub(crate) fn track(&self) -> Track {
        if let Some(led) = self.open_scene.led() {
            return led.track();
        }
        match self.open_scene.timetable() {
            Some(timetable) => Track {
                span: timetable.period(),
                oscillation: None,
                speed: 1.0,
            },
            None => self.open_scene.driver_range().track(),
        }
    }

    /// Returns the position on the track; 0 if the driver is outside its motion over time.
    fn place(&self) -> f64 {
        if let Some(led) = self.open_scene.led() {
            return led.time();
        }
        match self.open_scene.timetable() {
            Some(_) => self.open_scene.time().unwrap_or(0.0),
            None => self.open_scene.at(),
        }
    }

    /// Moves to a coordinate or its equivalent in the range, and returns the reached one.
    pub(crate) fn jump(&mut self, at: f64, now: Duration) -> Result<f64, OutOfRange> {
        let reached = self.open_scene.driver_range().reach(at)?;
        self.move_to_coordinate(reached, now);
        Ok(reached)
    }

    /// Moves to the scene's initial position: that of a leading point, if the scene has one.
    pub(crate) fn go_to_opening(&mut self, now: Duration) {
        if self.lead_to_time(f64::NEG_INFINITY, now) {
            return;
        }
        if self.open_scene.timetable().is_some() {
            return self.move_to_time(0.0, now);
        }
        let driver_range = self.open_scene.driver_range();
        self.move_to_coordinate(driver_range.clamp(driver_range.opening()), now);
    }

    /// Moves by a step, as far as the range permits. Returns `true` if the whole step was possible.
    pub(crate) fn step(&mut self, by: f64, now: Duration) -> bool {
        let wanted = rounded(self.open_scene.at() + by, STEP_DECIMALS);
        let reached = self.open_scene.driver_range().clamp(wanted);
        self.move_to_coordinate(reached, now);
        reached == wanted
    }

    // ---- playback

    /// Starts or pauses playback. After a pause, the driver stays where the last frame showed it.
    pub(crate) fn toggle(&mut self, now: Duration) {
        if self.playback.is_playing() {
            self.playback.pause();
        } else {
            if let Some(time) = self.open_scene.led_motion().map(LedMotion::time) {
                self.lead_to_time(time, now);
            }
            self.playback.play(now, self.place());
            self.frame = now;
        }
    }

    /// Continues playback from the current position, for example after the process was suspended.
    pub(crate) fn rebase(&mut self, now: Duration) {
        self.playback.rebase(now, self.place());
    }

    /// Reverses playback.
    pub(crate) fn reverse(&mut self, now: Duration) {
        self.playback.reverse(now, self.place());
    }

    /// Selects the next faster pace, if there is one.
    pub(crate) fn faster(&mut self, now: Duration) {
        self.playback.faster(now, self.place());
    }

    /// Selects the next slower pace, if there is one.
    pub(crate) fn slower(&mut self, now: Duration) {
        self.playback.slower(now, self.place());
    }

    /// Continues playback from the current position with a new frame clock, after no frames were
    /// due.
    pub(crate) fn resume(&mut self, now: Duration) {
        self.rebase(now);
        self.frame = now;
    }

    /// Moves the driver to the playback position at `now`.
    pub(crate) fn follow(&mut self, now: Duration) {
        let Some(place) = self.playback.position(now, &self.track()) else {
            return;
        };
        self.frame = now;
        if let Some(led) = self.open_scene.led() {
            let time = led.on_grid(place);
            self.open_scene.lead_to_time(time);
            return;
        }
        match self.open_scene.timetable() {
            Some(timetable) => {
                let time = timetable.on_grid(place);
                self.open_scene.go_to_time(time);
            }
            None => {
                let at = self.open_scene.driver_range().on_grid(place);
                self.open_scene.go(at);
            }
        }
    }

    /// Returns the time of the next frame; `None` while paused.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        self.playback.is_playing().then(|| self.frame + FRAME)
    }

    /// Measures the cost of a state if due: at once for another scene, after a pause for another
    /// coordinate.
    pub(crate) fn measure_cost(&mut self, now: Duration) {
        let (edition, at) = (self.open_scene.edition(), self.open_scene.at());
        let weighed = self.cost_measured.as_ref();
        let is_due = weighed.is_none_or(|&(then, ref scene, place)| {
            scene != edition || (place != at && now >= then + cost::PAUSE)
        });
        if is_due {
            self.cost_measured = Some((now, edition.clone(), at));
            self.open_scene.measure_cost();
        }
    }
}

/// Returns the step sizes for the time of a leading point, or for the scene's driver.
fn steps_of(open_scene: &OpenScene) -> StepLadder {
    if let Some(led) = open_scene.led() {
        return StepLadder::of_length(led.track().span);
    }
    if open_scene.driver_range().turns() {
        StepLadder::of_angle()
    } else {
        StepLadder::of_length(open_scene.driver_range().span())
    }
}
