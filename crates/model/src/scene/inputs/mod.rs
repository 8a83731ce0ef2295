//! The driver, the inputs that follow it or a point, its motion over time, and its motor.

pub(super) mod input;
pub(super) mod leading_point;
pub(super) mod motor;
pub(super) mod timed_inputs;
pub(super) mod timed_motion;
