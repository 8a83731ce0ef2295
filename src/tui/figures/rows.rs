//! The subjects of the tables' rows.

use crate::quantity::Subject;
use crate::scene::Scene;
use crate::tui::figures::sheet::SheetPart;

/// Returns the subject of a row; `None` beyond the last row.
pub(crate) fn subject_of(scene: &Scene, part: SheetPart, row: usize) -> Option<Subject> {
    let mechanism = &scene.mechanism;
    match part {
        SheetPart::Points => {
            let (point, _) = scene.listed_points().nth(row)?;
            Some(Subject::Point(point))
        }
        SheetPart::Vectors => match scene.vectors.get(row) {
            Some(vector) => Some(vector.kind.into()),
            // The vectors are followed by the links that are defined only by their points.
            None => {
                let mut links = mechanism
                    .link_ids()
                    .filter(|&link| mechanism.link(link).ends.is_none());
                links
                    .nth(row.checked_sub(scene.vectors.len())?)
                    .map(Subject::Link)
            }
        },
    }
}
