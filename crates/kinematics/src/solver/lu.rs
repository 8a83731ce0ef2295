//! Solves dense linear systems in place, by Gaussian elimination with partial pivoting.
//!
//! A coupled group needs only these few lines, and solving must not allocate.

use crate::Number;

/// Factors the n x n `matrix` (row-major) into L U; `pivots[k]` is the row swapped with row k.
/// Returns the sign of the determinant, 1 or -1. `None` if a column has no pivot: the matrix is
/// singular, or not finite.
pub(super) fn factor<T: Number>(matrix: &mut [T], pivots: &mut [usize], n: usize) -> Option<f64> {
    let mut sign = 1.0;
    for k in 0..n {
        // The bits of absolute values are in their order, NaN last.
        let size = |row: &usize| matrix[row * n + k].nearest().abs();
        let pivot = (k..n).max_by_key(|row| size(row).to_bits())?;
        let largest = size(&pivot);
        if !(largest > 0.0 && largest.is_finite()) {
            return None;
        }
        pivots[k] = pivot;
        if pivot != k {
            sign = -sign;
            let (upper, lower) = matrix.split_at_mut(pivot * n);
            upper[k * n..(k + 1) * n].swap_with_slice(&mut lower[..n]);
        }
        let (upper, lower) = matrix.split_at_mut((k + 1) * n);
        let [pivot, right @ ..] = &upper[k * n + k..] else {
            return None;
        };
        sign *= pivot.nearest().signum();
        let inverse = T::exactly(1.0) / *pivot;
        for row in lower.chunks_exact_mut(n) {
            let [first, rest @ ..] = &mut row[k..] else {
                return None;
            };
            let factor = *first * inverse;
            *first = factor;
            for (value, &above) in rest.iter_mut().zip(right) {
                *value = *value - factor * above;
            }
        }
    }
    Some(sign)
}

/// Solves a system with the factors from [`factor`]. The solution replaces `right`.
pub(super) fn solve<T: Number>(matrix: &[T], pivots: &[usize], right: &mut [T], n: usize) {
    for (k, &pivot) in pivots.iter().enumerate() {
        right.swap(k, pivot);
    }
    for i in 1..n {
        let (done, rest) = right.split_at_mut(i);
        rest[0] = rest[0] - dot(&matrix[i * n..i * n + i], done);
    }
    for i in (0..n).rev() {
        let (rest, done) = right.split_at_mut(i + 1);
        let sum = dot(&matrix[i * n + i + 1..(i + 1) * n], done);
        rest[i] = (rest[i] - sum) / matrix[i * n + i];
    }
}

/// Solves with the transpose of the matrix passed to [`factor`].
pub(super) fn solve_transposed<T: Number>(
    matrix: &[T],
    pivots: &[usize],
    right: &mut [T],
    n: usize,
) {
    for i in 0..n {
        let sum = (0..i).fold(T::default(), |sum, k| sum + matrix[k * n + i] * right[k]);
        right[i] = (right[i] - sum) / matrix[i * n + i];
    }
    for i in (0..n).rev() {
        let below = i + 1..n;
        let sum = below.fold(T::default(), |sum, k| sum + matrix[k * n + i] * right[k]);
        right[i] = right[i] - sum;
    }
    for (k, &pivot) in pivots.iter().enumerate().rev() {
        right.swap(k, pivot);
    }
}

/// Returns the largest absolute value of the components. NaN if any is NaN, so that `largest(..) <
/// limit` is `false`.
pub(super) fn largest<T: Number>(v: &[T]) -> f64 {
    let sizes = v.iter().map(|v| v.nearest().abs());
    sizes.fold(0.0, |maximum, size| {
        if size > maximum || size.is_nan() {
            size
        } else {
            maximum
        }
    })
}

pub(super) fn dot<T: Number>(a: &[T], b: &[T]) -> T {
    let products = a.iter().zip(b).map(|(&a, &b)| a * b);
    products.fold(T::default(), |sum, product| sum + product)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_system_that_needs_pivoting() {
        let a = [0.0, 2.0, 1.0, 1.0, 0.0, 3.0, 4.0, 5.0, 0.0];
        let x = [1.0, -2.0, 0.5];
        let mut right: Vec<f64> = (0..3).map(|i| dot(&a[3 * i..3 * i + 3], &x)).collect();
        let (mut matrix, mut pivots) = (a, [0; 3]);
        factor(&mut matrix, &mut pivots, 3).unwrap();
        solve(&matrix, &pivots, &mut right, 3);
        for (got, want) in right.iter().zip(x) {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
    }

    #[test]
    fn solves_transposed_system() {
        let a = [0.0, 2.0, 1.0, 1.0, 0.0, 3.0, 4.0, 5.0, 0.0];
        let x = [1.0, -2.0, 0.5];
        let column = |i: usize| [a[i], a[3 + i], a[6 + i]];
        let mut right: Vec<f64> = (0..3).map(|i| dot(&column(i), &x)).collect();
        let (mut matrix, mut pivots) = (a, [0; 3]);
        factor(&mut matrix, &mut pivots, 3).unwrap();
        solve_transposed(&matrix, &pivots, &mut right, 3);
        for (got, want) in right.iter().zip(x) {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
    }

    #[test]
    fn factor_returns_sign_of_determinant() {
        let mut matrix = [0.0, 2.0, 3.0, 0.0];
        assert_eq!(factor(&mut matrix, &mut [0; 2], 2), Some(-1.0));
        let mut matrix = [-1.0, 0.0, 5.0, -4.0];
        assert_eq!(factor(&mut matrix, &mut [0; 2], 2), Some(1.0));
    }

    #[test]
    fn largest_returns_nan_if_present() {
        assert_eq!(largest(&[1.0, -3.0, 2.0]), 3.0);
        for index in 0..3 {
            let mut v = [1.0, -3.0, 2.0];
            v[index] = f64::NAN;
            assert!(largest(&v).is_nan(), "{v:?}");
        }
    }

    #[test]
    fn singular_matrix_returns_none() {
        let mut matrix = [1.0, 2.0, 2.0, 4.0];
        assert_eq!(factor(&mut matrix, &mut [0; 2], 2), None);
        assert_eq!(factor(&mut [f64::NAN], &mut [0; 1], 1), None);
    }
}
