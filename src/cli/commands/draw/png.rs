//! Writes a drawing as a PNG image, painted from the SVG document.

use super::svg::{document, unpainted};
use super::{DrawFormat, DrawnScene};
use crate::cli::failure::Failure;
use crate::pixels::Canvas;
use crate::wording::Words;

pub(super) static FORMAT: DrawFormat = DrawFormat {
    name: "png",
    about: <dyn Words>::format_png,
    takes: &["--width", "--dark"],
    is_picture: true,
    is_binary: true,
    write,
};

/// Default width in pixels: enough for a slide.
const WIDTH: u16 = 1600;

fn write(drawn: &DrawnScene<'_>) -> Result<Vec<u8>, Failure> {
    let canvas = Canvas::new().map_err(unpainted)?;
    let width = drawn.args.width.unwrap_or(WIDTH);
    let pixels = canvas.paint(&document(drawn), u32::from(width));
    pixels.and_then(|pixels| pixels.png()).map_err(unpainted)
}
