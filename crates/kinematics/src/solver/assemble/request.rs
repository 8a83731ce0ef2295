//! Defines the request for an assembly.

use crate::solver::fault::Fault;
use crate::solver::plan::{AssemblyChoice, Plan};
use crate::{ElementId, PointId, Vec2};

/// The requested coordinate and assembly: picks decide for their groups, approximate positions for
/// the others.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Request<'a> {
    /// The driver's coordinate.
    pub at: f64,
    /// Approximate positions of points, in the scene's unit and frame.
    pub near: &'a [(PointId, Vec2)],
    /// The pick of every group of the plan, if any.
    pub picks: Vec<Option<AssemblyChoice>>,
}

impl<'a> Request<'a> {
    /// Creates a request.
    ///
    /// # Errors
    /// Returns [`Fault::NoChoice`] if a pick names no group of the plan.
    pub(in crate::solver) fn new(
        plan: &Plan,
        at: f64,
        near: &'a [(PointId, Vec2)],
        choices: &[(ElementId, AssemblyChoice)],
    ) -> Result<Request<'a>, Fault> {
        let mut all = vec![None; plan.groups.len()];
        for &(group, choice) in choices {
            let number = plan.named(group);
            *number
                .and_then(|n| all.get_mut(n.index()))
                .ok_or(Fault::NoChoice { group, found: 0 })? = Some(choice);
        }
        Ok(Request {
            at,
            near,
            picks: all,
        })
    }
}
