//! The line behind a descriptor: of what kind it is, how fast, and how large the screen at its end.

use rustix::fs::{fstat, major, minor};
use rustix::termios::{tcgetattr, tcgetwinsize};
use std::os::fd::AsFd;

/// Device numbers of Linux: slaves of pseudo-terminals, and terminals of which the lower minor numbers
/// are virtual consoles.
const PSEUDO_TERMINALS: std::ops::RangeInclusive<u32> = 136..=143;
const TERMINALS: u32 = 4;
const FIRST_SERIAL: u32 = 64;
/// `/dev/tty` and `/dev/console`.
const OTHER_NAMES: u32 = 5;

/// What carries the bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wire {
    /// A window, a multiplexer or a network connection: termios says nothing true about its speed.
    Pseudo,
    /// A console of this machine.
    Console,
    /// A real line, set to so many bits a second.
    Serial(u32),
}

/// Bits on a serial line for each byte: one to start, eight, one to stop.
const BITS: f64 = 10.0;

impl Wire {
    /// The line behind a terminal.
    pub(crate) fn of(terminal: impl AsFd) -> Option<Wire> {
        let device = fstat(&terminal).ok()?.st_rdev;
        let speed = tcgetattr(&terminal).ok()?.output_speed();
        Some(match (major(device), minor(device)) {
            (kind, _) if PSEUDO_TERMINALS.contains(&kind) => Wire::Pseudo,
            (TERMINALS, ..FIRST_SERIAL) | (OTHER_NAMES, _) => Wire::Console,
            _ if speed == 0 => Wire::Pseudo,
            _ => Wire::Serial(speed),
        })
    }

    /// Bytes a second, where that is known.
    pub(crate) fn rate(self) -> Option<f64> {
        match self {
            Wire::Pseudo | Wire::Console => None,
            Wire::Serial(bits) => Some(f64::from(bits) / BITS),
        }
    }
}

/// Columns and rows of a terminal, and the pixels of all together; 0 for what is not told.
pub(crate) fn window(terminal: impl AsFd) -> Option<[u16; 4]> {
    let size = tcgetwinsize(terminal).ok()?;
    Some([size.ws_col, size.ws_row, size.ws_xpixel, size.ws_ypixel])
}
