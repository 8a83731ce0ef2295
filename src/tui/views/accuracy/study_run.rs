//! The study of the open scene, done in slices between frames, so that every key is answered.

use crate::solver::Solver;
use crate::study::{Findings, Study, USUAL_POSITIONS};
use std::time::Duration;

/// Work between two looks at the keyboard.
const SLICE: Duration = Duration::from_millis(25);

/// A clock that only goes forward; its beginning means nothing.
pub(crate) type Ticker = fn() -> Duration;

/// How far a study has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Not begun.
    Idle,
    /// Measuring.
    Running,
    /// Stopped before its end.
    Stopped,
    /// Everything was measured.
    Done,
}

/// The study of a scene, if it was asked for.
#[derive(Debug)]
pub(crate) struct StudyRun {
    clock: Ticker,
    phase: Phase,
    study: Option<Box<Study>>,
    findings: Option<Findings>,
}

impl StudyRun {
    pub(crate) fn new(clock: Ticker) -> Self {
        StudyRun {
            clock,
            phase: Phase::Idle,
            study: None,
            findings: None,
        }
    }

    /// Begins, goes on where it was stopped, or measures again where all was measured.
    pub(crate) fn go_on(&mut self, solver: &Solver) {
        if matches!(self.phase, Phase::Idle | Phase::Done) {
            let study = Study::new(solver, USUAL_POSITIONS);
            self.findings = Some(study.findings());
            self.study = Some(Box::new(study));
        }
        self.phase = Phase::Running;
    }

    /// Stops where it is, if it is running; whether it was.
    pub(crate) fn stop(&mut self) -> bool {
        let was_running = self.phase == Phase::Running;
        if was_running {
            self.phase = Phase::Stopped;
        }
        was_running
    }

    /// Another scene: nothing is known of it.
    pub(crate) fn forget(&mut self) {
        *self = StudyRun::new(self.clock);
    }

    /// Works for a slice of time, if there is anything to do.
    pub(crate) fn work(&mut self) {
        let (Phase::Running, Some(study)) = (self.phase, &mut self.study) else {
            return;
        };
        let clock = self.clock;
        if !study.advance(&mut || clock(), SLICE) {
            self.phase = Phase::Done;
        }
        self.findings = Some(study.findings());
    }

    pub(crate) fn phase(&self) -> Phase {
        self.phase
    }

    /// What was found so far; `None` before it has begun.
    pub(crate) fn findings(&self) -> Option<&Findings> {
        self.findings.as_ref()
    }

    /// How much is done, from 0 to 1.
    pub(crate) fn progress(&self) -> f64 {
        self.study.as_ref().map_or(0.0, |study| study.progress())
    }
}
