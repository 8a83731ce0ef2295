//! Chooses the points that get arrows or traces by default.

use crate::scene::Scene;
use crate::{Body, Mechanism, PointId, Slider};

/// Maximum numbers of traces, and of arrows of one kind; more would be indistinguishable.
const MAX_TRACES: usize = 12;
const MAX_ARROWS: usize = 40;

/// Returns the points that move and are not centres of mass: joints and coupler points.
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

/// Returns the points with arrows by default: all moving points, up to a maximum.
#[must_use]
pub fn usual_arrows(mechanism: &Mechanism) -> Vec<PointId> {
    moving_points(mechanism).take(MAX_ARROWS).collect()
}

/// Returns the points with traces by default: those that the scene names, or else the points with
/// informative traces, which the ground does not lead on a circle or along a line. If there are
/// none, returns all moving points.
#[must_use]
pub fn usual_traces(scene: &Scene) -> Vec<PointId> {
    if !scene.traces.is_empty() {
        return scene.traces.clone();
    }
    let mechanism = &scene.mechanism;
    let guided = grounded_links(mechanism);
    let free = |id: &PointId| !guided[id.index()];
    let curves: Vec<PointId> = moving_points(mechanism)
        .filter(free)
        .take(MAX_TRACES)
        .collect();
    if curves.is_empty() {
        moving_points(mechanism).take(MAX_TRACES).collect()
    } else {
        curves
    }
}

/// Returns, for every point, `true` if its link has a ground pin or slides along the ground, or if
/// it slides along the ground itself.
fn grounded_links(mechanism: &Mechanism) -> Vec<bool> {
    let mut guided = vec![false; mechanism.points().len()];
    for link in mechanism.links() {
        let is_pinned = |p: PointId| mechanism.point(p).ground.is_some();
        if link.members.iter().any(|m| is_pinned(m.point)) {
            link.members
                .iter()
                .for_each(|m| guided[m.point.index()] = true);
        }
    }
    for slide in mechanism.slides().iter().filter(|s| s.on == Body::Ground) {
        guided[slide.slider.point().index()] = true;
        if let Slider::Link { link, .. } = slide.slider {
            let members = mechanism.link(link).members.iter();
            members.for_each(|m| guided[m.point.index()] = true);
        }
    }
    guided
}
