//! Runs the accuracy study of the open scene in slices between frames, so that every key is
//! answered.

use crate::solver::Solver;
use crate::study::{DEFAULT_POSITIONS, Findings, Study};
use std::time::Duration;

/// Duration of one slice of work between two reads of the keyboard.
const SLICE: Duration = Duration::from_millis(25);

/// A monotonic clock with an arbitrary origin.
pub(crate) type Ticker = fn() -> Duration;

/// The phase of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Not started.
    Idle,
    /// Measuring.
    Running,
    /// Stopped before its end.
    Stopped,
    /// All measurements are complete.
    Done,
}

/// The accuracy study of a scene, empty until it is started.
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

    /// Starts the study, resumes a stopped one, or restarts a completed one.
    pub(crate) fn start_or_resume(&mut self, solver: &Solver) {
        if matches!(self.phase, Phase::Idle | Phase::Done) {
            let study = Study::new(solver, DEFAULT_POSITIONS);
            self.findings = Some(study.findings());
            self.study = Some(Box::new(study));
        }
        self.phase = Phase::Running;
    }

    /// Stops a running study.
    pub(crate) fn stop(&mut self) {
        if self.phase == Phase::Running {
            self.phase = Phase::Stopped;
        }
    }

    /// Discards the study and its findings, because another scene is open.
    pub(crate) fn forget(&mut self) {
        *self = StudyRun::new(self.clock);
    }

    /// Works for one slice of time if the study is running.
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

    /// Returns the findings so far; `None` before the study is started.
    pub(crate) fn findings(&self) -> Option<&Findings> {
        self.findings.as_ref()
    }

    /// Returns the completed fraction, from 0 to 1.
    pub(crate) fn progress(&self) -> f64 {
        self.study.as_ref().map_or(0.0, |study| study.progress())
    }
}
