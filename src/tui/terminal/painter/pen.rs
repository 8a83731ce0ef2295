//! Writes changes in a given order, with the shortest cursor movements between them.

use super::super::queue;
use super::super::sgr::{CellStyle, Sgr, escape};
use super::MAX_FRAME_START;
use super::changes::{CellChange, MIN_ERASED_CELLS, Screens, ToWrite};
use crossterm::cursor::MoveTo;
use crossterm::terminal::{Clear, ClearType};
use ratatui::buffer::Cell;

/// Maximum number of unchanged cells to rewrite instead of skipping: `ESC [ n C` has the same
/// length.
const REWRITE: u16 = 4;

/// Length of the sequence that resets the style.
const RESET_LEN: usize = 3;

/// The written bytes, and the terminal's state after them.
#[derive(Debug)]
pub(super) struct CellPen {
    pub(super) bytes: Vec<u8>,
    /// The cursor position, if known.
    cursor: Option<(u16, u16)>,
    sgr: Sgr,
    /// The bytes of the other order, during a comparison of lengths.
    other: Vec<u8>,
}

impl Default for CellPen {
    fn default() -> Self {
        CellPen {
            bytes: Vec::new(),
            cursor: None,
            sgr: Sgr::PLAIN,
            other: Vec::new(),
        }
    }
}

/// A written list: the state before it, and the number of changes written.
pub(super) struct WrittenList {
    start: usize,
    cursor: Option<(u16, u16)>,
    sgr: Sgr,
    pub(super) written: usize,
}

impl CellPen {
    /// Starts a frame: the cursor position is unknown, the style is plain.
    pub(super) fn start_frame(&mut self) {
        self.bytes.clear();
        (self.cursor, self.sgr) = (None, Sgr::PLAIN);
    }

    /// Switches to a style.
    pub(super) fn set(&mut self, style: Sgr) {
        style.write_style(self.sgr, &mut self.bytes);
        self.sgr = style;
    }

    /// Writes changes up to the limit. Even with a tiny limit, every frame writes something.
    pub(super) fn write(
        &mut self,
        screens: Screens<'_>,
        changes: &[CellChange],
        space: usize,
    ) -> WrittenList {
        let mut list = WrittenList {
            start: self.bytes.len(),
            cursor: self.cursor,
            sgr: self.sgr,
            written: 0,
        };
        while let Some(change) = changes.get(list.written) {
            let has_begun = self.bytes.len() > MAX_FRAME_START;
            if has_begun && self.bytes.len() >= space {
                break;
            }
            if let Some((cells, blanks)) = blanks_in_row(screens, &changes[list.written..]) {
                let (shown, row) = screens.row(change.y);
                self.go_to(change, screens.look, shown, row);
                self.set(change.style);
                escape(&mut self.bytes, format_args!("\x1b[{cells}X"));
                list.written += blanks;
            } else {
                self.write_change(screens, change);
                list.written += 1;
            }
        }
        list
    }

    /// Writes a list in another order and keeps that version if it is shorter.
    pub(super) fn write_instead(
        &mut self,
        screens: Screens<'_>,
        changes: &[CellChange],
        list: &WrittenList,
    ) {
        let (cursor, sgr) = (self.cursor, self.sgr);
        self.other.clear();
        self.other.extend_from_slice(&self.bytes[list.start..]);
        self.bytes.truncate(list.start);
        (self.cursor, self.sgr) = (list.cursor, list.sgr);
        self.write(screens, changes, usize::MAX);
        // The style at the end must be reset.
        let ending = |sgr: Sgr| if sgr == Sgr::PLAIN { 0 } else { RESET_LEN };
        let this = self.bytes.len() - list.start + ending(self.sgr);
        if this >= self.other.len() + ending(sgr) {
            self.bytes.truncate(list.start);
            self.bytes.append(&mut self.other);
            (self.cursor, self.sgr) = (cursor, sgr);
        }
    }

    fn write_change(&mut self, screens: Screens<'_>, change: &CellChange) {
        let (shown, row) = screens.row(change.y);
        self.go_to(change, screens.look, shown, row);
        self.set(change.style);
        let symbol = row[usize::from(change.x)].symbol();
        match change.what {
            ToWrite::Cell => self.bytes.extend_from_slice(symbol.as_bytes()),
            ToWrite::Rough(glyph) => {
                let mut utf8 = [0; 4];
                let text = glyph.encode_utf8(&mut utf8);
                self.bytes.extend_from_slice(text.as_bytes());
            }
            ToWrite::Nothing => {
                queue(&mut self.bytes, Clear(ClearType::UntilNewLine));
                return;
            }
        }
        // Terminals differ in the cursor position after the last column.
        let next = (change.x + 1, change.y);
        self.cursor = (usize::from(next.0) < row.len()).then_some(next);
    }

