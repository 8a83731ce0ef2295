//! How far a state is from a singularity, group by group.

use super::{Condition, Order, Solver, Workspace};

impl Solver {
    /// For every group of the plan how far it is from a singularity at a coordinate of the driver: of a dyad
    /// the square of the sine of its transmission angle, or what plays that part, 0 at a dead point or a change
    /// point; of a coupled group the size of its determinant, which tells along one motion alone. 1 for a group
    /// that has no singularity. `None` where the state is not an ordinary one.
    #[must_use]
    pub fn margins(&self, at: f64, work: &mut Workspace) -> Option<Vec<f64>> {
        if self.solve(at, Order::Position, work) != Condition::Ok {
            return None;
        }
        self.engine.measure_coupled(at, work);
        Some(work.measures.clone())
    }
}
