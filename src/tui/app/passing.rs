//! Time that passes: what is played moves, a study goes on, and what a state costs is measured.

use super::super::cost;
use super::super::survey::{Clock, Phase, Survey};
use super::super::views::Need;
use super::{App, Mode};
use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// Time between two frames while playing.
const FRAME: Duration = Duration::from_millis(33);

impl App {
    /// Time has passed: if a frame is due, what is played moves to where it is now. A study goes on.
    pub(crate) fn tick(&mut self, now: Duration) {
        if self.is_working() {
            self.survey.work();
        }
        self.now = now;
        if self.next_frame().is_none_or(|next| now < next) {
            return;
        }
        if let Some(at) = self.playback.position(now, self.stage.course()) {
            self.frame = now;
            let at = self.stage.course().on_grid(at);
            self.stage.go(at);
        }
        self.look_at_file(now, false);
        self.take_in(now);
    }

    /// Measures what a state costs, where that is worth it: of another scene at once, of another state
    /// after a while.
    pub(crate) fn weigh(&mut self) {
        let (opened, at) = (self.opened, self.stage.at());
        let is_due = self.weighed.is_none_or(|(then, scene, place)| {
            scene != opened || (place != at && self.now >= then + cost::PAUSE)
        });
        if is_due {
            self.stage.weigh();
            self.weighed = Some((self.now, opened, at));
        }
    }

    /// When to call [`App::tick`]; never while paused.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        // While another scene is looked for, this one waits.
        let plays = self.playback.is_playing() && !matches!(self.mode, Mode::Pick(_));
        plays.then(|| self.frame + FRAME)
    }

    /// The program was stopped meanwhile: playing goes on from where it was.
    pub(crate) fn wake(&mut self, now: Duration) {
        self.playback.rebase(now, self.stage.at());
    }

    /// Whether there is work to do between two frames, whoever waits: only in its view.
    pub(crate) fn is_working(&self) -> bool {
        self.view.pane().needs() == Need::Study && self.survey.phase() == Phase::Running
    }

    /// Takes the time of studies from another clock.
    pub(crate) fn set_clock(&mut self, clock: Clock) {
        self.survey = Survey::new(clock);
    }
}

/// The clock by which studies are timed.
pub(super) fn wall_clock() -> Duration {
    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGUN.elapsed()
}
