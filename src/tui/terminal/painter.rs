//! From a screen to the fewest bytes that bring the terminal there.
//!
//! The painter knows what the terminal shows, compares it with the screen that is wanted, and writes
//! what differs: one frame, one block of bytes, none at all where nothing differs. It keeps to what
//! a VT100 understands (CUP, CUF, EL, SGR), asks nothing, and never relies on where the cursor is
//! after the last column. Every cell is one column wide: the views let nothing else through.

use crate::capability::{Capability, Colours};
use crate::tui::Frames;
use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier};
use std::io::Write;

const SYNC_ON: &[u8] = b"\x1b[?2026h";
const SYNC_OFF: &[u8] = b"\x1b[?2026l";
const PLAIN: &[u8] = b"\x1b[0m";
const CLEAR: &[u8] = b"\x1b[2J";
const ERASE_TO_END: &[u8] = b"\x1b[K";

/// Up to so many unchanged cells are written again rather than skipped: `ESC [ n C` costs as much.
const REWRITE: u16 = 4;

/// Colours and attributes in force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Pen {
    fg: Color,
    bg: Color,
    modifier: Modifier,
}

impl Pen {
    const PLAIN: Pen = Pen {
        fg: Color::Reset,
        bg: Color::Reset,
        modifier: Modifier::empty(),
    };
}

/// Writes frames.
#[derive(Debug)]
pub(crate) struct Painter {
    capability: Capability,
    /// What the terminal shows.
    shown: Buffer,
    /// Whether it shows something else, so that all must be cleared and drawn again.
    stale: bool,
    bytes: Vec<u8>,
    /// Where the cursor is, if that is certain.
    cursor: Option<(u16, u16)>,
    pen: Pen,
    frames: Frames,
}

impl Painter {
    /// A painter for a terminal that shows anything.
    #[must_use]
    pub(crate) fn new(capability: Capability) -> Self {
        Painter {
            capability,
            shown: Buffer::empty(Rect::ZERO),
            stale: true,
            bytes: Vec::new(),
            cursor: None,
            pen: Pen::PLAIN,
            frames: Frames::default(),
        }
    }

    /// Forgets what the terminal shows: the next frame clears it and draws everything.
    pub(crate) fn forget(&mut self) {
        self.stale = true;
    }

    /// What has been painted so far.
    #[must_use]
    pub(crate) fn frames(&self) -> Frames {
        self.frames
    }

    /// The bytes that make the terminal show `wanted`; none if it does already.
    pub(crate) fn frame(&mut self, wanted: Buffer) -> &[u8] {
        self.bytes.clear();
        let stale = self.stale || self.shown.area != wanted.area;
        if stale {
            self.shown = Buffer::empty(wanted.area);
        }
        if !stale && self.shown == wanted {
            return &self.bytes;
        }
        self.cursor = None;
        if self.capability.modern {
            self.bytes.extend_from_slice(SYNC_ON);
        }
        if stale {
            self.bytes.extend_from_slice(PLAIN);
            self.bytes.extend_from_slice(CLEAR);
        }
        let prologue = self.bytes.len();
        for y in 0..wanted.area.height {
            self.row(&wanted, y);
        }
        let changed = stale || self.bytes.len() > prologue;
        if !changed {
            // The screens differ in what this terminal cannot show, a colour for instance.
            self.bytes.clear();
        } else {
            self.set_pen(Pen::PLAIN);
            if self.capability.modern {
                self.bytes.extend_from_slice(SYNC_OFF);
            }
            self.frames.count += 1;
            self.frames.bytes += self.bytes.len() as u64;
        }
        self.shown = wanted;
        self.stale = false;
        &self.bytes
    }

    fn row(&mut self, wanted: &Buffer, y: u16) {
        let width = wanted.area.width;
        let start = usize::from(y) * usize::from(width);
        let next = &wanted.content[start..start + usize::from(width)];
        let shown = std::mem::take(&mut self.shown.content);
        let previous = &shown[start..start + usize::from(width)];
        let (end, erase) = self.tail(previous, next);
        for x in 0..end {
            let cell = &next[usize::from(x)];
            if !self.same(&previous[usize::from(x)], cell) {
                self.go_to(x, y, next);
                self.put(cell, width);
            }
        }
        if erase {
            self.go_to(end, y, next);
            self.set_pen(Pen::PLAIN);
            self.bytes.extend_from_slice(ERASE_TO_END);
        }
        self.shown.content = shown;
    }

    /// Up to where a row is written cell by cell, and whether the rest is erased at once.
    fn tail(&self, previous: &[Cell], next: &[Cell]) -> (u16, bool) {
        let blank = |cell: &Cell| cell.symbol() == " " && self.pen_of(cell) == Pen::PLAIN;
        let end = next.iter().rposition(|c| !blank(c)).map_or(0, |i| i + 1);
        let to_erase = previous[end..].iter().filter(|c| !blank(c)).count();
        if to_erase > ERASE_TO_END.len() {
            (to_u16(end), true)
        } else {
            (to_u16(next.len()), false)
        }
    }

