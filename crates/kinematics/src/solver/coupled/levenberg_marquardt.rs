//! Assembles a group from a rough start, by Newton's method in a trust region.
//!
//! Along the motion a group is predicted so well that Newton's method needs no care. A rough start
//! may lie where the matrix is nearly singular, and two solutions close together draw Newton's
//! steps far away. The step here is therefore that of Levenberg and Marquardt, (J'J + m) d = -J'r.
//! The damping m follows from the ratio of the actual to the predicted reduction (Nielsen, Damping
//! Parameter in Marquardt's Method, 1999, eq. 2.5; the rest is Madsen, Nielsen and Tingleff,
//! Methods for Non-Linear Least Squares Problems, 2004, algorithm 3.16).

use super::{Coupled, GroupScratch, Scratch};
use crate::numeric::{DampedSearch, Trial};
use crate::solver::lu;
use crate::solver::state::State;

/// The initial damping is relative to the largest entry of J'J. Near a double solution every step
/// halves the distance, so that these tries suffice down to the rounding error.
const SEARCH: DampedSearch = DampedSearch {
    tries: 120,
    growth: 2.0,
    growth_of_growth: 2.0,
    min_damping: 0.0,
    max_damping: f64::INFINITY,
    level_steps: usize::MAX,
    ..DampedSearch::DEFAULT
};
/// Step size, in scaled lengths and radians, below which Newton's method takes over.
const NEAR: f64 = 1e-9;

impl Coupled {
    /// Moves the z in the scratch downhill, and completes it by Newton's method. Returns `true` if
    /// this converges to a solution.
    pub(in crate::solver) fn approach(
        &self,
        q: f64,
        state: &mut State,
        scratch: &mut Scratch,
    ) -> bool {
        let mut region = Region::new(self.unknowns());
        SEARCH.run(f64::INFINITY, |damping| {
            region.step(self, q, state, &mut self.open(scratch), damping)
        });
        self.correct(q, state, scratch).settled
    }
}

/// The trust region: the unit of the damping, and buffers.
struct Region {
    n: usize,
    /// The largest entry of J'J at the start.
    unit: Option<f64>,
    matrix: Vec<f64>,
    step: Vec<f64>,
    pivots: Vec<usize>,
}

impl Region {
    fn new(n: usize) -> Region {
        Region {
            n,
            unit: None,
            matrix: vec![0.0; n * n],
            step: vec![0.0; n],
            pivots: vec![0; n],
        }
    }

    /// Tries one step, and keeps it if it leads downhill. The search is finished once the steps are
    /// small or the matrix is singular.
    fn step(
        &mut self,
        group: &Coupled,
        q: f64,
        state: &State,
        buffers: &mut GroupScratch<'_>,
        damping: f64,
    ) -> Trial {
        let n = self.n;
        group.residuals(q, state, buffers);
        group.jacobian(q, state, buffers);
        let before = lu::dot(buffers.right, buffers.right);
        let slope: Vec<f64> = (0..n)
            .map(|j| {
                (0..n)
                    .map(|i| buffers.matrix[i * n + j] * buffers.right[i])
                    .sum()
            })
            .collect();
        let largest = self.square(buffers.matrix);
        let damping = damping * *self.unit.get_or_insert(largest);
        for (i, slope) in slope.iter().enumerate() {
            self.matrix[i * n + i] += damping;
            self.step[i] = -slope;
        }
        if lu::factor(&mut self.matrix, &mut self.pivots, n).is_none() {
            return Trial::Finished;
        }
        lu::solve(&self.matrix, &self.pivots, &mut self.step, n);
        let size = lu::largest(&self.step);
        // Negated so that NaN also ends the steps.
        if !(size > NEAR) {
            return Trial::Finished;
        }
        let kept = buffers.z.to_vec();
        group.shift(buffers.z, &self.step);
        group.residuals(q, state, buffers);
        let steps = self.step.iter().zip(&slope);
        let promised: f64 = steps.map(|(d, g)| d * (damping * d - g)).sum();
        let measure = lu::dot(buffers.right, buffers.right);
        let gain = (before - measure) / promised;
        if gain > 0.0 {
            let shrinking = 1.0 - (2.0 * gain - 1.0).powi(3);
            let shrinking = Some(shrinking.max(1.0 / 3.0));
            Trial::Kept { measure, shrinking }
        } else {
            buffers.z.copy_from_slice(&kept);
            Trial::Rejected
        }
    }

    /// Sets `matrix` to J'J and returns its largest entry.
    fn square(&mut self, jacobian: &[f64]) -> f64 {
        let n = self.n;
        for i in 0..n {
            for j in 0..n {
                let column = (0..n).map(|k| jacobian[k * n + i] * jacobian[k * n + j]);
                self.matrix[i * n + j] = column.sum();
            }
        }
        (0..n).fold(0.0, |m: f64, i| m.max(self.matrix[i * n + i]))
    }
}
