//! Common properties of drawings and plots in characters: glyphs and size.

use super::args::{GlyphChoice, Size};
use super::output::goes_to_terminal;
use super::screen;
use crate::document::with_ascii_letters;
use crate::drawing;
use std::path::Path;

/// Size if the terminal reports none.
pub(super) const USUAL: Size = Size { cols: 80, rows: 24 };

/// Height of a character divided by its width, in most fonts.
pub(super) const ASPECT: f64 = 2.0;

/// Returns the requested glyphs, or those that the locale and the terminal support.
pub(super) fn glyphs(wish: GlyphChoice) -> drawing::Glyphs {
    wish.asked()
        .unwrap_or_else(|| screen::judgement().glyphs().value)
}

/// Converts letters in a drawing's text to ASCII if its glyphs are ASCII.
pub(super) fn lettered(text: String, glyphs: drawing::Glyphs) -> String {
    match glyphs.is_dotted() {
        true => text,
        false => with_ascii_letters(&text),
    }
}

/// Returns the requested size, or the terminal's size without a line for the prompt.
pub(super) fn size(wish: Option<Size>, output: Option<&Path>) -> Size {
    let terminal = || {
        let (cols, rows) = screen::size().filter(|_| goes_to_terminal(output))?;
        let rows = rows.saturating_sub(1).max(1);
        Some(Size { cols, rows })
    };
    wish.or_else(terminal).unwrap_or(USUAL)
}
