//! Tests that concern several modules, and helpers for random tests.

mod chance;
mod dead_centres;
mod edge;
mod equilibrium;
mod fuzz;
mod internals;
mod margin;
mod scenes;
mod speed;
mod unbalanced;
mod varied;

pub(crate) use chance::TestRng;
#[cfg(feature = "tui")]
pub(crate) use fuzz::{Fuzz, shape};
