//! Replaces the canvas if krank is built without pictures. These types cannot be constructed.

use super::PaintError;

pub(crate) enum Canvas {}

impl Canvas {
    pub(crate) fn new() -> Result<Self, PaintError> {
        Err(PaintError::NotBuilt)
    }

    pub(crate) fn paint(&self, _svg: &str, _width: u32) -> Result<Pixels, PaintError> {
        match *self {}
    }
}

pub(crate) enum Pixels {}

impl Pixels {
    pub(crate) fn png(&self) -> Result<Vec<u8>, PaintError> {
        match *self {}
    }

    #[cfg(feature = "tui")]
    pub(crate) fn sixels(&self) -> Result<Vec<u8>, PaintError> {
        match *self {}
    }
}

pub(crate) fn animation(
    _typical: impl Iterator<Item = Result<Pixels, PaintError>>,
    _pictures: impl ExactSizeIterator<Item = Result<Pixels, PaintError>>,
    _rate: u16,
) -> Result<Vec<u8>, PaintError> {
    Err(PaintError::NotBuilt)
}
