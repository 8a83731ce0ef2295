//! Encodes successive pictures as a GIF.

use super::PaintError;
use super::canvas::Pixels;
use super::colour_table::ColourTable;
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use std::borrow::Cow;

/// The index of a pixel that equals the previous picture's: most do, and a run of them takes a few
/// bytes.
const UNCHANGED_PIXEL: u8 = 255;
/// The time unit of a GIF: hundredths of a second.
const HUNDREDTHS: u32 = 100;

pub(super) struct Animation {
    table: ColourTable,
    /// Pictures per second.
    rate: u16,
    count: u32,
    /// The previous picture, as indices.
    before: Vec<u8>,
    encoder: Option<Encoder<Vec<u8>>>,
}

impl Animation {
    pub(super) fn new(table: ColourTable, rate: u16) -> Self {
        Animation {
            table,
            rate,
            count: 0,
            before: Vec::new(),
            encoder: None,
        }
    }

    pub(super) fn add(&mut self, picture: &Pixels) -> Result<(), PaintError> {
        let (width, height) = side_lengths(picture)?;
        // Most pixels equal their neighbour.
        let mut last = None;
        let indices = picture.colours().map(|colour| match last {
            Some((same, index)) if same == colour => index,
            _ => {
                let index = self.table.index(colour);
                last = Some((colour, index));
                index
            }
        });
        let indices: Vec<u8> = indices.collect();
        let changed = indices.iter().zip(&self.before);
        let changed =
            changed.map(|(now, before)| if now == before { UNCHANGED_PIXEL } else { *now });
        let buffer = match self.before.len() == indices.len() {
            true => changed.collect(),
            false => indices.clone(),
        };
        let frame = Frame {
            delay: self.next_delay(),
            dispose: DisposalMethod::Keep,
            transparent: Some(UNCHANGED_PIXEL),
            width,
            height,
            buffer: Cow::Owned(buffer),
            ..Frame::default()
        };
        let encoder = match &mut self.encoder {
            Some(encoder) => encoder,
            none => none.insert(start_encoder(&self.table, width, height)?),
        };
        encoder.write_frame(&frame).map_err(failed)?;
        self.before = indices;
        Ok(())
    }

    pub(super) fn finish(self) -> Result<Vec<u8>, PaintError> {
        match self.encoder {
            Some(encoder) => encoder.into_inner().map_err(failed),
            None => Ok(Vec::new()),
        }
    }

    /// Returns the delay of the next picture in hundredths of a second. The exact duration need not
    /// be an integer; the rounding errors do not accumulate.
    fn next_delay(&mut self) -> u16 {
        let until = |count: u32| count * HUNDREDTHS / u32::from(self.rate.max(1));
        let delay = until(self.count + 1) - until(self.count);
        self.count += 1;
        u16::try_from(delay).unwrap_or(u16::MAX)
    }
}

fn start_encoder(
    table: &ColourTable,
    width: u16,
    height: u16,
) -> Result<Encoder<Vec<u8>>, PaintError> {
    let mut encoder = Encoder::new(Vec::new(), width, height, &table.bytes()).map_err(failed)?;
    encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
    Ok(encoder)
}

fn side_lengths(picture: &Pixels) -> Result<(u16, u16), PaintError> {
    let (width, height) = picture.size();
    match (u16::try_from(width), u16::try_from(height)) {
        (Ok(width), Ok(height)) => Ok((width, height)),
        _ => Err(PaintError::TooLarge(width, height)),
    }
}

fn failed(error: impl std::fmt::Display) -> PaintError {
    PaintError::Failed(error.to_string())
}
