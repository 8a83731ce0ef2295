//! Computes the numerical rank and the null spaces of a matrix with rows of unit length.

use nalgebra::{DMatrix, RowDVector};
use std::collections::BTreeSet;

/// The unit roundoff u: half the distance from 1 to the next double.
const U: f64 = 0.5 * f64::EPSILON;
/// Bound on the rounding of a row and its decomposition, in u per term.
const ROUNDINGS: f64 = 16.0;
/// Singular values up to this factor above the threshold are inconclusive: they may be zero in a
/// mechanism slightly different from the drawn one. With a coarse threshold, the limit is its square
/// root, half of the decades to 1.
const INCONCLUSIVE_FACTOR: f64 = 1e3;
/// Shares of a null vector below this, or below so many of the matrix's own roundings, are rounding
/// errors.
const MAX_ROUNDING_SHARE: f64 = 1e-8;
const SHARE_ROUNDINGS: f64 = 32.0;
/// Weight of each step of readiness to be set aside: a row to be kept first yields to one that is
/// better conditioned by this factor.
const READINESS_WEIGHT: f64 = 0.5;

/// The conclusions from a matrix's singular values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spectrum {
    pub(super) rank: usize,
    /// Whether a nonzero singular value is close to zero.
    pub(super) is_unclear: bool,
    /// The ratio of the smallest singular value to the largest one.
    pub(super) ratio: f64,
    /// A share of a null vector below this is rounding error.
    pub(super) noise: f64,
}

impl Spectrum {
    /// Computes the spectrum; returns `None` if the decomposition does not converge.
    ///
    /// `slack` bounds the angular error of a row's direction, in radians. A row then changes by at
    /// most 2 `slack`, and a singular value by sqrt(2 m) times that (Weyl). `doubt` bounds the
    /// accepted error in the same way: any motion that it could hide is unclear.
    pub(super) fn of(matrix: &DMatrix<f64>, slack: f64, confirm_reason: f64) -> Option<Spectrum> {
        let (m, n) = matrix.shape();
        if m.min(n) == 0 {
            return Some(Spectrum {
                rank: 0,
                is_unclear: false,
                ratio: 0.0,
                noise: MAX_ROUNDING_SHARE,
            });
        }
        const MAX_SWEEPS: usize = 100_000;
        let decomposed = nalgebra::SVD::try_new(matrix.clone(), false, false, U, MAX_SWEEPS)?;
        let values = decomposed.singular_values;
        let largest = values.max();
        let rounding = ROUNDINGS * m.max(n) as f64 * U * largest;
        let change = |off: f64| (2.0 * m as f64).sqrt() * 2.0 * off;
        let zero = rounding.max(change(slack));
        let unclear = (INCONCLUSIVE_FACTOR * zero)
            .min(zero.sqrt())
            .max(change(confirm_reason));
        let rank = values.iter().filter(|&&v| v > zero).count();
        let is_unclear = values.iter().any(|&v| zero < v && v <= unclear);
        let minimum = values
            .iter()
            .copied()
            .filter(|&v| v > zero)
            .fold(largest, f64::min);
        Some(Spectrum {
            rank,
            is_unclear,
            ratio: values.min() / largest,
            noise: MAX_ROUNDING_SHARE
                .max(SHARE_ROUNDINGS * (U * largest).max(2.0 * slack) / minimum),
        })
    }
}

/// The rows kept of a matrix, and the sums that the others repeat.
#[derive(Clone)]
pub(super) struct IndependentRows {
    pub(super) kept: Vec<usize>,
    pub(super) set_aside: Vec<usize>,
    /// The coefficient of each kept row in the sum of each set-aside row.
    parts: DMatrix<f64>,
}

