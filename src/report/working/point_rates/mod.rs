//! Writes the motion of points and the instant centres.

pub(super) mod centres;
pub(super) mod kennedy;
pub(super) mod point_parts;
pub(super) mod points;
