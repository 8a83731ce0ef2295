//! Optimality at a kink of the optimized figure, such as the minimum of several angles where two
//! are equal; the figure has no slope there. A design is a local optimum if zero lies in the convex
//! hull of the slopes from all sides. This is Goldstein's condition, with the gradient sampling of
//! Burke, Lewis and Overton.

use super::active_constraints::{ActiveConstraints, multipliers};
use super::projection::{DesignEvaluator, EvaluatedDesign};
use crate::parallel;
use nalgebra::{DMatrix, DVector};

/// Step of differences, relative to the distance at which slopes are sampled, so that none crosses
/// the kink.
const DIFFERENCE: f64 = 0.1;
/// The relative length below which the shortest convex combination of slopes counts as zero; slopes
/// vary over the sampling distance.
const FLAT: f64 = 1e-3;
/// Maximum steps towards the shortest convex combination.
const STEPS: usize = 4000;

/// The result of sampling slopes from all sides.
#[derive(Clone, Debug)]
pub(super) enum KinkSampling {
    /// No small step improves the design.
    Lowest,
    /// A direction improves the design, to first order.
    Down {
        travel: DVector<f64>,
        /// The derivatives of the slacks at the design.
        slacks: DMatrix<f64>,
    },
    /// The slopes do not decide.
    Open,
}

impl KinkSampling {
    /// Samples slopes around a design that satisfies the constraints, at a given distance relative
    /// to the ranges. The result does not depend on the number of threads.
    pub(super) fn at(
        judge: &mut DesignEvaluator,
        here: &EvaluatedDesign,
        nearby: f64,
        threads: usize,
    ) -> KinkSampling {
        let part = DIFFERENCE * nearby;
        let Some(own) = judge.slopes(here, part, true) else {
            return KinkSampling::Open;
        };
        let holds = ActiveConstraints::at(judge, here, &own);
        let normals = holds.normals();
        let count = here.numbers.len();
        let slopes_at = |judge: &mut DesignEvaluator, k: usize| {
            let mut travel = DVector::zeros(count);
            travel[k / 2] = if k.is_multiple_of(2) { -nearby } else { nearby };
            let there = judge.evaluate(judge.moved(&here.numbers, &travel))?;
            judge.slopes(&there, part, true)
        };
        let copy = || judge.clone();
        let sampled = parallel::each(2 * count, threads, copy, slopes_at, &mut |_| true);
        let (mut free, mut held, mut maximum) = (Vec::new(), Vec::new(), 0.0_f64);
        for slopes in sampled {
            let Some(slopes) = slopes else {
                return KinkSampling::Open;
            };
            let by = multipliers(&normals, &slopes.value);
            let held_back = match normals.nrows() {
                0 => DVector::zeros(count),
                _ => normals.tr_mul(&by),
            };
            free.push(&slopes.value - held_back);
            held.push(by);
            maximum = maximum.max(slopes.value.norm());
        }
        let (shortest, parts) = shortest_between(&free);
        if shortest.norm() > FLAT * maximum.max(here.value.abs()) {
            return KinkSampling::Down {
                travel: -shortest,
                slacks: own.slacks,
            };
        }
        let mut held_by = DVector::zeros(normals.nrows());
        for (by, part) in held.iter().zip(&parts) {
            held_by += by * *part;
        }
        match holds.keep(&held_by) {
            true => KinkSampling::Lowest,
            false => KinkSampling::Open,
        }
    }
}

/// Returns the shortest convex combination of some slopes and its coefficients. Uses the
/// Frank-Wolfe method with pairwise steps from the worst active slope to the best one.
fn shortest_between(slopes: &[DVector<f64>]) -> (DVector<f64>, Vec<f64>) {
    let mut parts = vec![1.0 / slopes.len().max(1) as f64; slopes.len()];
    let size = slopes.first().map_or(0, DVector::len);
    let matrix = DMatrix::from_fn(size, slopes.len(), |i, k| slopes[k][i]);
    for _ in 0..STEPS {
        let here = &matrix * DVector::from_column_slice(&parts);
        let along = matrix.tr_mul(&here);
        let taking_part = (0..parts.len()).filter(|&k| parts[k] > 0.0);
        let worst = taking_part.max_by(|&a, &b| along[a].total_cmp(&along[b]));
        let best = (0..parts.len()).min_by(|&a, &b| along[a].total_cmp(&along[b]));
        let (Some(worst), Some(best)) = (worst, best) else {
            break;
        };
        let travel = &slopes[best] - &slopes[worst];
        let gain = along[worst] - along[best];
        if !(gain > f64::EPSILON * here.norm_squared()) {
            break;
        }
        let step = (gain / travel.norm_squared()).min(parts[worst]);
        parts[best] += step;
        parts[worst] -= step;
    }
    (&matrix * DVector::from_column_slice(&parts), parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between (1, 3) and (1, -1) the shortest vector is (1, 0), with weights 1/4 and 3/4. Around
    /// the origin it is zero.
    #[test]
    fn shortest_between_finds_shortest_convex_combination() {
        let slope = |x: f64, y: f64| DVector::from_vec(vec![x, y]);
        let (shortest, parts) = shortest_between(&[slope(1.0, 3.0), slope(1.0, -1.0)]);
        assert!((shortest - slope(1.0, 0.0)).norm() < 1e-9);
        assert!((parts[0] - 0.25).abs() < 1e-9, "{parts:?}");
        let around = [slope(2.0, 0.1), slope(-1.0, 3.0), slope(-0.5, -4.0)];
        assert!(shortest_between(&around).0.norm() < 1e-6);
    }
}
