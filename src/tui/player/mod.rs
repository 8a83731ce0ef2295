//! The open scene solved where its driver stands, and how that moves.

pub(crate) mod assembly_list;
pub(crate) mod compared_scene;
pub(crate) mod cost;
pub(crate) mod driver_range;
pub(crate) mod edition;
pub(crate) mod explained;
pub(crate) mod next_singularity;
pub(crate) mod open_scene;
pub(crate) mod playback;
pub(crate) mod steps;
pub(crate) mod timetable;
pub(crate) mod watched_method;

use super::Opened;
use crate::tui::figures::format::rounded;
use driver_range::OutOfRange;
use edition::Edition;
use open_scene::OpenScene;
use playback::{Playback, Track};
use std::time::Duration;
use steps::StepLadder;

/// Time between two frames while playing.
pub(crate) const FRAME: Duration = Duration::from_millis(33);
/// Decimals to which a step is exact.
const STEP_DECIMALS: usize = 9;

/// The open scene, where its driver is, and how it goes on from there.
#[derive(Debug)]
pub(crate) struct Player {
    pub(crate) open_scene: OpenScene,
    pub(crate) steps: StepLadder,
    pub(crate) playback: Playback,
    /// When the last frame was due.
    frame: Duration,
    /// When the last state was weighed, and where that was; `None` before the first one.
    weighed: Option<(Duration, Edition, f64)>,
}

impl Player {
    /// A scene, paused where it opens.
    pub(crate) fn new(opened: Opened) -> Self {
        let open_scene = OpenScene::new(opened);
        Player {
            steps: steps_of(&open_scene),
            playback: Playback::new(),
            open_scene,
            frame: Duration::ZERO,
            weighed: None,
        }
    }

    /// The same scene in another form: the driver stands where it stood, as far as it can be there. Gives back the form
    /// that it had.
    pub(crate) fn exchange(&mut self, open_scene: OpenScene, now: Duration) -> OpenScene {
        let (at, turned) = (self.open_scene.at(), self.turns());
        let time = self.open_scene.time();
        let before = std::mem::replace(&mut self.open_scene, open_scene);
        // A file that was read again may have a slide for a driver where it had a link.
        if turned != self.turns() {
            self.steps = steps_of(&self.open_scene);
        }
        match time.filter(|_| self.open_scene.timetable().is_some()) {
            Some(time) => self.arrive_at(time, now),
            None => self.arrive(self.open_scene.driver_range().clamp(at), now),
        }
        before
    }

    fn turns(&self) -> bool {
        self.open_scene.driver_range().turns()
    }

    // ---- where the driver is

    /// The driver is here now, and goes on from here if it is playing.
    pub(crate) fn arrive(&mut self, at: f64, now: Duration) {
        self.open_scene.go(at);
        self.rebase(now);
    }

    /// The same of a time of its motion.
    pub(crate) fn arrive_at(&mut self, time: f64, now: Duration) {
        self.open_scene.go_to_time(time);
        self.rebase(now);
    }

    /// The same of a time that is pointed at.
    pub(crate) fn lead_to_time(&mut self, time: f64, now: Duration) {
        if let Some(timetable) = self.open_scene.timetable() {
            self.arrive_at(timetable.on_grid(time), now);
        }
    }

    /// What playing goes along.
    pub(crate) fn track(&self) -> Track {
        match self.open_scene.timetable() {
            Some(timetable) => Track {
                span: timetable.period(),
                shuttle: None,
                speed: 1.0,
            },
            None => self.open_scene.driver_range().track(),
        }
    }

    /// Where on that it is; off its motion the driver is where that begins.
    fn place(&self) -> f64 {
        match self.open_scene.timetable() {
            Some(_) => self.open_scene.time().unwrap_or(0.0),
            None => self.open_scene.at(),
        }
    }

    /// Goes to a coordinate, or to the place that is meant by it; that place.
    pub(crate) fn jump(&mut self, at: f64, now: Duration) -> Result<f64, OutOfRange> {
        let reached = self.open_scene.driver_range().reach(at)?;
        self.arrive(reached, now);
        Ok(reached)
    }

    /// Goes to where the scene opens.
    pub(crate) fn go_to_opening(&mut self, now: Duration) {
        if self.open_scene.timetable().is_some() {
            return self.arrive_at(0.0, now);
        }
        let driver_range = self.open_scene.driver_range();
        self.arrive(driver_range.clamp(driver_range.opening()), now);
    }

    /// Moves on by a step, as far as the motion goes; whether it goes so far.
    pub(crate) fn step(&mut self, by: f64, now: Duration) -> bool {
        let wanted = rounded(self.open_scene.at() + by, STEP_DECIMALS);
        let reached = self.open_scene.driver_range().clamp(wanted);
        self.arrive(reached, now);
        reached == wanted
    }

    // ---- playing

    /// Plays, or pauses. Pausing leaves the driver where the last frame showed it.
    pub(crate) fn toggle(&mut self, now: Duration) {
        if self.playback.is_playing() {
            self.playback.pause();
        } else {
            self.playback.play(now, self.place());
            self.frame = now;
        }
    }

    /// What is played goes on from here: time has passed that nobody has seen.
    pub(crate) fn rebase(&mut self, now: Duration) {
        self.playback.rebase(now, self.place());
    }

    /// Turns round.
    pub(crate) fn reverse(&mut self, now: Duration) {
        self.playback.reverse(now, self.place());
    }

    /// The next faster pace, if there is one.
    pub(crate) fn faster(&mut self, now: Duration) {
        self.playback.faster(now, self.place());
    }

    /// The next slower pace, if there is one.
    pub(crate) fn slower(&mut self, now: Duration) {
        self.playback.slower(now, self.place());
    }

    /// The same where frames were not looked for either.
    pub(crate) fn resume(&mut self, now: Duration) {
        self.rebase(now);
        self.frame = now;
    }

    /// Moves to where what is played is now.
    pub(crate) fn follow(&mut self, now: Duration) {
        let Some(place) = self.playback.position(now, &self.track()) else {
            return;
        };
        self.frame = now;
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

    /// When the next frame is due; never while paused.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        self.playback.is_playing().then(|| self.frame + FRAME)
    }

    /// Measures what a state costs, where that is worth it: of another scene at once, of another state
    /// after a while.
    pub(crate) fn weigh(&mut self, now: Duration) {
        let (edition, at) = (self.open_scene.edition(), self.open_scene.at());
        let weighed = self.weighed.as_ref();
        let is_due = weighed.is_none_or(|&(then, ref scene, place)| {
            scene != edition || (place != at && now >= then + cost::PAUSE)
        });
        if is_due {
            self.weighed = Some((now, edition.clone(), at));
            self.open_scene.weigh();
        }
    }
}

/// The steps that fit the driver.
fn steps_of(open_scene: &OpenScene) -> StepLadder {
    if open_scene.driver_range().turns() {
        StepLadder::of_angle()
    } else {
        StepLadder::of_length(open_scene.driver_range().span())
    }
}
