//! How far the lengths of a mechanism may be off when it is made, and how loose its pins are.

use super::{Length, LinkId, PointId};

/// What may be off, and by how much; what is not named is exact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerances {
    /// Lengths, each as much longer or shorter at the most, in the scene's unit.
    pub lengths: Vec<(Length, f64)>,
    /// Pins, each at a point of a link: how far from the middle of its hole it can be, in any direction. A pin that
    /// joins several links is fixed in one of them, and has one for each of the others.
    pub clearances: Vec<(LinkId, PointId, f64)>,
}

impl Tolerances {
    /// Whether everything is exact.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        let lengths = self.lengths.iter().map(|&(_, by)| by);
        let pins = self.clearances.iter().map(|&(.., by)| by);
        lengths.chain(pins).all(|by| by == 0.0)
    }
}
