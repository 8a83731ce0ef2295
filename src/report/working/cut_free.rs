//! Links cut free: what acts on each of them, as it is drawn.

use super::Working;
use super::free_body::{BodyForce, BodyJoint, on_link};
use super::reactions::inertia;
use crate::LinkId;
use crate::drawing::FreeForce;
use crate::scene::Scene;
use crate::solver::{Solver, State};

impl Working {
    /// What acts on a link of a state that is solved to its forces, inertia among it - so
    /// that all of it closes - by the names of joints and guides. Nothing where some of it does not exist or is left
    /// open.
    #[must_use]
    pub fn on_link(
        &self,
        scene: &Scene,
        solver: &Solver,
        state: &State,
        link: LinkId,
    ) -> Vec<FreeForce> {
        let context = self.context(scene, solver, state, 1);
        if context.state.drive().is_none() || context.state.residual().is_none() {
            return Vec::new();
        }
        let acted = solver.acted(state);
        let all = on_link(&context, link, &acted).unwrap_or_default();
        let all = all.into_iter().chain(inertia(&context, link));
        all.map(|row| FreeForce {
            name: name(scene, &row),
            at: row.at,
            force: row.force,
            couple: row.couple,
        })
        .collect()
    }
}

/// What it is in a picture: the joint or the guide that hands it on.
fn name(scene: &Scene, row: &BodyForce) -> String {
    match row.joint {
        Some(BodyJoint::Pin(point)) => scene.point_name(point).unwrap_or_default(),
        Some(BodyJoint::Guide(slide)) => scene.slide_name(slide),
        Some(BodyJoint::Driver) | None => &row.name,
    }
    .to_owned()
}
