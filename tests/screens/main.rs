//! Tests the drawing and the whole workbench in an emulated terminal, driven by key scripts.
//! Snapshots are in the folder `snapshots`; look at them before you accept new ones.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod drawing;

#[cfg(feature = "tui")]
mod accuracy;
#[cfg(feature = "tui")]
mod assemblies;
#[cfg(feature = "tui")]
mod candidates;
#[cfg(feature = "tui")]
mod claims;
#[cfg(feature = "tui")]
mod compare;
#[cfg(feature = "tui")]
mod compare_plots;
#[cfg(feature = "tui")]
mod documents;
#[cfg(feature = "tui")]
mod export;
#[cfg(feature = "tui")]
mod forces;
#[cfg(feature = "tui")]
mod frames;
#[cfg(feature = "tui")]
mod glyphs;
#[cfg(feature = "tui")]
mod habits;
#[cfg(feature = "tui")]
mod help;
#[cfg(feature = "tui")]
mod lead;
#[cfg(feature = "tui")]
mod light;
#[cfg(feature = "tui")]
mod motion;
#[cfg(feature = "tui")]
mod motor;
#[cfg(feature = "tui")]
mod panes;
#[cfg(feature = "tui")]
mod picker;
#[cfg(feature = "tui")]
mod player;
#[cfg(feature = "tui")]
mod plots;
#[cfg(feature = "tui")]
mod polygons;
#[cfg(feature = "tui")]
mod scene;
#[cfg(feature = "tui")]
mod scene_files;
#[cfg(feature = "tui")]
mod screen;
#[cfg(feature = "tui")]
mod staged_edits;
#[cfg(feature = "tui")]
mod tables;
#[cfg(feature = "tui")]
mod terminal;
#[cfg(feature = "tui")]
mod timed;
#[cfg(feature = "tui")]
mod tour;
#[cfg(feature = "tui")]
mod trust;
#[cfg(feature = "tui")]
mod words;
#[cfg(feature = "tui")]
mod workbench;
#[cfg(feature = "tui")]
mod working;