/// Selects `rank` well-conditioned rows, preferring those less ready to be set aside.
///
/// Uses QR with pivoting of the weighted rows, A^T P = Q (R1 R2); the other rows are R1^-1 R2 times
/// the kept ones.
pub(super) fn choose(matrix: &DMatrix<f64>, rank: usize, readiness: &[u8]) -> IndependentRows {
    let weight = |i: usize| READINESS_WEIGHT.powi(i32::from(readiness[i]));
    let mut columns = matrix.transpose();
    for i in 0..columns.ncols() {
        columns.column_mut(i).scale_mut(weight(i));
    }
    let order = pivoted(columns);
    let (kept, set_aside) = order.split_at(rank);
    let (mut kept, mut set_aside) = (kept.to_vec(), set_aside.to_vec());
    kept.sort_unstable();
    set_aside.sort_unstable();
    IndependentRows::new(matrix, kept, set_aside)
}

impl IndependentRows {
    pub(super) fn new(
        matrix: &DMatrix<f64>,
        kept: Vec<usize>,
        set_aside: Vec<usize>,
    ) -> IndependentRows {
        let of_kept = matrix.select_rows(&kept).transpose();
        let of_others = matrix.select_rows(&set_aside).transpose();
        IndependentRows {
            parts: least_squares(&of_kept, of_others),
            kept,
            set_aside,
        }
    }

    /// Returns the maximum coefficient in the sum of a set-aside row, given by its index among
    /// these.
    pub(super) fn largest_of(&self, aside: usize) -> f64 {
        self.parts
            .column(aside)
            .iter()
            .fold(0.0, |maximum, part| f64::max(maximum, part.abs()))
    }

    /// Returns the maximum of all coefficients; infinite if the kept rows are dependent.
    pub(super) fn largest(&self) -> f64 {
        let finite = |v: &f64| {
            if v.is_finite() {
                v.abs()
            } else {
                f64::INFINITY
            }
        };
        self.parts.iter().map(finite).fold(0.0, f64::max)
    }

    /// Returns the rows in the sum of a set-aside row, given by its index among these.
    pub(super) fn repeated_by(&self, aside: usize, noise: f64) -> Vec<usize> {
        let parts = self.parts.column(aside);
        let parts = self.kept.iter().zip(parts.iter());
        parts
            .filter(|(_, part)| part.abs() > noise)
            .map(|(&i, _)| i)
            .collect()
    }

    /// Returns all rows that repeat each other.
    pub(super) fn repeating(&self, noise: f64) -> BTreeSet<usize> {
        let sums = (0..self.set_aside.len()).flat_map(|i| self.repeated_by(i, noise));
        sums.chain(self.set_aside.iter().copied()).collect()
    }
}

/// Returns the residual of the last column of a matrix as a linear combination of the others, which
/// must be independent.
pub(super) fn residual(matrix: &DMatrix<f64>) -> f64 {
    let n = matrix.ncols().saturating_sub(1);
    let others = matrix.columns(0, n).into_owned();
    let last = matrix.columns(n, 1).into_owned();
    let parts = least_squares(&others, last.clone());
    (last - others * parts).norm()
}

/// Returns the share of every column in the motions that the kept rows leave free; 0 if it is
/// rounding error.
///
/// With A P = Q (R1 R2), the columns of R2 move freely, by 1, and those of R1 follow by -R1^-1 R2.
pub(super) fn free_shares(matrix: &DMatrix<f64>, kept: &[usize], noise: f64) -> Vec<f64> {
    let kept_rows = matrix.select_rows(kept);
    let (rank, n) = kept_rows.shape();
    let mut shares = vec![0.0; n];
    if rank == n {
        return shares;
    }
    let order = pivoted(kept_rows.clone());
    let (bound, free) = order.split_at(rank);
    let follow = least_squares(
        &kept_rows.select_columns(bound),
        kept_rows.select_columns(free),
    );
    for &column in free {
        shares[column] = 1.0;
    }
    for (row, &column) in follow.row_iter().zip(bound) {
        let share = row.norm();
        shares[column] = if share > noise { share } else { 0.0 };
    }
    shares
}

