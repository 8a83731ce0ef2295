//! Documents as pixels: one is painted, and written as PNG, as sixels, or with others as a GIF that moves.
//!
//! All of it is the affair of crates, which are built in with the feature `pictures` alone. Without it nothing can
//! be painted, and [`PaintError::NotBuilt`] says what to do.

#[cfg(feature = "pictures")]
mod animation;
#[cfg_attr(not(feature = "pictures"), path = "no_canvas.rs")]
mod canvas;
#[cfg(feature = "pictures")]
mod colour_table;
#[cfg(all(feature = "pictures", feature = "tui"))]
mod sixels;

pub(crate) use canvas::{Canvas, Pixels, animation};

use crate::wording::words;
use thiserror::Error;

/// Why there is no picture.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub(crate) enum PaintError {
    /// krank is built without what it takes.
    #[cfg(not(feature = "pictures"))]
    #[error("{}", words().no_pictures())]
    NotBuilt,
    /// More pixels than memory is for.
    #[cfg(feature = "pictures")]
    #[error("{}", words().picture_too_large(*.0, *.1))]
    TooLarge(u32, u32),
    /// More pictures than anybody waits for.
    #[cfg(feature = "pictures")]
    #[error("{}", words().turn_too_large(*.0))]
    TooMany(usize),
    /// What the crates say.
    #[cfg(feature = "pictures")]
    #[error("{0}")]
    Failed(String),
}
