//! Dash patterns, which distinguish lines without colour.

use crate::drawing::figure::Role;

/// A dash pattern: the lengths drawn and left out in turn.
#[derive(Clone, Copy)]
pub(in crate::drawing) struct Dashes {
    drawn: i32,
    left_out: i32,
}

impl Dashes {
    const fn new(drawn: i32, left_out: i32) -> Dashes {
        Dashes { drawn, left_out }
    }

    /// Returns `true` if `place` lies in a gap. Places count over the whole raster, so that the
    /// dashes of a line that moves along itself do not move.
    pub(in crate::drawing) fn is_gap(self, place: i32) -> bool {
        place.rem_euclid(self.drawn + self.left_out) >= self.drawn
    }
}

/// Returns the dashes of a line of characters, in cells along its main axis; `None` for a solid
/// line. A ghost's points fill every cell.
pub(in crate::drawing) fn of_cells(role: Role) -> Option<Dashes> {
    match role {
        Role::Acceleration => Some(Dashes::new(2, 1)),
        Role::Echo => Some(Dashes::new(1, 1)),
        _ => None,
    }
}

/// Returns the dashes of a line of dots, with `in_cell` dots per cell along it; `None` for a solid
/// line. In a small window bars are lines of dots too, so a ghost must look different without
/// colour: single dots, close enough for the eye to follow. Echoes are dashes.
pub(in crate::drawing) fn of_dots(role: Role, in_cell: i32) -> Option<Dashes> {
    match role {
        Role::Acceleration => Some(Dashes::new(2 * in_cell, in_cell)),
        Role::Ghost => Some(Dashes::new(1, 2)),
        Role::Echo => Some(Dashes::new(4, 2)),
        _ => None,
    }
}
