//! Assigns roles to points and links.

use super::figure::{LINK_HUES, Role};
use crate::quantity::Subject;
use crate::scene::{Scene, Vector, VectorKind};
use crate::{Body, Input, Link, LinkId, Load, Mechanism, Point, SlideId};

/// Returns the role of each point.
pub(super) fn roles(mechanism: &Mechanism) -> Vec<Role> {
    let role = |point: &Point| match (point.ground, point.links.len()) {
        (Some(_), 0) => Role::Ground,
        (Some(_), _) => Role::GroundPin,
        (None, 0 | 1) => Role::Rider,
        (None, _) => Role::Joint,
    };
    let mut roles: Vec<Role> = mechanism.points().iter().map(role).collect();
    for com in mechanism.links().iter().filter_map(|link| link.com) {
        roles[com.index()] = Role::CentreOfMass;
    }
    // A spring is fixed to the ground like a link, by a support.
    for end in mechanism.loads().iter().filter_map(Load::ends).flatten() {
        let slot = &mut roles[end.index()];
        if *slot == Role::Ground {
            *slot = Role::GroundPin;
        }
    }
    for slide in mechanism.slides() {
        let slot = &mut roles[slide.slider.point().index()];
        // A ground point in a slot of a link is a pin like any other, and needs its support.
        *slot = match *slot {
            Role::Ground | Role::GroundPin => Role::GroundPin,
            _ => Role::Slider,
        };
    }
    roles
}

/// Returns the role of each link: the driver, or a hue. A link gets a hue that differs from those
/// of earlier links at its joints, as far as there are enough. Only the order of the links matters,
/// so a link keeps its hue when lengths change.
#[must_use]
pub fn link_roles(mechanism: &Mechanism) -> Vec<Role> {
    let mut next = 0;
    // Stored per point, so that links that share a point are not searched again for each of them.
    let mut met = vec![[false; LINK_HUES as usize]; mechanism.points().len()];
    // The joints of links with the driver's hue. The driver has it before further inputs.
    let mut driven = vec![false; mechanism.points().len()];
    if let Input::Turn(link) = mechanism.driver().input {
        let members = mechanism.link(link).members.iter();
        members.for_each(|member| driven[member.point.index()] = true);
    }
    let role = |(id, link): (LinkId, &Link)| {
        let points = || link.members.iter().map(|m| m.point.index());
        let is_driver = mechanism.driver().input == Input::Turn(id);
        if is_driver || mechanism.is_turned(id) && !points().any(|point| driven[point]) {
            points().for_each(|point| driven[point] = true);
            return Role::Driver;
        }
        let is_free = |hue: &u8| !points().any(|point| met[point][usize::from(*hue)]);
        let mut hues = (0..LINK_HUES).map(|k| (next + k) % LINK_HUES);
        let hue = hues.find(is_free).unwrap_or(next);
        points().for_each(|point| met[point][usize::from(hue)] = true);
        next = (hue + 1) % LINK_HUES;
        Role::Link(hue)
    };
    mechanism
        .link_ids()
        .zip(mechanism.links())
        .map(role)
        .collect()
}

/// Returns, for each vector of the tables in their order, the role of its link; `None` for vectors
/// without a link.
#[must_use]
pub fn vector_roles(scene: &Scene) -> Vec<Option<Role>> {
    let links = link_roles(&scene.mechanism);
    // The rod of a driving cylinder. A driven block on the ground is drawn as a block.
    let is_rod = |slide: SlideId| {
        let is_driven = scene.mechanism.is_pushed(slide);
        is_driven && scene.mechanism.slide(slide).on != Body::Ground
    };
    let role = |v: &Vector| match v.kind {
        VectorKind::Slide(slide) if is_rod(slide) => Some(Role::Driver),
        kind => link_of(&scene.mechanism, kind.into()).map(|link| links[link.index()]),
    };
    scene.vectors.iter().map(role).collect()
}

/// Returns the link that a subject belongs to: the link itself, or a point's only link. For a
/// vector, it is the link with both ends, and for a slide, the link that carries the guide. Returns
/// `None` for subjects of several links or of the frame.
pub(super) fn link_of(mechanism: &Mechanism, subject: Subject) -> Option<LinkId> {
    match subject {
        Subject::Link(link) | Subject::Joint(link, _) => Some(link),
        Subject::Slide(slide) => match mechanism.slide(slide).on {
            Body::Link(link) => Some(link),
            Body::Ground => None,
        },
        Subject::Between(from, to) => {
            let mut of_both = mechanism.point(from).links.iter();
            let link = of_both.find(|link| mechanism.point(to).links.contains(link));
            link.copied()
        }
        Subject::Point(point) => match mechanism.point(point).links[..] {
            [link] => Some(link),
            _ => None,
        },
        Subject::Driver | Subject::Drive(_) => match mechanism.driver().input {
            Input::Turn(link) => Some(link),
            Input::Push(_) => None,
        },
        Subject::Frame | Subject::FrameResidual => None,
    }
}
