//! Free-body diagrams: the forces on each link, for drawings.

use super::free_body::{BodyForce, BodyJoint, on_link};
use crate::LinkId;
use crate::drawing::FreeForce;
use crate::report::working::Working;
use crate::report::working::reactions::inertia;
use crate::scene::Scene;
use crate::solver::{Solver, State};

impl Working {
    /// Returns the forces on a link of a state solved with forces, named after joints and guides.
    /// Inertia is included, so that the force polygon closes. Returns an empty list if a force does
    /// not exist or is indeterminate.
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

/// Returns the name of a force in a drawing: its joint or guide.
fn name(scene: &Scene, row: &BodyForce) -> String {
    match row.joint {
        Some(BodyJoint::Pin(point)) => scene.point_name(point).unwrap_or_default(),
        Some(BodyJoint::Guide(slide)) => scene.slide_name(slide),
        Some(BodyJoint::Driver) | None => &row.name,
    }
    .to_owned()
}
