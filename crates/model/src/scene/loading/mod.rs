//! Loads and springs, with their values over a coordinate.

pub(super) mod loads;
pub(super) mod profile;
pub(super) mod spring;
