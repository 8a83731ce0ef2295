//! Defines manufacturing tolerances of lengths and clearances of pins.

use super::{Length, LinkId, PointId};

/// The tolerances of a mechanism; all other lengths are exact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerances {
    /// Lengths with the maximum deviation of each in either direction, in the scene's unit.
    pub lengths: Vec<(Length, f64)>,
    /// Pins, each at a point of a link, with the maximum distance from the centre of its hole, in
    /// any direction. A pin that joins several links is fixed in one of them and has one entry for
    /// each of the others.
    pub clearances: Vec<(LinkId, PointId, f64)>,
}

impl Tolerances {
    /// Returns `true` if all deviations are zero.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let lengths = self.lengths.iter().map(|&(_, by)| by);
        let pins = self.clearances.iter().map(|&(.., by)| by);
        lengths.chain(pins).all(|by| by == 0.0)
    }
}
