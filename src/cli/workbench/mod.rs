//! Opens the workbench, reads its configuration, and reports the detected terminal.

mod args;
#[cfg(feature = "tui")]
mod config;
#[cfg(feature = "tui")]
mod diagnose;
#[cfg(feature = "tui")]
mod open;
#[cfg(not(feature = "tui"))]
#[path = "unavailable.rs"]
mod open;

pub(super) use args::WorkbenchArgs;
pub(super) use open::open;
#[cfg(feature = "tui")]
pub(super) use {
    config::{config, language},
    diagnose::diagnose,
    open::open_task,
};
