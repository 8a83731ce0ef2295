//! What each part of the screen looks like, and how a terminal shows that.

pub(crate) mod palette;
pub(crate) mod theme;
