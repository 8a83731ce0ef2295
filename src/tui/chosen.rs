//! What is chosen in the tables, for the motion view to show.

use crate::PointId;
use crate::scene::Scene;

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

    /// The same points in the scene after a change, by their names.
    pub(crate) fn moved(&self, before: &Scene, after: &Scene) -> Chosen {
        let named = |name: &str| {
            let mut points = after.mechanism.point_ids();
            points.find(|&point| after.point_name(point) == Some(name))
        };
        let points = self.points.iter();
        let points = points.filter_map(|&point| named(before.point_name(point)?));
        Chosen {
            points: points.collect(),
        }
    }

    /// In the order in which they were chosen.
    pub(crate) fn points(&self) -> &[PointId] {
        &self.points
    }
}
