//! The driver's position over time, for a scene with a motion law.

use crate::MotionLaw;
use crate::quantity::{Clock, DriverState};
use crate::scene::Scene;
use crate::solver::Range;
use crate::tui::figures::format::{MAX_COORDINATE_DECIMALS, rounded};

/// The motion of a scene's driver over time.
#[derive(Clone, Debug)]
pub(crate) struct Timetable {
    clock: Clock,
    law: MotionLaw,
    range: Range,
    /// The number of decimals to which times are rounded during playback, so that the displayed
    /// time is the solved one.
    decimals: usize,
}

/// Minimum number of time steps in a period, as a power of ten.
const PLACES: f64 = 3.0;

impl Timetable {
    /// Creates the timetable of a scene; `None` for a driver with constant speed.
    pub(crate) fn new(scene: &Scene, range: Range) -> Option<Timetable> {
        let (law, clock) = (scene.motion.clone()?, Clock::of(scene)?);
        let digits = law.period().log10().floor();
        let decimals = (0..MAX_COORDINATE_DECIMALS).find(|&d| d as f64 + digits >= PLACES);
        Some(Timetable {
            clock,
            law,
            range,
            decimals: decimals.unwrap_or(MAX_COORDINATE_DECIMALS),
        })
    }

    /// Returns the period of the motion, in s.
    pub(crate) fn period(&self) -> f64 {
        self.law.period()
    }

    /// Returns the driver state at a time.
    pub(crate) fn driver_state(&self, time: f64) -> DriverState {
        let moment = self.clock.moment(time, self.range);
        DriverState {
            at: moment.at,
            pace: Some(moment),
        }
    }

    /// Returns the driver state at an exact coordinate, with the rates at `time`. Without a time,
    /// the rates are those of the scene's constant speed.
    pub(crate) fn driver_state_at(&self, at: f64, time: Option<f64>) -> DriverState {
        let pace = match time {
            Some(time) => self.clock.moment(time, self.range),
            None => self.clock.passing(at),
        };
        DriverState {
            at,
            pace: Some(pace),
        }
    }

    /// Returns the time nearest to `time` at which the driver has a coordinate; `None` outside the
    /// motion.
    pub(crate) fn nearest(&self, at: f64, time: f64) -> Option<f64> {
        self.law.nearest(at, time)
    }

    /// Rounds a time as in playback.
    pub(crate) fn on_grid(&self, time: f64) -> f64 {
        rounded(time, self.decimals)
    }

    /// Formats a time since the start of the current period, in s.
    pub(crate) fn text(&self, time: f64) -> String {
        let since = time.rem_euclid(self.period());
        let text = format!("{since:.*}", self.decimals);
        // A time that rounds to a whole period starts the next one.
        match text == format!("{:.*}", self.decimals, self.period()) {
            true => format!("{:.*}", self.decimals, 0.0),
            false => text,
        }
    }
}
