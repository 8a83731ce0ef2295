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
        let mut buffers = self.open(scratch);
        self.read_as(state, buffers.z, Dual::exactly);
        self.residuals(q, dual, &mut buffers);
        self.jacobian(q, dual, &mut buffers);
        let n = self.unknowns();
        if lu::factor(buffers.matrix, buffers.pivots, n).is_none() {
            return false;
        }
        lu::solve(buffers.matrix, buffers.pivots, buffers.right, n);
        let joints = 2 * self.free;
        for (z, requested) in buffers.z.iter_mut().zip(&buffers.right[..joints]) {
            z.slope = -requested.slope;
        }
        for (d, requested) in buffers.z[joints..]
            .chunks_exact_mut(2)
            .zip(&buffers.right[joints..])
        {
            let turning = Vec2::new(d[0].value, d[1].value).perp() * -requested.slope;
            (d[0].slope, d[1].slope) = (turning.x, turning.y);
        }
        self.finish(q, order, dual, scratch)
    }
}
