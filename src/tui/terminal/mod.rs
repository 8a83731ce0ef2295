//! Handles the terminal: modes, keys, signals and output.
//!
//! All terminal input and output passes through this module, which knows nothing about linkages.
//! One reader parses all input (`intake`, `keyboard`), one writer writes whole frames (`painter`),
//! and one guard restores the terminal's original state (`tty`).

mod about;
mod base64;
pub(crate) mod clipboard;
mod console;
#[cfg_attr(not(target_os = "linux"), path = "no_watch.rs")]
mod file_watch;
pub(crate) mod image_escapes;
mod input_thread;
mod keyboard;
mod line;
mod painter;
mod rate_limit;
mod sgr;
mod signals;
#[cfg(test)]
mod slow_line;
mod tty;

pub use about::Terminal;
pub(crate) use console::Console;
pub(crate) use keyboard::TerminalColour;
#[cfg(test)]
pub(crate) use keyboard::{Keyboard, TerminalInput};
pub(crate) use painter::Painter;
pub(crate) use signals::{HANG_UP_SIGNAL, SignalEvent, die_of, suspend_process_group};
#[cfg(test)]
pub(crate) use slow_line::SlowLine;
pub(crate) use tty::{Tty, Wake};

use crossterm::QueueableCommand as _;

/// Appends a command of crossterm.
fn queue(bytes: &mut Vec<u8>, command: impl crossterm::Command) {
    // Writing into memory cannot fail.
    let _ = bytes.queue(command);
}
