//! What the rows of the tables are about.

use crate::quantity::Subject;
use crate::scene::Scene;
use crate::tui::figures::sheet::SheetPart;

/// What a row is about; none beyond the last.
pub(crate) fn subject_of(scene: &Scene, part: SheetPart, row: usize) -> Option<Subject> {
    let mechanism = &scene.mechanism;
    match part {
        SheetPart::Points => {
            let (point, _) = scene.listed_points().nth(row)?;
            Some(Subject::Point(point))
        }
        SheetPart::Vectors => match scene.vectors.get(row) {
            Some(vector) => Some(vector.kind.into()),
            // Behind the vectors stand the links that are given by their points alone.
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
