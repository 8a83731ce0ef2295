//! Reports the system's knowledge of the terminal, without querying the terminal itself.

use super::line::{ConnectionKind, window};
use rustix::fs::{Mode, OFlags, open};
use rustix::termios::isatty;
use std::io::{stderr, stdin, stdout};
use std::os::fd::AsFd;

/// The properties of the program's terminal as known to the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terminal {
    /// Columns and rows of the screen; 0 if unknown.
    pub size: (u16, u16),
    /// Width and height of a cell in pixels, if known.
    pub cell: Option<(u16, u16)>,
    /// The speed of a real serial line, in baud.
    pub baud: Option<u32>,
    /// `true` for a console of this machine.
    pub console: bool,
}

impl Terminal {
    /// Returns the terminal of standard output, input or error, or else the controlling terminal.
    #[must_use]
    pub fn find() -> Option<Self> {
        let standard = Self::of(stdout())
            .or_else(|| Self::of(stdin()))
            .or_else(|| Self::of(stderr()));
        standard.or_else(|| {
            let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC | OFlags::NONBLOCK;
            Self::of(open("/dev/tty", flags, Mode::empty()).ok()?)
        })
    }

    fn of(stream: impl AsFd) -> Option<Self> {
        if !isatty(&stream) {
            return None;
        }
        let [columns, rows, width, height] = window(&stream)?;
        let cell = |pixels: u16, cells: u16| pixels.checked_div(cells).filter(|&n| n > 0);
        let line = ConnectionKind::of(&stream);
        Some(Terminal {
            size: (columns, rows),
            cell: cell(width, columns).zip(cell(height, rows)),
            baud: match line {
                Some(ConnectionKind::Serial(baud)) => Some(baud),
                Some(ConnectionKind::Pseudo | ConnectionKind::Console) | None => None,
            },
            console: line == Some(ConnectionKind::Console),
        })
    }
}
