//! Approximates a smooth function on an interval by a sum of Chebyshev polynomials.
//!
//! On its interval a function f is c0 T0(t) + c1 T1(t) + ... with t from -1 to 1, interpolated at
//! the zeros of T24. These never include the ends of the interval, where a load may jump. The size
//! of the last terms indicates how well the sum approximates the function (Trefethen 2013,
//! Approximation Theory and Approximation Practice, chapters 3 and 8). The integral, slope and
//! extrema of a sum follow from its terms, without solving further states of the mechanism.

use super::roots;
use std::f64::consts::PI;

/// Number of terms of a sum, and of nodes at which an interval is solved.
pub const TERMS: usize = 24;
/// Number of last terms that estimate the truncation error: in an even function, every second term
/// is 0.
const LAST: usize = 4;
/// Number of subintervals in which a sign change is searched.
const SUBINTERVALS: u32 = 64;
/// The last terms count as rounding errors unless they are smaller than the terms at a quarter by
/// this factor.
const FLAT: f64 = 0.5;

/// The nodes of an interval, and the cosines that turn values there into terms.
pub struct Basis {
    /// The value of t at every node.
    pub places: [f64; TERMS],
    /// The cosines of the multiples of pi / 48.
    cosines: [f64; 4 * TERMS],
}

/// A sum of Chebyshev polynomials, given by the coefficients of T0, T1, ...
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChebyshevSum(pub [f64; TERMS]);

impl Default for Basis {
    fn default() -> Basis {
        Basis::new()
    }
}

impl Basis {
    pub fn new() -> Basis {
        let half = 2.0 * TERMS as f64;
        let cosines = std::array::from_fn(|m| (PI * m as f64 / half).cos());
        Basis {
            places: std::array::from_fn(|j| (PI * (2 * j + 1) as f64 / half).cos()),
            cosines,
        }
    }

    /// Returns the sum that interpolates these values at the nodes.
    pub fn through(&self, values: &[f64; TERMS]) -> ChebyshevSum {
        ChebyshevSum(std::array::from_fn(|k| {
            let cosine = |j: usize| self.cosines[(k * (2 * j + 1)) % (4 * TERMS)];
            let terms = values.iter().enumerate().map(|(j, v)| v * cosine(j));
            let complete = if k == 0 { 1.0 } else { 2.0 };
            complete / TERMS as f64 * terms.sum::<f64>()
        }))
    }
}

impl ChebyshevSum {
    /// Returns the value at t, by Clenshaw's recurrence.
    pub fn at(&self, t: f64) -> f64 {
        let (mut b1, mut b2) = (0.0, 0.0);
        for &c in self.0[1..].iter().rev() {
            (b1, b2) = (c + 2.0 * t * b1 - b2, b1);
        }
        self.0[0] + t * b1 - b2
    }

    /// Returns the derivative by t.
    pub fn slope(&self) -> ChebyshevSum {
        let mut slope = [0.0; TERMS];
        for k in (1..TERMS).rev() {
            let beyond = if k + 1 < TERMS { slope[k + 1] } else { 0.0 };
            slope[k - 1] = beyond + 2.0 * k as f64 * self.0[k];
        }
        slope[0] *= 0.5;
        ChebyshevSum(slope)
    }

    /// Returns the integral by t from -1. It omits the highest term, which is 1/48 of the last term
    /// here.
    pub fn integral(&self) -> ChebyshevSum {
        let c = &self.0;
        let mut integral: [f64; TERMS] = std::array::from_fn(|k| {
            let beyond = if k + 1 < TERMS { c[k + 1] } else { 0.0 };
            match k {
                0 => 0.0,
                1 => c[0] - 0.5 * beyond,
                _ => (c[k - 1] - beyond) / (2.0 * k as f64),
            }
        });
        let signs = [-1.0, 1.0].into_iter().cycle();
        integral[0] = -integral[1..]
            .iter()
            .zip(signs)
            .map(|(c, s)| c * s)
            .sum::<f64>();
        ChebyshevSum(integral)
    }

