//! Solves small strictly convex quadratic programs with inequalities. A program is transformed to a
//! least-distance problem, and this to non-negative least squares (Lawson and Hanson, Solving Least
//! Squares Problems, 1974, chapter 23).

use super::projection::is_finite;
use nalgebra::{DMatrix, DVector};

/// The relative size below which a gain or a residual counts as zero.
const ROUNDING: f64 = 1e-12;
/// Maximum number of columns that enter, for each column.
const ENTRIES: usize = 4;

/// The minimum of a quadratic program.
#[derive(Clone, Debug)]
pub(super) struct QuadraticMinimum {
    pub(super) place: DVector<f64>,
    /// The Lagrange multiplier of each inequality; 0 for one that does not act.
    pub(super) multipliers: DVector<f64>,
}

/// Minimizes `slope x + x curvature x / 2` where `normals x >= limits`. The curvature must be positive
/// definite. Returns `None` if it is not, or if no `x` satisfies the inequalities.
pub(super) fn quadratic_minimum(
    curvature: &DMatrix<f64>,
    slope: &DVector<f64>,
    normals: &DMatrix<f64>,
    limits: &DVector<f64>,
) -> Option<QuadraticMinimum> {
    // With `L L' = curvature` and `y = L' x + L^-1 slope`, the nearest `y` to the origin is sought.
    let root = curvature.clone().cholesky()?.l();
    let offset = root.solve_lower_triangular(slope)?;
    let mut normals = root.solve_lower_triangular(&normals.transpose())?;
    let mut limits = limits + normals.tr_mul(&offset);
    let sizes: Vec<f64> = normals.column_iter().map(|normal| normal.norm()).collect();
    for (i, &size) in sizes.iter().enumerate().filter(|(_, size)| **size > 0.0) {
        normals.column_mut(i).scale_mut(1.0 / size);
        limits[i] /= size;
    }
    let (count, size) = (normals.ncols(), normals.nrows());
    let matrix = DMatrix::from_fn(size + 1, count, |row, i| match row < size {
        true => normals[(row, i)],
        false => limits[i],
    });
    let mut right = DVector::zeros(size + 1);
    right[size] = 1.0;
    let parts = nonnegative_least_squares(&matrix, &right)?;
    let rest = 1.0 - limits.dot(&parts);
    if !(rest > ROUNDING) {
        return None;
    }
    let nearest = &normals * &parts / rest;
    let place = root.tr_solve_lower_triangular(&(nearest - offset))?;
    let multipliers = parts
        .iter()
        .zip(&sizes)
        .map(|(part, size)| match *size > 0.0 {
            true => part / (rest * size),
            false => 0.0,
        });
    Some(QuadraticMinimum {
        multipliers: DVector::from_iterator(count, multipliers),
        place,
    })
}

/// Returns the non-negative combination of columns nearest to a vector.
fn nonnegative_least_squares(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if !is_finite(matrix) {
        return None;
    }
    let count = matrix.ncols();
    let mut acts = vec![false; count];
    let mut found = DVector::zeros(count);
    for _ in 0..ENTRIES * count {
        let rest = right - matrix * &found;
        let gains = matrix.tr_mul(&rest);
        let gain = |&i: &usize| gains[i] / matrix.column(i).norm().max(f64::MIN_POSITIVE);
        let next = (0..count)
            .filter(|i| !acts[*i] && gain(i) > ROUNDING)
            .max_by(|a, b| gain(a).total_cmp(&gain(b)));
        let Some(next) = next else {
            break;
        };
        acts[next] = true;
        loop {
            let own: Vec<usize> = (0..count).filter(|&i| acts[i]).collect();
            if own.is_empty() {
                break;
            }
            let parts = matrix.select_columns(&own).svd(true, true);
            let minimum = f64::EPSILON * parts.singular_values.max();
            let solved = parts.solve(right, minimum).ok()?;
            if solved.iter().all(|part| *part > 0.0) {
                for (&i, part) in own.iter().zip(solved.iter()) {
                    found[i] = *part;
                }
                break;
            }
            // Moves towards the solution until the first part is zero, which then leaves.
            let pairs = || own.iter().zip(solved.iter());
            let leaving = pairs().filter(|(_, part)| **part <= 0.0);
            let reach =
                leaving.map(|(&i, part)| found[i] / (found[i] - part).max(f64::MIN_POSITIVE));
            let reach = reach.fold(1.0, f64::min);
            for (&i, part) in own.iter().zip(solved.iter()) {
                found[i] += reach * (part - found[i]);
                if *part <= 0.0 && found[i] <= ROUNDING {
                    found[i] = 0.0;
                    acts[i] = false;
                }
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(numbers: &[f64]) -> DVector<f64> {
        DVector::from_column_slice(numbers)
    }

    /// The point of a half-plane nearest to (1, 2), with another inequality that does not act.
    #[test]
    fn minimum_lies_on_acting_inequality() {
        let normals = DMatrix::from_row_slice(2, 2, &[-1.0, -1.0, 1.0, 0.0]);
        let found = quadratic_minimum(
            &(2.0 * DMatrix::identity(2, 2)),
            &vector(&[-2.0, -4.0]),
            &normals,
            &vector(&[-2.0, -5.0]),
        );
        let found = found.unwrap();
        assert!((found.place - vector(&[0.5, 1.5])).norm() < 1e-12);
        assert!((found.multipliers - vector(&[1.0, 0.0])).norm() < 1e-12);
    }

    /// In a corner, the multipliers combine the normals to the slope.
    #[test]
    fn minimum_in_corner_balances_slope() {
        let curvature = DMatrix::from_row_slice(2, 2, &[3.0, 1.0, 1.0, 2.0]);
        let slope = vector(&[5.0, 4.0]);
        let normals = DMatrix::from_row_slice(3, 2, &[1.0, 0.2, -0.1, 1.0, 1.0, 1.0]);
        let limits = vector(&[1.0, 2.0, -9.0]);
        let found = quadratic_minimum(&curvature, &slope, &normals, &limits).unwrap();
        assert!((&normals * &found.place - &limits).rows(0, 2).norm() < 1e-12);
        let rest = slope + curvature * &found.place - normals.tr_mul(&found.multipliers);
        assert!(rest.norm() < 1e-11, "{rest}");
        assert!(found.multipliers[0] > 0.0 && found.multipliers[2] == 0.0);
    }

    #[test]
    fn contradicting_inequalities_have_no_minimum() {
        let normals = DMatrix::from_row_slice(2, 1, &[1.0, -1.0]);
        let of = |upper: f64| {
            let limits = vector(&[1.0, -upper]);
            quadratic_minimum(&DMatrix::identity(1, 1), &vector(&[0.0]), &normals, &limits)
        };
        assert!(of(0.5).is_none());
        assert!((of(1.0).unwrap().place[0] - 1.0).abs() < 1e-12);
        assert!((of(2.0).unwrap().place[0] - 1.0).abs() < 1e-12);
    }
}
