//! What is chosen in the tables, for the motion view to show.

use crate::PointId;

/// Points that the motion view gives arrows and traces; none chosen means the usual ones.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Chosen {
    points: Vec<PointId>,
}

impl Chosen {
    /// Chooses a point, or no longer.
    pub(crate) fn toggle(&mut self, point: PointId) {
        match self.points.iter().position(|&p| p == point) {
            Some(at) => drop(self.points.remove(at)),
            None => self.points.push(point),
        }
    }

    pub(crate) fn contains(&self, point: PointId) -> bool {
        self.points.contains(&point)
    }

    /// In the order in which they were chosen.
    pub(crate) fn points(&self) -> &[PointId] {
        &self.points
    }
}
