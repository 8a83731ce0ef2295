//! Where a motion over time goes beyond what the mechanism can do.

use crate::solver::{Range, Solver};
use crate::{LimitId, MotionLaw};

/// A motion over time that goes on where the motion of the mechanism ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionLeaves {
    /// When it comes there, in s from where the scene opens.
    pub time: f64,
    /// The driver's coordinate there, in degrees or in the scene's length unit.
    pub at: f64,
    /// The limit whose stop is passed; `None` where the mechanism cannot go on.
    pub stop: Option<LimitId>,
}

impl MotionLeaves {
    /// Where a motion first does; `None` for one that stays within.
    #[must_use]
    pub fn of(law: &MotionLaw, solver: &Solver) -> Option<MotionLeaves> {
        let motion = solver.motion();
        let Range::Limited { low, high } = motion.range else {
            return None;
        };
        let [time, at] = law.leaves([low, high])?;
        let stop = motion.stops.iter().find(|stop| stop.at == at);
        Some(MotionLeaves {
            time,
            at,
            stop: stop.map(|stop| stop.limit),
        })
    }
}
