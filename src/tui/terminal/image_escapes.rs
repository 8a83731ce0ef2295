//! Encodes images for terminals, and the sequences that remove them.

use super::base64::base64;
use crate::capability::PictureProtocol;
use crate::pixels::{PaintError, Pixels};
use ratatui::layout::Rect;

/// The bytes that show an image, and those that remove it; the latter are empty if clearing
/// suffices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StillSequence {
    pub(crate) bytes: Vec<u8>,
    pub(crate) removal: &'static [u8],
}

/// Maximum chunk length in kitty's protocol.
const CHUNK: usize = 4096;
/// Removes and frees the only image, which has id 1.
const KITTY_REMOVAL: &[u8] = b"\x1b_Ga=d,d=I,i=1,q=2\x1b\\";

/// Encodes an image that covers these cells.
pub(crate) fn sequence(
    protocol: PictureProtocol,
    pixels: &Pixels,
    area: Rect,
) -> Result<StillSequence, PaintError> {
    let mut bytes = format!("\x1b[{};{}H", area.y + 1, area.x + 1).into_bytes();
    match protocol {
        PictureProtocol::Kitty => bytes.extend(kitty(&pixels.png()?, area)),
        PictureProtocol::Iterm => bytes.extend(iterm(&pixels.png()?, area)),
        PictureProtocol::Sixel => bytes.extend(pixels.sixels()?),
    }
    Ok(StillSequence {
        bytes,
        removal: removal(protocol),
    })
}

/// Returns the bytes that remove an image if clearing does not.
pub(crate) fn removal(protocol: PictureProtocol) -> &'static [u8] {
    match protocol {
        PictureProtocol::Kitty => KITTY_REMOVAL,
        // These images replace characters, and characters replace them.
        PictureProtocol::Iterm | PictureProtocol::Sixel => &[],
    }
}

/// Encodes a PNG image (`f=100`) for immediate display (`a=T`), without moving the cursor (`C=1`).
/// The terminal's answer is suppressed (`q=2`), because it would be taken for keys.
fn kitty(png: &[u8], area: Rect) -> Vec<u8> {
    let text = base64(png);
    let chunks: Vec<&[u8]> = text.as_bytes().chunks(CHUNK).collect();
    let mut bytes = Vec::with_capacity(text.len() + 16 * chunks.len());
    for (k, chunk) in chunks.iter().enumerate() {
        let more = u8::from(k + 1 < chunks.len());
        let head = match k {
            0 => format!(
                "\x1b_Ga=T,f=100,i=1,q=2,C=1,c={},r={},m={more};",
                area.width, area.height
            ),
            _ => format!("\x1b_Gm={more};"),
        };
        bytes.extend_from_slice(head.as_bytes());
        bytes.extend_from_slice(chunk);
        bytes.extend_from_slice(b"\x1b\\");
    }
    bytes
}

fn iterm(png: &[u8], area: Rect) -> Vec<u8> {
    let (size, Rect { width, height, .. }) = (png.len(), area);
    let text = base64(png);
    format!(
        "\x1b]1337;File=inline=1;size={size};width={width};height={height};preserveAspectRatio=0:{text}\x07"
    )
    .into_bytes()
}
