//! Numbers with a bound on their error.

use super::double::{two_product, two_sum};
use super::{TWICE, U};
use crate::{Constant, Number, Vec2, angle};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// The bits that hold a double's power of two.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
/// Radii are sums of positive terms, each rounded: this part more covers some ten million of these
/// roundings, and what underflows.
pub(crate) const INFLATION: f64 = 1.0 + 1e-9;
const TINY: f64 = 1e-290;
/// Squares above this keep all their digits, with what they lose.
const LEAST_SQUARE: f64 = 1e-280;
/// pi / 180, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

/// All numbers within `radius` of `mid`: what is computed, and how far the truth can be from it.
///
/// The operations are those of running error analysis (Higham, Accuracy and Stability of Numerical
/// Algorithms, 2nd ed., chapter 3): the radius of a result covers what the operands' radii do to it
/// and the rounding of the operation itself. Where nothing can be said, the radius is infinite or
/// not a number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// The middle.
    pub mid: f64,
    /// How far the truth can be from it.
    pub radius: f64,
}

impl Ball {
    /// A ball.
    #[inline]
    #[must_use]
    pub const fn new(mid: f64, radius: f64) -> Ball {
        Ball { mid, radius }
    }

    /// How far the truth can be from `value`; `None` where nothing can be said.
    #[must_use]
    pub fn bound(self, value: f64) -> Option<f64> {
        let bound = (value - self.mid).abs() + self.radius;
        if bound == 0.0 {
            return Some(0.0);
        }
        let bound = bound * INFLATION + TINY;
        (bound < f64::MAX).then_some(bound)
    }

    /// A middle that is moved by what it left out, which two roundings and a product have spoilt.
    #[inline]
    fn shifted(mid: f64, shift: f64, radius: f64) -> Ball {
        let (mid, lost) = two_sum(mid, shift);
        Ball::new(mid, radius + lost.abs() + 4.0 * U * shift.abs())
    }

    /// Widened by `more` on both sides.
    #[inline]
    #[must_use]
    pub fn widened(self, more: f64) -> Ball {
        Ball::new(self.mid, self.radius + more)
    }

    /// The largest size in the ball.
    #[inline]
    #[must_use]
    pub fn largest(self) -> f64 {
        self.mid.abs() + self.radius
    }

    /// The smallest size in the ball, 0 where it holds zero.
    #[inline]
    #[must_use]
    pub fn smallest(self) -> f64 {
        (self.mid.abs() - self.radius).max(0.0)
    }
}

/// The most by which an operation whose result was rounded to `value` can be off.
#[inline]
pub(crate) fn half_ulp(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & EXPONENT) * U
}

impl Add for Ball {
    type Output = Ball;
    #[inline]
    fn add(self, o: Ball) -> Ball {
        // What the sum itself rounds is known, and often nothing.
        let (mid, lost) = two_sum(self.mid, o.mid);
        Ball::new(mid, self.radius + o.radius + lost.abs())
    }
}

impl AddAssign for Ball {
    #[inline]
    fn add_assign(&mut self, o: Ball) {
        *self = *self + o;
    }
}

impl Sub for Ball {
    type Output = Ball;
    #[inline]
    fn sub(self, o: Ball) -> Ball {
        self + -o
    }
}

impl Neg for Ball {
    type Output = Ball;
    #[inline]
    fn neg(self) -> Ball {
        Ball::new(-self.mid, self.radius)
    }
}

impl Mul for Ball {
    type Output = Ball;
    #[inline]
    fn mul(self, o: Ball) -> Ball {
        // As of a sum.
        let (mid, lost) = two_product(self.mid, o.mid);
        let carried = self.mid.abs() * o.radius + self.radius * (o.mid.abs() + o.radius);
        Ball::new(mid, carried + lost.abs())
    }
}

impl Div for Ball {
    type Output = Ball;
    #[inline]
    fn div(self, o: Ball) -> Ball {
        let mid = self.mid / o.mid;
        let least = o.mid.abs() - o.radius;
        if !(least > 0.0) {
            return Ball::new(mid, f64::INFINITY);
        }
        let carried = (self.radius + mid.abs() * o.radius) / least;
        Ball::new(mid, carried + half_ulp(mid))
    }
}

impl Number for Ball {
    const IS_CHEAP: bool = false;

    #[inline]
    fn of(constant: Constant) -> Ball {
        Ball::new(constant.hi, constant.off())
    }

    #[inline]
    fn exactly(value: f64) -> Ball {
        Ball::new(value, 0.0)
    }

