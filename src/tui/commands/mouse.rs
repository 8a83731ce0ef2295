//! Mouse events, as reported by the terminal.

use ratatui::layout::Position;

/// A mouse event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mouse {
    pub(crate) kind: MouseEventKind,
    /// The cell, counted from the upper left one.
    pub(crate) at: Position,
}

/// The kind of an event of the first button or the wheel; other buttons are not reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MouseEventKind {
    Press,
    /// Moved while the button is held down.
    Drag,
    Release,
    WheelUp,
    WheelDown,
}
