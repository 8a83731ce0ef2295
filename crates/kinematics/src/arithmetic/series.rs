//! Power series: a function of t by its first Taylor coefficients.
//!
//! Run in series, the solver's formulas give every derivative of a motion at once. At a change point,
//! where the equations of the derivatives are singular, the motion itself is still a series: roots and
//! quotients of series that begin with a power of t are series, too.

use crate::{Constant, Double, Number, Vec2, angle};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// How many coefficients are carried at the most: groups in a row that are singular at one place lose one
/// or two each.
pub(crate) const TERMS: usize = 48;

/// c[0] + c[1] t + c[2] t^2 and so on, of which the first `known` are right; the others are zeros.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series {
    pub(crate) c: [Double; TERMS],
    /// What is divided by t loses its last coefficient.
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
    /// A value that stays.
    pub(crate) fn constant(value: Double) -> Series {
        let mut series = Series::default();
        series.c[0] = value;
        series
    }

    /// value + slope t.
    pub(crate) fn line(value: Double, slope: Double) -> Series {
        let mut line = Series::constant(value);
        line.c[1] = slope;
        line
    }

    /// An angle in degrees that grows by a radian with t.
    pub(crate) fn angle(degrees: Double) -> Series {
        Series::line(degrees, Double::DEGREES)
    }

    /// The first few coefficients alone.
    pub(crate) fn cut(self, known: usize) -> Series {
        Series::by(known.min(self.known), |n, _| self.c[n])
    }

    /// With the sizes of the coefficients: sums and products of these bound those of the series.
    pub(crate) fn majorant(self) -> Series {
        Series::by(self.known, |n, _| self.c[n].abs())
    }

    /// The place of the first coefficient that is more than a part of its size.
    pub(crate) fn valuation(&self, sizes: &Series, part: f64) -> Option<usize> {
        (0..self.known.min(sizes.known)).find(|&n| self.c[n].hi.abs() > part * sizes.c[n].hi)
    }

    /// Divided by t^n; the first n coefficients are taken for zeros.
    pub(crate) fn lowered(self, n: usize) -> Series {
        let mut c = [Double::ZERO; TERMS];
        c[..TERMS - n].copy_from_slice(&self.c[n..]);
        let known = self.known.saturating_sub(n);
        Series { c, known }
    }

    /// Times t^n.
    pub(crate) fn raised(self, n: usize) -> Series {
        let mut c = [Double::ZERO; TERMS];
        c[n..].copy_from_slice(&self.c[..TERMS - n]);
        let known = (self.known + n).min(TERMS);
        Series { c, known }
    }

    /// The series whose n-th coefficient is `next(n, those before)`.
    fn by(known: usize, mut next: impl FnMut(usize, &[Double]) -> Double) -> Series {
        let mut c = [Double::ZERO; TERMS];
        for n in 0..known {
            c[n] = next(n, &c[..n]);
        }
        Series { c, known }
    }

    /// The unit vector that turns with the angle of this series, in radians, from +x; its first
    /// coefficient counts as 0. e' = i a' e.
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

/// sum of a[i] b[n - i] for i in `range`.
fn convolved(a: &[Double], b: &[Double], n: usize, range: std::ops::Range<usize>) -> Double {
    range.fold(Double::ZERO, |sum, i| sum + a[i] * b[n - i])
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
        Series::by(known, |n, _| convolved(&self.c, &o.c, n, 0..n + 1))
    }
}

impl Div for Series {
    type Output = Series;
    /// q o = self: q[n] = (self[n] - sum of q[i] o[n - i]) / o[0].
    fn div(self, o: Series) -> Series {
        let known = self.known.min(o.known);
        Series::by(known, |n, q| {
            (self.c[n] - convolved(q, &o.c, n, 0..n)) / o.c[0]
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

    /// s s = self: s[n] = (self[n] - sum of s[i] s[n - i]) / 2 s[0].
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

    /// The angle's rate is (x y' - y x') / (x^2 + y^2).
    fn degrees(direction: Vec2<Series>) -> Series {
        let Vec2 { x, y } = direction;
        let rate = |s: Series| {
            let lowered = s.lowered(1);
            Series::by(lowered.known, |n, _| {
                lowered.c[n] * Double::exactly((n + 1) as f64)
            })
        };
        let rate =
            (x * rate(y) - y * rate(x)) / direction.norm2() * Series::constant(Double::DEGREES);
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
    fn quotients_and_roots_are_those_of_the_textbooks() {
        let t = Series::line(Double::ZERO, Double::ONE);
        let one = Series::exactly(1.0);
        assert_near(one / (one - t), &[1.0; TERMS]);
        assert_near((one + t).sqrt(), &[1.0, 0.5, -0.125, 0.0625, -0.039_062_5]);
        let root = (one + t).sqrt();
        assert_near(root * root, &[1.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn what_is_divided_by_t_knows_less() {
        let square = (Series::line(Double::ZERO, Double::ONE)
            * Series::line(Double::exactly(2.0), Double::ONE))
        .lowered(1);
        assert_near(square, &[2.0, 1.0, 0.0]);
        assert_eq!(square.known, TERMS - 1);
        assert_eq!((square + Series::exactly(1.0)).known, TERMS - 1);
        assert_eq!(square.raised(1).known, TERMS);
    }

    #[test]
    fn an_angle_turns_its_unit_vector() {
        let unit = Series::unit(Series::angle(Double::exactly(90.0)));
        assert_near(unit.x, &[0.0, -1.0, 0.0, 1.0 / 6.0]);
        assert_near(unit.y, &[1.0, 0.0, -0.5, 0.0, 1.0 / 24.0]);
        let back = Series::degrees(unit) * Series::constant(Double::RADIAN);
        assert_near(back, &[std::f64::consts::FRAC_PI_2, 1.0, 0.0, 0.0]);
    }
}