    #[inline]
    fn nearest(self) -> f64 {
        self.mid
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Ball {
        Ball::new(self.mid * power_of_two, self.radius * power_of_two.abs())
    }

    /// What the constant's double leaves out has a sign, and so has what the product rounds.
    #[inline]
    fn times(self, constant: Constant) -> Ball {
        let Constant { hi, lo, radius, .. } = constant;
        let (mid, lost) = two_product(self.mid, hi);
        let radius = radius + TWICE * hi.abs();
        let carried = self.radius * (hi.abs() + lo.abs() + radius) + self.mid.abs() * radius;
        Ball::shifted(mid, lost + self.mid * lo, carried)
    }

    /// As of a product.
    #[inline]
    fn plus(self, constant: Constant) -> Ball {
        let Constant { hi, lo, radius, .. } = constant;
        let (mid, lost) = two_sum(self.mid, hi);
        Ball::shifted(mid, lost + lo, self.radius + radius + TWICE * hi.abs())
    }

    /// |sqrt(v + d) - sqrt(v)| = |d| / (sqrt(v) + sqrt(v + d)).
    #[inline]
    fn sqrt(self) -> Ball {
        let mid = self.mid.sqrt();
        let least = self.mid - self.radius;
        if !(least > 0.0) {
            return Ball::new(mid, f64::INFINITY);
        }
        Ball::new(mid, self.radius / (mid + least.sqrt()) + half_ulp(mid))
    }

    #[inline]
    fn abs(self) -> Ball {
        Ball::new(self.mid.abs(), self.radius)
    }

    #[inline]
    fn min(self, other: Ball) -> Ball {
        Ball::new(self.mid.min(other.mid), self.radius.max(other.radius))
    }

    #[inline]
    fn exceeds(self, other: Ball) -> bool {
        self.mid - self.radius > other.mid + other.radius
    }

    /// Around both.
    fn either(self, other: Ball) -> Ball {
        let apart = (self.mid - other.mid).abs();
        Ball::new(
            self.mid,
            self.radius.max((apart + other.radius) * INFLATION),
        )
    }

    /// Each component within 0.75 ulp (0.6 was measured), exact where the other is zero, and turned by as much as the angle
    /// can be off.
    #[inline]
    fn unit(degrees: Ball) -> Vec2<Ball> {
        let Vec2 { x, y } = angle::unit(degrees.mid);
        let ulps = if x == 0.0 || y == 0.0 { 0.0 } else { 1.5 };
        let off = degrees.radius * RADIAN;
        let ball =
            |v: f64, across: f64| Ball::new(v, ulps * half_ulp(v) + off * (across.abs() + off));
        Vec2::new(ball(x, y), ball(y, x))
    }

    /// Along an axis the length is the component, exactly. A vector that may be 0 is no further from another in
    /// length than the two are apart: | |a| - |b| | <= |a - b|.
    #[inline]
    fn norm(vector: Vec2<Ball>) -> Ball {
        let Vec2 { x, y } = vector;
        if y == Ball::default() {
            x.abs()
        } else if x == Ball::default() {
            y.abs()
        } else {
            let square = vector.norm2();
            let root = square.sqrt();
            // What a square loses that doubles hardly hold is in no radius.
            if root.radius.is_finite() && square.mid > LEAST_SQUARE {
                return root;
            }
            let mid = x.mid.hypot(y.mid);
            // The platform's hypot is right to an ulp.
            let apart = x.radius.hypot(y.radius) * INFLATION;
            Ball::new(mid, apart + 4.0 * half_ulp(mid) + TINY)
        }
    }

    /// A vector that can be off by r across its length n and by s along it is off by an angle of
    /// at most r / (n - s).
    fn degrees(direction: Vec2<Ball>) -> Ball {
        let Vec2 { x, y } = direction;
        let length = x.mid.hypot(y.mid) * (1.0 - 4.0 * U);
        let across = (x.mid.abs() * y.radius + y.mid.abs() * x.radius) / length;
        let least = length - (x.radius + y.radius);
        let off = if least > 0.0 {
            (across / least).to_degrees() * (1.0 + 4.0 * U)
        } else {
            f64::INFINITY
        };
        // Along an axis there is nothing to round.
        if !(off < f64::INFINITY) || x.mid == 0.0 || y.mid == 0.0 {
            return Ball::new(angle::degrees(direction.nearest()), off);
        }
        // The platform's atan2 is right to an ulp.
        let radians = y.mid.atan2(x.mid);
        let radians = Ball::new(radians, 2.0 * half_ulp(radians));
        let degrees = radians.times(Constant::DEGREES).widened(off);
        if degrees.mid >= 0.0 {
            return degrees;
        }
        let positive = degrees + Ball::exactly(angle::TURN);
        if positive.mid < angle::TURN {
            positive
        } else {
            Ball::new(0.0, degrees.largest())
        }
    }
}
