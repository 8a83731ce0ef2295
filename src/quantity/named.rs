//! What the names of a scene are about.

use super::Subject;
use crate::scene::{Scene, Value};

impl Subject {
    /// What a value of the scene belongs to: of a load what it acts on, of a spring the line between its ends. None
    /// where that is no part of the linkage, as of its weight.
    #[must_use]
    pub fn of_value(scene: &Scene, value: &Value) -> Option<Subject> {
        let mut words = value.name.split(' ');
        match words.next()? {
            "driver" => Some(Subject::Driver),
            "spring" => words.next().and_then(|ends| between(scene, ends)),
            name => of_element(scene, name),
        }
    }
}

/// The point, the link or the slide of this name: the names of a scene are all different.
fn of_element(scene: &Scene, name: &str) -> Option<Subject> {
    let mechanism = &scene.mechanism;
    let mut links = mechanism.link_ids();
    let mut slides = mechanism.slide_ids();
    point(scene, name)
        .or_else(|| {
            let link = links.find(|&link| scene.link_name(link) == name);
            link.map(Subject::Link)
        })
        .or_else(|| {
            let slide = slides.find(|&slide| scene.slide_name(slide) == name);
            slide.map(Subject::Slide)
        })
}

fn point(scene: &Scene, name: &str) -> Option<Subject> {
    let mut points = scene.mechanism.point_ids();
    let point = points.find(|&point| scene.point_name(point) == Some(name));
    point.map(Subject::Point)
}

/// The line between two points that are called `A-B`; a name may have a `-` of its own.
fn between(scene: &Scene, ends: &str) -> Option<Subject> {
    let mut halves = ends.match_indices('-');
    halves.find_map(|(at, _)| {
        let [from, to] = [&ends[..at], &ends[at + 1..]].map(|name| point(scene, name));
        match (from?, to?) {
            (Subject::Point(from), Subject::Point(to)) => Some(Subject::Between(from, to)),
            _ => None,
        }
    })
}
