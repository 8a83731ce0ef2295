//! What tests that go by chance have in common, and those that concern several modules.

mod chance;
mod edge;
mod fuzz;
mod scenes;
mod unbalanced;

pub(crate) use chance::Chance;
#[cfg(feature = "tui")]
pub(crate) use fuzz::{Fuzz, shape};
