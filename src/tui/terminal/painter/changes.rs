//! What differs between the screen that is shown and the one that is wanted, as a list of what to write where.

use super::super::sgr::{CellStyle, Sgr, identical};
use ratatui::buffer::{Buffer, Cell};
use std::ops::Range;

/// What erasing to the end of a row costs.
const ERASING: usize = 3;
/// Blanks that are saved by erasing a row: fewer are as soon written.
const WORTH_WIPING: usize = 12;

/// What is written at one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellChange {
    pub(super) x: u16,
    pub(super) y: u16,
    /// With what in force: a blank, of which little of it is seen, takes that of its neighbours.
    pub(super) style: Sgr,
    pub(super) what: ToWrite,
}

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ToWrite {
    /// The cell that is wanted.
    Cell,
    /// A character of one byte that looks like it.
    Rough(char),
    /// Nothing from here to the end of the row.
    Nothing,
}

impl CellChange {
    /// Notes that it was written.
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

/// What is shown and what is wanted, of the same size, and what of it can be seen.
#[derive(Clone, Copy)]
pub(super) struct Screens<'a> {
    pub(super) look: CellStyle,
    pub(super) shown: &'a Buffer,
    pub(super) wanted: &'a Buffer,
}

impl Screens<'_> {
    /// A row of what is shown, and of what is wanted.
    pub(super) fn row(&self, y: u16) -> (&[Cell], &[Cell]) {
        let width = usize::from(self.wanted.area.width);
        let start = usize::from(y) * width;
        let row = start..start + width;
        (&self.shown.content[row.clone()], &self.wanted.content[row])
    }

    /// Appends what differs in some columns of a row, in rough characters if it may.
    pub(super) fn find(
        &self,
        y: u16,
        columns: Range<u16>,
        rough: bool,
        changes: &mut Vec<CellChange>,
    ) {
        let (shown, next) = self.row(y);
        let Some(changed) = changed(columns.clone(), shown, next) else {
            return;
        };
        let erased = |x: u16| CellChange {
            x,
            y,
            style: Sgr::PLAIN,
            what: ToWrite::Nothing,
        };
        let is_wiped = changed.len() > WORTH_WIPING && self.is_worth_wiping(&columns, shown, next);
        let changed = if is_wiped {
            changes.push(erased(columns.start));
            columns.clone()
        } else {
            changed
        };
        let at_end = usize::from(columns.end) == next.len();
        let (end, erase) = if at_end && !is_wiped {
            self.tail(shown, next)
        } else {
            (columns.end, false)
        };
        let first = changes.len();
        for x in changed.start..changed.end.min(end) {
            let cell = &next[usize::from(x)];
            let shown = if is_wiped {
                &Cell::EMPTY
            } else {
                &shown[usize::from(x)]
            };
            if self.look.same(shown, cell) {
                continue;
            }
            let mut what = ToWrite::Cell;
            if let Some(glyph) = rough.then(|| roughly(cell)).flatten() {
                let mut rough = cell.clone();
                if self.look.same(shown, rough.set_char(glyph)) {
                    continue;
                }
                what = ToWrite::Rough(glyph);
            }
            changes.push(CellChange {
                x,
                y,
                style: self.look.sgr_of(cell),
                what,
            });
        }
        blanks_like_their_neighbours(&mut changes[first..], next);
        if erase {
            changes.push(erased(end));
        }
    }

    /// Whether it is cheaper to erase a row from these columns on than to write blanks one by one: what is
    /// erased and stays is written again.
    fn is_worth_wiping(&self, columns: &Range<u16>, shown: &[Cell], next: &[Cell]) -> bool {
        let (from, to) = (usize::from(columns.start), usize::from(columns.end));
        if to < next.len() {
            // Beyond these columns it is not for this list to write.
            return false;
        }
        let both = || shown.iter().zip(next).skip(from);
        let is_ink = |cell: &Cell| !self.look.is_blank(cell);
        let gone = both().filter(|(a, b)| !is_ink(b) && is_ink(a)).count();
        // Most frames change a few cells of a row: then nothing else is asked of it.
        let saved = gone.saturating_sub(WORTH_WIPING);
        let stays = both().filter(|(a, b)| is_ink(b) && self.look.same(a, b));
        saved > 0 && stays.take(saved).count() < saved
    }

    /// Up to where a row is written cell by cell, and whether the rest is erased at once.
    fn tail(&self, previous: &[Cell], next: &[Cell]) -> (u16, bool) {
        let is_ink = |cell: &Cell| !self.look.is_blank(cell);
        let end = next.iter().rposition(is_ink).map_or(0, |i| i + 1);
        let to_erase = previous[end..].iter().filter(|c| is_ink(c)).count();
        if to_erase > ERASING {
            (to_u16(end), true)
        } else {
            (to_u16(next.len()), false)
        }
    }
}

/// From the first to the last of some columns whose cells differ.
fn changed(columns: Range<u16>, shown: &[Cell], next: &[Cell]) -> Option<Range<u16>> {
    let differs = |x: &u16| !identical(&shown[usize::from(*x)], &next[usize::from(*x)]);
    let first = columns.clone().find(differs)?;
    let last = columns.rev().find(differs)?;
    Some(first..last + 1)
}

/// Gives blanks the style of what is written nearest to them in their row, where it does not show on them.
fn blanks_like_their_neighbours(changes: &mut [CellChange], row: &[Cell]) {
    let is_blank = |change: &CellChange| {
        change.style == Sgr::PLAIN && row[usize::from(change.x)].symbol() == " "
    };
    let mut before: Option<CellChange> = None;
    let mut i = 0;
    while i < changes.len() {
        let blanks = changes[i..].iter().take_while(|c| is_blank(c)).count();
        let behind = changes.get(i + blanks).copied();
        for blank in &mut changes[i..i + blanks] {
            let near = [before, behind].into_iter().flatten();
            let near = near.filter(|ink| ink.style.leaves_blanks());
            if let Some(ink) = near.min_by_key(|ink| ink.x.abs_diff(blank.x)) {
                blank.style = ink.style;
            }
        }
        before = behind;
        i += blanks + 1;
    }
}

/// The same changes, those of one style together: plain ones first, since what is erased is written anew
/// behind that, and the others as they come.
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

/// A character of one byte for one of three that looks like it.
fn roughly(cell: &Cell) -> Option<char> {
    match cell.symbol() {
        "\u{2500}" => Some('-'),
        "\u{2502}" => Some('|'),
        "\u{250c}" | "\u{2510}" | "\u{2514}" | "\u{2518}" => Some('+'),
        _ => None,
    }
}

/// Positions within a row, which is at most `u16::MAX` wide.
fn to_u16(n: usize) -> u16 {
    u16::try_from(n).unwrap_or(u16::MAX)
}
