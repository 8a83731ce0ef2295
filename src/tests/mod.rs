//! Tests that concern several modules, and helpers for random tests.

mod dead_centres;
mod edge;
mod equilibrium;
mod fuzz;
mod internals;
mod margin;
mod random;
mod scenes;
mod speed;
mod unbalanced_forces;
mod varied;

#[cfg(feature = "tui")]
pub(crate) use fuzz::{Fuzz, shape};
pub(crate) use random::TestRng;
