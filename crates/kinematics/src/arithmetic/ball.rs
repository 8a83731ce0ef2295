//! Implements ball arithmetic: numbers with a bound on their error.

use super::double::{two_product, two_sum};
use super::{DOUBLE_DOUBLE_ERROR, U};
use crate::{Constant, Number, Vec2, angle};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// The exponent bits of a double.
const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
/// Factor that covers the rounding of radii. Radii are sums of rounded positive terms; the factor
/// covers about ten million such roundings, and `TINY` covers underflow.
pub(crate) const INFLATION: f64 = 1.0 + 1e-9;
const TINY: f64 = 1e-290;
/// Above this, the square of a double and its rounding error are free of underflow.
const MIN_SQUARE: f64 = 1e-280;
/// pi / 180, rounded up.
const RADIAN: f64 = 0.017_453_292_519_943_3;

/// All numbers within `radius` of `mid`: a computed value with a bound on its error.
///
/// The operations are those of running error analysis (Higham, Accuracy and Stability of Numerical
/// Algorithms, 2nd ed., chapter 3). A result's radius covers the propagated radii of the operands
/// and the rounding of the operation itself. If there is no bound, the radius is infinite or NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// The midpoint: the computed value.
    pub mid: f64,
    /// The maximum distance of the true value from the midpoint.
    pub radius: f64,
}

impl Ball {
    /// Creates a ball.
    #[inline]
    #[must_use]
    pub const fn new(mid: f64, radius: f64) -> Ball {
        Ball { mid, radius }
    }

    /// Returns a bound on the distance of the true value from `value`, or `None` if there is no
    /// bound.
    #[must_use]
    pub fn bound(self, value: f64) -> Option<f64> {
        let bound = (value - self.mid).abs() + self.radius;
        if bound == 0.0 {
            return Some(0.0);
        }
        let bound = bound * INFLATION + TINY;
        (bound < f64::MAX).then_some(bound)
    }

    /// Returns a ball with its midpoint corrected by `shift`. The radius grows to cover the error
    /// of `shift`: two roundings and a product.
    #[inline]
    fn shifted(mid: f64, shift: f64, radius: f64) -> Ball {
        let (mid, lost) = two_sum(mid, shift);
        Ball::new(mid, radius + lost.abs() + 4.0 * U * shift.abs())
    }

    /// Returns the ball widened by `more` on both sides.
    #[inline]
    #[must_use]
    pub fn widened(self, more: f64) -> Ball {
        Ball::new(self.mid, self.radius + more)
    }

    /// Returns the maximum magnitude in the ball.
    #[inline]
    #[must_use]
    pub fn largest(self) -> f64 {
        self.mid.abs() + self.radius
    }

    /// Returns the minimum magnitude in the ball; 0 if it contains zero.
    #[inline]
    #[must_use]
    pub fn smallest(self) -> f64 {
        (self.mid.abs() - self.radius).max(0.0)
    }
}

/// Returns the maximum rounding error of an operation whose result was rounded to `value`.
#[inline]
pub(crate) fn half_ulp(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & EXPONENT) * U
}

impl Add for Ball {
    type Output = Ball;
    #[inline]
    fn add(self, o: Ball) -> Ball {
        // The sum's rounding error is known exactly, and is often zero.
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
        // The product's rounding error is known exactly, as in a sum.
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
        let minimum = o.mid.abs() - o.radius;
        if !(minimum > 0.0) {
            return Ball::new(mid, f64::INFINITY);
        }
        let carried = (self.radius + mid.abs() * o.radius) / minimum;
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

    /// Corrects the midpoint by the constant's low part and by the product's rounding error, since
    /// both are known with their sign.
    #[inline]
    fn times(self, constant: Constant) -> Ball {
        let Constant { hi, lo, radius, .. } = constant;
        let (mid, lost) = two_product(self.mid, hi);
        let radius = radius + DOUBLE_DOUBLE_ERROR * hi.abs();
        let carried = self.radius * (hi.abs() + lo.abs() + radius) + self.mid.abs() * radius;
        Ball::shifted(mid, lost + self.mid * lo, carried)
    }

    /// Corrects the midpoint by the constant's low part and by the sum's rounding error.
    #[inline]
    fn plus(self, constant: Constant) -> Ball {
        let Constant { hi, lo, radius, .. } = constant;
        let (mid, lost) = two_sum(self.mid, hi);
        Ball::shifted(
            mid,
            lost + lo,
            self.radius + radius + DOUBLE_DOUBLE_ERROR * hi.abs(),
        )
    }

    /// Bounds the error by |sqrt(v + d) - sqrt(v)| = |d| / (sqrt(v) + sqrt(v + d)).
    #[inline]
    fn sqrt(self) -> Ball {
        let mid = self.mid.sqrt();
        let minimum = self.mid - self.radius;
        if !(minimum > 0.0) {
            return Ball::new(mid, f64::INFINITY);
        }
        Ball::new(mid, self.radius / (mid + minimum.sqrt()) + half_ulp(mid))
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

    /// Encloses both balls.
    fn either(self, other: Ball) -> Ball {
        let distance = (self.mid - other.mid).abs();
        Ball::new(
            self.mid,
            self.radius.max((distance + other.radius) * INFLATION),
        )
    }

    /// Returns each component within 0.75 ulp (0.6 was measured), exact if the other is zero. The
    /// radius also covers the rotation by the angle's radius.
    #[inline]
    fn unit(degrees: Ball) -> Vec2<Ball> {
        let Vec2 { x, y } = angle::unit(degrees.mid);
        let ulps = if x == 0.0 || y == 0.0 { 0.0 } else { 1.5 };
        let off = degrees.radius * RADIAN;
        let ball =
            |v: f64, across: f64| Ball::new(v, ulps * half_ulp(v) + off * (across.abs() + off));
        Vec2::new(ball(x, y), ball(y, x))
    }

    /// Returns the length. Along an axis, it is exactly the component. For a vector that may be 0,
    /// the length's error is at most the vector's error: | |a| - |b| | <= |a - b|.
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
            // Radii do not cover underflow in squares, so tiny squares are not used.
            if root.radius.is_finite() && square.mid > MIN_SQUARE {
                return root;
            }
            let mid = x.mid.hypot(y.mid);
            // The platform's hypot is accurate to an ulp.
            let distance = x.radius.hypot(y.radius) * INFLATION;
            Ball::new(mid, distance + 4.0 * half_ulp(mid) + TINY)
        }
    }

    /// Returns the direction. A vector with an error of at most r across its length n and s along
    /// it has an angular error of at most r / (n - s).
    fn degrees(direction: Vec2<Ball>) -> Ball {
        let Vec2 { x, y } = direction;
        let length = x.mid.hypot(y.mid) * (1.0 - 4.0 * U);
        let across = (x.mid.abs() * y.radius + y.mid.abs() * x.radius) / length;
        let minimum = length - (x.radius + y.radius);
        let off = if minimum > 0.0 {
            (across / minimum).to_degrees() * (1.0 + 4.0 * U)
        } else {
            f64::INFINITY
        };
        // Along an axis, the direction has no rounding error.
        if !(off < f64::INFINITY) || x.mid == 0.0 || y.mid == 0.0 {
            return Ball::new(angle::degrees(direction.nearest()), off);
        }
        // The platform's atan2 is accurate to an ulp.
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
