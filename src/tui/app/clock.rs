//! Time that passes: what is played moves, a study goes on, and what a state costs is measured.

use super::super::views::Need;
use super::goal_run::GoalRun;
use super::{App, Mode};
use crate::tui::player::FRAME;
use crate::tui::views::accuracy::study_run::{Phase, StudyRun, Ticker};
use crate::tui::views::candidates::list::CandidateList;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

impl App {
    /// Time has passed: if a frame is due, what is played moves to where it is now. A study goes on.
    pub(crate) fn tick(&mut self, now: Duration) {
        if self.is_working() {
            self.study_run.work();
            // What has been measured may take fewer lines than what had not.
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
        self.look_at_file(now, false);
        self.take_in(now);
    }

    /// Measures what a state costs, where that is worth it.
    pub(crate) fn weigh(&mut self) {
        self.player.weigh(self.now);
    }

    /// When to call [`App::tick`]: for the next frame, and when what is said has been read.
    pub(crate) fn next_frame(&self) -> Option<Duration> {
        // While another scene is looked for, this one waits.
        let frame = match self.shell.mode {
            Mode::Pick(_) => None,
            Mode::Candidates => {
                let moves = |list: &&CandidateList| list.is_playing() || list.percent().is_some();
                let list = self.candidates.as_ref().filter(moves);
                list.map(|_| self.now + FRAME)
            }
            Mode::GoalRun => {
                let run = self.goal_run.as_ref();
                let searching = run.and_then(GoalRun::percent).map(|_| self.now + FRAME);
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

    /// The program was stopped meanwhile: playing goes on from where it was.
    pub(crate) fn wake(&mut self, now: Duration) {
        self.player.rebase(now);
        if let Some(list) = &mut self.candidates {
            list.rebase(now);
        }
    }

    /// Whether there is work to do between two frames, whoever waits: only while it stands.
    pub(crate) fn is_working(&self) -> bool {
        self.study_run.phase() == Phase::Running && self.is_needed(Need::Study)
    }

    /// Takes the time of studies from another clock.
    pub(crate) fn set_clock(&mut self, clock: Ticker) {
        self.study_run = StudyRun::new(clock);
    }
}

/// The clock by which studies are timed.
pub(super) fn wall_clock() -> Duration {
    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGUN.elapsed()
}
