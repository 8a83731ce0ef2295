//! When the driver is where, of a scene with a motion over time.

use crate::MotionLaw;
use crate::quantity::{Clock, DriverStand};
use crate::scene::Scene;
use crate::solver::Range;
use crate::tui::figures::format::{FINEST, rounded};

/// The motion of a scene's driver over time.
#[derive(Clone, Debug)]
pub(crate) struct Timetable {
    clock: Clock,
    law: MotionLaw,
    range: Range,
    /// Decimals that times are rounded to while playing, so that what is shown is what was solved.
    decimals: usize,
}

/// A period has at least so many decimal places in it, as a power of ten.
const PLACES: f64 = 3.0;

impl Timetable {
    /// `None` for a driver that runs by its speed.
    pub(crate) fn new(scene: &Scene, range: Range) -> Option<Timetable> {
        let (law, clock) = (scene.motion.clone()?, Clock::of(scene)?);
        let digits = law.period().log10().floor();
        let decimals = (0..FINEST).find(|&d| d as f64 + digits >= PLACES);
        Some(Timetable {
            clock,
            law,
            range,
            decimals: decimals.unwrap_or(FINEST),
        })
    }

    /// The time after which the motion begins anew, in s.
    pub(crate) fn period(&self) -> f64 {
        self.law.period()
    }

    /// Where the driver is at a time, and how it passes there.
    pub(crate) fn stand(&self, time: f64) -> DriverStand {
        let moment = self.clock.moment(time, self.range);
        DriverStand {
            at: moment.at,
            pace: Some(moment),
        }
    }

    /// The same where it is at a coordinate, which no time makes less exact; off the motion at the scene's speed.
    pub(crate) fn stand_at(&self, at: f64, time: Option<f64>) -> DriverStand {
        let pace = match time {
            Some(time) => self.clock.moment(time, self.range),
            None => self.clock.passing(at),
        };
        DriverStand {
            at,
            pace: Some(pace),
        }
    }

    /// When it is at a coordinate, next to a time; `None` off the motion.
    pub(crate) fn nearest(&self, at: f64, time: f64) -> Option<f64> {
        self.law.nearest(at, time)
    }

    /// A time as playing shows it.
    pub(crate) fn on_grid(&self, time: f64) -> f64 {
        rounded(time, self.decimals)
    }

    /// A time from where the motion last began, in s.
    pub(crate) fn text(&self, time: f64) -> String {
        let since = time.rem_euclid(self.period());
        let text = format!("{since:.*}", self.decimals);
        // What rounds to a whole period is the beginning of the next.
        match text == format!("{:.*}", self.decimals, self.period()) {
            true => format!("{:.*}", self.decimals, 0.0),
            false => text,
        }
    }
}
