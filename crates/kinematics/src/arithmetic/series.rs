//! Implements power series: functions of t by their first Taylor coefficients.
//!
//! In series arithmetic, the solver's formulas give every derivative of a motion at once. At a
//! change point, the equations of the derivatives are singular, but the motion itself is still a
//! series. Roots and quotients of series that begin with a power of t are series, too.

use crate::{Constant, Double, Number, Vec2, angle};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Maximum number of coefficients. Consecutive groups that are singular at one position lose one or
/// two each.
pub(crate) const TERMS: usize = 48;

/// A series c[0] + c[1] t + c[2] t^2 and so on. The first `known` coefficients are correct; the
/// others are zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series {
    pub(crate) c: [Double; TERMS],
    /// The number of correct coefficients; a division by t loses the last one.
    pub(crate) known: usize,
}

impl Default for Series {
    fn default() -> Self {
        Series {
            c: [Double::ZERO; TERMS],
            known: TERMS,
        }
    }
}

impl Series {
    /// Creates a constant.
    pub(crate) fn constant(value: Double) -> Series {
        let mut series = Series::default();
        series.c[0] = value;
        series
    }

    /// Creates value + slope t.
    pub(crate) fn line(value: Double, slope: Double) -> Series {
        let mut line = Series::constant(value);
        line.c[1] = slope;
        line
    }

    /// Creates an angle in degrees that grows by one radian per unit of t.
    pub(crate) fn angle(degrees: Double) -> Series {
        Series::line(degrees, Double::DEGREES)
    }

    /// Returns the series truncated to at most `known` coefficients.
    pub(crate) fn cut(self, known: usize) -> Series {
        Series::by(known.min(self.known), |n, _| self.c[n])
    }

    /// Returns the value of the known terms at t.
    pub(crate) fn value(&self, t: Double) -> Double {
        let known = self.c[..self.known].iter().rev();
        known.fold(Double::ZERO, |sum, &c| sum * t + c)
    }

    /// Returns the series of the known terms about t = `by`.
    pub(crate) fn shifted(mut self, by: Double) -> Series {
        // Horner's scheme, once for each coefficient.
        for first in 0..self.known {
            for n in (first..self.known - 1).rev() {
                let higher = self.c[n + 1] * by;
                self.c[n] += higher;
            }
        }
        self
    }

    /// Returns the series of the coefficients' absolute values. Its sums and products bound those
    /// of the series.
    pub(crate) fn majorant(self) -> Series {
        Series::by(self.known, |n, _| self.c[n].abs())
    }

    /// Returns the index of the first coefficient whose magnitude exceeds `part` times its entry in
    /// `sizes`.
    pub(crate) fn valuation(&self, sizes: &Series, part: f64) -> Option<usize> {
        (0..self.known.min(sizes.known)).find(|&n| self.c[n].hi.abs() > part * sizes.c[n].hi)
    }

    /// Divides by t^n, assuming that the first n coefficients are zero.
    pub(crate) fn lowered(self, n: usize) -> Series {
        let mut c = [Double::ZERO; TERMS];
        c[..TERMS - n].copy_from_slice(&self.c[n..]);
        let known = self.known.saturating_sub(n);
        Series { c, known }
    }

    /// Multiplies by t^n.
    pub(crate) fn raised(self, n: usize) -> Series {
        let mut c = [Double::ZERO; TERMS];
        c[n..].copy_from_slice(&self.c[..TERMS - n]);
        let known = (self.known + n).min(TERMS);
        Series { c, known }
    }

    /// Divides by the polynomial t^N + lower\[N - 1\] t^(N - 1) + ... + lower\[0\], whose lower
    /// coefficients are small. Returns the quotient and the coefficients of the remainder.
    pub(crate) fn divided<const N: usize>(self, lower: [Double; N]) -> (Series, [Double; N]) {
        let mut rest = self.c;
        let mut quotient = Series {
            known: self.known.saturating_sub(N),
            ..Series::default()
        };
        for n in (0..quotient.known).rev() {
            let leading = rest[n + N];
            quotient.c[n] = leading;
            for (k, &of) in lower.iter().enumerate() {
                rest[n + k] += -(leading * of);
            }
        }
        let mut remainder = [Double::ZERO; N];
        remainder.copy_from_slice(&rest[..N]);
        (quotient, remainder)
    }

