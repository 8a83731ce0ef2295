//! The points that the motion view gives arrows and traces, as they are chosen in the tables.

use crate::PointId;
use crate::scene::{Scene, VectorKind};
use crate::tui::figures::sheet::SheetPart;

/// Points that the motion view gives arrows and traces; none chosen means the usual ones.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct FollowedPoints {
    points: Vec<PointId>,
}

impl FollowedPoints {
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
    pub(crate) fn moved(&self, before: &Scene, after: &Scene) -> FollowedPoints {
        let named = |name: &str| {
            let mut points = after.mechanism.point_ids();
            points.find(|&point| after.point_name(point) == Some(name))
        };
        let points = self.points.iter();
        let points = points.filter_map(|&point| named(before.point_name(point)?));
        FollowedPoints {
            points: points.collect(),
        }
    }

    /// In the order in which they were chosen.
    pub(crate) fn points(&self) -> &[PointId] {
        &self.points
    }
}

/// What stands behind a row of the tables: a point itself, of a vector its ends, of a link that is given
/// by its points alone all of these.
fn points_of(scene: &Scene, part: SheetPart, row: usize) -> Vec<PointId> {
    let mechanism = &scene.mechanism;
    match part {
        SheetPart::Points => {
            let points = mechanism.point_ids();
            let mut named = points.filter(|&p| scene.point_name(p).is_some());
            named.nth(row).into_iter().collect()
        }
        SheetPart::Vectors => match scene.vectors.get(row).map(|vector| vector.kind) {
            Some(VectorKind::Between(tail, head)) => vec![tail, head],
            Some(VectorKind::Slide(slide)) => vec![mechanism.slide(slide).slider.point()],
            Some(VectorKind::Link(link)) => {
                let ends = mechanism.link(link).ends;
                ends.into_iter().flat_map(|(from, to)| [from, to]).collect()
            }
            None => {
                let links = mechanism.link_ids();
                let mut links = links.filter(|&link| mechanism.link(link).ends.is_none());
                let link = links.nth(row - scene.vectors.len());
                let members = link.map(|link| mechanism.link(link).members.iter());
                members.into_iter().flatten().map(|m| m.point).collect()
            }
        },
    }
}

/// Those of them that move, with their names: a point of the ground has no arrows and leaves no trace.
pub(crate) fn moving(scene: &Scene, part: SheetPart, row: usize) -> Vec<(PointId, &str)> {
    let points = points_of(scene, part, row).into_iter();
    let moving = points.filter(|&p| scene.mechanism.point(p).ground.is_none());
    moving
        .filter_map(|p| Some((p, scene.point_name(p)?)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;
    use crate::solver::{Order, Solver};

    fn preset(name: &str) -> Scene {
        Scene::parse(presets::find(name).unwrap().text, name).unwrap()
    }

    fn names(scene: &Scene, part: SheetPart, row: usize) -> Vec<&str> {
        let points = moving(scene, part, row).into_iter();
        points.map(|(_, name)| name).collect()
    }

    #[test]
    fn a_vector_stands_for_those_of_its_ends_that_move() {
        let scene = preset("four-bar");
        let vectors: Vec<_> = (0..4)
            .map(|row| names(&scene, SheetPart::Vectors, row))
            .collect();
        assert_eq!(vectors, [&["B"][..], &["B", "C"], &["C"], &[]]);
        let slider = preset("slider-crank");
        let at = slider
            .vectors
            .iter()
            .position(|v| matches!(v.kind, VectorKind::Slide(_)));
        assert_eq!(names(&slider, SheetPart::Vectors, at.unwrap()), ["C"]);
    }

    /// The rows of the tables and what stands behind them are the same, in every preset.
    #[test]
    fn every_row_knows_its_points() {
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let mut state = solver.state();
            let _ = solver.solve(scene.mechanism.driver().start, Order::Position, &mut state);
            let tables = crate::report::Tables::new(&scene, &state);
            for (row, point) in tables.points.iter().enumerate() {
                let found = points_of(&scene, SheetPart::Points, row);
                let names: Vec<_> = found.iter().map(|&p| scene.point_name(p)).collect();
                assert_eq!(names, [Some(point.name.as_str())], "{}", preset.name);
                assert_eq!(
                    moving(&scene, SheetPart::Points, row).is_empty(),
                    point.fixed
                );
            }
            for (row, vector) in tables.vectors.iter().enumerate() {
                let found = points_of(&scene, SheetPart::Vectors, row);
                assert!(!found.is_empty(), "{}: {}", preset.name, vector.name);
            }
            assert!(points_of(&scene, SheetPart::Points, tables.points.len()).is_empty());
            assert!(points_of(&scene, SheetPart::Vectors, tables.vectors.len()).is_empty());
        }
    }
}
