//! Draws ghosts of the linkage: another assembly, other places in its motion, the linkage before an
//! edit, or another linkage.

use crate::Member;
use crate::drawing::figure::{Figure, Role};
use crate::drawing::outline::{self, Corner};
use crate::drawing::roles::roles;
use crate::scene::Scene;
use crate::solver::{Condition, State};

/// Adds the links that have moved in another state of the same scene. Call it before all other
/// shapes, so that the ghost lies below them.
pub fn add_ghost(figure: &mut Figure, scene: &Scene, now: &State, other: &State) {
    add_moved(figure, scene, now, other, Role::Ghost);
}

/// Adds the links that have moved in another state, with the given role.
pub(in crate::drawing) fn add_moved(
    figure: &mut Figure,
    scene: &Scene,
    now: &State,
    other: &State,
    role: Role,
) {
    let (now, other) = (now.known(), other.known());
    let mechanism = &scene.mechanism;
    let points = || mechanism.point_ids();
    let size = points()
        .map(|p| now.position(p).norm())
        .fold(f64::MIN_POSITIVE, f64::max);
    let moved = |m: &Member| {
        (now.position(m.point) - other.position(m.point)).norm() > SAME_PLACE_DISTANCE * size
    };
    let roles = roles(mechanism);
    for link in mechanism.links() {
        let solid = || link.members.iter().filter(|m| link.com != Some(m.point));
        if !solid().any(moved) {
            continue;
        }
        let corner = |m: &Member| Corner {
            at: other.position(m.point),
            block: roles[m.point.index()] == Role::Slider,
        };
        outline::draw(figure, &solid().map(corner).collect::<Vec<_>>(), role, None);
    }
}

/// Adds the links moved by an edit, as they were before it. `now` and `before` are the scene and
/// its state after and before the edit. If the edit has changed the points or the unit, all links
/// are added. Call it before all other shapes, so that the ghost lies below them.
pub fn add_before(figure: &mut Figure, now: (&Scene, &State), before: (&Scene, &State)) {
    let points = |scene: &Scene| scene.mechanism.points().len();
    let is_alike = now.0.unit == before.0.unit && points(now.0) == points(before.0);
    if is_alike && before.1.condition() != Condition::NoAssembly {
        add_ghost(figure, before.0, now.1, before.1);
    } else {
        add_other(
            figure,
            before.0,
            before.1,
            before.0.unit.in_units_of(now.0.unit),
        );
    }
}

/// Adds all links of another scene; nothing if it has no assembly. `scale` converts a length in the
/// other scene's unit to the figure's unit. Call it before all other shapes, so that the ghost lies
/// below them.
pub fn add_other(figure: &mut Figure, scene: &Scene, state: &State, scale: f64) {
    if state.condition() == Condition::NoAssembly {
        return;
    }
    let state = state.known();
    let mechanism = &scene.mechanism;
    let roles = roles(mechanism);
    for link in mechanism.links() {
        let solid = link.members.iter().filter(|m| link.com != Some(m.point));
        let corner = |m: &Member| Corner {
            at: state.position(m.point) * scale,
            block: roles[m.point.index()] == Role::Slider,
        };
        let corners: Vec<Corner> = solid.map(corner).collect();
        outline::draw(figure, &corners, Role::Ghost, None);
    }
}

/// The distance below which two places look the same, as a fraction of the largest coordinate.
const SAME_PLACE_DISTANCE: f64 = 1e-6;
