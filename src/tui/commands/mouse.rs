//! What is done with the mouse, as the terminal tells it.

use ratatui::layout::Position;

/// Something that was done with the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mouse {
    pub(crate) deed: MouseDeed,
    /// The cell, counted from the upper left one.
    pub(crate) at: Position,
}

/// What the first button or the wheel does; of other buttons nothing is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MouseDeed {
    Press,
    /// Moved, with the button held down.
    Drag,
    Release,
    WheelUp,
    WheelDown,
}
