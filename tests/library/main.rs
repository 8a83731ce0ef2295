//! The library from outside: scenes as they are read and refused, what is told of a solution, and the house that it
//! is.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod architecture;
mod broken;
mod harmless;
mod line_order;
mod machines;
mod presets;
mod properties;
mod report;
mod sweeps;
mod told;
mod tolerance_edges;
mod working;
mod working_chains;
