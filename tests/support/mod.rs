//! Conditions that a state must satisfy for any mechanism, computed from the mechanism alone.

use krank::solver::State;
use krank::{Body, Input, Mechanism, Slider, Vec2, angle};

/// Unit roundoff: half an ulp of 1.
pub(crate) const U: f64 = f64::EPSILON / 2.0;

/// Returns the largest distance between two points of one link.
pub(crate) fn longest_link(mechanism: &Mechanism) -> f64 {
    let mut longest: f64 = 0.0;
    for link in mechanism.links() {
        for a in &link.members {
            for b in &link.members {
                longest = longest.max((a.local - b.local).norm());
            }
        }
    }
    longest
}

/// Returns the closure error of a state: the largest of these distances: between a link's own point
/// and the point's position, between a sliding point and its guide, and between the driver's
/// coordinate and its requested value. Angles count as arcs of the longest link.
pub(crate) fn closure_error(mechanism: &Mechanism, state: &State) -> f64 {
    let links = links_error(mechanism, state);
    let slides = slides_error(mechanism, state);
    let grounds = mechanism.point_ids().filter_map(|id| {
        let position = mechanism.point(id).ground?;
        Some((state.position(id).unwrap() - position).norm())
    });
    let worst = grounds.fold(links.max(slides), f64::max);
    worst.max(driver_error(mechanism, state))
}

fn links_error(mechanism: &Mechanism, state: &State) -> f64 {
    let mut worst: f64 = 0.0;
    for id in mechanism.link_ids() {
        let members = &mechanism.link(id).members;
        let direction = state.direction(id).unwrap();
        worst = worst.max((direction.norm() - 1.0).abs() * longest_link(mechanism));
        for a in members {
            for b in members {
                let distance = state.position(b.point).unwrap() - state.position(a.point).unwrap();
                let local = b.local - a.local;
                worst = worst
                    .max((distance.norm() - local.norm()).abs())
                    .max((distance - local.turned(direction)).norm());
            }
        }
    }
    worst
}

fn slides_error(mechanism: &Mechanism, state: &State) -> f64 {
    let mut worst: f64 = 0.0;
    for id in mechanism.slide_ids() {
        let slide = mechanism.slide(id);
        let (through, along) = match slide.on {
            Body::Ground => (slide.through, slide.direction()),
            Body::Link(on) => {
                // Any point of the link gives its frame; a link without points cannot be built.
                let member = mechanism.link(on).members[0];
                let turn = state.direction(on).unwrap();
                let origin = state.position(member.point).unwrap() - member.local.turned(turn);
                (
                    origin + slide.through.turned(turn),
                    slide.direction().turned(turn),
                )
            }
        };
        let distance = state.position(slide.slider.point()).unwrap() - through;
        let travel = state.travel(id).unwrap();
        worst = worst
            .max(along.cross(distance).abs())
            .max((travel.position - along.dot(distance)).abs())
            .max((travel.guide - along).norm() * longest_link(mechanism));
        if let Slider::Link { link, turn, .. } = slide.slider {
            let off = state.direction(link).unwrap() - krank::angle::unit(turn).turned(along);
            worst = worst.max(off.norm() * longest_link(mechanism));
        }
    }
    worst
}

fn driver_error(mechanism: &Mechanism, state: &State) -> f64 {
    match mechanism.driver().input {
        Input::Turn(link) => {
            let off: Vec2 = state.direction(link).unwrap() - angle::unit(state.at());
            off.norm() * longest_link(mechanism)
        }
        Input::Push(slide) => (state.travel(slide).unwrap().position - state.at()).abs(),
    }
}
