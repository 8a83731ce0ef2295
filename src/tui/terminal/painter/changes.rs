//! Computes the differences between the shown and the wanted screen as a list of writes.

use super::super::sgr::{CellStyle, Sgr, identical};
use ratatui::buffer::{Buffer, Cell};
use std::ops::Range;

/// Length of the sequence that erases to the end of a row.
const ERASING: usize = 3;
/// Minimum number of blanks that erasing a whole row must save. Fewer are just as quickly written.
const MIN_ERASED_BLANKS: usize = 12;

/// Minimum number of blanks to erase at once. `ESC [ n X` leaves the cursor where it is, so the next
/// write in the row moves it by a sequence of the same length.
pub(super) const MIN_ERASED_CELLS: usize = 11;

/// A write at one position.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellChange {
    pub(super) x: u16,
    pub(super) y: u16,
    /// The style in force. A blank, on which little of it shows, takes its neighbours' style.
    pub(super) style: Sgr,
    pub(super) what: ToWrite,
}

/// The content of a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ToWrite {
    /// The wanted cell.
    Cell,
    /// A similar character of one byte.
    Rough(char),
    /// Erasure from here to the end of the row.
    Nothing,
}

impl CellChange {
    /// Updates the shown screen after the write.
    pub(super) fn take_effect(self, shown: &mut Buffer, wanted: &Buffer) {
        let width = usize::from(wanted.area.width);
        let at = usize::from(self.y) * width + usize::from(self.x);
        match self.what {
            ToWrite::Cell => shown.content[at].clone_from(&wanted.content[at]),
            ToWrite::Rough(glyph) => {
                shown.content[at].clone_from(&wanted.content[at]);
                shown.content[at].set_char(glyph);
            }
            ToWrite::Nothing => {
                let end = (usize::from(self.y) + 1) * width;
                shown.content[at..end].fill(Cell::EMPTY);
            }
        }
    }
}

/// The shown and the wanted screen, of equal size, and the terminal's visible styles.
#[derive(Clone, Copy)]
pub(super) struct Screens<'a> {
    pub(super) look: CellStyle,
    pub(super) shown: &'a Buffer,
    pub(super) wanted: &'a Buffer,
}

impl Screens<'_> {
    /// Returns a row of the shown and of the wanted screen.
    pub(super) fn row(&self, y: u16) -> (&[Cell], &[Cell]) {
        let width = usize::from(self.wanted.area.width);
        let start = usize::from(y) * width;
        let row = start..start + width;
        (&self.shown.content[row.clone()], &self.wanted.content[row])
    }

    /// Appends the differences in a range of columns of a row, with similar characters if `rough`.
    ///
    /// Every cell of every frame is compared here, and only once. Most cells are equal, so the
    /// remaining work depends on the others only.
    pub(super) fn find(
        &self,
        y: u16,
        columns: Range<u16>,
        rough: bool,
        changes: &mut Vec<CellChange>,
    ) {
        let (shown, next) = self.row(y);
        let mut first = changes.len();
        let cells = columns.clone().zip(&next[within(&columns)]);
        let pairs = cells.zip(&shown[within(&columns)]);
        let differing = pairs.filter(|((_, cell), shown)| !identical(shown, cell));
        let differing =
            differing.filter_map(|((x, cell), shown)| self.change((x, y), shown, cell, rough));
        changes.extend(differing);
        if changes.len() == first {
            return;
        }
        let mut erases = None;
        if usize::from(columns.end) == next.len() {
            if self.is_erase_shorter(&changes[first..], columns.start) {
                changes.truncate(first);
                changes.push(erased(columns.start, y));
                first += 1;
                let cells = columns.clone().zip(&next[within(&columns)]);
                changes.extend(
                    cells.filter_map(|(x, cell)| self.change((x, y), &Cell::EMPTY, cell, rough)),
                );
            } else if let Some(end) = self.tail(&changes[first..]) {
                let stay = changes[first..].iter().filter(|c| c.x < end).count();
                changes.truncate(first + stay);
                erases = Some(erased(end, y));
            }
        }
        blanks_like_their_neighbours(&mut changes[first..], next);
        changes.extend(erases);
    }

    /// Returns the write at a position, if it changes the terminal visibly.
    fn change(
        &self,
        (x, y): (u16, u16),
        shown: &Cell,
        cell: &Cell,
        rough: bool,
    ) -> Option<CellChange> {
        if self.look.same(shown, cell) {
            return None;
        }
        let mut what = ToWrite::Cell;
        if let Some(glyph) = rough.then(|| roughly(cell)).flatten() {
            let mut rough = cell.clone();
            if self.look.same(shown, rough.set_char(glyph)) {
                return None;
            }
            what = ToWrite::Rough(glyph);
        }
        Some(CellChange {
            x,
            y,
            style: self.look.sgr_of(cell),
            what,
        })
    }

    /// Returns `true` if a change erases visible content.
    fn takes_away(&self, change: &CellChange) -> bool {
        let (shown, next) = self.row(change.y);
        let at = usize::from(change.x);
        self.look.is_blank(&next[at]) && !self.look.is_blank(&shown[at])
    }

    /// Returns the number of bytes that blank out visible content, cell by cell or in runs.
    fn erasing_len(&self, changes: &[CellChange]) -> usize {
        let (mut len, mut run, mut next) = (0, 0, None);
        for change in changes.iter().filter(|c| self.takes_away(c)) {
            run = if next == Some(change.x) { run + 1 } else { 1 };
            if run <= MIN_ERASED_CELLS || !self.look.erases_cells {
                len += 1;
            }
            next = Some(change.x + 1);
        }
        len
    }

    /// Returns `true` if erasing the row from here on is shorter than writing blanks. Erased
    /// content that stays must be written again.
    fn is_erase_shorter(&self, changes: &[CellChange], from: u16) -> bool {
        let gone = self.erasing_len(changes);
        // A quick exit: most frames change only a few cells of a row.
        let saved = gone.saturating_sub(MIN_ERASED_BLANKS);
        if saved == 0 {
            return false;
        }
        let (shown, next) = self.row(changes[0].y);
        let from = usize::from(from);
        let stays = shown[from..].iter().zip(&next[from..]);
        let stays = stays.filter(|(a, b)| !self.look.is_blank(b) && self.look.same(a, b));
        stays.take(saved).count() < saved
    }

    /// Returns the column from which the row is erased at once, if that is shorter than cell by
    /// cell.
    fn tail(&self, changes: &[CellChange]) -> Option<u16> {
        let (_, next) = self.row(changes[0].y);
        let is_ink = |cell: &Cell| !self.look.is_blank(cell);
        let last = changes.iter().rev();
        let last = last.take_while(|change| !is_ink(&next[usize::from(change.x)]));
        if last.filter(|c| self.takes_away(c)).count() <= ERASING {
            return None;
        }
        let end = next.iter().rposition(is_ink).map_or(0, |i| to_u16(i + 1));
        let after = changes.iter().filter(|change| change.x >= end);
        (after.filter(|c| self.takes_away(c)).count() > ERASING).then_some(end)
    }
}

