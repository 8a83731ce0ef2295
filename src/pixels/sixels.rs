//! A picture as sixels, for terminals alone.

use super::{PaintError, Pixels};
use icy_sixel::EncodeOptions;

/// Colours that sixels are written in: hues, and what lies between them and the ground.
const SIXEL_COLOURS: u16 = 128;

impl Pixels {
    /// As the sequence that terminals with sixels show.
    pub(crate) fn sixels(&self) -> Result<Vec<u8>, PaintError> {
        let options = EncodeOptions {
            max_colors: SIXEL_COLOURS,
            // A line drawing has no shades that dots could stand for.
            diffusion: 0.0,
            ..EncodeOptions::default()
        };
        let (width, height) = (self.pixmap.width() as usize, self.pixmap.height() as usize);
        let sequence = icy_sixel::sixel_encode(self.pixmap.data(), width, height, &options);
        let sequence = sequence.map_err(|e| PaintError::Failed(e.to_string()))?;
        Ok(sequence.into_bytes())
    }
}
