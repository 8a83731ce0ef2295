//! Scenes: what is broken is told with line, rule and mend; what is not is read as it was written, presets
//! among them; and what lies in a file reaches no terminal as anything but text.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod broken;
mod harmless;
mod presets;
mod properties;
