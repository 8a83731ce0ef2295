//! What is told of a solution: the working by hand, sweeps, and speed against error.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod accuracy;
mod sweeps;
mod working;
mod working_chains;