    /// Moves the cursor by the shortest sequence.
    fn go_to(&mut self, change: &CellChange, look: CellStyle, shown: &[Cell], row: &[Cell]) {
        let (x, y) = (change.x, change.y);
        match self.cursor {
            Some(at) if at == (x, y) => return,
            Some((cx, cy)) if cy == y && cx < x => {
                let between = usize::from(cx)..usize::from(x);
                let (stay, are) = (&row[between.clone()], &shown[between]);
                let as_they_are = |(cell, shown): (&Cell, &Cell)| {
                    cell.symbol().len() == 1 && look.same(cell, shown) && self.suits(look, cell)
                };
                if x - cx <= REWRITE && stay.iter().zip(are).all(as_they_are) {
                    for cell in stay {
                        self.bytes.extend_from_slice(cell.symbol().as_bytes());
                    }
                } else {
                    self.step(x - cx, None, 'C');
                }
            }
            Some((cx, cy)) => self.move_cursor((cx, cy), (x, y)),
            None => queue(&mut self.bytes, MoveTo(x, y)),
        }
        self.cursor = Some((x, y));
    }

    /// Moves by the shortest of an absolute position, steps from the cursor, and steps from the
    /// start of its row.
    fn move_cursor(&mut self, (cx, cy): (u16, u16), (x, y): (u16, u16)) {
        let start = self.bytes.len();
        queue(&mut self.bytes, MoveTo(x, y));
        for returns in [false, true] {
            let end = self.bytes.len();
            let from = if returns { 0 } else { cx };
            self.bytes.extend(returns.then_some(b'\r'));
            match y >= cy {
                true => self.step(y - cy, Some(b'\n'), 'B'),
                false => self.step(cy - y, None, 'A'),
            }
            match x >= from {
                true => self.step(x - from, None, 'C'),
                false => self.step(from - x, Some(b'\x08'), 'D'),
            }
            if self.bytes.len() - end < end - start {
                self.bytes.drain(start..end);
            } else {
                self.bytes.truncate(end);
            }
        }
    }

    /// Moves the cursor by some cells in a direction: by a sequence, or by control characters if they
    /// are shorter.
    fn step(&mut self, count: u16, control: Option<u8>, direction: char) {
        match (count, control) {
            (0, _) => {}
            (1..4, Some(control)) => self
                .bytes
                .resize(self.bytes.len() + usize::from(count), control),
            (1, None) => escape(&mut self.bytes, format_args!("\x1b[{direction}")),
            (_, _) => escape(&mut self.bytes, format_args!("\x1b[{count}{direction}")),
        }
    }

    /// Returns `true` if a cell looks right in the current style. On a blank, little of a style
    /// shows.
    fn suits(&self, look: CellStyle, cell: &Cell) -> bool {
        let sgr = look.sgr_of(cell);
        sgr == self.sgr
            || (cell.symbol() == " " && sgr == Sgr::PLAIN && self.sgr.is_blank_background())
    }
}

/// Returns the number of cells at the start of a list that are erased at once, and the number of their
/// changes; `None` if writing blanks is shorter. Blanks between them that do not change are erased,
/// too.
fn blanks_in_row(screens: Screens<'_>, changes: &[CellChange]) -> Option<(usize, usize)> {
    let first = changes.first().filter(|_| screens.look.erases_cells)?;
    let (_, row) = screens.row(first.y);
    let is_erased = |change: &&CellChange| {
        change.y == first.y
            && change.what == ToWrite::Cell
            && change.style.is_blank_background()
            && row[usize::from(change.x)].symbol() == " "
    };
    let from = usize::from(first.x);
    let (mut end, mut count, mut written) = (from, 0, 0);
    for change in changes.iter().take_while(is_erased) {
        let x = usize::from(change.x);
        if x < end || !row[end..x].iter().all(|cell| screens.look.is_blank(cell)) {
            break;
        }
        written += (x - end).min(usize::from(REWRITE)) + 1;
        (end, count) = (x + 1, count + 1);
    }
    (written >= MIN_ERASED_CELLS).then_some((end - from, count))
}
