//! Encodes a picture as sixels, for terminals.

use super::{PaintError, Pixels};
use icy_sixel::EncodeOptions;

/// The number of colours of sixels: hues, and their mixtures with the background.
const SIXEL_COLOURS: u16 = 128;

impl Pixels {
    /// Returns the escape sequence for terminals with sixels.
    pub(crate) fn sixels(&self) -> Result<Vec<u8>, PaintError> {
        let options = EncodeOptions {
            max_colors: SIXEL_COLOURS,
            // A line drawing has no gradients to dither.
            diffusion: 0.0,
            ..EncodeOptions::default()
        };
        let (width, height) = (self.pixmap.width() as usize, self.pixmap.height() as usize);
        let sequence = icy_sixel::sixel_encode(self.pixmap.data(), width, height, &options);
        let sequence = sequence.map_err(|e| PaintError::Failed(e.to_string()))?;
        Ok(sequence.into_bytes())
    }
}
