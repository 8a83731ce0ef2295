//! Shows the drawing as a pixel image over its cells until the next event.

use super::super::terminal::image_escapes::{self, StillSequence};
use super::super::views;
use super::{Theme, Workbench};
use crate::capability::PictureProtocol;
use crate::drawing::SvgGround;
use crate::pixels::{Canvas, PaintError};
use crate::tui::commands::action::Action;
use crate::wording::words;
use ratatui::layout::Rect;

/// Maximum transmission time in seconds; a longer one must be confirmed first.
const PATIENCE: f64 = 3.0;
/// Assumed cell size of a terminal that does not report it, in pixels. It is smaller than most, so
/// that an image fits.
const DEFAULT_CELL_SIZE: (u16, u16) = (6, 12);

/// The state of a requested image.
#[derive(Debug, Default)]
pub(super) enum Still {
    /// There is none.
    #[default]
    None,
    /// The transmission takes long, and the user must confirm it.
    Offered,
    /// The user has confirmed the long transmission.
    Accepted,
    /// The image is sent after the next complete frame.
    Ready(StillSequence, ActiveImage),
    /// The image is on the screen.
    Shown(ActiveImage),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct ActiveImage {
    protocol: PictureProtocol,
    area: Rect,
}

impl Still {
    /// Confirms or drops an offered image: `again` if the next action was the same request.
    pub(super) fn confirm(&mut self, again: bool) {
        if matches!(self, Still::Offered) {
            *self = if again { Still::Accepted } else { Still::None };
        }
    }
}

impl Workbench {
    /// Prepares an image of the current drawing. `cell` is the terminal's cell size in pixels and
    /// `rate` the line's speed in bytes per second, if they are known.
    pub(in crate::tui) fn show_still(&mut self, cell: Option<(u16, u16)>, rate: Option<f64>) {
        let Some(protocol) = self.app.pictures() else {
            return;
        };
        let accepted = matches!(self.still, Still::Accepted);
        if accepted {
            self.still = Still::None;
        }
        let message = match self.painted(protocol, cell) {
            Ok(None) => words().no_drawing_here().to_owned(),
            Err(error) => error.to_string(),
            Ok(Some((sequence, shown))) => {
                let bytes = sequence.bytes.len();
                #[expect(clippy::cast_precision_loss, reason = "no picture has 2^52 bytes")]
                let seconds = rate.map_or(0.0, |rate| bytes as f64 / rate);
                if seconds > PATIENCE && !accepted {
                    self.still = Still::Offered;
                    let key = self.app.keymap().key(Action::Still);
                    let key = key.map_or_else(String::new, |key| key.to_string());
                    words().still_takes(bytes, seconds, &key)
                } else {
                    self.still = Still::Ready(sequence, shown);
                    words().still_shown(bytes)
                }
            }
        };
        self.app.report_image(message);
    }

    /// Returns the bytes to be sent after the last painted frame.
    pub(in crate::tui) fn take_still(&mut self) -> Option<StillSequence> {
        let removal = std::mem::take(&mut self.removal);
        if !removal.is_empty() {
            return Some(StillSequence {
                bytes: removal.to_vec(),
                removal: &[],
            });
        }
        match std::mem::take(&mut self.still) {
            Still::Ready(sequence, shown) if !self.painter.is_cut() => {
                self.still = Still::Shown(shown);
                Some(sequence)
            }
            still => {
                self.still = still;
                None
            }
        }
    }

    /// Removes the image before the next event, so that its cells are painted again.
    pub(super) fn remove_image(&mut self) {
        match self.still {
            Still::Shown(shown) => {
                self.still = Still::None;
                self.removal = image_escapes::removal(shown.protocol);
                self.painter.forget();
            }
            Still::Ready(..) => self.still = Still::None,
            Still::None | Still::Offered | Still::Accepted => {}
        }
    }

    /// Removes the image if the cells below it change.
    pub(super) fn uncover(&mut self) {
        if let Still::Shown(shown) = self.still
            && self.painter.differs_in(shown.area)
        {
            self.remove_image();
        }
    }

    fn painted(
        &mut self,
        protocol: PictureProtocol,
        cell: Option<(u16, u16)>,
    ) -> Result<Option<(StillSequence, ActiveImage)>, PaintError> {
        let canvas = Canvas::new()?;
        self.app.update_before_frame();
        views::prepare(&self.app, &mut self.sketch);
        let ground = match self.app.palette().theme {
            Theme::Dark => SvgGround::Dark,
            Theme::Auto | Theme::Light | Theme::Plain => SvgGround::Preferred,
        };
        let Some((svg, area)) = self.sketch.document(&self.app, ground) else {
            return Ok(None);
        };
        let pixels = canvas.paint(&svg, width_in(area, cell, self.app.aspect()))?;
        let sequence = image_escapes::sequence(protocol, &pixels, area)?;
        Ok(Some((sequence, ActiveImage { protocol, area })))
    }
}

/// Returns the width of an image in pixels, such that its height fits too; its cells have the given
/// aspect.
fn width_in(area: Rect, cell: Option<(u16, u16)>, aspect: f64) -> u32 {
    let (width, height) = cell.unwrap_or(DEFAULT_CELL_SIZE);
    let column = f64::from(width).min(f64::from(height) / aspect);
    let across = f64::from(area.width) * column;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "two u16 multiplied; a half pixel is none"
    )]
    let across = across as u32;
    across.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sixel image that is too high would scroll the screen.
    #[test]
    fn image_fits_its_cells() {
        let area = Rect::new(3, 2, 60, 20);
        for (cell, aspect) in [
            (Some((10, 20)), 2.0),
            (Some((10, 18)), 1.8),
            (Some((10, 18)), 2.0),
            (Some((10, 30)), 2.0),
            (None, 2.0),
            (None, 1.5),
        ] {
            let (width, height) = cell.unwrap_or(DEFAULT_CELL_SIZE);
            let across = f64::from(width_in(area, cell, aspect));
            let down = across * f64::from(area.height) * aspect / f64::from(area.width);
            assert!(across <= f64::from(area.width * width), "{cell:?}");
            assert!(down <= f64::from(area.height * height) + 1e-9, "{cell:?}");
            // The image is as large as possible, within half a pixel per side.
            let fills = across + 1.0 > f64::from(area.width * width)
                || down + 2.0 * aspect > f64::from(area.height * height);
            assert!(fills, "{cell:?} {across} {down}");
        }
    }
}
