//! Finds where a motion over time exceeds the mechanism's range.

use crate::solver::{Range, Solver};
use crate::{LimitId, MotionLaw};

/// A motion over time that continues beyond the mechanism's range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionOutOfRange {
    /// The time at which it leaves the range, in s from the scene's start.
    pub time: f64,
    /// The driver's coordinate at that time, in degrees or in the scene's length unit.
    pub at: f64,
    /// The limit whose stop is passed; `None` where the mechanism itself cannot go further.
    pub stop: Option<LimitId>,
}

impl MotionOutOfRange {
    /// Returns where a motion law first leaves the range; `None` if it stays within.
    #[must_use]
    pub fn of(law: &MotionLaw, solver: &Solver) -> Option<MotionOutOfRange> {
        let motion = solver.motion();
        let Range::Limited { low, high } = motion.range else {
            return None;
        };
        let [time, at] = law.exit_interval([low, high])?;
        let stop = motion.stops.iter().find(|stop| stop.at == at);
        Some(MotionOutOfRange {
            time,
            at,
            stop: stop.map(|stop| stop.limit),
        })
    }
}
