//! What tests that go by chance have in common, and those that concern several modules.

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

pub(crate) use chance::Chance;
#[cfg(feature = "tui")]
pub(crate) use fuzz::{Fuzz, shape};
