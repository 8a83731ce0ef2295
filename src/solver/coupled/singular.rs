//! Where a coupled group is singular: how near it is to that, and the folds at which it ends.
//!
//! At a fold two solutions z meet and the driver turns back. There J has a null vector v, and
//!
//! ```text
//! F(z, q) = 0        J(z, q) v = 0        c.v = 1
//! ```
//!
//! is a regular system for z, v and q (Moore and Spence 1980), though J itself is singular. Its second
//! derivatives come from the second rates of the equations: with z'' = 0 and z' = a these are
//! R(a) = Q(a, a) + 2 L a + r, so that R(a + b) - R(a) - R(b) + R(0) = 2 Q(a, b) and
//! R(a) - R(-a) = 4 L a.

use super::{Coupled, Room, Scratch, lu};
use crate::solver::state::State;

/// What Newton's method for a fold carries from step to step besides z: the null vector, and the
/// vector that normalises it.
pub(in crate::solver) struct Fold {
    v: Vec<f64>,
    c: Vec<f64>,
}

impl Coupled {
    /// How far the group is from being singular, signed: the determinant of its matrix with rows of
    /// unit length, which is at most 1 (Hadamard), times its size: as the square of a sine. From z in
    /// the scratch; 0 where the matrix has no pivot.
    pub(in crate::solver) fn measure(&self, q: f64, state: &State, scratch: &mut Scratch) -> f64 {
        let det = self.determinant(q, state, scratch);
        det * det.abs()
    }

    /// The determinant of the matrix with rows of unit length.
    pub(in crate::solver) fn determinant(
        &self,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> f64 {
        let n = self.unknowns();
        let mut room = self.open(scratch);
        self.jacobian(q, state, &mut room);
        let mut det = 1.0;
        for row in room.matrix.chunks(n) {
            det /= row.iter().map(|v| v * v).sum::<f64>().sqrt();
        }
        let Some(sign) = lu::factor(room.matrix, room.pivots, n) else {
            return 0.0;
        };
        for k in 0..n {
            det *= room.matrix[k * n + k].abs();
        }
        sign * det
    }

    /// A start for [`Coupled::approach`]: close to a fold the group moves along its null vector.
    pub(in crate::solver) fn fold(&self, scratch: &mut Scratch) -> Option<Fold> {
        let room = self.open(scratch);
        let length = norm(room.first);
        let v: Vec<f64> = room.first.iter().map(|x| x / length).collect();
        let c = v.clone();
        v.iter().all(|x| x.is_finite()).then_some(Fold { v, c })
    }

    /// One step of Newton towards a fold: corrects z in the scratch and v, and gives the size of the
    /// correction and that of the coordinate, which is left to the caller. The inputs of the group
    /// stand in `state`, with both derivatives.
    pub(in crate::solver) fn approach(
        &self,
        fold: &mut Fold,
        q: f64,
        state: &State,
        scratch: &mut Scratch,
    ) -> Option<(f64, f64)> {
        let n = self.unknowns();
        let m = 2 * n + 1;
        let mut system = vec![0.0; m * m];
        let mut right = vec![0.0; m];
        let mut room = self.open(scratch);

        self.residuals(q, state, &mut room);
        right[..n].copy_from_slice(room.right);
        room.first.fill(0.0);
        room.second.fill(0.0);
        self.rates(q, state, &mut room, 1);
        let by_q = room.right.to_vec();
        self.jacobian(q, state, &mut room);
        let matrix = room.matrix.to_vec();

        let still = self.second_rates(&vec![0.0; n], q, state, &mut room);
        let along = self.second_rates(&fold.v, q, state, &mut room);
        let against: Vec<f64> = fold.v.iter().map(|x| -x).collect();
        let against = self.second_rates(&against, q, state, &mut room);
        for i in 0..n {
            for j in 0..n {
                system[i * m + j] = matrix[i * n + j];
                system[(n + i) * m + n + j] = matrix[i * n + j];
                right[n + i] += matrix[i * n + j] * fold.v[j];
            }
            system[i * m + 2 * n] = by_q[i];
            system[(n + i) * m + 2 * n] = 0.25 * (along[i] - against[i]);
            system[2 * n * m + n + i] = fold.c[i];
        }
        for j in 0..n {
            let mut unit = vec![0.0; n];
            unit[j] = 1.0;
            let alone = self.second_rates(&unit, q, state, &mut room);
            unit.iter_mut().zip(&fold.v).for_each(|(u, v)| *u += v);
            let both = self.second_rates(&unit, q, state, &mut room);
            for i in 0..n {
                system[(n + i) * m + j] = 0.5 * (both[i] - along[i] - alone[i] + still[i]);
            }
        }
        right[2 * n] = dot(&fold.c, &fold.v) - 1.0;

        let mut pivots = vec![0; m];
        lu::factor(&mut system, &mut pivots, m)?;
        lu::solve(&system, &pivots, &mut right, m);
        right.iter_mut().for_each(|x| *x = -*x);
        let size = right.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if !size.is_finite() {
            return None;
        }
        self.shift(room.z, &right[..n]);
        fold.v
            .iter_mut()
            .zip(&right[n..])
            .for_each(|(v, by)| *v += by);
        Some((size, right[2 * n]))
    }

    /// The second rates of the equations with z' = `first` and z'' = 0.
    fn second_rates(&self, first: &[f64], q: f64, state: &State, room: &mut Room<'_>) -> Vec<f64> {
        room.first.copy_from_slice(first);
        self.rates(q, state, room, 2);
        room.right.to_vec()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(v: &[f64]) -> f64 {
    dot(v, v).sqrt()
}