    fn same(&self, a: &Cell, b: &Cell) -> bool {
        a.symbol() == b.symbol() && self.pen_of(a) == self.pen_of(b)
    }

    /// Moves the cursor by the shorter of the ways there.
    fn go_to(&mut self, x: u16, y: u16, row: &[Cell]) {
        match self.cursor {
            Some((cx, cy)) if (cx, cy) == (x, y) => return,
            Some((cx, cy)) if cy == y && cx < x => {
                let between = &row[usize::from(cx)..usize::from(x)];
                let cheap = x - cx <= REWRITE
                    && between
                        .iter()
                        .all(|c| c.symbol().len() == 1 && self.pen_of(c) == self.pen);
                if cheap {
                    for cell in between {
                        self.bytes.extend_from_slice(cell.symbol().as_bytes());
                    }
                } else if x - cx == 1 {
                    self.bytes.extend_from_slice(b"\x1b[C");
                } else {
                    self.escape(format_args!("\x1b[{}C", x - cx));
                }
            }
            Some((_, cy)) if x == 0 && y == cy + 1 => self.bytes.extend_from_slice(b"\r\n"),
            _ if x == 0 => self.escape(format_args!("\x1b[{}H", y + 1)),
            _ => self.escape(format_args!("\x1b[{};{}H", y + 1, x + 1)),
        }
        self.cursor = Some((x, y));
    }

    fn put(&mut self, cell: &Cell, width: u16) {
        self.set_pen(self.pen_of(cell));
        self.bytes.extend_from_slice(cell.symbol().as_bytes());
        // Behind the last column terminals differ.
        self.cursor = self
            .cursor
            .map(|(x, y)| (x + 1, y))
            .filter(|&(x, _)| x < width);
    }

    /// A cell's colours and attributes, as far as the terminal has them.
    fn pen_of(&self, cell: &Cell) -> Pen {
        let shown = |colour| match self.capability.colours {
            Colours::None => Color::Reset,
            Colours::Sixteen | Colours::Indexed | Colours::True => colour,
        };
        // The Linux console shows faint text in a grey that is hard to read; a VT100 has none.
        let faint = if self.capability.modern {
            Modifier::empty()
        } else {
            Modifier::DIM
        };
        Pen {
            fg: shown(cell.fg),
            bg: shown(cell.bg),
            modifier: cell.modifier - faint,
        }
    }

    fn set_pen(&mut self, pen: Pen) {
        if pen == self.pen {
            return;
        }
        let has = self.pen;
        self.pen = pen;
        if pen == Pen::PLAIN {
            self.bytes.extend_from_slice(PLAIN);
            return;
        }
        // An attribute is taken away by starting over: VT100s do not know how to end a single one.
        let over = !pen.modifier.contains(has.modifier);
        let has = if over { Pen::PLAIN } else { has };
        self.bytes.extend_from_slice(b"\x1b[");
        if over {
            self.bytes.extend_from_slice(b"0;");
        }
        for (modifier, code) in ATTRIBUTES {
            if (pen.modifier - has.modifier).contains(modifier) {
                self.escape(format_args!("{code};"));
            }
        }
        if pen.fg != has.fg {
            self.colour(pen.fg, 0);
        }
        if pen.bg != has.bg {
            self.colour(pen.bg, 10);
        }
        // The last separator becomes the end.
        self.bytes.pop();
        self.bytes.push(b'm');
    }

    /// A colour with a separator behind it; `layer` is 0 for the foreground, 10 for the background.
    fn colour(&mut self, colour: Color, layer: u8) {
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
            Color::Indexed(i) => return self.escape(format_args!("{};5;{i};", 38 + layer)),
            Color::Rgb(r, g, b) => {
                return self.escape(format_args!("{};2;{r};{g};{b};", 38 + layer));
            }
        };
        self.escape(format_args!("{};", name + layer));
    }

    fn escape(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing into memory cannot fail.
        let _ = self.bytes.write_fmt(text);
    }
}

const ATTRIBUTES: [(Modifier, u8); 4] = [
    (Modifier::BOLD, 1),
    (Modifier::DIM, 2),
    (Modifier::UNDERLINED, 4),
    (Modifier::REVERSED, 7),
];