    /// Returns the integral of the product with another sum, by t from -1 to 1.
    pub fn product(&self, other: &ChebyshevSum) -> f64 {
        // Tm Tn = (T(m + n) + T(m - n)) / 2. Only even ones have a nonzero integral: 2 / (1 - k^2).
        let even = |k: usize| 2.0 / (1.0 - (k * k) as f64);
        let mut complete = 0.0;
        for (m, a) in self.0.iter().enumerate() {
            for n in (m % 2..TERMS).step_by(2) {
                complete += a * other.0[n] * 0.5 * (even(m + n) + even(m.abs_diff(n)));
            }
        }
        complete
    }

    /// Subtracts a constant.
    pub fn less(mut self, offset: f64) -> ChebyshevSum {
        self.0[0] -= offset;
        self
    }

    /// Returns the maximum magnitude of all terms, as a measure of the function's size.
    pub fn size(&self) -> f64 {
        largest(&self.0)
    }

    /// Returns the maximum magnitude of the last terms, which estimates the error of the sum.
    pub fn tail(&self) -> f64 {
        largest(&self.0[TERMS - LAST..])
    }

    /// Returns the maximum magnitude of the terms following the first third.
    ///
    /// The terms of a smooth function fall geometrically, so that the last ones are about the cube
    /// of this. They cannot be measured directly by [`ChebyshevSum::tail`], because they end in
    /// rounding errors.
    pub(crate) fn third(&self) -> f64 {
        let third = TERMS / 3;
        largest(&self.0[third..third + LAST])
    }

    /// Returns `true` if the terms no longer decrease: the rest is rounding errors or waves much
    /// shorter than the interval.
    pub fn is_flat(&self) -> bool {
        let early = TERMS / 4;
        self.tail() >= FLAT * largest(&self.0[early..early + LAST])
    }

    /// Returns the extrema of the sum, in ascending order.
    pub fn turns(&self) -> Vec<f64> {
        let slope = self.slope();
        crossings(|t| slope.at(t))
    }

    /// Returns the zeros at which the sum changes its sign, in ascending order. `turns` are the
    /// sum's own extrema: it is monotonic between them, so that even two close zeros are both
    /// found.
    pub fn zeros(&self, turns: &[f64]) -> Vec<f64> {
        let ends = [-1.0].into_iter().chain(turns.iter().copied()).chain([1.0]);
        roots(ends, f64::EPSILON, |t| Some(self.at(t)))
    }
}

fn largest(terms: &[f64]) -> f64 {
    terms.iter().fold(0.0, |maximum, c| maximum.max(c.abs()))
}

