//! Computes the shortest byte sequence that updates the terminal to a wanted screen.
//!
//! The painter knows the terminal's contents, compares them with the wanted screen, and writes the
//! differences: one frame is one block of bytes, or none at all. It uses only sequences of a VT100
//! (CUP, CUU, CUD, CUF, CUB, EL, SGR), sends no queries, and never relies on the cursor position
//! after the last column. Every cell is one column wide; the views exclude wider characters.
//!
//! Differences are written row by row, or style by style if that is shorter, as for a drawing in
//! true colours.
//!
//! A frame that exceeds the line's capacity is cut, and the rest is carried over: the terminal's
//! contents are known cell by cell, so the next frame simply contains the remaining changes. Urgent
//! parts come first, then the rest from the top or from the row of the last cut.

mod changes;
mod pen;

use super::queue;
use super::sgr::{CellStyle, Sgr, identical};
use crate::capability::Capability;
use crate::tui::Frames;
use crate::tui::appearance::palette::{Palette, Theme};
use changes::{CellChange, Screens};
use crossterm::style::ResetColor;
use crossterm::terminal::{BeginSynchronizedUpdate, Clear, ClearType, EndSynchronizedUpdate};
use pen::CellPen;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// Maximum length of a frame's start: synchronized mode, and clearing the screen.
const MAX_FRAME_START: usize = 16;
/// Maximum length beyond the limit at a frame's end: one cell with cursor movement and attributes,
/// and their reset.
const MAX_FRAME_END: usize = 32;
/// Limit below which the line counts as slow, so that urgent parts are first drawn roughly.
const SLOW_LINE_LIMIT: usize = 1000;

/// Computes frames.
#[derive(Debug)]
pub(crate) struct Painter {
    look: CellStyle,
    /// `true` if frames use synchronized mode, so that they appear at once.
    synchronised: bool,
    /// The terminal's contents, unless `stale`.
    shown: Buffer,
    /// The wanted screen.
    wanted: Buffer,
    /// `true` if the terminal's contents are unknown and must be cleared and redrawn.
    stale: bool,
    /// The row at which the last frame was cut.
    cut: Option<u16>,
    /// The maximum length of a frame, in bytes.
    max_frame_len: usize,
    pen: CellPen,
    /// The changes to write, row by row and style by style.
    changes: Vec<CellChange>,
    by_style: Vec<CellChange>,
    frames: Frames,
}

impl Painter {
    /// Creates a painter for a terminal with unknown contents.
    #[must_use]
    pub(crate) fn new(capability: Capability) -> Self {
        let palette = Palette {
            colours: capability.colours,
            theme: Theme::Auto,
            has_weak_text: false,
        };
        Painter {
            look: CellStyle {
                palette,
                has_faint: capability.modern,
                erases_cells: capability.modern,
            },
            synchronised: capability.modern,
            shown: Buffer::empty(Rect::ZERO),
            wanted: Buffer::empty(Rect::ZERO),
            stale: true,
            cut: None,
            max_frame_len: usize::MAX,
            pen: CellPen::default(),
            changes: Vec::new(),
            by_style: Vec::new(),
            frames: Frames::default(),
        }
    }

    /// Marks the terminal's contents as unknown: the next frame clears and redraws everything.
    pub(crate) fn forget(&mut self) {
        self.stale = true;
    }

    /// Sets the palette. A different one causes a complete redraw.
    pub(crate) fn paint_with(&mut self, palette: Palette) {
        self.stale |= self.look.palette != palette;
        self.look.palette = palette;
    }

    /// Returns `true` if a part of the terminal differs from the wanted screen.
    #[must_use]
    pub(crate) fn differs_in(&self, part: Rect) -> bool {
        let part = part.intersection(self.wanted.area);
        self.shown.area != self.wanted.area
            || part
                .positions()
                .any(|at| !identical(&self.shown[at], &self.wanted[at]))
    }

    /// Returns the number and size of the frames so far.
    #[must_use]
    pub(crate) fn frames(&self) -> Frames {
        self.frames
    }

    /// Returns `true` if the last frame was cut, so that the terminal lacks part of the wanted
    /// screen.
    #[must_use]
    pub(crate) fn is_cut(&self) -> bool {
        self.cut.is_some()
    }

