//! Common properties of drawings and plots in characters: glyphs and size.

use crate::cli::choice::{OptionValue, OrAuto, option_values, or_auto};
use crate::cli::output::writes_to_terminal;
use crate::cli::screen;
use crate::document::with_ascii_letters;
use crate::drawing::Glyphs;
use crate::wording::words;
use std::path::Path;
use std::str::FromStr;

/// Returns the characters to draw with.
pub(super) fn glyph_choices() -> Vec<OptionValue<OrAuto<Glyphs>>> {
    let about = [
        words().glyphs_of_seven_bits(),
        words().glyphs_of_boxes(),
        words().glyphs_of_braille(),
        words().glyphs_of_quadrants(),
        words().glyphs_of_sextants(),
        words().glyphs_of_octants(),
    ];
    let glyphs = option_values(Glyphs::ALL, Glyphs::name, about);
    or_auto(words().glyphs_as_allowed(), glyphs)
}

/// A size in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) cols: u16,
    pub(super) rows: u16,
}

/// Maximum number of columns or rows; larger pictures only waste memory.
const MAX_SIDE: u16 = 2000;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(['x', 'X']);
        let side = |text: &str| text.parse().ok().filter(|n| (1..=MAX_SIDE).contains(n));
        let size = sides.and_then(|(cols, rows)| {
            Some(Size {
                cols: side(cols)?,
                rows: side(rows)?,
            })
        });
        size.ok_or_else(|| words().size_is_meant(&MAX_SIDE))
    }
}

/// Size if the terminal reports none.
pub(super) const DEFAULT_SIZE: Size = Size { cols: 80, rows: 24 };

/// Height of a character divided by its width, in most fonts.
pub(super) const ASPECT: f64 = 2.0;

/// Returns the requested glyphs, or those that the locale and the terminal support.
pub(super) fn glyphs(requested: OrAuto<Glyphs>) -> Glyphs {
    requested.unwrap_or_else(|| screen::judgement().glyphs().value)
}

/// Converts letters in a drawing's text to ASCII if its glyphs are ASCII.
pub(super) fn lettered(text: String, glyphs: Glyphs) -> String {
    match glyphs.is_dotted() {
        true => text,
        false => with_ascii_letters(&text),
    }
}

/// Returns the requested size, or the terminal's size without a line for the prompt.
pub(super) fn size(requested: Option<Size>, output: Option<&Path>) -> Size {
    let terminal = || {
        let (cols, rows) = screen::size().filter(|_| writes_to_terminal(output))?;
        let rows = rows.saturating_sub(1).max(1);
        Some(Size { cols, rows })
    };
    requested.or_else(terminal).unwrap_or(DEFAULT_SIZE)
}