/// Returns the points between -1 and 1 where a function of the sums changes its sign.
pub fn crossings(f: impl Fn(f64) -> f64) -> Vec<f64> {
    let place = |k: u32| -(PI * f64::from(k) / f64::from(SUBINTERVALS)).cos();
    roots((0..=SUBINTERVALS).map(place), f64::EPSILON, |t| Some(f(t)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn through(f: impl Fn(f64) -> f64) -> ChebyshevSum {
        let basis = Basis::new();
        basis.through(&basis.places.map(f))
    }

    #[test]
    fn smooth_function_slope_and_integral_are_accurate() {
        let sum = through(|t| (2.0 * t).exp() * (3.0 * t).sin());
        let primitive =
            |t: f64| (2.0 * t).exp() * (2.0 * (3.0 * t).sin() - 3.0 * (3.0 * t).cos()) / 13.0;
        let (slope, integral) = (sum.slope(), sum.integral());
        for k in -20..=20 {
            let t = f64::from(k) / 20.0;
            let e = (2.0 * t).exp();
            let exact = e * (3.0 * t).sin();
            assert!((sum.at(t) - exact).abs() < 1e-13, "{t}");
            let exact = e * (2.0 * (3.0 * t).sin() + 3.0 * (3.0 * t).cos());
            assert!((slope.at(t) - exact).abs() < 1e-10, "{t}");
            let exact = primitive(t) - primitive(-1.0);
            assert!((integral.at(t) - exact).abs() < 1e-13, "{t}");
        }
        assert!(sum.tail() < 1e-13 && !sum.is_flat());
    }

    #[test]
    fn integral_of_product_is_exact() {
        // (t^3 - 2)(5 t^2 + t), from -1 to 1: the even part is t^4 - 10 t^2.
        let (a, b) = (through(|t| t.powi(3) - 2.0), through(|t| 5.0 * t * t + t));
        assert!((a.product(&b) - (2.0 / 5.0 - 20.0 / 3.0)).abs() < 1e-14);
    }

    #[test]
    fn close_zeros_are_found() {
        // (t - 0.3)^2 - 1e-8: two zeros within 2e-4.
        let sum = through(|t| (t - 0.3).powi(2) - 1e-8);
        let turns = sum.turns();
        let zeros = sum.zeros(&turns);
        assert_eq!((turns.len(), zeros.len()), (1, 2));
        assert!((turns[0] - 0.3).abs() < 1e-12);
        assert!((zeros[0] - 0.2999).abs() < 1e-10 && (zeros[1] - 0.3001).abs() < 1e-10);
    }

    #[test]
    fn poor_fit_has_large_tail_and_noise_is_flat() {
        assert!(through(|t| (t - 0.1).abs()).tail() > 1e-4);
        let noise = through(|t| (t * 1e9).sin() * 1e-16);
        assert!(noise.is_flat());
    }

    /// Returns the sum with these terms, by their numbers; all others are 0.
    fn terms(some: &[(usize, f64)]) -> ChebyshevSum {
        let mut sum = ChebyshevSum([0.0; TERMS]);
        for &(k, term) in some {
            sum.0[k] = term;
        }
        sum
    }

    #[test]
    fn tail_third_and_flatness_read_their_terms() {
        assert_eq!(terms(&[(19, 9.0), (20, -2.0), (23, 1.0)]).tail(), 2.0);
        let third = terms(&[(7, 9.0), (8, 1.0), (11, -3.0), (12, 9.0)]).third();
        assert_eq!(third, 3.0);
        // Half of the terms from the sixth to the ninth; the fifth and the tenth do not count.
        let of = |last| terms(&[(5, 9.0), (6, 1.0), (9, -2.0), (10, 9.0), (23, last)]);
        assert!(of(1.0).is_flat() && !of(0.99).is_flat());
        assert!(terms(&[]).is_flat());
    }

    #[test]
    fn zeros_are_ascending_and_inside_the_interval() {
        // The outermost subinterval is about 1e-3 wide.
        let sum = through(|t| (t - 0.9995) * (t + 0.9995) * (t - 0.1));
        let found = crossings(|t| sum.at(t));
        assert_eq!(found.len(), 3);
        for (found, zero) in found.iter().zip([-0.9995, 0.1, 0.9995]) {
            assert!((found - zero).abs() < 1e-13, "{found}");
        }
        for zero in [-1.5, 1.5] {
            let outside = through(|t| t - zero);
            assert!(outside.zeros(&outside.turns()).is_empty());
        }
    }

    #[test]
    fn last_term_is_integrated() {
        // The integral of T23 is T24 / 48 - T22 / 44; the first part is omitted.
        let integral = terms(&[(23, 1.0)]).integral();
        assert_eq!((integral.0[22], integral.at(-1.0)), (-1.0 / 44.0, 0.0));
    }

    #[test]
    fn offset_is_subtracted() {
        let sum = through(|t| t * t + 3.0).less(2.0);
        assert!((sum.at(0.5) - 1.25).abs() < 1e-14 && (sum.size() - 1.5).abs() < 1e-14);
    }
}
