//! The points that get arrows and traces in the motion view, as selected in the tables.

use crate::PointId;
use crate::quantity::Subject;
use crate::scene::Scene;
use crate::tui::figures::rows::subject_of;
use crate::tui::figures::sheet::SheetPart;

/// The points that get arrows and traces; an empty selection means the default ones.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct FollowedPoints {
    points: Vec<PointId>,
}

impl FollowedPoints {
    /// Selects or deselects a point.
    pub(crate) fn toggle(&mut self, point: PointId) {
        match self.points.iter().position(|&p| p == point) {
            Some(at) => drop(self.points.remove(at)),
            None => self.points.push(point),
        }
    }

    pub(crate) fn contains(&self, point: PointId) -> bool {
        self.points.contains(&point)
    }

    /// Returns the points with the same names in the edited scene.
    pub(crate) fn moved(&self, before: &Scene, after: &Scene) -> FollowedPoints {
        let points = self.points.iter();
        let points = points.filter_map(|&point| same_point(point, before, after));
        FollowedPoints {
            points: points.collect(),
        }
    }

    /// Returns the points in the order of their selection.
    pub(crate) fn points(&self) -> &[PointId] {
        &self.points
    }
}

/// Returns the point with the same name in the edited scene, if there is one.
pub(crate) fn same_point(point: PointId, before: &Scene, after: &Scene) -> Option<PointId> {
    let name = before.point_name(point)?;
    let mut points = after.mechanism.point_ids();
    points.find(|&point| after.point_name(point) == Some(name))
}

/// Returns the points of a row of the tables: a point itself, the ends of a vector, or all points
/// of a link defined only by its points.
fn points_of(scene: &Scene, part: SheetPart, row: usize) -> Vec<PointId> {
    let mechanism = &scene.mechanism;
    match subject_of(scene, part, row) {
        Some(Subject::Point(point)) => vec![point],
        Some(Subject::Between(tail, head)) => vec![tail, head],
        Some(Subject::Slide(slide)) => vec![mechanism.slide(slide).slider.point()],
        Some(Subject::Link(link)) => {
            let link = mechanism.link(link);
            let members = || link.members.iter().map(|m| m.point).collect();
            link.ends.map_or_else(members, |(from, to)| vec![from, to])
        }
        _ => Vec::new(),
    }
}

/// Returns the moving points among them, with their names. A point of the ground has neither arrows
/// nor a trace.
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
    use crate::scene::{VectorKind, presets};
    use crate::solver::{Order, Solver};

    fn preset(name: &str) -> Scene {
        Scene::parse(presets::find(name).unwrap().text, name).unwrap()
    }

    fn names(scene: &Scene, part: SheetPart, row: usize) -> Vec<&str> {
        let points = moving(scene, part, row).into_iter();
        points.map(|(_, name)| name).collect()
    }

    #[test]
    fn vectors_stand_for_their_moving_ends() {
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

    /// In every preset, each row of the tables maps to the points that it shows.
    #[test]
    fn table_rows_map_to_their_points() {
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