/// Positions within a row, which is at most `u16::MAX` wide.
fn to_u16(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Glyphs;
    use proptest::prelude::*;
    use ratatui::style::Style;
    use std::num::NonZeroU16;

    const WIDTH: u16 = 12;
    const HEIGHT: u16 = 4;

    fn painter(colours: Colours, modern: bool) -> Painter {
        Painter::new(Capability {
            glyphs: Glyphs::Ascii,
            colours,
            modern,
        })
    }

    fn terminal() -> vt100::Parser {
        let [rows, cols] = [HEIGHT, WIDTH].map(|n| NonZeroU16::new(n).unwrap());
        vt100::Parser::new(rows, cols, 0)
    }

    fn text(lines: &[&str]) -> Buffer {
        let mut buffer = Buffer::empty(Rect::new(0, 0, WIDTH, HEIGHT));
        for (y, line) in (0..HEIGHT).zip(lines) {
            buffer.set_string(0, y, line, Style::new());
        }
        buffer
    }

    #[test]
    fn nothing_changed_is_no_byte() {
        let mut painter = painter(Colours::Sixteen, true);
        assert!(!painter.frame(text(&["hello"])).is_empty());
        assert!(painter.frame(text(&["hello"])).is_empty());
        assert_eq!(painter.frames().count, 1);
        painter.forget();
        assert!(!painter.frame(text(&["hello"])).is_empty());
    }

    #[test]
    fn what_the_terminal_cannot_show_is_no_change() {
        let mut painter = painter(Colours::None, true);
        painter.frame(text(&["hello"]));
        let mut red = text(&["hello"]);
        red.set_style(Rect::new(0, 0, 3, 1), Style::new().fg(Color::Red));
        assert!(painter.frame(red).is_empty());
    }

    #[test]
    fn faint_text_is_plain_on_a_console() {
        let mut faint = text(&["unit"]);
        faint.set_style(
            Rect::new(0, 0, 4, 1),
            Style::new().add_modifier(Modifier::DIM),
        );
        let bytes = |modern| {
            let mut painter = painter(Colours::Sixteen, modern);
            painter.frame(faint.clone()).escape_ascii().to_string()
        };
        assert!(bytes(true).contains(r"\x1b[2munit"), "{}", bytes(true));
        assert!(!bytes(false).contains("[2m"), "{}", bytes(false));
    }

    #[test]
    fn a_change_costs_what_it_must() {
        let mut painter = painter(Colours::Sixteen, false);
        painter.frame(text(&["omega 1.234", "alpha"]));
        let frame = painter.frame(text(&["omega 1.235", "Alpha"])).to_vec();
        assert_eq!(frame.escape_ascii().to_string(), r"\x1b[1;11H5\r\nA");
        let erased = painter.frame(text(&["", "Alpha"])).to_vec();
        assert_eq!(erased.escape_ascii().to_string(), r"\x1b[1H\x1b[K");
    }

    #[test]
    fn colours_of_the_palette_have_their_short_form() {
        let mut painter = painter(Colours::Sixteen, false);
        painter.frame(text(&[]));
        let mut wanted = text(&["ab"]);
        let bold_red = Style::new().fg(Color::Red).add_modifier(Modifier::BOLD);
        wanted.set_style(Rect::new(0, 0, 1, 1), bold_red);
        let frame = painter.frame(wanted).to_vec();
        assert_eq!(
            frame.escape_ascii().to_string(),
            r"\x1b[1H\x1b[1;31ma\x1b[0mb"
        );
    }

    fn screens() -> impl Strategy<Value = Buffer> {
        let styles = prop::sample::select(vec![
            Style::new(),
            Style::new().fg(Color::Red),
            Style::new().fg(Color::Cyan).add_modifier(Modifier::BOLD),
            Style::new().bg(Color::Blue),
            Style::new().add_modifier(Modifier::REVERSED | Modifier::UNDERLINED),
        ]);
        // Mostly blank, as screens are.
        let symbols = prop::sample::select("        abc|".chars().collect::<Vec<_>>());
        let cells = usize::from(WIDTH * HEIGHT);
        prop::collection::vec((symbols, styles), cells..=cells).prop_map(|cells| {
            let mut buffer = text(&[]);
            for (cell, (symbol, style)) in buffer.content.iter_mut().zip(cells) {
                cell.set_char(symbol).set_style(style);
            }
            buffer
        })
    }

    proptest! {
        /// Frame by frame, the terminal shows what it would show if all were drawn anew.
        #[test]
        fn differences_add_up_to_the_screen(
            screens in prop::collection::vec(screens(), 1..6),
            modern: bool,
        ) {
            let mut painter_of_differences = painter(Colours::Sixteen, modern);
            let mut shown = terminal();
            for screen in screens {
                shown.process(painter_of_differences.frame(screen.clone()));
                let mut anew = terminal();
                anew.process(painter(Colours::Sixteen, modern).frame(screen.clone()));
                for (y, x) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (y, x))) {
                    let cell = |t: &vt100::Parser| t.screen().cell(y, x).unwrap().clone();
                    let (a, b) = (cell(&shown), cell(&anew));
                    let blank = |c: &vt100::Cell| if c.has_contents() { c.contents().to_owned() } else { " ".to_owned() };
                    prop_assert_eq!(blank(&a), blank(&b));
                    prop_assert_eq!(blank(&a), screen[(x, y)].symbol());
                    prop_assert_eq!((a.bold(), a.inverse(), a.underline()), (b.bold(), b.inverse(), b.underline()));
                    prop_assert_eq!((a.fgcolor(), a.bgcolor()), (b.fgcolor(), b.bgcolor()));
                }
            }
        }
    }
}
