//! Samples the driver's whole motion for traces and arrow scales.

use crate::quantity::{Clock, DriverState};
use crate::scene::Scene;
use crate::solver::{Range, Solver};
use std::f64::consts::PI;

/// Samples per turn, or per motion between limits. Half a degree keeps the chords of a circle
/// within 1e-5 of its radius.
const SAMPLES: u32 = 720;

/// Number of samples of a trail: a quarter of a turn.
pub(in crate::drawing) const TRAIL: usize = SAMPLES as usize / 4;

/// The samples of a motion.
#[derive(Clone, Debug)]
pub(in crate::drawing) struct Course {
    low: f64,
    high: f64,
    count: usize,
    closed: bool,
}

impl Course {
    /// Returns the samples of [`course`].
    pub(in crate::drawing) fn of(scene: &Scene, solver: &Solver) -> Course {
        let (low, high, count, closed) = ends(scene, solver);
        Course {
            low,
            high,
            count: count as usize,
            closed,
        }
    }

    /// Returns the number of samples up to a coordinate, with a fraction; `None` if the coordinate
    /// is not finite.
    pub(in crate::drawing) fn sample(&self, at: f64) -> Option<f64> {
        let share = (at - self.low) / (self.high - self.low);
        let share = match self.closed {
            true => share.rem_euclid(1.0),
            false => (1.0 - 2.0 * share.clamp(0.0, 1.0)).acos() / PI,
        };
        share.is_finite().then_some(share * self.count as f64)
    }

    /// Returns the `count` samples before a place, the farthest first; `backwards` if the motion
    /// comes from the later samples. A motion between limits has fewer near its ends.
    pub(in crate::drawing) fn behind(
        &self,
        place: f64,
        count: usize,
        backwards: bool,
    ) -> impl Iterator<Item = usize> + use<> {
        let Course {
            count: all, closed, ..
        } = *self;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of samples"
        )]
        let nearest = match backwards {
            true => place.ceil() as usize,
            false => place.floor() as usize,
        };
        (0..count)
            .rev()
            .filter_map(move |back| match (backwards, closed) {
                (false, true) => Some((nearest + all - back % all) % all),
                (true, true) => Some((nearest + back) % all),
                (false, false) => nearest.checked_sub(back),
                (true, false) => Some(nearest + back).filter(|k| *k <= all),
            })
    }
}

/// Returns the driver's coordinates along the motion, both ends included.
pub(in crate::drawing) fn course(
    scene: &Scene,
    solver: &Solver,
) -> impl Iterator<Item = DriverState> + use<> {
    let (low, high, count, closed) = ends(scene, solver);
    (0..=count).map(move |k| {
        let share = f64::from(k) / f64::from(count);
        // Closer towards limits, where points change fastest.
        let share = if closed {
            share
        } else {
            (1.0 - (PI * share).cos()) / 2.0
        };
        DriverState::at((low + (high - low) * share).min(high))
    })
}

/// Returns the driver's coordinates along the motion. If `is_timed` and the scene has a motion over
/// time, they are its moments, with their rates.
pub(in crate::drawing) fn paced_course(
    scene: &Scene,
    solver: &Solver,
    is_timed: bool,
) -> Vec<DriverState> {
    let clock = Clock::of(scene).filter(|_| is_timed && scene.motion.is_some());
    let Some(clock) = clock else {
        return course(scene, solver).collect();
    };
    let range = solver.motion().range;
    let (start, end) = clock.span(range);
    let moments = (0..=SAMPLES).map(|k| {
        let share = f64::from(k) / f64::from(SAMPLES);
        let moment = clock.moment(start + (end - start) * share, range);
        DriverState {
            at: moment.at,
            pace: Some(moment),
        }
    });
    moments.collect()
}

/// Returns where the motion begins and ends, its number of samples, and whether it closes.
pub(in crate::drawing) fn ends(scene: &Scene, solver: &Solver) -> (f64, f64, u32, bool) {
    let start = scene.mechanism.driver().start;
    match solver.motion().range {
        Range::Full { period } => {
            let count = if period > crate::angle::TURN {
                2 * SAMPLES
            } else {
                SAMPLES
            };
            (start, start + period, count, true)
        }
        Range::Limited { low, high } => (low, high, SAMPLES, false),
    }
}