/// Returns the columns of a matrix in the order of QR with pivoting.
fn pivoted(matrix: DMatrix<f64>) -> Vec<usize> {
    let n = matrix.ncols();
    let mut order = RowDVector::from_fn(n, |_, i| i);
    matrix.col_piv_qr().p().permute_columns(&mut order);
    order.iter().copied().collect()
}

/// Solves A X = B in the least-squares sense; the columns of A must be independent.
fn least_squares(a: &DMatrix<f64>, b: DMatrix<f64>) -> DMatrix<f64> {
    let (n, columns) = (a.ncols(), b.ncols());
    if n == 0 || columns == 0 {
        return DMatrix::zeros(n, columns);
    }
    let qr = a.clone().qr();
    let mut right = b;
    qr.q_tr_mul(&mut right);
    let top = right.rows(0, n).into_owned();
    let r = qr.r();
    r.solve_upper_triangular(&top)
        .unwrap_or_else(|| DMatrix::from_element(n, columns, f64::INFINITY))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns pseudorandom numbers between -1 and 1.
    fn scattered(i: usize, j: usize) -> f64 {
        (12.9898 * (i + 1) as f64 + 78.233 * (j + 1) as f64).sin() * 43_758.545_3 % 1.0
    }

    /// Returns m rows of unit length with a known rank; the later ones are sums of the first.
    fn planted(m: usize, n: usize, rank: usize) -> DMatrix<f64> {
        let base = DMatrix::from_fn(rank, n, scattered);
        let sums = DMatrix::from_fn(m, rank, |i, j| {
            if i < rank {
                f64::from(u8::from(i == j))
            } else {
                scattered(i + 7, j)
            }
        });
        let mut matrix = sums * base;
        for i in 0..m {
            let norm = matrix.row(i).norm();
            matrix.row_mut(i).unscale_mut(norm);
        }
        matrix
    }

    #[test]
    fn planted_rank_is_found_and_near_singularity_is_unclear() {
        for (m, n, rank) in [
            (1, 1, 1),
            (9, 9, 8),
            (24, 20, 17),
            (20, 24, 20),
            (70, 60, 41),
        ] {
            let spectrum = Spectrum::of(&planted(m, n, rank), 0.0, 0.0).unwrap();
            assert_eq!(spectrum.rank, rank, "{m} x {n}");
            assert!(!spectrum.is_unclear, "{m} x {n}");
        }
        let nearly = |off: f64| DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 1.0, off]);
        let of = |off, slack| Spectrum::of(&nearly(off), slack, 0.0).unwrap();
        assert_eq!((of(1e-17, 0.0).rank, of(1e-9, 0.0).rank), (1, 2));
        assert!(of(1e-13, 0.0).is_unclear && !of(1e-9, 0.0).is_unclear);
        // Rounded input coordinates hide larger deviations.
        assert_eq!(of(1e-5, 1e-4).rank, 1);
        let doubted = Spectrum::of(&nearly(1e-5), 0.0, 1e-4).unwrap();
        assert!(doubted.rank == 2 && doubted.is_unclear);
    }

    #[test]
    fn readiest_dependent_row_is_set_aside() {
        // The third row is a combination of the first two; the fourth is independent.
        let matrix = DMatrix::from_row_slice(
            4,
            3,
            &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0],
        );
        for (ready, gone) in [([0, 3, 0, 4], 1), ([4, 0, 0, 4], 0), ([0, 0, 2, 4], 2)] {
            let choice = choose(&matrix, 3, &ready);
            assert_eq!(choice.set_aside, [gone]);
            let repeating: Vec<usize> = choice.repeating(1e-8).into_iter().collect();
            assert_eq!(repeating, [0, 1, 2]);
        }
    }

    #[test]
    fn only_free_unknowns_have_share() {
        let matrix = DMatrix::from_row_slice(2, 4, &[1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        let shares = free_shares(&matrix, &[0, 1], 1e-8);
        let moves: Vec<bool> = shares.iter().map(|&share| share > 0.0).collect();
        assert_eq!(moves, [true, true, false, true]);
    }
}
