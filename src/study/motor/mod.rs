//! The motor over a cycle: what the driver must do at its worst instant, in the mean, and in all; what
//! evens it out; what the ground feels; and, of a press, what its ram does.
//!
//! ```text
//! course     the driver's way through one cycle: round, or there and back
//! marks      where on it a load bends or jumps
//! bends      where springs do
//! pieces     between these, what the driver must do as sums of Chebyshev polynomials
//! periodic   where nothing bends: the trapezoid rule over the whole cycle
//! cycle      peaks, means, energies, fluctuation, shaking: read from these
//! duty       a mechanism and its solver over the cycle
//! source     what is asked in one state of it
//! fitting    a flywheel and a motor against it
//! ram        what a slide does as the ram of a press: stroke, dwell, speed and force at a height
//! guide      the slide wherever the driver is
//! timed      what the driver must do over the period of a motion over time
//! ```
//!
//! Torque stands for what the driver does: N m where a link is turned, N where a slide is pushed.
//! Nothing here solves a mechanism: the figures are those of any function of the coordinate, and the
//! solver is asked for it in one place.

mod bends;
mod course;
mod cycle;
mod duty;
mod flywheel;
mod guide;
mod marks;
mod periodic;
mod pieces;
mod ram;
mod source;
mod timed;

pub use course::Course;
pub use cycle::{Cycle, CycleShaking, DriveEffort, Fluctuation, Peak, Rule};
pub use duty::{Duty, NoDuty, is_within};
pub use flywheel::{
    Geared, LARGEST_FLUCTUATION, MotorDemand, MotorFit, SMALL_FLUCTUATION, fluctuation_with,
    flywheel_for,
};
pub use guide::Passing;
pub(in crate::study) use marks::bends_within as load_bends;
pub use marks::repeats;
pub use ram::{Dwell, NoRam, Ram, RamEnd, rams};
pub use source::Step;
pub use timed::{NoTimedDuty, TimedDuty, TimedInstant, TimedPart, TimedPeak};

use crate::Vec2;

/// Torque, its three parts, the force on the ground and its moment.
const CHANNELS: usize = 7;
/// So many of them, the first, are torques; the last is the moment.
const TORQUES: usize = 4;
const MOMENT: usize = 6;

/// What the driver must do in one state, and what the ground feels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// What the driver must do, in N m or N, positive along its coordinate.
    pub torque: f64,
    /// What of it goes into loads, gravity and inertia.
    pub parts: [f64; 3],
    /// The force of the mechanism on the ground in N.
    pub force: Vec2,
    /// Its moment about the scene's origin in N m.
    pub moment: f64,
}

/// What the units of a driver mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverUnits {
    /// The work in J of a torque of 1 over one unit of the driver's coordinate.
    pub joule: f64,
    /// The driver's speed in rad/s or m/s.
    pub speed: f64,
    /// The size of the mechanism in m where the driver is turned, 1 where it is pushed.
    pub arm: f64,
    /// The size of the mechanism in m.
    pub reach: f64,
}

impl Default for DriverUnits {
    /// Of a slide that is pushed at 1 m/s in a mechanism of 1 m.
    fn default() -> Self {
        DriverUnits {
            joule: 1.0,
            speed: 1.0,
            arm: 1.0,
            reach: 1.0,
        }
    }
}

impl Effort {
    fn channels(&self) -> [f64; CHANNELS] {
        let [load, gravity, inertia] = self.parts;
        let Vec2 { x, y } = self.force;
        [self.torque, load, gravity, inertia, x, y, self.moment]
    }
}
