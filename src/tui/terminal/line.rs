//! Determines the kind, speed and screen size of the line behind a descriptor.

use rustix::fs::{fstat, major, minor};
use rustix::termios::{tcgetattr, tcgetwinsize};
use std::os::fd::AsFd;

/// Linux device numbers: pseudo-terminal slaves, and terminals, whose lower minor numbers are
/// virtual consoles.
const PSEUDO_TERMINALS: std::ops::RangeInclusive<u32> = 136..=143;
const TERMINALS: u32 = 4;
const FIRST_SERIAL: u32 = 64;
/// `/dev/tty` and `/dev/console`.
const OTHER_NAMES: u32 = 5;

/// The kind of line that carries the bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ConnectionKind {
    /// A window, a multiplexer or a network connection. Its speed in termios is meaningless.
    Pseudo,
    /// A console of this machine.
    Console,
    /// A real serial line with this speed, in bits per second.
    Serial(u32),
}

/// Bits on a serial line per byte: one start bit, eight data bits, one stop bit.
const BITS: f64 = 10.0;

impl ConnectionKind {
    /// Returns the kind of line behind a terminal.
    pub(crate) fn of(terminal: impl AsFd) -> Option<ConnectionKind> {
        let device = fstat(&terminal).ok()?.st_rdev;
        let speed = tcgetattr(&terminal).ok()?.output_speed();
        Some(match (major(device), minor(device)) {
            (kind, _) if PSEUDO_TERMINALS.contains(&kind) => ConnectionKind::Pseudo,
            (TERMINALS, ..FIRST_SERIAL) | (OTHER_NAMES, _) => ConnectionKind::Console,
            _ if speed == 0 => ConnectionKind::Pseudo,
            _ => ConnectionKind::Serial(speed),
        })
    }

    /// Returns the speed in bytes per second, if known.
    pub(crate) fn rate(self) -> Option<f64> {
        match self {
            ConnectionKind::Pseudo | ConnectionKind::Console => None,
            ConnectionKind::Serial(bits) => Some(f64::from(bits) / BITS),
        }
    }
}

/// Returns the columns and rows of a terminal and its width and height in pixels; unknown values
/// are 0.
pub(crate) fn window(terminal: impl AsFd) -> Option<[u16; 4]> {
    let size = tcgetwinsize(terminal).ok()?;
    Some([size.ws_col, size.ws_row, size.ws_xpixel, size.ws_ypixel])
}