/// Returns the erasure of the row from `x` on.
fn erased(x: u16, y: u16) -> CellChange {
    CellChange {
        x,
        y,
        style: Sgr::PLAIN,
        what: ToWrite::Nothing,
    }
}

/// Converts a range of columns to indices into a row's cells.
fn within(columns: &Range<u16>) -> Range<usize> {
    usize::from(columns.start)..usize::from(columns.end)
}

/// Gives blanks the style of the nearest write in their row, if it does not show on blanks.
fn blanks_like_their_neighbours(changes: &mut [CellChange], row: &[Cell]) {
    let is_blank = |change: &CellChange| {
        change.style == Sgr::PLAIN && row[usize::from(change.x)].symbol() == " "
    };
    let mut before: Option<CellChange> = None;
    let mut i = 0;
    while i < changes.len() {
        let blanks = changes[i..].iter().take_while(|c| is_blank(c)).count();
        let after = changes.get(i + blanks).copied();
        for blank in &mut changes[i..i + blanks] {
            let near = [before, after].into_iter().flatten();
            let near = near.filter(|ink| ink.style.is_blank_background());
            if let Some(ink) = near.min_by_key(|ink| ink.x.abs_diff(blank.x)) {
                blank.style = ink.style;
            }
        }
        before = after;
        i += blanks + 1;
    }
}

/// Sorts changes by style: plain ones first, because erased cells are written again after them,
/// then the others in order of appearance.
pub(super) fn sort_by_style(changes: &[CellChange], sorted: &mut Vec<CellChange>) {
    let mut styles = vec![Sgr::PLAIN];
    for change in changes {
        if !styles.contains(&change.style) {
            styles.push(change.style);
        }
    }
    sorted.clear();
    for style in styles {
        sorted.extend(changes.iter().filter(|change| change.style == style));
    }
}

/// Returns a character of one byte that resembles a cell's character of three bytes.
fn roughly(cell: &Cell) -> Option<char> {
    match cell.symbol() {
        "\u{2500}" => Some('-'),
        "\u{2502}" => Some('|'),
        "\u{250c}" | "\u{2510}" | "\u{2514}" | "\u{2518}" => Some('+'),
        _ => None,
    }
}

/// Converts a position within a row, which is at most `u16::MAX` wide.
fn to_u16(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}
