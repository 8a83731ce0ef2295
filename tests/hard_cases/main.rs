//! Hard cases: inputs that break the usual methods of computing a linkage, with exact values from
//! 60-digit arithmetic.
//!
//! The name of a test starts with the number of its case. The module `others` draws random cases of
//! the same kinds. `cargo test --test hard_cases -- --nocapture` prints how close the errors are to
//! their limits.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

#[path = "../support/bits.rs"]
mod bits;
#[path = "../exact/mod.rs"]
mod exact;

mod change_points;
mod closed_form;
mod driver;
mod edge_rates;
mod edges;
mod equal_lengths;
mod far_ends;
mod led_change_points;
mod led_through;
mod lifts;
mod limits;
mod many_links;
mod others;
mod ratios;
mod refusals;
mod rig;
mod sizes;
mod triangles;
