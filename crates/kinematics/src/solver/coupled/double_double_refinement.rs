//! Refines the solution of a coupled group in double-double.

use super::{Coupled, GroupScratch, Scratch};
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::lu;
use crate::solver::state::State;
use crate::{Double, Vec2};

/// Number of corrections from a state in doubles. Each gains the digits of a double, less those
/// lost by the condition of the matrix.
const CORRECTIONS: usize = 4;

impl Coupled {
    /// Refines the group's solution in `state` to double-double, and writes it into `twice`, which
    /// holds the inputs. Returns `false` if the matrix is singular.
    pub(in crate::solver) fn refine(
        &self,
        q: Double,
        order: u8,
        state: &State,
        twice: &mut State<Double>,
        scratch: &mut Scratch<Double>,
    ) -> bool {
        let mut work = std::mem::take(&mut scratch.work);
        let mut buffers = self.open(scratch);
        self.read_as(state, buffers.z, Double::exactly);
        self.read_rates(state, buffers.first, buffers.second);
        let solved = self.refine_in(q, order, twice, &mut buffers, &mut work);
        if solved {
            self.write(q, twice, &buffers);
        }
        scratch.work = work;
        solved
    }

    fn refine_in(
        &self,
        q: Double,
        order: u8,
        twice: &State<Double>,
        buffers: &mut GroupScratch<'_, Double>,
        work: &mut [f64],
    ) -> bool {
        let n = self.unknowns();
        let (matrix, right) = work.split_at_mut(n * n);
        let right = &mut right[..n];
        self.jacobian(q, twice, buffers);
        for (copy, value) in matrix.iter_mut().zip(&*buffers.matrix) {
            *copy = value.hi;
        }
        if lu::factor(matrix, buffers.pivots, n).is_none() {
            return false;
        }
        for _ in 0..CORRECTIONS {
            self.residuals(q, twice, buffers);
            self.correction(matrix, right, buffers);
            self.turn(buffers.z, right);
        }
        for _ in 0..CORRECTIONS {
            if order >= VELOCITY {
                self.rates(q, twice, buffers, 1);
                self.correction(matrix, right, buffers);
                add(right, buffers.first);
            }
        }
        for _ in 0..CORRECTIONS {
            if order >= ACCELERATION {
                self.rates(q, twice, buffers, 2);
                self.correction(matrix, right, buffers);
                add(right, buffers.second);
            }
        }
        true
    }

    /// Computes into `right` the correction for the residuals in `buffers`, in doubles. `matrix` is
    /// factored.
    fn correction(&self, matrix: &[f64], right: &mut [f64], buffers: &GroupScratch<'_, Double>) {
        for (to, from) in right.iter_mut().zip(&*buffers.right) {
            *to = -from.hi;
        }
        lu::solve(matrix, buffers.pivots, right, self.unknowns());
    }

    /// Adds a change of the unknowns to z; directions are rotated and keep their length.
    pub(super) fn turn(&self, z: &mut [Double], change: &[f64]) {
        let joints = 2 * self.free;
        add(&change[..joints], z);
        for (i, &angle) in change[joints..].iter().enumerate() {
            let at = joints + 2 * i;
            let d = Vec2::new(z[at], z[at + 1]);
            let mut unit = d + d.perp() * Double::exactly(angle);
            for _ in 0..2 {
                // Newton's method for the length: each step doubles its digits.
                let off = (Double::exactly(3.0) - unit.norm2()).scaled(0.5);
                unit = unit * off;
            }
            (z[at], z[at + 1]) = (unit.x, unit.y);
        }
    }
}

fn add(change: &[f64], to: &mut [Double]) {
    for (to, &change) in to.iter_mut().zip(change) {
        *to += Double::exactly(change);
    }
}
