//! Velocities and accelerations of points with their components, for vector diagrams.

use super::points::{PointBasis, arm, earliest, places, seat};
use crate::report::working::Working;
use crate::report::working::context::Context;
use crate::report::working::symbols::of_point;
use crate::scene::Scene;
use crate::solver::{Solver, State};
use crate::{LinkId, PointId, Vec2};

/// The motion of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct PointMotion {
    /// The symbols of velocity and acceleration: `vB`, `aB`.
    pub symbols: [String; 2],
    /// `true` for a centre of mass.
    pub is_centre: bool,
    /// The velocity.
    pub velocity: Vec2,
    /// The acceleration.
    pub acceleration: Vec2,
    /// The motion relative to other points of its links.
    pub parts: Vec<PointParts>,
}

/// The motion of a point relative to another one of its link.
#[derive(Clone, Debug, PartialEq)]
pub struct PointParts {
    /// The suffix of the point's symbol, such as `/B`; empty if the other point is fixed.
    pub about: String,
    /// The velocity and the acceleration of the other point.
    pub base: [Vec2; 2],
    /// The relative velocity.
    pub velocity: Vec2,
    /// The normal component of the relative acceleration.
    pub normal: Vec2,
    /// The tangential component of the relative acceleration.
    pub tangential: Vec2,
}

impl Working {
    /// Returns the motion of all named points that move; empty if there are no rates.
    #[must_use]
    pub fn point_motions(&self, scene: &Scene, solver: &Solver, state: &State) -> Vec<PointMotion> {
        let context = self.context(scene, solver, state, 1);
        if !context.has_rates() {
            return Vec::new();
        }
        let mechanism = &scene.mechanism;
        let places = places(&context);
        let moving = mechanism.point_ids().filter_map(|point| {
            let name = scene.point_name(point)?;
            mechanism
                .point(point)
                .ground
                .is_none()
                .then_some((point, name))
        });
        let motion = |(point, name): (PointId, &str)| PointMotion {
            symbols: ["v", "a"].map(|figure| of_point(figure, name).to_string()),
            is_centre: mechanism.links().iter().any(|link| link.com == Some(point)),
            velocity: context.state.velocity(point),
            acceleration: context.state.acceleration(point),
            parts: parts(&context, &places, point),
        };
        moving.map(motion).collect()
    }
}

/// Returns the motion relative to the reference point of the working, and to earlier points of its
/// other links.
fn parts(context: &Context<'_>, places: &[usize], point: PointId) -> Vec<PointParts> {
    let mechanism = &context.scene.mechanism;
    let mut pairs: Vec<(LinkId, PointId)> = Vec::new();
    if let Some(PointBasis::Link(link, base)) = seat(mechanism, places, point) {
        pairs.push((link, base));
    }
    for &link in &mechanism.point(point).links {
        let is_new = pairs.iter().all(|(known, _)| *known != link);
        let base = earliest(mechanism, places, link, point).filter(|_| is_new);
        pairs.extend(base.map(|base| (link, base)));
    }
    let pairs = pairs.into_iter();
    pairs
        .filter_map(|(link, base)| about(context, link, base, point))
        .collect()
}

/// Returns the motion of a point of a link relative to another one.
pub(super) fn about(
    context: &Context<'_>,
    link: LinkId,
    base: PointId,
    point: PointId,
) -> Option<PointParts> {
    let mechanism = &context.scene.mechanism;
    let state = context.state;
    let e = arm(mechanism, link, base, point)?.turned(state.direction(link));
    let (w, alpha) = (state.omega(link), state.alpha(link));
    let is_fixed = mechanism.point(base).ground.is_some();
    let name = context.scene.point_name(base).filter(|_| !is_fixed);
    Some(PointParts {
        about: name.map_or_else(String::new, |name| format!("/{name}")),
        base: [state.velocity(base), state.acceleration(base)],
        velocity: e.perp() * w,
        normal: -e * (w * w),
        tangential: e.perp() * alpha,
    })
}
