//! What tells lines apart without colour: which of them are broken, and how.

use super::figure::Role;

/// How much of a line is drawn, and how much is left out before it goes on.
#[derive(Clone, Copy)]
pub(super) struct Dashes {
    drawn: i32,
    left_out: i32,
}

impl Dashes {
    const fn new(drawn: i32, left_out: i32) -> Dashes {
        Dashes { drawn, left_out }
    }

    /// Places are counted over the whole raster: while a line moves along itself, its dashes stand still.
    pub(super) fn is_gap(self, place: i32) -> bool {
        place.rem_euclid(self.drawn + self.left_out) >= self.drawn
    }
}

/// The dashes of a line of characters, in cells along its main axis; none where it is whole. The points of a ghost stand
/// in every cell.
pub(super) fn of_cells(role: Role) -> Option<Dashes> {
    match role {
        Role::Acceleration => Some(Dashes::new(2, 1)),
        Role::Echo => Some(Dashes::new(1, 1)),
        _ => None,
    }
}

/// The same of a line of dots, of which a cell has so many along it. In a small window bars are lines of dots too, and
/// without colour a ghost must be none of them: single dots, near enough to be traced by eye. Echoes are dashes.
pub(super) fn of_dots(role: Role, in_cell: i32) -> Option<Dashes> {
    match role {
        Role::Acceleration => Some(Dashes::new(2 * in_cell, in_cell)),
        Role::Ghost => Some(Dashes::new(1, 2)),
        Role::Echo => Some(Dashes::new(4, 2)),
        _ => None,
    }
}
