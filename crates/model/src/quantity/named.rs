//! What the numbers of a scene are about.

use super::Subject;
use crate::PointId;
use crate::scene::{Scene, Value, ValueOwner};

impl Subject {
    /// What a value of the scene belongs to: of a load what it acts on, of a spring the line between its ends. None
    /// where that is no part of the linkage, as of its weight.
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

/// The point, the link or the slide of this name: the names of a scene are all different.
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
