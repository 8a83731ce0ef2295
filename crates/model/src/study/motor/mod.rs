//! Analyses the driver over a cycle: its torque at the worst instant, its mean and its work.
//! Further results are a flywheel, the forces on the ground, and the ram of a press.
//!
//! ```text
//! cycle_travel   the driver's travel through one cycle: full turns, or back and forth
//! marks          the places in the cycle where a load has a kink or jumps
//! spring_kinks   the places where springs have a kink
//! torque_pieces  the torque between these places, as sums of Chebyshev polynomials
//! periodic       the trapezoidal rule over the whole cycle, if it has no kinks
//! cycle          peaks, means, energies, fluctuation and shaking, computed from these
//! duty           a mechanism and its solver over the cycle
//! source         the driving torque in one state of the cycle
//! flywheel       compares a flywheel and a motor with the cycle
//! ram            a slide as the ram of a press: stroke, dwell, speed and force at a height
//! guide          the slide at any coordinate of the driver
//! over_time      the driving torque over the period of a motion over time
//! ```
//!
//! The driver's effort is called torque: N m if a link is turned, N if a slide is pushed. These
//! modules solve no mechanism themselves: the results are those of any function of the coordinate,
//! and the solver is called in one place.

mod cycle;
mod cycle_travel;
mod duty;
mod flywheel;
mod guide;
mod marks;
mod over_time;
mod periodic;
mod ram;
mod source;
mod spring_kinks;
mod torque_pieces;

pub use cycle::{Cycle, CycleShaking, DriveEffort, Fluctuation, Peak, Rule};
pub use cycle_travel::CyclePath;
pub use duty::{Duty, DutyError, is_within};
pub use flywheel::{
    Geared, MAX_FLUCTUATION, MotorDemand, MotorFit, SMALL_FLUCTUATION, fluctuation_with,
    flywheel_for,
};
pub use guide::SlidePassing;
pub(in crate::study) use marks::bends_within as load_bends;
pub use marks::repeats;
pub use over_time::{NoTimedDuty, TimedDuty, TimedInstant, TimedPart, TimedPeak};
pub use ram::{Dwell, NoRam, Ram, RamEnd, rams};
pub use source::Step;

use crate::Vec2;

/// The channels: torque, its three parts, the force on the ground and its moment.
const CHANNELS: usize = 7;
/// The number of torques, which come first; the last channel is the moment.
const TORQUES: usize = 4;
const MOMENT: usize = 6;

/// The driving torque in one state, and the force on the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// The driving torque in N m, or force in N, positive along the coordinate.
    pub torque: f64,
    /// The parts of the torque due to loads, gravity and inertia.
    pub parts: [f64; 3],
    /// The force of the mechanism on the ground in N.
    pub force: Vec2,
    /// The moment on the ground about the scene's origin in N m.
    pub moment: f64,
}

/// The conversion of a driver's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverUnits {
    /// The work in J of a torque of 1 over one unit of the driver's coordinate.
    pub joule: f64,
    /// The driver's speed in rad/s or m/s.
    pub speed: f64,
    /// The size of the mechanism in m for a turned driver, 1 for a pushed one.
    pub arm: f64,
    /// The size of the mechanism in m.
    pub reach: f64,
}

impl Default for DriverUnits {
    /// Returns the units of a slide pushed at 1 m/s in a mechanism of 1 m.
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
