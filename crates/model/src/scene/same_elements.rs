//! Compares the elements of two scenes, so that ids and quantities of one can be used with the other.

use super::Scene;
use crate::{Body, Input, LinkId, Mechanism, PointId, Slider};

/// The elements of a mechanism without their numbers.
#[derive(PartialEq)]
struct Elements {
    /// For each point, whether it is on the ground, and whether it is only shown.
    points: Vec<(bool, bool)>,
    links: Vec<LinkPoints>,
    slides: Vec<(MovingElement, Body, Option<PointId>)>,
    inputs: Vec<Input>,
}

/// The points of a link.
#[derive(PartialEq)]
struct LinkPoints {
    members: Vec<PointId>,
    ends: Option<(PointId, PointId)>,
    com: Option<PointId>,
}

/// The moving element of a slide.
#[derive(PartialEq)]
enum MovingElement {
    Pin(PointId),
    Link(LinkId, PointId),
}

impl Scene {
    /// Returns `true` if another scene has the same elements in the same order: names, kinds,
    /// joints and inputs. Only then do ids and quantities of one scene apply to the other. A
    /// changed number can change the elements of `[copies]`, such as `count`, or a `turn` after
    /// which a ground point is no longer shared.
    #[must_use]
    pub fn has_elements_of(&self, other: &Scene) -> bool {
        let names = |scene: &Scene| scene.limits.iter().map(|limit| limit.0.clone()).collect();
        let [own, others]: [Vec<String>; 2] = [self, other].map(names);
        self.point_names == other.point_names
            && self.link_names == other.link_names
            && self.slide_names == other.slide_names
            && own == others
            && Elements::of(&self.mechanism) == Elements::of(&other.mechanism)
    }
}

impl Elements {
    fn of(mechanism: &Mechanism) -> Elements {
        let points = mechanism.points().iter();
        let links = mechanism.links().iter().map(|link| LinkPoints {
            members: link.members.iter().map(|member| member.point).collect(),
            ends: link.ends,
            com: link.com,
        });
        let slides = mechanism.slides().iter().map(|slide| {
            let moving = match slide.slider {
                Slider::Pin(point) => MovingElement::Pin(point),
                Slider::Link { link, origin, .. } => MovingElement::Link(link, origin),
            };
            (moving, slide.on, slide.named)
        });
        let timed = mechanism.timed().iter().map(|timed| timed.input);
        Elements {
            points: points.map(|p| (p.ground.is_some(), p.is_mark)).collect(),
            links: links.collect(),
            slides: slides.collect(),
            inputs: std::iter::once(mechanism.driver().input)
                .chain(timed)
                .collect(),
        }
    }
}
