//! Solves linear equations with one additional cubic condition.
//!
//! The equations of both outputs are linear in products of the unknowns. If there are two fewer
//! equations than products, the solutions form a plane through the origin, v = t v1 + v2 up to a
//! factor. The condition that one product equals the product of two others is a cubic in t. It has
//! at most three solutions, and all of them are found.

use kinematics::numeric::polynomial_roots;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Maximum number of iterations of a decomposition; so small a matrix needs far fewer.
const SWEEPS: usize = 200;
/// A singular value below this fraction of the largest one reduces the rank of the equations.
const SINGULAR: f64 = 1e-12;
/// The condition holds everywhere if its largest value on unit vectors is below this limit.
const IDENTITY_TOLERANCE: f64 = 1e-12;
/// Number of samples from a continuous family of solutions.
pub(super) const SAMPLES: usize = 24;

/// Solution vectors, each up to a factor, and whether these are all.
#[derive(Clone, Debug, Default)]
pub(super) struct SolvedLines {
    pub(super) vectors: Vec<DVector<f64>>,
    pub(super) is_complete: bool,
}

/// Solves rows of equations, in the least-squares sense if they are many, on the `free` (1 or 2)
/// directions with the smallest residuals. With two directions, returns the vectors on which
/// `condition`, a homogeneous cubic, is 0.
pub(super) fn solved(
    rows: &[Vec<f64>],
    free: usize,
    condition: impl Fn(&DVector<f64>) -> f64,
) -> SolvedLines {
    let Some((mut space, rank)) = directions(rows) else {
        return SolvedLines::default();
    };
    let width = space.len();
    let needed = width.saturating_sub(free);
    if rank < needed {
        return family(&space[rank..], condition);
    }
    let mut space = space.split_off(needed);
    match (space.pop(), space.pop()) {
        (Some(one), None) => SolvedLines {
            vectors: vec![one],
            is_complete: true,
        },
        (Some(one), Some(two)) => on_a_plane(&one, &two, &condition),
        _ => SolvedLines::default(),
    }
}

/// Returns the right singular vectors in descending order of their singular values, and the
/// numerical rank.
fn directions(rows: &[Vec<f64>]) -> Option<(Vec<DVector<f64>>, usize)> {
    let width = rows.first()?.len();
    // Each row is scaled to the same size, and zero rows complete the square.
    let height = rows.len().max(width);
    let mut matrix = DMatrix::zeros(height, width);
    for (i, row) in rows.iter().enumerate() {
        let size = row.iter().fold(0.0_f64, |maximum, v| maximum.max(v.abs()));
        if !row.iter().all(|v| v.is_finite()) {
            return None;
        }
        for (j, value) in row.iter().enumerate() {
            matrix[(i, j)] = if size > 0.0 { value / size } else { 0.0 };
        }
    }
    let decomposed = nalgebra::SVD::try_new(matrix, false, true, f64::EPSILON, SWEEPS)?;
    let right = decomposed.v_t?;
    let values = decomposed.singular_values;
    let mut order: Vec<usize> = (0..width).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let largest = values.max();
    let rank = values.iter().filter(|v| **v > SINGULAR * largest).count();
    let space = order.iter().map(|&i| right.row(i).transpose()).collect();
    Some((space, rank))
}

/// Samples a continuous family of solutions on planes of pairs of directions.
fn family(space: &[DVector<f64>], condition: impl Fn(&DVector<f64>) -> f64) -> SolvedLines {
    let mut vectors = Vec::new();
    for (k, one) in space.iter().enumerate() {
        for two in &space[k + 1..] {
            // With one more direction than the condition needs, the condition is solved on the
            // plane of a sample and the third direction.
            let planes = (0..SAMPLES).map(|i| {
                let (sin, cos) = (PI * i as f64 / SAMPLES as f64).sin_cos();
                one * cos + two * sin
            });
            for vector in planes {
                match space.iter().find(|v| *v != one && *v != two) {
                    Some(third) => vectors.extend(on_a_plane(&vector, third, &condition).vectors),
                    None => vectors.push(vector),
                }
            }
        }
    }
    vectors.truncate(4 * SAMPLES);
    SolvedLines {
        vectors,
        is_complete: false,
    }
}

/// Solves the condition on the plane of two directions.
fn on_a_plane(
    one: &DVector<f64>,
    two: &DVector<f64>,
    condition: &impl Fn(&DVector<f64>) -> f64,
) -> SolvedLines {
    let turned = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        (one * cos + two * sin, two * cos - one * sin)
    };
    let looks = (0..8).map(|k| turned(PI * f64::from(k) / 8.0));
    // In the direction with the largest absolute value of the condition lies no solution, so t
    // stays small.
    let maximum = looks
        .map(|(a, b)| (condition(&a).abs(), a, b))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((size, a, b)) = maximum else {
        return SolvedLines::default();
    };
    if !(size > IDENTITY_TOLERANCE) {
        return SolvedLines {
            vectors: (0..SAMPLES)
                .map(|k| turned(PI * k as f64 / SAMPLES as f64).0)
                .collect(),
            is_complete: false,
        };
    }
    let (c0, c3) = (condition(&b), condition(&a));
    let (sum, difference) = (condition(&(&a + &b)), condition(&(&a - &b)));
    let terms = [
        c0,
        (sum + difference) / 2.0 - c3,
        (sum - difference) / 2.0 - c0,
        c3,
    ];
    SolvedLines {
        vectors: polynomial_roots(&terms)
            .into_iter()
            .map(|t| &a * t + &b)
            .collect(),
        is_complete: true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubic_condition_on_plane_finds_known_solution() {
        // x = 1, y = 2 z + w with x y z = w^3 is a cubic in w / x; the known vector (1, 5, 2, 1)
        // solves the rows.
        let rows = [vec![5.0, -1.0, 0.0, 0.0], vec![0.0, 1.0, -2.0, -1.0]];
        let condition = |v: &DVector<f64>| v[0] * v[1] * v[2] - 10.0 * v[3].powi(3);
        let solved = solved(&rows, 2, condition);
        assert!(solved.is_complete);
        let near = solved.vectors.iter().any(|v| {
            let v = v / v[0];
            (v - DVector::from_vec(vec![1.0, 5.0, 2.0, 1.0])).norm() < 1e-12
        });
        assert!(near, "{solved:?}");
    }

    #[test]
    fn dependent_rows_give_sampled_family() {
        let rows = [vec![1.0, 2.0, 3.0], vec![2.0, 4.0, 6.0]];
        let solved = solved(&rows, 1, |_| 0.0);
        assert!(!solved.is_complete && solved.vectors.len() == SAMPLES);
        for v in &solved.vectors {
            assert!((v[0] + 2.0 * v[1] + 3.0 * v[2]).abs() < 1e-12);
        }
        let none = super::solved(&[vec![f64::NAN, 1.0]], 1, |_| 0.0);
        assert!(none.vectors.is_empty() && !none.is_complete);
    }
}
