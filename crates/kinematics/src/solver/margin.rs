//! Measures how far a state is from a singularity, group by group.

use super::{Condition, Order, Solver, Workspace};

impl Solver {
    /// Returns for each group of the plan how far it is from a singularity at a coordinate of the
    /// driver. For a dyad it is the square of the sine of its transmission angle, or an equivalent:
    /// 0 at a dead point or a change point. For a coupled group it is the signed square of its
    /// determinant, comparable only along one motion. It is 1 for a group without singularities.
    /// `None` if the state is not an ordinary one.
    #[must_use]
    pub fn margins(&self, at: f64, workspace: &mut Workspace) -> Option<Vec<f64>> {
        if self.solve(at, Order::Position, workspace) != Condition::Ok {
            return None;
        }
        self.engine.measure_coupled(at, workspace);
        Some(workspace.measures.clone())
    }
}
