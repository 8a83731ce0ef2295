//! From a motion that is wanted to linkages that do it, every defect named.
//!
//! A [`Task`] is a motion in numbers: poses of a body, a function of the crank's angle, or a path. A method proposes
//! linkages: each a [`Proposal`], two pivots and where the two moving pins are at every point of the task. None is
//! believed: [`Candidate::judge`] builds it as any mechanism is built, drives it through the task with the solver, and
//! names what fails between which two points. What comes out is in order: first those that do the task, then, apart,
//! those that do not, each with the reason.
//!
//! ```text
//! task       what is wanted, in numbers: no text
//! proposal   a linkage and its moving pins at every point of the task
//! poses      dyads through three, four and five poses
//! functions  Freudenstein's equation with signed ratios
//! paths      points on a curve of the coupler, with times and without; cognates
//! machine    a proposal as a scene
//! goals      the task as goals on that scene
//! candidate  a proposal that was driven through its task: defects, figures, wishes
//! ```
//!
//! Lengths are in the task's unit, angles in degrees, counter-clockwise, as everywhere in this library.

mod candidate;
mod cognates;
mod defects;
#[cfg(test)]
mod driven_functions;
pub mod functions;
mod goals;
mod machine;
mod output_misses;
mod paths;
#[cfg(test)]
mod planted;
mod poses;
mod proposal;
#[cfg(test)]
mod round_trips;
mod run;
mod task;
#[cfg(test)]
mod tests;
mod way;

pub(crate) use candidate::is_inside;
pub use candidate::{Candidate, CandidateFigures, MissedWish};
pub use defects::TaskDefect;
pub use goals::SceneGoals;
pub use machine::{SceneTitles, scene_text};
pub use paths::PathSearch;
pub use proposal::{OpenReason, Partner, PosedDyad, Proposal, Proposals};
pub use run::{Synthesis, SynthesisOrder};
pub use task::{
    FunctionTask, Given, Output, PathTask, Pose, PoseTask, Sense, Task, TaskKind, Wishes,
};
