//! Tolerances and clearances.

pub(super) mod deviations;
pub(super) mod general_tolerance;
pub(super) mod typed_tolerance;