    /// Returns the wanted screen for the next frame: empty, of this size.
    pub(crate) fn canvas(&mut self, area: Rect) -> &mut Buffer {
        empty(&mut self.wanted, area);
        &mut self.wanted
    }

    /// Keeps the terminal's contents outside some areas in the wanted screen.
    pub(crate) fn keep_outside(&mut self, areas: &[Rect]) {
        if self.stale || self.shown.area != self.wanted.area {
            return;
        }
        for at in self.wanted.area.positions() {
            if !areas.iter().any(|area| area.contains(at)) {
                self.wanted[at].clone_from(&self.shown[at]);
            }
        }
    }

    /// Makes all text of an area plain in the wanted screen.
    pub(crate) fn drop_styles(&mut self, area: Rect) {
        for at in area.intersection(self.wanted.area).positions() {
            self.wanted[at].set_style(Style::reset());
        }
    }

    /// Returns the bytes that update the terminal, `urgent` parts first; none if it is up to date.
    /// About `room` bytes at most: [`Painter::is_cut`] says whether that was enough.
    pub(crate) fn frame(&mut self, urgent: &[Rect], space: usize) -> &[u8] {
        self.pen.start_frame();
        self.stale |= self.shown.area != self.wanted.area;
        // A slow line takes longer for the brackets than the terminal for the frame.
        let synchronised = self.synchronised && space >= SLOW_LINE_LIMIT;
        if synchronised {
            queue(&mut self.pen.bytes, BeginSynchronizedUpdate);
        }
        let prologue = self.pen.bytes.len();
        let clear = std::mem::take(&mut self.stale);
        if clear {
            empty(&mut self.shown, self.wanted.area);
            queue(&mut self.pen.bytes, ResetColor);
            queue(&mut self.pen.bytes, Clear(ClearType::All));
        }
        self.max_frame_len = space.saturating_sub(MAX_FRAME_END);
        let from = self.cut.take().unwrap_or(0);
        self.cut = self.rows(urgent, from).err();
        if self.pen.bytes.len() == prologue {
            // The screens differ only in properties that this terminal lacks, such as colours.
            self.pen.bytes.clear();
            return &self.pen.bytes;
        }
        self.pen.set(Sgr::PLAIN);
        if self.is_cut() {
            // A cut frame need not appear at once, and the brackets cost as much as a number.
            self.pen.bytes.drain(..prologue);
        } else if synchronised {
            queue(&mut self.pen.bytes, EndSynchronizedUpdate);
        }
        self.frames.count += 1;
        self.frames.bytes += self.pen.bytes.len() as u64;
        &self.pen.bytes
    }

    /// Writes the differences up to the limit. The error is the row of the cut.
    fn rows(&mut self, urgent: &[Rect], from: u16) -> Result<(), u16> {
        let area = self.wanted.area;
        let rough = self.max_frame_len < SLOW_LINE_LIMIT;
        for part in urgent.iter().map(|part| part.intersection(area)) {
            for y in part.top()..part.bottom() {
                self.find(y, part, rough);
            }
            self.write().map_err(|_| from)?;
        }
        for y in (from..area.height).chain(0..from.min(area.height)) {
            self.find(y, area, false);
        }
        self.write()
    }

    /// Lists the differences in a range of columns of a row.
    fn find(&mut self, y: u16, columns: Rect, rough: bool) {
        let screens = Screens {
            look: self.look,
            shown: &self.shown,
            wanted: &self.wanted,
        };
        screens.find(y, columns.left()..columns.right(), rough, &mut self.changes);
    }

    /// Writes the listed changes in the shorter order. If they exceed the limit, writes them row by
    /// row; the error is the row of the cut.
    fn write(&mut self) -> Result<(), u16> {
        let screens = Screens {
            look: self.look,
            shown: &self.shown,
            wanted: &self.wanted,
        };
        let by_row = self.pen.write(screens, &self.changes, self.max_frame_len);
        let cut = self.changes.get(by_row.written).map(|change| change.y);
        if cut.is_none() {
            changes::sort_by_style(&self.changes, &mut self.by_style);
            self.pen.write_instead(screens, &self.by_style, &by_row);
        }
        for change in self.changes.drain(..).take(by_row.written) {
            change.take_effect(&mut self.shown, &self.wanted);
        }
        cut.map_or(Ok(()), Err)
    }
}

