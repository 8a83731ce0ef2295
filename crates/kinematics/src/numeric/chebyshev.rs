//! A smooth function on an interval, as a sum of Chebyshev polynomials.
//!
//! On its piece a function f is c0 T0(t) + c1 T1(t) + ... with t from -1 to 1, through its values at the
//! zeros of T24. These never include the ends of the piece, where a load may jump. How small the last
//! terms are tells how well the sum stands for the function (Trefethen 2013, Approximation Theory and
//! Approximation Practice, chapters 3 and 8); integral, slope and places of a sum follow from its terms,
//! and cost no state of the mechanism.

use super::roots;
use std::f64::consts::PI;

/// Terms of a sum, and places at which a piece is solved.
pub const TERMS: usize = 24;
/// The last terms, by which the rest is judged: of an even function every other one is 0.
const LAST: usize = 4;
/// A sum is searched for the places where it turns between so many neighbours.
const LOOKS: u32 = 64;
/// The last terms are rounding where they are not this much smaller than those a quarter of the way on.
const FLAT: f64 = 0.5;

/// The places of a piece, and what makes terms of the values there.
pub struct Basis {
    /// t of every place.
    pub places: [f64; TERMS],
    /// cos of a multiple of pi / 48.
    cosines: [f64; 4 * TERMS],
}

/// A sum of Chebyshev polynomials, by the coefficients of T0, T1, ...
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

    /// The sum through these values at the places.
    pub fn through(&self, values: &[f64; TERMS]) -> ChebyshevSum {
        ChebyshevSum(std::array::from_fn(|k| {
            let cosine = |j: usize| self.cosines[(k * (2 * j + 1)) % (4 * TERMS)];
            let terms = values.iter().enumerate().map(|(j, v)| v * cosine(j));
            let whole = if k == 0 { 1.0 } else { 2.0 };
            whole / TERMS as f64 * terms.sum::<f64>()
        }))
    }
}

impl ChebyshevSum {
    /// The value at t, by Clenshaw's recurrence.
    pub fn at(&self, t: f64) -> f64 {
        let (mut b1, mut b2) = (0.0, 0.0);
        for &c in self.0[1..].iter().rev() {
            (b1, b2) = (c + 2.0 * t * b1 - b2, b1);
        }
        self.0[0] + t * b1 - b2
    }

    /// The derivative by t.
    pub fn slope(&self) -> ChebyshevSum {
        let mut slope = [0.0; TERMS];
        for k in (1..TERMS).rev() {
            let beyond = if k + 1 < TERMS { slope[k + 1] } else { 0.0 };
            slope[k - 1] = beyond + 2.0 * k as f64 * self.0[k];
        }
        slope[0] *= 0.5;
        ChebyshevSum(slope)
    }

    /// The integral by t from -1; without its highest term, which is a 48th of the last one here.
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

    /// The integral of the product with another sum, by t from -1 to 1.
    pub fn product(&self, other: &ChebyshevSum) -> f64 {
        // Tm Tn is half of T(m + n) + T(m - n), and only even ones have an integral: 2 / (1 - k^2).
        let even = |k: usize| 2.0 / (1.0 - (k * k) as f64);
        let mut whole = 0.0;
        for (m, a) in self.0.iter().enumerate() {
            for n in (m % 2..TERMS).step_by(2) {
                whole += a * other.0[n] * 0.5 * (even(m + n) + even(m.abs_diff(n)));
            }
        }
        whole
    }

    /// The sum less a number.
    pub fn less(mut self, offset: f64) -> ChebyshevSum {
        self.0[0] -= offset;
        self
    }

    /// The largest of the terms, by which values are measured.
    pub fn size(&self) -> f64 {
        largest(&self.0)
    }

    /// The largest of the last terms: what the sum is off by is of this size.
    pub fn tail(&self) -> f64 {
        largest(&self.0[TERMS - LAST..])
    }

    /// The largest of the terms after a third of them. Those of a smooth function fall as a geometric series
    /// does, so that the last ones are smaller by the cube; as told by [`ChebyshevSum::tail`] they end in rounding.
    pub(crate) fn third(&self) -> f64 {
        let third = TERMS / 3;
        largest(&self.0[third..third + LAST])
    }

    /// Whether the terms no longer become smaller: what is left is rounding, or waves much shorter than
    /// the piece.
    pub fn is_flat(&self) -> bool {
        let early = TERMS / 4;
        self.tail() >= FLAT * largest(&self.0[early..early + LAST])
    }

    /// Where the sum turns, from the lower to the upper end.
    pub fn turns(&self) -> Vec<f64> {
        let slope = self.slope();
        crossings(|t| slope.at(t))
    }

    /// Where the sum changes its sign, from the lower to the upper end; `turns` are its own: between them
    /// it goes one way, so that no zero is missed, not even two close together.
    pub fn zeros(&self, turns: &[f64]) -> Vec<f64> {
        let ends = [-1.0].into_iter().chain(turns.iter().copied()).chain([1.0]);
        roots(ends, f64::EPSILON, |t| Some(self.at(t)))
    }
}

fn largest(terms: &[f64]) -> f64 {
    terms.iter().fold(0.0, |most, c| most.max(c.abs()))
}

/// Where a function of the sums changes its sign between -1 and 1.
pub fn crossings(f: impl Fn(f64) -> f64) -> Vec<f64> {
    let place = |k: u32| -(PI * f64::from(k) / f64::from(LOOKS)).cos();
    roots((0..=LOOKS).map(place), f64::EPSILON, |t| Some(f(t)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn through(f: impl Fn(f64) -> f64) -> ChebyshevSum {
        let basis = Basis::new();
        basis.through(&basis.places.map(f))
    }

    #[test]
    fn a_smooth_function_is_met_everywhere_with_slope_and_integral() {
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
    fn the_integral_of_a_square_is_exact() {
        // (t^3 - 2)(5 t^2 + t), from -1 to 1: the even part is t^4 - 10 t^2.
        let (a, b) = (through(|t| t.powi(3) - 2.0), through(|t| 5.0 * t * t + t));
        assert!((a.product(&b) - (2.0 / 5.0 - 20.0 / 3.0)).abs() < 1e-14);
    }

    #[test]
    fn zeros_are_found_even_where_two_are_close() {
        // (t - 0.3)^2 - 1e-8: twice 0 within 2e-4.
        let sum = through(|t| (t - 0.3).powi(2) - 1e-8);
        let turns = sum.turns();
        let zeros = sum.zeros(&turns);
        assert_eq!((turns.len(), zeros.len()), (1, 2));
        assert!((turns[0] - 0.3).abs() < 1e-12);
        assert!((zeros[0] - 0.2999).abs() < 1e-10 && (zeros[1] - 0.3001).abs() < 1e-10);
    }

    #[test]
    fn what_is_not_met_shows_in_the_last_terms() {
        assert!(through(|t| (t - 0.1).abs()).tail() > 1e-4);
        let noise = through(|t| (t * 1e9).sin() * 1e-16);
        assert!(noise.is_flat());
    }
}