    /// Multiplies by the polynomial of [`Series::divided`].
    pub(crate) fn multiplied<const N: usize>(self, lower: [Double; N]) -> Series {
        let mut product = self.raised(N);
        for n in 0..self.known {
            for (k, &of) in lower.iter().enumerate() {
                if n + k < TERMS {
                    product.c[n + k] += self.c[n] * of;
                }
            }
        }
        product
    }

    /// Returns the derivative by t.
    pub(crate) fn derivative(self) -> Series {
        let lowered = self.lowered(1);
        Series::by(lowered.known, |n, _| {
            lowered.c[n] * Double::exactly((n + 1) as f64)
        })
    }

    /// Creates the series whose n-th coefficient is `next(n, previous)`.
    fn by(known: usize, mut next: impl FnMut(usize, &[Double]) -> Double) -> Series {
        let mut c = [Double::ZERO; TERMS];
        for n in 0..known {
            c[n] = next(n, &c[..n]);
        }
        Series { c, known }
    }

    /// Returns the unit vector e at the angle a of this series, in radians, from +x. The constant
    /// coefficient counts as 0. Uses e' = i a' e.
    pub(crate) fn turning(self) -> Vec2<Series> {
        let mut e = Vec2::new(Series::exactly(1.0), Series::default());
        (e.x.known, e.y.known) = (self.known, self.known);
        for n in 1..self.known {
            let (mut x, mut y) = (Double::ZERO, Double::ZERO);
            for j in 1..=n {
                let rate = self.c[j] * Double::exactly(j as f64);
                x += -(rate * e.y.c[n - j]);
                y += rate * e.x.c[n - j];
            }
            let n_th = Double::exactly(n as f64);
            (e.x.c[n], e.y.c[n]) = (x / n_th, y / n_th);
        }
        e
    }
}

/// Returns the sum of a[i] b[n - i] for i in `range`.
fn convolved(a: &[Double], b: &[Double], n: usize, range: std::ops::Range<usize>) -> Double {
    range.fold(Double::ZERO, |sum, i| sum + a[i] * b[n - i])
}

/// Returns the number of coefficients up to the last one that is not zero. That of a constant is 1.
fn length(c: &[Double]) -> usize {
    let last = c.iter().rposition(|c| c.hi != 0.0);
    last.map_or(0, |last| last + 1)
}

impl Add for Series {
    type Output = Series;
    fn add(self, o: Series) -> Series {
        let known = self.known.min(o.known);
        Series::by(known, |n, _| self.c[n] + o.c[n])
    }
}

impl AddAssign for Series {
    fn add_assign(&mut self, o: Series) {
        *self = *self + o;
    }
}

impl Neg for Series {
    type Output = Series;
    fn neg(self) -> Series {
        Series::by(self.known, |n, _| -self.c[n])
    }
}

impl Sub for Series {
    type Output = Series;
    fn sub(self, o: Series) -> Series {
        self + -o
    }
}

impl Mul for Series {
    type Output = Series;
    fn mul(self, o: Series) -> Series {
        let known = self.known.min(o.known);
        // Most series of links at rest and of lengths are constants.
        let [a, b] = [length(&self.c), length(&o.c)];
        Series::by(known, |n, _| {
            convolved(&self.c, &o.c, n, (n + 1).saturating_sub(b)..a.min(n + 1))
        })
    }
}

impl Div for Series {
    type Output = Series;
    /// Solves q o = self: q[n] = (self[n] - sum of q[i] o[n - i]) / o[0].
    fn div(self, o: Series) -> Series {
        let known = self.known.min(o.known);
        let length = length(&o.c);
        Series::by(known, |n, q| {
            let first = (n + 1).saturating_sub(length);
            (self.c[n] - convolved(q, &o.c, n, first..n)) / o.c[0]
        })
    }
}

impl Number for Series {
    fn of(constant: Constant) -> Series {
        Series::constant(constant.value())
    }

    fn exactly(value: f64) -> Series {
        Series::constant(Double::exactly(value))
    }

    fn nearest(self) -> f64 {
        self.c[0].hi
    }

    fn scaled(self, power_of_two: f64) -> Series {
        Series::by(self.known, |n, _| self.c[n].scaled(power_of_two))
    }

    /// Solves s s = self: s[n] = (self[n] - sum of s[i] s[n - i]) / 2 s[0].
    fn sqrt(self) -> Series {
        Series::by(self.known, |n, s| match s.first() {
            None => self.c[0].sqrt(),
            Some(&first) => (self.c[n] - convolved(s, s, n, 1..n)) / first.scaled(2.0),
        })
    }

    fn abs(self) -> Series {
        if self.nearest() < 0.0 { -self } else { self }
    }

