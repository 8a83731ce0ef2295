//! Renders SVG to pixels with an embedded font. System fonts are not used, so a picture is the same
//! everywhere.

use super::PaintError;
use super::animation::Animation;
use super::colour_table::ColourCensus;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Source};
use resvg::usvg::{Options, Tree};
use std::sync::Arc;

/// Maximum number of pixels of a picture, each of four bytes in memory.
const MAX_COUNT: u64 = 1 << 25;
/// Maximum number of pixels of all pictures of an animation: some minutes of work.
const MAX_TURN_SHARE: u64 = 1 << 31;

/// A renderer of SVG documents.
pub(crate) struct Canvas {
    options: Options<'static>,
}

impl Canvas {
    pub(crate) fn new() -> Result<Self, PaintError> {
        let mut fonts = Database::new();
        fonts.load_font_source(Source::Binary(Arc::new(dejavu::sans::regular())));
        fonts.set_sans_serif_family("DejaVu Sans");
        let fontdb = Arc::new(fonts);
        Ok(Canvas {
            options: Options {
                fontdb,
                ..Options::default()
            },
        })
    }

    /// Renders a document, `width` pixels wide.
    pub(crate) fn paint(&self, svg: &str, width: u32) -> Result<Pixels, PaintError> {
        let tree = Tree::from_str(svg, &self.options);
        let tree = tree.map_err(|e| PaintError::Failed(e.to_string()))?;
        let size = tree.size();
        #[expect(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "sizes of pictures; what is too large becomes the largest, and is refused"
        )]
        let (across, down, height) = {
            let across = width as f32 / size.width();
            let height = (size.height() * across).round().max(1.0);
            // Whole pixels, so that the background covers the last row too.
            (across, height / size.height(), height as u32)
        };
        let too_large = PaintError::TooLarge(width, height);
        if u64::from(width) * u64::from(height) > MAX_COUNT {
            return Err(too_large);
        }
        let mut pixmap = Pixmap::new(width, height).ok_or(too_large)?;
        let scale = Transform::from_scale(across, down);
        resvg::render(&tree, scale, &mut pixmap.as_mut());
        Ok(Pixels { pixmap })
    }
}

/// A picture, completely covered by its background.
pub(crate) struct Pixels {
    pub(super) pixmap: Pixmap,
}

impl Pixels {
    pub(super) fn size(&self) -> (u32, u32) {
        (self.pixmap.width(), self.pixmap.height())
    }

    /// Returns the colours from the top left, row by row.
    pub(super) fn colours(&self) -> impl Iterator<Item = [u8; 3]> {
        let pixels = self.pixmap.pixels().iter();
        pixels.map(|pixel| [pixel.red(), pixel.green(), pixel.blue()])
    }

    pub(crate) fn png(&self) -> Result<Vec<u8>, PaintError> {
        let bytes = self.pixmap.encode_png();
        bytes.map_err(|e| PaintError::Failed(e.to_string()))
    }
}

/// Encodes a repeating GIF with `rate` pictures per second. Its colours are taken from the
/// `typical` pictures.
pub(crate) fn animation(
    typical: impl Iterator<Item = Result<Pixels, PaintError>>,
    pictures: impl ExactSizeIterator<Item = Result<Pixels, PaintError>>,
    rate: u16,
) -> Result<Vec<u8>, PaintError> {
    let count = pictures.len();
    let mut census = ColourCensus::default();
    for picture in typical {
        let picture = picture?;
        let (width, height) = picture.size();
        if u64::from(width) * u64::from(height) * count as u64 > MAX_TURN_SHARE {
            return Err(PaintError::TooMany(count));
        }
        census.count(picture.colours());
    }
    let mut animation = Animation::new(census.table(), rate);
    for picture in pictures {
        animation.add(&picture?)?;
    }
    animation.finish()
}
