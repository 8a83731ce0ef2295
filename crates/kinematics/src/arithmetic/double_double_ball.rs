//! Implements ball arithmetic with a midpoint in double-double.

use super::{INFLATION, U};
use crate::{Ball, Constant, Double, Number, Vec2};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Relative rounding error of an operation in double-double (Joldes, Muller and Popescu: below 10
/// u^2), with a margin for the quotient and the root.
const ROUNDING: f64 = 64.0 * U * U;
/// pi / 180, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

/// All numbers within `radius` of `mid`, like [`Ball`](crate::Ball), but with a double-double
/// midpoint, so that rounding hardly widens it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sharp {
    pub(crate) mid: Double,
    pub radius: f64,
}

impl Sharp {
    /// Creates a number from a midpoint and a bound on its error.
    #[inline]
    pub(crate) const fn new(mid: Double, radius: f64) -> Sharp {
        Sharp { mid, radius }
    }

    /// Creates the result of an operation from its value and the propagated radius; adds the
    /// rounding error.
    #[inline]
    fn rounded(mid: Double, carried: f64) -> Sharp {
        Sharp::new(mid, carried + ROUNDING * mid.hi.abs())
    }

    /// Returns the midpoint minus `value`.
    #[inline]
    pub fn way_from(self, value: f64) -> f64 {
        (self.mid.hi - value) + self.mid.lo
    }
}

impl From<Ball> for Sharp {
    #[inline]
    fn from(ball: Ball) -> Sharp {
        Sharp::new(Double::exactly(ball.mid), ball.radius)
    }
}

impl From<Sharp> for Ball {
    #[inline]
    fn from(sharp: Sharp) -> Ball {
        let Sharp { mid, radius } = sharp;
        Ball::new(mid.hi, radius + mid.lo.abs())
    }
}

impl Add for Sharp {
    type Output = Sharp;
    #[inline]
    fn add(self, o: Sharp) -> Sharp {
        Sharp::rounded(self.mid + o.mid, self.radius + o.radius)
    }
}

impl AddAssign for Sharp {
    #[inline]
    fn add_assign(&mut self, o: Sharp) {
        *self = *self + o;
    }
}

impl Sub for Sharp {
    type Output = Sharp;
    #[inline]
    fn sub(self, o: Sharp) -> Sharp {
        self + -o
    }
}

impl Neg for Sharp {
    type Output = Sharp;
    #[inline]
    fn neg(self) -> Sharp {
        Sharp::new(-self.mid, self.radius)
    }
}

impl Mul for Sharp {
    type Output = Sharp;
    #[inline]
    fn mul(self, o: Sharp) -> Sharp {
        let carried = self.mid.hi.abs() * o.radius + self.radius * (o.mid.hi.abs() + o.radius);
        Sharp::rounded(self.mid * o.mid, carried)
    }
}

impl Div for Sharp {
    type Output = Sharp;
    #[inline]
    fn div(self, o: Sharp) -> Sharp {
        let mid = self.mid / o.mid;
        let minimum = o.mid.hi.abs() * (1.0 - U) - o.radius;
        if !(minimum > 0.0) {
            return Sharp::new(mid, f64::INFINITY);
        }
        Sharp::rounded(mid, (self.radius + mid.hi.abs() * o.radius) / minimum)
    }
}

impl Number for Sharp {
    const IS_CHEAP: bool = false;
    const RELATIVE_ROUNDING: f64 = 0.0;

    #[inline]
    fn of(constant: Constant) -> Sharp {
        Sharp::rounded(constant.value(), constant.radius)
    }

    #[inline]
    fn exactly(value: f64) -> Sharp {
        Sharp::new(Double::exactly(value), 0.0)
    }

    #[inline]
    fn nearest(self) -> f64 {
        self.mid.hi
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Sharp {
        Sharp::new(
            self.mid.scaled(power_of_two),
            self.radius * power_of_two.abs(),
        )
    }

    /// Bounds the error by |sqrt(v + d) - sqrt(v)| = |d| / (sqrt(v) + sqrt(v + d)).
    #[inline]
    fn sqrt(self) -> Sharp {
        let mid = self.mid.sqrt();
        let minimum = self.mid.hi * (1.0 - U) - self.radius;
        if !(minimum > 0.0) {
            return Sharp::new(mid, f64::INFINITY);
        }
        Sharp::rounded(mid, self.radius / (mid.hi + minimum.sqrt()))
    }

    #[inline]
    fn abs(self) -> Sharp {
        Sharp::new(self.mid.abs(), self.radius)
    }

    #[inline]
    fn min(self, o: Sharp) -> Sharp {
        Sharp::new(Number::min(self.mid, o.mid), self.radius.max(o.radius))
    }

    #[inline]
    fn exceeds(self, o: Sharp) -> bool {
        (self.mid - o.mid).hi > self.radius + o.radius
    }

    /// Encloses both.
    fn either(self, o: Sharp) -> Sharp {
        let distance = (self.mid - o.mid).hi.abs();
        Sharp::new(self.mid, self.radius.max((distance + o.radius) * INFLATION))
    }

    fn unit(degrees: Sharp) -> Vec2<Sharp> {
        let rest = degrees.mid.lo * RADIAN;
        let off = degrees.radius * RADIAN + rest * rest;
        <Double as Number>::unit(degrees.mid).map(|v| Sharp::rounded(v, off + ROUNDING))
    }

    fn degrees(direction: Vec2<Sharp>) -> Sharp {
        let mid = <Double as Number>::degrees(direction.map(|v| v.mid));
        let length = direction.x.mid.hi.hypot(direction.y.mid.hi) * (1.0 - 4.0 * U);
        let off = direction.x.radius + direction.y.radius;
        let minimum = length - off;
        if !(minimum > 0.0) {
            return Sharp::new(mid, f64::INFINITY);
        }
        Sharp::rounded(mid, (off / minimum).to_degrees() * (1.0 + 8.0 * U))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error of a midpoint is at most the radius.
    #[test]
    fn radius_covers_errors_of_operands() {
        let near = |v: f64, off: f64| (Sharp::new(Double::exactly(v), off), Double::sum(v, off));
        for off in [1e-20, -1e-18, 1e-9] {
            let ((a, ta), (b, tb)) = (near(0.7, off), near(-1.3, -off));
            let (a, b) = (Sharp::new(a.mid, off.abs()), Sharp::new(b.mid, off.abs()));
            let quotient = ta / tb;
            for (sharp, truth) in [
                (a + b, ta + tb),
                (a - b, ta - tb),
                (a * b, ta * tb),
                (a / b, quotient),
                (a.sqrt(), ta.sqrt()),
            ] {
                let miss = (sharp.mid - truth).hi.abs();
                assert!(miss <= sharp.radius, "{miss:e} {sharp:?}");
                assert!(sharp.radius < 4.0 * off.abs() + 1e-30, "{sharp:?}");
            }
        }
    }
}
