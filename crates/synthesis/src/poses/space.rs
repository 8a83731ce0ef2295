//! Double-double homogeneous coordinates `(x, y, w)`: the point `(x, y) / w`, or a direction if w
//! is zero.

use kinematics::{Double, Vec2};

/// Three coordinates, defined up to a common factor.
pub(super) type Triple = [Double; 3];

/// Rows are linearly dependent if their cross product is below this fraction of its possible size.
const DEPENDENCE_TOLERANCE: f64 = 1e-13;

pub(super) fn point(at: Vec2<Double>) -> Triple {
    [at.x, at.y, Double::ONE]
}

pub(super) fn dot(a: Triple, b: Triple) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Triple, b: Triple) -> Triple {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn determinant(rows: [Triple; 3]) -> Double {
    dot(rows[0], cross(rows[1], rows[2]))
}

/// Returns the largest absolute value of the coordinates.
pub(super) fn largest(a: &[Double]) -> f64 {
    a.iter().fold(0.0, |maximum, c| c.hi.abs().max(maximum))
}

/// Scales the largest coordinate to between 1 and 2; `None` if it is zero or not finite.
pub(super) fn leveled(a: Triple) -> Option<Triple> {
    let maximum = largest(&a);
    let scale = 2.0_f64.powi(-exponent(maximum)?);
    let leveled = a.map(|c| c.scaled(scale));
    leveled.iter().all(|c| c.hi.is_finite()).then_some(leveled)
}

/// Returns the exponent of the largest power of two up to a positive number; `None` if this power
/// or its inverse is out of range.
pub(super) fn exponent(size: f64) -> Option<i32> {
    let power = size.log2().floor();
    (size > 0.0 && power.abs() < 1000.0).then_some(power as i32)
}

/// Returns the vector orthogonal to all rows, from the two most independent ones; `None` if all
/// rows are dependent.
pub(super) fn kernel(rows: &[Triple]) -> Option<Triple> {
    let maximum = rows.iter().map(|row| largest(row)).fold(0.0, f64::max);
    let mut best = (DEPENDENCE_TOLERANCE * maximum * maximum, None);
    for (k, a) in rows.iter().enumerate() {
        for b in &rows[..k] {
            let common = cross(*a, *b);
            let size = largest(&common);
            if size > best.0 {
                best = (size, Some(common));
            }
        }
    }
    leveled(best.1?)
}

/// Solves four linear equations by elimination with row exchanges; `None` if they are singular.
pub(super) fn solved(mut rows: [[Double; 4]; 4], mut right: [Double; 4]) -> Option<[Double; 4]> {
    for k in 0..4 {
        let size = |row: &usize| rows[*row][k].hi.abs();
        let pivot = (k..4).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        rows.swap(k, pivot);
        right.swap(k, pivot);
        if rows[k][k].hi == 0.0 {
            return None;
        }
        for row in k + 1..4 {
            let factor = rows[row][k] / rows[k][k];
            let above = rows[k];
            for (entry, above) in rows[row].iter_mut().zip(above).skip(k) {
                *entry = *entry - factor * above;
            }
            right[row] = right[row] - factor * right[k];
        }
    }
    for k in (0..4).rev() {
        for column in k + 1..4 {
            right[k] = right[k] - rows[k][column] * right[column];
        }
        right[k] = right[k] / rows[k][k];
    }
    right.iter().all(|v| v.hi.is_finite()).then_some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernel_is_orthogonal_to_all_rows() {
        let exact = |v: [f64; 3]| v.map(Double::exactly);
        let rows = [[1.0, 2.0, 3.0], [1.0, 2.0, 3.0], [0.5, -1.0, 4.0]].map(exact);
        let kernel = kernel(&rows).unwrap();
        assert!(rows.iter().all(|row| dot(*row, kernel).hi.abs() < 1e-29));
        assert_eq!(super::kernel(&rows[..2]), None);
        assert_eq!(super::kernel(&[exact([f64::NAN; 3]), rows[2]]), None);
    }

    #[test]
    fn solves_four_equations_and_rejects_singular_ones() {
        let entry = |i: usize, j: usize| Double::exactly(1.0 / (i + j + 1) as f64);
        let rows: [[Double; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        let planted = [1.0, -2.0, 3.0, 0.5].map(Double::exactly);
        let right = rows.map(|row| (0..4).fold(Double::ZERO, |s, k| s + row[k] * planted[k]));
        for (found, planted) in solved(rows, right).unwrap().iter().zip(planted) {
            assert!((*found - planted).hi.abs() < 1e-26);
        }
        assert_eq!(solved([rows[0]; 4], right), None);
    }
}
