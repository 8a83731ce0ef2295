//! Tests the library's public API: reading and rejecting scenes, reports on solutions, and the
//! structure of the code.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod architecture;
mod broken;
mod copies;
mod harmless;
mod imports;
mod inputs;
mod leading_point;
mod lecture_requirements;
mod line_order;
mod machines;
mod presets;
mod properties;
mod report;
mod sweeps;
mod tolerance_edges;
mod working;
mod working_chains;
