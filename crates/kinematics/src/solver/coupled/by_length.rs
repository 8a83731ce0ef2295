//! Differentiates a coupled group by a length: J dz = -(derivative of the equations by the length).

use super::{Coupled, Scratch};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Dual, Number, Vec2};

impl Coupled {
    /// Computes the derivatives of the solution in `state` by a length, and writes the group's
    /// points and links into `dual`. Returns `false` if the matrix is singular.
    pub(in crate::solver) fn by_length(
        &self,
        q: Dual,
        order: u8,
        state: &State,
        dual: &mut State<Dual>,
        scratch: &mut Scratch<Dual>,
    ) -> bool {
        let mut room = self.open(scratch);
        self.read_as(state, room.z, Dual::exactly);
        self.residuals(q, dual, &mut room);
        self.jacobian(q, dual, &mut room);
        let n = self.unknowns();
        if lu::factor(room.matrix, room.pivots, n).is_none() {
            return false;
        }
        lu::solve(room.matrix, room.pivots, room.right, n);
        let joints = 2 * self.free;
        for (z, asked) in room.z.iter_mut().zip(&room.right[..joints]) {
            z.slope = -asked.slope;
        }
        for (d, asked) in room.z[joints..]
            .chunks_exact_mut(2)
            .zip(&room.right[joints..])
        {
            let turning = Vec2::new(d[0].value, d[1].value).perp() * -asked.slope;
            (d[0].slope, d[1].slope) = (turning.x, turning.y);
        }
        self.finish(q, order, dual, scratch)
    }
}
