//! Decides in double-double, from the typed decimals, whether the solutions of a coupled group
//! cross.
//!
//! The equations of a crossing (see [`singular`](super::singular)) are solved in doubles.
//! Corrections with the matrix in doubles then remove their residuals in double-double. Each
//! correction gains the digits that the matrix's condition allows. The remaining unfolding b is
//! zero if the branches really meet.

use super::singular::{Crossing, CrossingPlaces, Local};
use super::{Coupled, GroupScratch, Scratch};
use crate::Double;
use crate::solver::lu;
use crate::solver::state::State;
use crate::solver::workspace::Workspace;

/// A crossing in double-double; its z is in the scratch.
pub(in crate::solver) struct Unfolding {
    v: Vec<Double>,
    p: Vec<Double>,
    /// The unfolding b, by which the equations are opened.
    pub(in crate::solver) by: Double,
    crossing: Crossing,
    matrix: Vec<f64>,
    pivots: Vec<usize>,
}

impl Coupled {
    /// Starts the corrections from a crossing found in doubles. Its z and the inputs of the group
    /// are in `here`. Returns `None` if the matrix of the crossing is singular.
    pub(in crate::solver) fn unfolding(
        &self,
        crossing: Crossing,
        q: f64,
        here: &mut Workspace,
        scratch: &mut Scratch<Double>,
    ) -> Option<Unfolding> {
        let Workspace {
            state,
            scratch: own,
            ..
        } = here;
        let mut buffers = self.open(own);
        let local = Local::new(self, q, state, &mut buffers);
        let vectors = [&crossing.v[..], &crossing.p];
        let mut system =
            self.crossing_system(vectors, &crossing.null, &local, q, state, &mut buffers);
        let mut pivots = vec![0; system.n];
        lu::factor(&mut system.matrix, &mut pivots, system.n)?;
        let exactly = |values: &[f64]| values.iter().map(|&v| Double::exactly(v)).collect();
        let z: Vec<Double> = exactly(buffers.z);
        self.open(scratch).z.copy_from_slice(&z);
        Some(Unfolding {
            v: exactly(&crossing.v),
            p: exactly(&crossing.p),
            by: Double::exactly(crossing.unfolding),
            crossing,
            matrix: system.matrix,
            pivots,
        })
    }

    /// Applies one correction, and returns the correction of the driver's coordinate, which the
    /// caller applies. `state` holds the inputs of the group with both derivatives.
    pub(in crate::solver) fn unfold(
        &self,
        unfolding: &mut Unfolding,
        q: Double,
        state: &State<Double>,
        scratch: &mut Scratch<Double>,
    ) -> f64 {
        let mut buffers = self.open(scratch);
        let mut change = unfolding.left(self, q, state, &mut buffers);
        let places = CrossingPlaces::of(self.unknowns());
        lu::solve(
            &unfolding.matrix,
            &unfolding.pivots,
            &mut change,
            places.count,
        );
        change.iter_mut().for_each(|x| *x = -*x);
        self.turn(buffers.z, &change[..self.unknowns()]);
        let add = |to: &mut [Double], change: &[f64]| {
            to.iter_mut()
                .zip(change)
                .for_each(|(to, &by)| *to += Double::exactly(by));
        };
        add(&mut unfolding.v, &change[places.v.clone()]);
        add(&mut unfolding.p, &change[places.p.clone()]);
        unfolding.by += Double::exactly(change[places.unfolding]);
        change[places.q]
    }
}

impl Unfolding {
    /// Returns the number of unknowns of the group.
    pub(in crate::solver) fn unknowns(&self) -> usize {
        self.v.len()
    }

    /// Returns the residuals of the crossing's equations.
    fn left(
        &self,
        group: &Coupled,
        q: Double,
        state: &State<Double>,
        buffers: &mut GroupScratch<'_, Double>,
    ) -> Vec<f64> {
        let n = group.unknowns();
        let null = &self.crossing.null;
        group.residuals(q, state, buffers);
        let opened = null.w.iter().map(|&w| Double::exactly(w) * self.by);
        let open: Vec<Double> = buffers
            .right
            .iter()
            .zip(opened)
            .map(|(&f, w)| f + w)
            .collect();
        buffers.first.fill(Double::ZERO);
        buffers.second.fill(Double::ZERO);
        group.rates(q, state, buffers, 1);
        let by_q = buffers.right.to_vec();
        group.jacobian(q, state, buffers);
        let times = |v: &[Double]| -> Vec<Double> {
            buffers
                .matrix
                .chunks(n)
                .map(|row| product(row, v))
                .collect()
        };
        let along = |v: &[Double]| {
            let terms = null.v.iter().zip(v);
            terms.fold(Double::ZERO, |sum, (&n, &v)| sum + Double::exactly(n) * v)
        };
        let moved = times(&self.p).into_iter().zip(by_q).map(|(p, q)| p + q);
        let all = open.into_iter().chain(times(&self.v));
        let all = all.chain([along(&self.v) - Double::ONE]).chain(moved);
        all.chain([along(&self.p)]).map(|v| v.hi).collect()
    }
}

/// Returns the dot product of two vectors.
pub(super) fn product(row: &[Double], v: &[Double]) -> Double {
    let terms = row.iter().zip(v);
    terms.fold(Double::ZERO, |sum, (&a, &b)| sum + a * b)
}
