//! Property tests with a known solution: choose a pose, measure its lengths, solve, and recover the
//! pose.
//!
//! The poses favour toggles, equal links and neighbours within 32 ulp. The tolerance for the
//! recovered pose follows from the measure of the group, sin(mu): a rounding error in a length
//! moves the inner joint by L u / sin(mu), and by at most about L sqrt(u) where sin(mu) vanishes.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

#[path = "../support/bits.rs"]
mod bits;
#[path = "../support/mod.rs"]
mod support;

mod chains;
mod coupled;
mod dyads;
mod four_bar;
mod invariance;
mod mobility;
mod passages;
mod plant;
mod planted;
mod transmission;
