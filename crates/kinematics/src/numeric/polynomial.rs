//! Finds all real roots of a polynomial of low degree.

use super::roots;

/// Relative tolerance for a double root: the maximum ratio of an extremum's value to the sum of its
/// terms' magnitudes. Rounding may have separated or merged two roots as close as that.
const DOUBLE_ROOT_TOLERANCE: f64 = 1e-13;

/// Returns the real roots of c0 + c1 x + c2 x^2 + ..., in ascending order. A double root is
/// returned once. Returns an empty list if all coefficients are 0 or one of them is not finite.
///
/// A polynomial has at most one root between two neighbouring extrema and beyond the outermost; its
/// extrema are roots of its derivative. All roots are within 1 + max |ck / cn| (Cauchy).
pub fn polynomial_roots(coefficients: &[f64]) -> Vec<f64> {
    let Some(degree) = coefficients.iter().rposition(|c| *c != 0.0) else {
        return Vec::new();
    };
    let terms = &coefficients[..=degree];
    let bound = 1.0
        + terms[..degree]
            .iter()
            .fold(0.0_f64, |maximum, c| maximum.max((c / terms[degree]).abs()));
    if degree == 0 || !bound.is_finite() {
        return Vec::new();
    }
    let slope: Vec<f64> = (1..=degree).map(|k| k as f64 * terms[k]).collect();
    let turns = polynomial_roots(&slope);
    let ends = [-bound]
        .into_iter()
        .chain(turns.iter().copied())
        .chain([bound]);
    let mut found = roots(ends, f64::EPSILON, |x| Some(polynomial(terms, x)));
    found.extend(turns.iter().copied().filter(|x| is_touched(terms, *x)));
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}

/// Returns the value by Horner's rule.
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

fn is_touched(terms: &[f64], x: f64) -> bool {
    let sizes: Vec<f64> = terms.iter().map(|c| c.abs()).collect();
    polynomial(terms, x).abs() <= DOUBLE_ROOT_TOLERANCE * polynomial(&sizes, x.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::SeededRng;

    /// Returns the polynomial with these roots.
    fn with(roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![1.0], |terms, root| {
            let mut product = vec![0.0; terms.len() + 1];
            for (k, c) in terms.iter().enumerate() {
                product[k + 1] += c;
                product[k] -= root * c;
            }
            product
        })
    }

    #[test]
    fn planted_roots_are_found_and_no_others() {
        let mut rng = SeededRng::new(1);
        for round in 0..300 {
            let mut planted: Vec<f64> = (0..=round % 6).map(|_| 3.0 * rng.even()).collect();
            planted.sort_by(f64::total_cmp);
            let near = planted.windows(2).any(|two| two[1] - two[0] < 0.05);
            let found = polynomial_roots(&with(&planted));
            if near {
                continue;
            }
            assert_eq!(found.len(), planted.len(), "{planted:?} {found:?}");
            for (a, b) in planted.iter().zip(&found) {
                assert!((a - b).abs() < 1e-8, "{planted:?} {found:?}");
            }
        }
    }

    #[test]
    fn double_root_and_missing_roots() {
        let found = polynomial_roots(&with(&[0.5, 0.5, -2.0]));
        assert!(
            found
                .iter()
                .all(|x| (x - 0.5).abs() < 1e-7 || (x + 2.0).abs() < 1e-12),
            "{found:?}"
        );
        assert!(found.len() >= 2);
        assert_eq!(polynomial_roots(&[1.0, 0.0, 1.0]), Vec::<f64>::new());
        assert_eq!(polynomial_roots(&[0.0, 0.0]), Vec::<f64>::new());
        assert_eq!(polynomial_roots(&[4.0]), Vec::<f64>::new());
        assert_eq!(polynomial_roots(&[f64::NAN, 1.0]), Vec::<f64>::new());
        // Leading zero coefficients do not add roots.
        assert_eq!(polynomial_roots(&[-2.0, 1.0, 0.0, 0.0]), vec![2.0]);
    }

    #[test]
    fn tolerance_of_double_roots_is_relative_to_the_terms() {
        // The terms at 1 have the sum 4.
        assert_eq!(polynomial_roots(&[1.0 + 2e-13, -2.0, 1.0]), vec![1.0]);
        assert_eq!(polynomial_roots(&[1.0 + 2e-13, 2.0, 1.0]), vec![-1.0]);
        assert_eq!(
            polynomial_roots(&[1.0 + 6e-13, -2.0, 1.0]),
            Vec::<f64>::new()
        );
    }

    #[test]
    fn roots_far_from_zero_and_coefficients_without_roots() {
        assert_eq!(polynomial_roots(&[-1.0, 1.0 / 1024.0]), vec![1024.0]);
        for k in 0..3 {
            for wrong in [f64::INFINITY, f64::NAN] {
                let mut terms = [-2.0, 1.0, 3.0];
                terms[k] = wrong;
                assert_eq!(polynomial_roots(&terms), Vec::<f64>::new(), "{terms:?}");
            }
        }
    }
}
