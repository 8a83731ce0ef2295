//! Which points are worth an arrow or a trace where nobody has said.

use crate::{Body, Mechanism, PointId, Slider};

/// More traces, or arrows of one kind, could not be told from each other.
const MOST_TRACES: usize = 12;
const MOST_ARROWS: usize = 40;

/// Points that move and are no centres of mass: joints and riders.
pub fn moving_points(mechanism: &Mechanism) -> impl Iterator<Item = PointId> {
    let mut moves: Vec<bool> = mechanism
        .points()
        .iter()
        .map(|p| p.ground.is_none())
        .collect();
    for centre in mechanism.links().iter().filter_map(|link| link.com) {
        moves[centre.index()] = false;
    }
    mechanism.point_ids().filter(move |id| moves[id.index()])
}

/// The points that get arrows: all that move, as far as they can be told apart.
#[must_use]
pub fn usual_arrows(mechanism: &Mechanism) -> Vec<PointId> {
    moving_points(mechanism).take(MOST_ARROWS).collect()
}

/// The points whose traces tell something: riders, and joints that lie on no link that the ground
/// leads on a circle or along a line. Where there is none, all that move.
#[must_use]
pub fn usual_traces(mechanism: &Mechanism) -> Vec<PointId> {
    let led = led_by_ground(mechanism);
    let free = |id: &PointId| !led[id.index()];
    let curves: Vec<PointId> = moving_points(mechanism)
        .filter(free)
        .take(MOST_TRACES)
        .collect();
    if curves.is_empty() {
        moving_points(mechanism).take(MOST_TRACES).collect()
    } else {
        curves
    }
}

/// For every point whether it lies on a link with a ground pin, or slides along the ground.
fn led_by_ground(mechanism: &Mechanism) -> Vec<bool> {
    let mut led = vec![false; mechanism.points().len()];
    for link in mechanism.links() {
        let is_pinned = |p: PointId| mechanism.point(p).ground.is_some();
        if link.members.iter().any(|m| is_pinned(m.point)) {
            link.members
                .iter()
                .for_each(|m| led[m.point.index()] = true);
        }
    }
    for slide in mechanism.slides().iter().filter(|s| s.on == Body::Ground) {
        led[slide.slider.point().index()] = true;
        if let Slider::Link { link, .. } = slide.slider {
            let members = mechanism.link(link).members.iter();
            members.for_each(|m| led[m.point.index()] = true);
        }
    }
    led
}
