//! Scene files, and the scenes that are built in.

pub mod presets;

#[doc(inline)]
pub use model::scene::*;

#[cfg(test)]
mod tests;