    fn min(self, other: Series) -> Series {
        if other.nearest() < self.nearest() {
            other
        } else {
            self
        }
    }

    fn exceeds(self, other: Series) -> bool {
        self.c[0].exceeds(other.c[0])
    }

    fn unit(degrees: Series) -> Vec2<Series> {
        let start = <Double as Number>::unit(degrees.c[0]).map(Series::constant);
        start.turned((degrees * Series::constant(Double::RADIAN)).turning())
    }

    /// Integrates the angle's rate, (x y' - y x') / (x^2 + y^2).
    fn degrees(direction: Vec2<Series>) -> Series {
        let Vec2 { x, y } = direction;
        let rate = (x * y.derivative() - y * x.derivative()) / direction.norm2()
            * Series::constant(Double::DEGREES);
        let grown = Series::by(rate.known, |n, _| {
            rate.c[n] / Double::exactly((n + 1) as f64)
        });
        let start = direction.nearest();
        Series::exactly(angle::degrees(start)) + grown.raised(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(found: Series, expected: &[f64]) {
        for (n, (found, expected)) in found.c.iter().zip(expected).enumerate() {
            assert!(
                (found.hi - expected).abs() < 1e-15,
                "t^{n}: {found:?} {expected}"
            );
        }
    }

    #[test]
    fn quotients_and_square_roots_match_textbook_series() {
        let t = Series::line(Double::ZERO, Double::ONE);
        let one = Series::exactly(1.0);
        assert_near(one / (one - t), &[1.0; TERMS]);
        assert_near((one + t).sqrt(), &[1.0, 0.5, -0.125, 0.0625, -0.039_062_5]);
        let root = (one + t).sqrt();
        assert_near(root * root, &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn short_series_are_multiplied_and_divided_like_long_ones() {
        let t = Series::line(Double::ZERO, Double::ONE);
        let line = t + Series::exactly(2.0);
        let long = (Series::exactly(1.0) + t).sqrt();
        assert_near(line * line * line, &[8.0, 12.0, 6.0, 1.0, 0.0, 0.0]);
        assert_near(line * Series::exactly(3.0), &[6.0, 3.0, 0.0]);
        assert_near(line * Series::default(), &[0.0; TERMS]);
        assert_near(
            Series::exactly(1.0) / line,
            &[0.5, -0.25, 0.125, -0.0625, 0.03125],
        );
        assert_near(long * line, &[2.0, 2.0, 0.25, 0.0, -0.015_625]);
        assert_near(line * long / line, &[1.0, 0.5, -0.125, 0.0625]);
    }

    #[test]
    fn lowering_reduces_known_terms() {
        let square = (Series::line(Double::ZERO, Double::ONE)
            * Series::line(Double::exactly(2.0), Double::ONE))
        .lowered(1);
        assert_near(square, &[2.0, 1.0, 0.0]);
        assert_eq!(square.known, TERMS - 1);
        assert_eq!((square + Series::exactly(1.0)).known, TERMS - 1);
        assert_eq!(square.raised(1).known, TERMS);
    }

    #[test]
    fn division_by_a_polynomial_is_undone_by_multiplication() {
        let lower = [1e-4, -3e-2].map(Double::exactly);
        let t = Series::line(Double::ZERO, Double::ONE).cut(12);
        let root = (Series::exactly(1.0) + t).sqrt();
        let (quotient, remainder) = root.multiplied(lower).divided(lower);
        assert_near(quotient, &[1.0, 0.5, -0.125, 0.0625, -0.039_062_5]);
        assert!(remainder.iter().all(|r| r.hi.abs() < 1e-30));
        // t^2 = (t^2 - 0.03 t + 0.0001) + 0.03 t - 0.0001
        let (quotient, remainder) = (t * t).divided(lower);
        assert_near(quotient, &[1.0, 0.0]);
        assert_eq!(remainder.map(|r| r.hi), [-1e-4, 3e-2]);
    }

    #[test]
    fn unit_vector_series_match_sine_and_cosine() {
        let unit = Series::unit(Series::angle(Double::exactly(90.0)));
        assert_near(unit.x, &[0.0, -1.0, 0.0, 1.0 / 6.0]);
        assert_near(unit.y, &[1.0, 0.0, -0.5, 0.0, 1.0 / 24.0]);
        let back = Series::degrees(unit) * Series::constant(Double::RADIAN);
        assert_near(back, &[std::f64::consts::FRAC_PI_2, 1.0, 0.0, 0.0]);
    }
}
