//! The style of each part of the screen, and its adaptation to the terminal.

pub(crate) mod palette;
pub(crate) mod theme;
