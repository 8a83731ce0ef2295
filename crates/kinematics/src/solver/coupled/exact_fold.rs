//! Corrects the fold of a coupled group in double-double, and bounds the driver's coordinate there.
//!
//! The equations of a fold (see [`singular`](super::singular)) are solved in doubles first. Their
//! residuals, in double-double and from the typed decimals, correct the solution with the inverse R
//! of their matrix in doubles. Krawczyk's operator (see [`enclose`](super::enclose)) then bounds
//! the error of the coordinate. With the matrix J over a box around the solution, the error is at
//! most |R f| + |I - R J| times the size of the box.

use super::enclose::{BOX, CONTRACTION, Inverse, UNIT};
use super::singular::{Correction, Fold, System};
use super::{Coupled, Scratch};
use crate::arithmetic::{Sharp, U};
use crate::solver::state::State;
use crate::{Ball, Double, Number};

/// A fold in double-double: the unknowns z of the group, its null vector v, and the vector c that
/// normalises v.
pub(in crate::solver) struct ExactFold {
    z: Vec<Double>,
    v: Vec<Double>,
    c: Vec<f64>,
}

/// The residuals of the equations of a fold, and the inverse of their matrix.
pub(in crate::solver) struct FoldResiduals {
    n: usize,
    inverse: Vec<f64>,
    right: Vec<Sharp>,
}

impl ExactFold {
    /// Returns the unknowns of the group, in doubles.
    pub(in crate::solver) fn unknowns(&self) -> Vec<f64> {
        self.z.iter().map(|z| z.hi).collect()
    }
}

impl FoldResiduals {
    /// Returns the radius of the box in which a solution must be proved.
    pub(in crate::solver) fn radius(&self) -> f64 {
        let (mut rows, mut left) = (self.inverse.clone(), Vec::new());
        BOX * self
            .view(&mut rows, &mut left)
            .largest_component(&self.right)
    }

    fn view<'a>(&self, rows: &'a mut [f64], left: &'a mut [f64]) -> Inverse<'a> {
        Inverse {
            n: self.n,
            rows,
            left,
            most: f64::INFINITY,
        }
    }
}

impl Coupled {
    /// Converts a fold found in doubles, with its z in the scratch, to double-double.
    pub(in crate::solver) fn exact_fold(&self, fold: Fold, scratch: &mut Scratch) -> ExactFold {
        let exactly = |values: &[f64]| values.iter().map(|&v| Double::exactly(v)).collect();
        let mut z: Vec<Double> = exactly(self.open(scratch).z);
        self.turn(&mut z, &vec![0.0; self.unknowns()]);
        ExactFold {
            z,
            v: exactly(&fold.v),
            c: fold.c,
        }
    }

    /// Evaluates the equations of a fold. `state` holds the inputs of the group with both
    /// derivatives. Returns `None` if their matrix is singular.
    pub(in crate::solver) fn fold_residuals(
        &self,
        fold: &ExactFold,
        q: Sharp,
        state: &State<Sharp>,
        scratch: &mut Scratch<Sharp>,
    ) -> Option<FoldResiduals> {
        let sharp = |v: &Double| Sharp::new(*v, 0.0);
        let z: Vec<Sharp> = fold.z.iter().map(|z| Sharp::new(*z, UNIT)).collect();
        let v: Vec<Sharp> = fold.v.iter().map(sharp).collect();
        let System {
            n, matrix, right, ..
        } = self.fold_equations((&z, &v, &fold.c), q, state, scratch);
        let mut matrix: Vec<f64> = matrix.iter().map(|m| m.mid.hi).collect();
        let mut inverse = vec![0.0; n * n];
        let (mut pivots, mut column) = (vec![0; n], vec![0.0; n]);
        Inverse {
            n,
            rows: &mut inverse,
            left: &mut [],
            most: f64::INFINITY,
        }
        .fill(&mut matrix, &mut pivots, &mut column)?;
        Some(FoldResiduals { n, inverse, right })
    }

    /// Corrects a fold; the caller applies the correction of the driver's coordinate.
    pub(in crate::solver) fn correct_fold(
        &self,
        fold: &mut ExactFold,
        residuals: &FoldResiduals,
    ) -> Correction {
        let n = self.unknowns();
        let steps = residuals.inverse.chunks(residuals.n).map(|row| {
            let terms = row.iter().zip(&residuals.right);
            -terms.map(|(r, f)| r * f.mid.hi).sum::<f64>()
        });
        let steps: Vec<f64> = steps.collect();
        self.turn(&mut fold.z, &steps[..n]);
        for (v, &step) in fold.v.iter_mut().zip(&steps[n + 1..]) {
            *v += Double::exactly(step);
        }
        Correction {
            size: crate::solver::lu::largest(&steps),
            dq: steps[n],
        }
    }

    /// Bounds the distance of the driver's coordinate from that of the fold. `state` holds the
    /// inputs of the group for all coordinates within the radius of `q`. Returns `None` if the box
    /// is not proved to contain a fold.
    pub(in crate::solver) fn fold_bound(
        &self,
        fold: &ExactFold,
        residuals: &FoldResiduals,
        q: Ball,
        state: &State<Ball>,
        scratch: &mut Scratch<Ball>,
    ) -> Option<f64> {
        let radius = residuals.radius();
        let joints = 2 * self.free;
        let around = |v: &Double, more: f64| Ball::new(v.hi, radius + v.lo.abs() + more);
        let z = fold.z.iter().enumerate();
        let z: Vec<Ball> = z
            .map(|(i, z)| around(z, if i < joints { 0.0 } else { 4.0 * U }))
            .collect();
        let v: Vec<Ball> = fold.v.iter().map(|v| around(v, 0.0)).collect();
        let system = self.fold_equations((&z, &v, &fold.c), q, state, scratch);
        let (mut rows, mut left) = (residuals.inverse.clone(), vec![0.0; residuals.n]);
        let mut inverse = residuals.view(&mut rows, &mut left);
        inverse.measure(&system.matrix);
        // Negated so that NaN proves nothing.
        if !(inverse.most <= CONTRACTION) {
            return None;
        }
        let around = inverse.largest_component(&residuals.right) / (1.0 - inverse.most);
        let step = inverse.step(self.unknowns(), &residuals.right, around);
        Some(step.mid.hi.abs() + step.radius)
    }

    fn fold_equations<T: Number>(
        &self,
        (z, v, c): (&[T], &[T], &[f64]),
        q: T,
        state: &State<T>,
        scratch: &mut Scratch<T>,
    ) -> System<T> {
        let c: Vec<T> = c.iter().map(|&c| T::exactly(c)).collect();
        let mut buffers = self.open(scratch);
        buffers.z.copy_from_slice(z);
        self.fold_system(v, &c, q, state, &mut buffers)
    }
}