/// Resizes a buffer and clears it, reusing its memory.
fn empty(buffer: &mut Buffer, area: Rect) {
    buffer.resize(area);
    buffer.reset();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capability::Colours;
    use crate::drawing::Glyphs;
    use proptest::prelude::*;
    use ratatui::style::{Color, Modifier};
    use std::num::NonZeroU16;

    const WIDTH: u16 = 12;
    const HEIGHT: u16 = 4;
    const SYNC_ON: &[u8] = b"\x1b[?2026h";
    const SYNC_OFF: &[u8] = b"\x1b[?2026l";

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

    impl Painter {
        fn full_frame(&mut self, wanted: Buffer) -> &[u8] {
            self.wanted = wanted;
            self.frame(&[], usize::MAX)
        }
    }

    fn text(lines: &[&str]) -> Buffer {
        let mut buffer = Buffer::empty(Rect::new(0, 0, WIDTH, HEIGHT));
        for (y, line) in (0..HEIGHT).zip(lines) {
            buffer.set_string(0, y, line, Style::new());
        }
        buffer
    }

    #[test]
    fn unchanged_screen_writes_no_bytes() {
        let mut painter = painter(Colours::Sixteen, true);
        assert!(!painter.full_frame(text(&["hello"])).is_empty());
        assert!(painter.full_frame(text(&["hello"])).is_empty());
        assert_eq!(painter.frames().count, 1);
        painter.forget();
        assert!(!painter.full_frame(text(&["hello"])).is_empty());
    }

    #[test]
    fn unsupported_colour_change_writes_no_bytes() {
        let mut painter = painter(Colours::None, true);
        painter.full_frame(text(&["hello"]));
        let mut red = text(&["hello"]);
        red.set_style(Rect::new(0, 0, 3, 1), Style::new().fg(Color::Red));
        assert!(painter.full_frame(red).is_empty());
    }

    #[test]
    fn run_of_blanks_is_erased_at_once() {
        let [long, short] = ["-", " "].map(|fill| text(&[&format!("{}y", fill.repeat(11)), "z"]));
        for modern in [true, false] {
            let (mut painter, mut terminal) = (painter(Colours::None, modern), terminal());
            terminal.process(painter.full_frame(long.clone()));
            let bytes = painter.full_frame(short.clone());
            terminal.process(bytes);
            let bytes = bytes.escape_ascii().to_string();
            assert_eq!(bytes.contains(r"\x1b[11X"), modern, "{bytes}");
            let row = terminal.screen().rows(0, WIDTH).next();
            assert_eq!(row.as_deref(), Some("           y"), "{bytes}");
        }
    }

    #[test]
    fn faint_text_is_plain_on_console() {
        let mut faint = text(&["unit"]);
        faint.set_style(
            Rect::new(0, 0, 4, 1),
            Style::new().add_modifier(Modifier::DIM),
        );
        let bytes = |modern| {
            let mut painter = painter(Colours::Sixteen, modern);
            painter.full_frame(faint.clone()).escape_ascii().to_string()
        };
        assert!(bytes(true).contains(r"\x1b[2munit"), "{}", bytes(true));
        assert!(!bytes(false).contains("[2m"), "{}", bytes(false));
    }

    /// Without faint text, guides are plain: only bold makes links stand out.
    #[test]
    fn links_are_bold_on_console() {
        let mut link = text(&["bar|guide"]);
        let blue = Style::new().fg(Color::Blue);
        link.set_style(Rect::new(0, 0, 3, 1), blue);
        for (colours, modern, bold) in [
            (Colours::None, false, true),
            (Colours::Sixteen, false, true),
            (Colours::Sixteen, true, false),
            (Colours::Indexed, false, false),
        ] {
            let frame = painter(colours, modern).full_frame(link.clone()).to_vec();
            let frame = frame.escape_ascii().to_string();
            let is_bold = frame.contains("[1mbar\\x1b[m|guide");
            assert_eq!(is_bold, bold, "{colours:?}, {modern}: {frame}");
        }
    }

    #[test]
    fn changes_use_shortest_sequences() {
        let mut painter = painter(Colours::Sixteen, false);
        painter.full_frame(text(&["omega 1.234", "alpha"]));
        let frame = painter.full_frame(text(&["omega 1.235", "Alpha"])).to_vec();
        assert_eq!(frame.escape_ascii().to_string(), r"\x1b[1;11H5\r\nA");
        let erased = painter.full_frame(text(&["", "Alpha"])).to_vec();
        assert_eq!(erased.escape_ascii().to_string(), r"\x1b[1;1H\x1b[K");
    }

    /// Regression: each step to another row took an absolute position, a fifth of all bytes.
    #[test]
    fn cursor_moves_by_shortest_sequence() {
        let mut painter = painter(Colours::Sixteen, false);
        painter.full_frame(text(&[]));
        let frame = painter
            .full_frame(text(&["     ab", "    cd", "         e"]))
            .to_vec();
        let moves = r"\x1b[1;6Hab\n\x08\x08\x08cd\n\x1b[3Ce";
        assert_eq!(frame.escape_ascii().to_string(), moves);
        let frame = painter
            .full_frame(text(&["     ac", "    cd", "         f"]))
            .to_vec();
        assert_eq!(frame.escape_ascii().to_string(), r"\x1b[1;7Hc\n\n\x1b[2Cf");
    }

    #[test]
    fn palette_colours_use_short_form() {
        let mut painter = painter(Colours::Sixteen, false);
        painter.full_frame(text(&[]));
        let mut wanted = text(&["ab"]);
        let bold_red = Style::new().fg(Color::Red).add_modifier(Modifier::BOLD);
        wanted.set_style(Rect::new(0, 0, 1, 1), bold_red);
        let frame = painter.full_frame(wanted).to_vec();
        assert_eq!(
            frame.escape_ascii().to_string(),
            r"\x1b[1;1H\x1b[1;91ma\x1b[mb"
        );
    }

    /// A true colour takes more bytes than a cursor movement across the screen, so that all cells
    /// of one colour are written together.
    #[test]
    fn true_colours_are_written_grouped_by_colour() {
        let look = Palette {
            colours: Colours::True,
            theme: Theme::Dark,
            has_weak_text: false,
        };
        let mut painter = painter(Colours::True, false);
        painter.paint_with(look);
        painter.full_frame(text(&[]));
        let mut wanted = text(&["a      o", "a      o", "a      o"]);
        wanted.set_style(Rect::new(0, 0, 1, 3), Style::new().fg(Color::Red));
        wanted.set_style(Rect::new(7, 0, 1, 3), Style::new().fg(Color::Cyan));
        let frame = painter.full_frame(wanted).escape_ascii().to_string();
        assert_eq!(frame.matches("[38;").count(), 2, "{frame}");
        let a = frame.rfind('a');
        assert!(a < frame.find('o'), "{frame}");
    }

    fn screens() -> impl Strategy<Value = Buffer> {
        let styles = prop::sample::select(vec![
            Style::new(),
            Style::new().fg(Color::Red),
            Style::new().fg(Color::Cyan).add_modifier(Modifier::BOLD),
            Style::new().bg(Color::Blue),
            Style::new().add_modifier(Modifier::REVERSED | Modifier::UNDERLINED),
        ]);
        // Mostly blank, like real screens.
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

    /// Returns the visible properties of a cell: those of a blank exclude its colour and boldness.
    fn visible_properties(
        terminal: &vt100::Parser,
        x: u16,
        y: u16,
    ) -> impl PartialEq + std::fmt::Debug {
        let cell = terminal.screen().cell(y, x).unwrap();
        let blank = !cell.has_contents() || cell.contents() == " ";
        let ink = (!blank || cell.inverse()).then(|| (cell.fgcolor(), cell.bold(), cell.dim()));
        let text = if blank { " " } else { cell.contents() };
        let ground = (cell.bgcolor(), cell.inverse(), cell.underline());
        (text.to_owned(), ink, ground)
    }

    fn shows(terminal: &vt100::Parser, screen: &Buffer, modern: bool) -> Result<(), TestCaseError> {
        let mut anew = self::terminal();
        anew.process(painter(Colours::Sixteen, modern).full_frame(screen.clone()));
        for (y, x) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (y, x))) {
            prop_assert_eq!(
                visible_properties(terminal, x, y),
                visible_properties(&anew, x, y),
                "{} {}",
                x,
                y
            );
            let contents = anew.screen().cell(y, x).unwrap().contents();
            let contents = if contents.is_empty() { " " } else { contents };
            prop_assert_eq!(contents, screen[(x, y)].symbol());
        }
        Ok(())
    }

    proptest! {
        /// After each frame, the terminal shows what a complete redraw would show.
        #[test]
        fn frame_differences_add_up_to_screen(
            screens in prop::collection::vec(screens(), 1..6),
            modern: bool,
        ) {
            let mut painter = painter(Colours::Sixteen, modern);
            let mut shown = terminal();
            for screen in screens {
                shown.process(painter.full_frame(screen.clone()));
                shows(&shown, &screen, modern)?;
            }
        }

        /// Cut frames also add up to the screen, even if the next screen arrives before the last
        /// one is complete. No frame exceeds its length limit.
        #[test]
        fn cut_frames_add_up_to_screen(
            screens in prop::collection::vec((screens(), 0_usize..6), 1..6),
            space in 0_usize..120,
            modern: bool,
        ) {
            let mut painter = painter(Colours::Sixteen, modern);
            let mut shown = terminal();
            let urgent = [Rect::new(0, HEIGHT - 1, WIDTH, 1), Rect::new(3, 1, 4, 2)];
            let maximum = space.max(MAX_FRAME_START + SYNC_OFF.len() + 1) + MAX_FRAME_END;
            let last = screens.last().unwrap().0.clone();
            for (screen, frames) in screens {
                painter.wanted = screen.clone();
                for _ in 0..frames {
                    let frame = painter.frame(&urgent, space);
                    prop_assert!(frame.len() <= maximum, "{} of {}", frame.len(), space);
                    shown.process(frame);
                }
            }
            painter.wanted = last.clone();
            let mut frames = 0;
            while frames == 0 || painter.is_cut() {
                shown.process(painter.frame(&urgent, space));
                frames += 1;
                prop_assert!(frames < 200, "a frame must bring something");
            }
            shows(&shown, &last, modern)?;
        }
    }

    /// On a slow line a box is first drawn in ASCII, which takes a third of the bytes.
    #[test]
    fn boxes_are_ascii_first_in_short_frames() {
        let mut painter = painter(Colours::None, true);
        painter.full_frame(text(&[]));
        let line = "\u{2500}".repeat(12);
        let urgent = [Rect::new(0, 1, WIDTH, 1); 2];
        painter.wanted = text(&["", &line]);
        let rough = painter.frame(&urgent, MAX_FRAME_END + 17).to_vec();
        assert!(painter.is_cut() && rough.is_ascii());
        let mut last = rough;
        while painter.is_cut() {
            last.extend(painter.frame(&urgent, MAX_FRAME_END + 17));
        }
        let text_of = String::from_utf8(last).unwrap();
        let dashes = text_of.find('-').unwrap();
        assert!(dashes < text_of.find('\u{2500}').unwrap());
        assert_eq!(text_of.matches('\u{2500}').count(), 12);
        painter.forget();
        let at_once = painter.full_frame(text(&["", &line]));
        assert!(!at_once.contains(&b'-'), "not where there is room");
    }

    #[test]
    fn urgent_areas_are_written_first() {
        let mut painter = painter(Colours::None, true);
        painter.full_frame(text(&["", "", "", ""]));
        painter.wanted = text(&["wwwwwwww", "xxxxxxxx", "yyyyyyyy", "zzzzzzzz"]);
        let urgent = [Rect::new(0, 3, WIDTH, 1), Rect::new(0, 2, 5, 1)];
        let mut frames = vec![painter.frame(&urgent, MAX_FRAME_END + 1).to_vec()];
        while painter.is_cut() {
            frames.push(painter.frame(&urgent, MAX_FRAME_END + 1).to_vec());
        }
        assert!(frames.len() > 1 && !frames[0].starts_with(SYNC_ON));
        let mut rows = frames.concat();
        rows.retain(|byte| b"wxyz".contains(byte));
        rows.dedup();
        assert_eq!(String::from_utf8(rows).unwrap(), "zywxy");
    }
}
