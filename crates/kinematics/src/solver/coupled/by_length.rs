//! How a coupled group follows a length: J dz = -(what the length does to the equations).

use super::{Coupled, Scratch};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Dual, Number, Vec2};

impl Coupled {
    /// Takes what was found in doubles, gives it its derivatives, and places with them what the group places;
    /// whether it could.
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
