//! Encodes colours and attributes as the shortest SGR sequences.

use crate::tui::appearance::palette::Palette;
use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};
use std::io::Write;

const PLAIN: &[u8] = b"\x1b[m";

const ATTRIBUTES: [(Modifier, u8); 4] = [
    (Modifier::BOLD, 1),
    (Modifier::DIM, 2),
    (Modifier::UNDERLINED, 4),
    (Modifier::REVERSED, 7),
];

/// Attributes visible on a blank.
const OF_BLANKS: Modifier = Modifier::UNDERLINED.union(Modifier::REVERSED);

/// The colours and attributes in force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sgr {
    fg: Color,
    bg: Color,
    modifier: Modifier,
}

/// The terminal's display of cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellStyle {
    pub(super) palette: Palette,
    /// The Linux console shows faint text in a hardly legible grey; a VT100 has no faint text.
    pub(super) has_faint: bool,
    /// A VT100 cannot erase some characters of a row.
    pub(super) erases_cells: bool,
}

impl CellStyle {
    /// Returns a cell's colours and attributes, without those that the terminal lacks or that are
    /// invisible.
    pub(super) fn sgr_of(&self, cell: &Cell) -> Sgr {
        let mut sgr = Sgr {
            fg: cell.fg,
            bg: cell.bg,
            modifier: cell.modifier,
        };
        let is_blank = cell.symbol() == " " && !sgr.modifier.contains(Modifier::REVERSED);
        if is_blank {
            sgr.fg = Color::Reset;
            sgr.modifier &= OF_BLANKS;
        }
        if sgr == Sgr::PLAIN && (is_blank || !self.palette.has_weak_text) {
            return sgr;
        }
        let (fg, modifier) = self.palette.faint(sgr.fg, sgr.modifier);
        let fg = match is_blank {
            true => fg,
            false => self.palette.of_text(fg, modifier),
        };
        let modifier = match self.has_faint {
            true => modifier,
            false if self.palette.is_bold_without_faint(fg) => {
                Modifier::BOLD | (modifier - Modifier::DIM)
            }
            false => modifier - Modifier::DIM,
        };
        let fg = self.palette.colour(fg);
        Sgr {
            fg,
            bg: self.palette.colour(sgr.bg),
            modifier: self.palette.weight(fg, modifier),
        }
    }

    /// Returns `true` if two cells look alike.
    pub(super) fn same(&self, a: &Cell, b: &Cell) -> bool {
        same_symbol(a, b) && (same_style(a, b) || self.sgr_of(a) == self.sgr_of(b))
    }

    /// Returns `true` if a cell is an empty cell of the plain background.
    pub(super) fn is_blank(&self, cell: &Cell) -> bool {
        let is_plain = cell.bg == Color::Reset && cell.modifier.is_empty();
        cell.symbol().as_bytes() == b" " && (is_plain || self.sgr_of(cell) == Sgr::PLAIN)
    }
}

/// Returns `true` if two cells are equal, independent of the terminal. Most are, and every cell of
/// every frame is checked.
pub(super) fn identical(a: &Cell, b: &Cell) -> bool {
    same_style(a, b) && same_symbol(a, b)
}

fn same_style(a: &Cell, b: &Cell) -> bool {
    (a.fg, a.bg, a.modifier) == (b.fg, b.bg, b.modifier)
}

fn same_symbol(a: &Cell, b: &Cell) -> bool {
    match (a.symbol().as_bytes(), b.symbol().as_bytes()) {
        // A fast path without a call.
        ([a], [b]) => a == b,
        (a, b) => a == b,
    }
}

impl Sgr {
    pub(super) const PLAIN: Sgr = Sgr {
        fg: Color::Reset,
        bg: Color::Reset,
        modifier: Modifier::empty(),
    };

    /// Returns `true` if a blank in this style looks like plain background.
    pub(super) fn is_blank_background(self) -> bool {
        self.bg == Color::Reset && !self.modifier.intersects(OF_BLANKS)
    }

    /// Appends the sequence that changes the style from `has` to this one.
    pub(super) fn write_style(self, has: Sgr, bytes: &mut Vec<u8>) {
        if self == has {
            return;
        }
        if self == Sgr::PLAIN {
            bytes.extend_from_slice(PLAIN);
            return;
        }
        // Attributes are removed by a reset: VT100s cannot end a single one.
        let over = !self.modifier.contains(has.modifier);
        let has = if over { Sgr::PLAIN } else { has };
        bytes.extend_from_slice(b"\x1b[");
        if over {
            bytes.extend_from_slice(b"0;");
        }
        for (modifier, code) in ATTRIBUTES {
            if (self.modifier - has.modifier).contains(modifier) {
                escape(bytes, format_args!("{code};"));
            }
        }
        if self.fg != has.fg {
            colour(self.fg, 0, bytes);
        }
        if self.bg != has.bg {
            colour(self.bg, 10, bytes);
        }
        // The last separator becomes the final byte.
        bytes.pop();
        bytes.push(b'm');
    }
}

/// Appends a colour with a separator after it; `layer` is 0 for the foreground, 10 for the
/// background.
fn colour(colour: Color, layer: u8, bytes: &mut Vec<u8>) {
    let name = match colour {
        Color::Reset => 39,
        Color::Black => 30,
        Color::Red => 31,
        Color::Green => 32,
        Color::Yellow => 33,
        Color::Blue => 34,
        Color::Magenta => 35,
        Color::Cyan => 36,
        Color::Gray => 37,
        Color::DarkGray => 90,
        Color::LightRed => 91,
        Color::LightGreen => 92,
        Color::LightYellow => 93,
        Color::LightBlue => 94,
        Color::LightMagenta => 95,
        Color::LightCyan => 96,
        Color::White => 97,
        Color::Indexed(i) => return escape(bytes, format_args!("{};5;{i};", 38 + layer)),
        Color::Rgb(r, g, b) => {
            return escape(bytes, format_args!("{};2;{r};{g};{b};", 38 + layer));
        }
    };
    escape(bytes, format_args!("{};", name + layer));
}

/// Appends formatted text.
pub(super) fn escape(bytes: &mut Vec<u8>, text: std::fmt::Arguments<'_>) {
    // Writing into memory cannot fail.
    let _ = bytes.write_fmt(text);
}
