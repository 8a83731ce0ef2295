//! What pictures on standard output or in a file have in common: their characters and their size.

use super::args::{GlyphChoice, Size};
use super::output::goes_to_terminal;
use super::screen;
use crate::document::with_ascii_letters;
use crate::drawing;
use std::path::Path;

/// Where nothing tells the size.
pub(super) const USUAL: Size = Size { cols: 80, rows: 24 };

/// The height of a character for its width, in most fonts.
pub(super) const ASPECT: f64 = 2.0;

/// The characters that were asked for, or that the locale and the terminal allow.
pub(super) fn glyphs(wish: GlyphChoice) -> drawing::Glyphs {
    wish.asked()
        .unwrap_or_else(|| screen::judgement().glyphs().value)
}

/// A picture's text with our own words in letters that go with its characters.
pub(super) fn lettered(text: String, glyphs: drawing::Glyphs) -> String {
    match glyphs.is_dotted() {
        true => text,
        false => with_ascii_letters(&text),
    }
}

/// As asked, or as large as the terminal that it goes to, the prompt's line left free.
pub(super) fn size(wish: Option<Size>, output: Option<&Path>) -> Size {
    let terminal = || {
        let (cols, rows) = screen::size().filter(|_| goes_to_terminal(output))?;
        let rows = rows.saturating_sub(1).max(1);
        Some(Size { cols, rows })
    };
    wish.or_else(terminal).unwrap_or(USUAL)
}
