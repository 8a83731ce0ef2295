//! Determines the subject of a scene's value.

use super::Subject;
use crate::PointId;
use crate::scene::{Scene, Value, ValueOwner};

impl Subject {
    /// Returns the subject of a value of the scene: for a load the loaded element, for a spring the
    /// line between its ends. Returns `None` for a value that belongs to no part of the linkage,
    /// such as gravity.
    #[must_use]
    pub fn of_value(scene: &Scene, value: &Value) -> Option<Subject> {
        match &value.owner {
            ValueOwner::Scene | ValueOwner::Parameter(_) => None,
            ValueOwner::Driver => Some(Subject::Driver),
            ValueOwner::Element(name) => of_element(scene, name),
            ValueOwner::Between(from, to) => {
                Some(Subject::Between(point(scene, from)?, point(scene, to)?))
            }
        }
    }
}

/// Returns the point, link or slide with this name; names in a scene are unique.
fn of_element(scene: &Scene, name: &str) -> Option<Subject> {
    let mechanism = &scene.mechanism;
    let mut links = mechanism.link_ids();
    let mut slides = mechanism.slide_ids();
    point(scene, name)
        .map(Subject::Point)
        .or_else(|| {
            let link = links.find(|&link| scene.link_name(link) == name);
            link.map(Subject::Link)
        })
        .or_else(|| {
            let slide = slides.find(|&slide| scene.slide_name(slide) == name);
            slide.map(Subject::Slide)
        })
}

fn point(scene: &Scene, name: &str) -> Option<PointId> {
    let mut points = scene.mechanism.point_ids();
    points.find(|&point| scene.point_name(point) == Some(name))
}
