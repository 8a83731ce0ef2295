//! Renders SVG documents to pixels: as PNG, as sixels, or as an animated GIF.
//!
//! The work is done by crates that only the feature `pictures` includes. Without it rendering
//! returns [`PaintError::NotBuilt`], whose message explains the remedy.

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

/// An error in rendering a picture.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub(crate) enum PaintError {
    /// The feature `pictures` is not built in.
    #[cfg(not(feature = "pictures"))]
    #[error("{}", words().no_pictures())]
    NotBuilt,
    /// Too many pixels for the memory.
    #[cfg(feature = "pictures")]
    #[error("{}", words().picture_too_large(*.0, *.1))]
    TooLarge(u32, u32),
    /// Too many pictures for an acceptable computing time.
    #[cfg(feature = "pictures")]
    #[error("{}", words().turn_too_large(*.0))]
    TooMany(usize),
    /// The error message of a crate.
    #[cfg(feature = "pictures")]
    #[error("{0}")]
    Failed(String),
}
