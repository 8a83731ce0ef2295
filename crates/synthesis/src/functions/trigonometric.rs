//! Finds all zeros of a trigonometric polynomial.

use kinematics::numeric::polynomial_roots;
use nalgebra::Complex;
use std::f64::consts::{PI, TAU};

/// Maximum number of Newton steps after the roots of the polynomial; two suffice.
const MAX_POLISH_STEPS: usize = 4;

/// Returns the zeros of a trigonometric polynomial of a degree, in radians. Returns `None` if it is
/// zero everywhere or not finite.
///
/// Its values at 2 n + 1 angles give its Fourier coefficients. With t = tan((a - a0) / 2) it is a
/// polynomial in t of degree 2 n. The angle a0 is opposite to the maximum of its absolute value, so
/// that no root lies at t = infinity.
pub(super) fn zeros(degree: usize, f: impl Fn(f64) -> f64) -> Option<Vec<f64>> {
    let count = 2 * degree + 1;
    let step = TAU / (2 * count) as f64;
    let looks = (0..2 * count).map(|k| (k as f64 * step, f(k as f64 * step)));
    let (far, size) = looks.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    if !(size.abs() > 0.0 && size.is_finite()) {
        return None;
    }
    let middle = far + PI;
    let fourier = |k: usize| {
        let each = (0..count).map(|j| {
            let angle = TAU * j as f64 / count as f64;
            Complex::from_polar(f(middle + angle) / count as f64, -angle * k as f64)
        });
        each.sum::<Complex<f64>>()
    };
    // e^(ika) (1 + t^2)^n = (1 + i t)^(n + k) (1 - i t)^(n - k)
    let mut terms = vec![0.0; count];
    for k in 0..=degree {
        let weight = fourier(k) * if k == 0 { 1.0 } else { 2.0 };
        let powers = (0..degree + k).map(|_| 1.0);
        let factors = powers.chain((0..degree - k).map(|_| -1.0));
        let product = factors.fold(vec![Complex::new(1.0, 0.0)], |product, sign| {
            let mut next = product.clone();
            next.push(Complex::ZERO);
            for (j, c) in product.iter().enumerate() {
                next[j + 1] += c * Complex::new(0.0, sign);
            }
            next
        });
        for (term, c) in terms.iter_mut().zip(product) {
            *term += (weight * c).re;
        }
    }
    let roots = polynomial_roots(&terms);
    Some(
        roots
            .into_iter()
            .map(|t| polished(middle + 2.0 * t.atan(), &f))
            .collect(),
    )
}

/// Improves a zero by Newton steps with a difference quotient, while the absolute value decreases.
fn polished(mut at: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let mut value = f(at);
    for _ in 0..MAX_POLISH_STEPS {
        let width = 1e-6;
        let slope = (f(at + width) - f(at - width)) / (2.0 * width);
        let next = at - value / slope;
        let there = f(next);
        if !(there.abs() < value.abs() && (next - at).abs() < width) {
            break;
        }
        (at, value) = (next, there);
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use kinematics::numeric::SeededRng;

    #[test]
    fn planted_zeros_are_found_and_no_others() {
        let mut rng = SeededRng::new(5);
        for round in 0..200 {
            let degree = 1 + round % 3;
            let planted: Vec<f64> = (0..2 * degree).map(|_| PI * rng.even()).collect();
            let f = |a: f64| {
                planted
                    .iter()
                    .map(|z| (0.5 * (a - z)).sin())
                    .product::<f64>()
            };
            let distance = |a: f64, b: f64| {
                let d = (a - b) / TAU;
                (d - d.round()).abs() * TAU
            };
            let is_near = |i: usize| {
                (0..i)
                    .map(|j| distance(planted[i], planted[j]))
                    .any(|d| d < 0.05)
            };
            if (0..planted.len()).any(is_near) {
                continue;
            }
            let found = zeros(degree, f).unwrap();
            assert_eq!(found.len(), planted.len());
            for z in &planted {
                assert!(
                    found.iter().any(|a| distance(*a, *z) < 1e-10),
                    "{z} {found:?}"
                );
            }
        }
        assert_eq!(zeros(2, |_| 0.0), None);
        assert_eq!(zeros(2, |a| 2.0 + a.cos()), Some(Vec::new()));
    }
}
