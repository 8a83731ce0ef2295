//! Properties: plant a pose, measure the lengths, solve, recover the pose.
//!
//! The poses lean towards toggles, equal links and neighbours within 32 ulp. What is recovered is
//! judged by the measure of the group, sin(mu): an error of one rounding in a length moves the inner
//! joint by L u / sin(mu), and by no more than about L sqrt(u) where sin(mu) vanishes.

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
