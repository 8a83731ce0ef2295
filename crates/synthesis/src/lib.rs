#![doc = include_str!("../README.md")]
//!
//! # Modules
//!
//! ```text
//! task       what the linkage is to do, in numbers
//! proposal   a linkage and its moving pins at every point of the task
//! poses      dyads through three, four and five poses
//! functions  Freudenstein's equation with signed ratios
//! paths      points on a coupler curve, with given crank angles or without; cognates
//! machine    a proposal as a mechanism
//! candidate  a proposal driven through its task: defects, values, unmet wishes
//! ```
//!
//! Lengths are in the task's unit. Angles are in degrees, counter-clockwise.
#![cfg_attr(test, allow(clippy::unwrap_used, reason = "a test fails by panicking"))]

mod candidate;
mod cognates;
mod crank_motion;
mod defects;
pub mod functions;
mod machine;
mod output_misses;
mod paths;
mod poses;
mod proposal;
mod run;
mod task;
#[cfg(test)]
mod tests;

pub use candidate::{Candidate, CandidateFigures, UnmetPreference, is_inside};
pub use defects::TaskDefect;
pub use paths::PathSearch;
pub use proposal::{OpenReason, PinConstraint, PosedDyad, Proposal, Proposals};
pub use run::{Synthesis, SynthesisSettings};
pub use task::{
    FunctionTask, GivenNumber, Output, PathTask, Pose, PoseTask, Preferences, Sense, Task, TaskKind,
};
