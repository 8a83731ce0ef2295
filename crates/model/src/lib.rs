//! Scenes of planar linkages, their values and studies: the part of krank between the solver and its output.
//!
//! The crate `krank` re-exports it and adds reports, drawings, the workbench and the command line.
//!
//! ```text
//! document, expression  TOML with source positions; formulas with units
//!   -> scene            a mechanism with names and units; errors with line and fix
//!   -> assembly, explain, quantity   assemblies; errors of the solver; all values with a name and a unit
//!   -> study            cycles, tolerances, motors and designs
//! wording               all messages, in English and Turkish
//! ```
#![cfg_attr(test, allow(clippy::unwrap_used, reason = "a test fails by panicking"))]

pub mod assembly;
#[doc(hidden)]
pub mod document;
mod explain;
#[doc(hidden)]
pub mod expression;
#[doc(hidden)]
pub mod nearest;
pub mod quantity;
pub mod scene;
pub mod study;
#[doc(hidden)]
pub mod wording;

use kinematics::*;
use kinematics::{arithmetic, mechanism, numeric, parallel};
