//! The drawing in pixels, over its own cells, until something happens.

use super::super::terminal::still::{self, StillSequence};
use super::super::views;
use super::{Theme, Workbench};
use crate::capability::PictureProtocol;
use crate::drawing::SvgGround;
use crate::pixels::{Canvas, PaintError};
use crate::tui::commands::action::Action;
use crate::wording::words;
use ratatui::layout::Rect;

/// A picture that takes longer on its line is sent only after somebody has read how long.
const PATIENCE: f64 = 3.0;
/// A cell of a terminal that does not tell its size in pixels: smaller than most, so that a picture fits.
const USUAL_CELL: (u16, u16) = (8, 16);

/// What became of the picture that was asked for.
#[derive(Debug, Default)]
pub(super) enum Still {
    /// None was, or it is gone.
    #[default]
    None,
    /// It takes long: whether it is wanted nevertheless has been asked.
    Offered,
    /// The same, and it is.
    Accepted,
    /// It goes behind the next whole frame.
    Ready(StillSequence, ShownStill),
    /// It is on the screen.
    Shown(ShownStill),
    /// It is no longer wanted, and the terminal has to be told.
    Gone(&'static [u8]),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct ShownStill {
    protocol: PictureProtocol,
    area: Rect,
}

impl Still {
    /// A key was pressed after it was offered: the same one, or another.
    pub(super) fn asked_again(&mut self, again: bool) {
        if matches!(self, Still::Offered) {
            *self = if again { Still::Accepted } else { Still::None };
        }
    }
}

impl Workbench {
    /// Shows the drawing as it stands. The line tells how large a cell of the terminal is, and how many bytes a
    /// second it takes, where it does.
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
        self.app.tell_of_still(message);
    }

    /// What is to be sent behind the frame that was painted last.
    pub(in crate::tui) fn take_still(&mut self) -> Option<StillSequence> {
        match std::mem::take(&mut self.still) {
            Still::Ready(sequence, shown) if !self.painter.is_cut() => {
                self.still = Still::Shown(shown);
                Some(sequence)
            }
            Still::Gone(removal) => Some(StillSequence {
                bytes: removal.to_vec(),
                removal: &[],
            }),
            still => {
                self.still = still;
                None
            }
        }
    }

    /// Something happens: the cells are painted anew.
    pub(super) fn put_still_away(&mut self) {
        match self.still {
            Still::Shown(shown) => {
                self.still = Still::Gone(still::removal(shown.protocol));
                self.painter.forget();
            }
            Still::Ready(..) => self.still = Still::None,
            Still::None | Still::Offered | Still::Accepted | Still::Gone(_) => {}
        }
    }

    /// The cells below it are to show something else.
    pub(super) fn uncover(&mut self) {
        if let Still::Shown(shown) = self.still
            && self.painter.differs_in(shown.area)
        {
            self.put_still_away();
        }
    }

    fn painted(
        &mut self,
        protocol: PictureProtocol,
        cell: Option<(u16, u16)>,
    ) -> Result<Option<(StillSequence, ShownStill)>, PaintError> {
        let canvas = Canvas::new()?;
        self.app.catch_up();
        views::prepare(&self.app, &mut self.sketch);
        let ground = match self.app.palette().theme {
            Theme::Dark => SvgGround::Dark,
            Theme::Auto | Theme::Light | Theme::Plain => SvgGround::Preferred,
        };
        let Some((svg, area)) = self.sketch.document(&self.app, ground) else {
            return Ok(None);
        };
        let (width, _) = cell.unwrap_or(USUAL_CELL);
        let pixels = canvas.paint(&svg, u32::from(area.width) * u32::from(width))?;
        let sequence = still::sequence(protocol, &pixels, area)?;
        Ok(Some((sequence, ShownStill { protocol, area })))
    }
}
