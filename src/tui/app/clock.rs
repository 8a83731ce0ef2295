//! Advances playback, studies and cost measurements with time.

use super::{App, Mode, View};
use crate::tui::player::FRAME;
use crate::tui::views::accuracy::study_run::{Phase, StudyRun, Ticker};
use crate::tui::views::candidates::list::CandidateList;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

impl App {
    /// Advances the time: continues a study, and moves the played scene if a frame is due.
    pub(crate) fn tick(&mut self, now: Duration) {
        if self.is_working() {
            self.views.study_run.work();
            // Finished measurements may take fewer lines than pending ones.
            self.scroll_by(0);
        }
        self.now = now;
        if let (Mode::Candidates, Some(list)) = (&self.shell.mode, &mut self.candidates) {
            list.follow(now);
        }
        self.shell.forget_message(now);
        if self.next_frame().is_none_or(|next| now < next) {
            return;
        }
        self.player.follow(now);
        self.refresh();
        self.check_file(now, false);
        self.drain_results(now);
    }

    /// Measures the cost of solving a state, if that is worthwhile.
    pub(crate) fn measure_cost(&mut self) {
        self.player.measure_cost(self.now);
    }

    /// Returns the time of the next [`App::tick`]: for the next frame, or to remove an expired
    /// message.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        // This scene pauses while the user picks another one.
        let frame = match self.shell.mode {
            Mode::AssemblyChoice(_) => None,
            Mode::Candidates => {
                let moves = |list: &&CandidateList| list.is_playing() || list.percent().is_some();
                let list = self.candidates.as_ref().filter(moves);
                list.map(|_| self.now + FRAME)
            }
            Mode::GoalRun(ref run) => {
                let searching = run.percent().map(|_| self.now + FRAME);
                [self.player.next_frame(), searching]
                    .into_iter()
                    .flatten()
                    .min()
            }
            _ => self.player.next_frame(),
        };
        let message = self.shell.message_ends();
        [frame, message].into_iter().flatten().min()
    }

    /// Returns `true` if there is a message that is not known to be on the screen yet.
    pub(crate) fn message_awaits_frame(&self) -> bool {
        self.shell.message_awaits_frame()
    }

    /// Returns `true` if the playback alone changes the screen until the next key.
    pub(crate) fn only_moves(&self) -> bool {
        let is_playing = self.player.playback.is_playing() && self.shell.mode.is_normal();
        is_playing && !self.is_working() && self.shell.message.is_none()
    }

    /// Resumes playback from the same position after the process was suspended.
    pub(crate) fn wake(&mut self, now: Duration) {
        self.player.rebase(now);
        if let Some(list) = &mut self.candidates {
            list.rebase(now);
        }
    }

    /// Returns `true` if a running study needs computing time between frames while it is shown.
    pub(crate) fn is_working(&self) -> bool {
        self.views.study_run.phase() == Phase::Running
            && self.visible_views().contains(&View::Accuracy)
    }

    /// Sets the clock for studies.
    pub(crate) fn set_clock(&mut self, clock: Ticker) {
        self.views.study_run = StudyRun::new(clock);
    }
}

/// Returns the time since the first call, for timing studies.
pub(super) fn wall_clock() -> Duration {
    static EPOCH: LazyLock<Instant> = LazyLock::new(Instant::now);
    EPOCH.elapsed()
}
