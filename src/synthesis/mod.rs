//! Synthesis of linkages for a motion, and its results as scenes.
//!
//! The searches are a crate of their own, re-exported here. This module writes a proposal as a scene file, and its task
//! as goals on that scene.

mod goals;
mod machine;
#[cfg(test)]
mod tests;

pub use self::goals::SceneGoals;
pub use self::machine::{SceneTitles, scene_text};
pub use ::synthesis::*;
