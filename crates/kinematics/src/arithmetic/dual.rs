//! Implements forward differentiation by one given length.

use super::U;
use crate::{Constant, Number, Vec2};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number with its derivative by the length under study.
///
/// Every operation propagates both by the rules of calculus. The derivative of a formula is
/// therefore as accurate as the formula itself, without a step size or truncation error. Over
/// [`Ball`](crate::Ball)s, the derivative contains all derivatives of the values in the ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual<T = f64> {
    /// The value.
    pub value: T,
    /// The derivative of the value.
    pub slope: T,
}

impl<T> Dual<T> {
    /// Creates a number with its derivative.
    #[inline]
    #[must_use]
    pub const fn new(value: T, slope: T) -> Dual<T> {
        Dual { value, slope }
    }
}

/// Relative tolerance for two derivatives computed in different ways.
const EQUALITY_TOLERANCE: f64 = 1e-12;

impl<T: Number> Add for Dual<T> {
    type Output = Dual<T>;
    #[inline]
    fn add(self, o: Dual<T>) -> Dual<T> {
        Dual::new(self.value + o.value, self.slope + o.slope)
    }
}

impl<T: Number> AddAssign for Dual<T> {
    #[inline]
    fn add_assign(&mut self, o: Dual<T>) {
        *self = *self + o;
    }
}

impl<T: Number> Sub for Dual<T> {
    type Output = Dual<T>;
    #[inline]
    fn sub(self, o: Dual<T>) -> Dual<T> {
        Dual::new(self.value - o.value, self.slope - o.slope)
    }
}

impl<T: Number> Neg for Dual<T> {
    type Output = Dual<T>;
    #[inline]
    fn neg(self) -> Dual<T> {
        Dual::new(-self.value, -self.slope)
    }
}

impl<T: Number> Mul for Dual<T> {
    type Output = Dual<T>;
    #[inline]
    fn mul(self, o: Dual<T>) -> Dual<T> {
        let slope = self.value * o.slope + self.slope * o.value;
        Dual::new(self.value * o.value, slope)
    }
}

impl<T: Number> Div for Dual<T> {
    type Output = Dual<T>;
    #[inline]
    fn div(self, o: Dual<T>) -> Dual<T> {
        let value = self.value / o.value;
        Dual::new(value, (self.slope - value * o.slope) / o.value)
    }
}

impl<T: Number> Number for Dual<T> {
    const IS_CHEAP: bool = T::IS_CHEAP;
    const RELATIVE_ROUNDING: f64 = T::RELATIVE_ROUNDING;
    const DERIVES_CONSTANTS: bool = !T::IS_CHEAP;

    #[inline]
    fn of(constant: Constant) -> Dual<T> {
        let slope = Constant::exactly(constant.slope);
        let rounding = 2.0 * U * constant.slope.abs();
        Dual::new(T::of(constant), T::of(slope.widened(rounding)))
    }

    #[inline]
    fn exactly(value: f64) -> Dual<T> {
        Dual::new(T::exactly(value), T::default())
    }

    #[inline]
    fn nearest(self) -> f64 {
        self.value.nearest()
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Dual<T> {
        let Dual { value, slope } = self;
        Dual::new(value.scaled(power_of_two), slope.scaled(power_of_two))
    }

    #[inline]
    fn sqrt(self) -> Dual<T> {
        let root = self.value.sqrt();
        Dual::new(root, self.slope / root.scaled(2.0))
    }

    #[inline]
    fn abs(self) -> Dual<T> {
        let zero = T::default();
        if zero.exceeds(self.value) {
            -self
        } else if self.value.exceeds(zero) {
            self
        } else {
            Dual::new(self.value.abs(), self.slope.either(-self.slope))
        }
    }

    #[inline]
    fn min(self, o: Dual<T>) -> Dual<T> {
        if self.value.exceeds(o.value) {
            o
        } else if o.value.exceeds(self.value) {
            self
        } else {
            Dual::new(self.value.min(o.value), self.slope.either(o.slope))
        }
    }

    #[inline]
    fn exceeds(self, o: Dual<T>) -> bool {
        self.value.exceeds(o.value)
    }

    #[inline]
    fn either(self, o: Dual<T>) -> Dual<T> {
        Dual::new(self.value.either(o.value), self.slope.either(o.slope))
    }

    /// Treats slopes that differ only by rounding errors as equal.
    fn at_kink(self, other: Dual<T>) -> Dual<T> {
        let [one, two] = [self.slope, other.slope].map(T::nearest);
        match (one - two).abs() <= EQUALITY_TOLERANCE * one.abs().max(two.abs()) {
            true => self,
            false => Dual::new(self.value, T::exactly(f64::NAN)),
        }
    }

    #[inline]
    fn unit(degrees: Dual<T>) -> Vec2<Dual<T>> {
        let Vec2 { x, y } = T::unit(degrees.value);
        let turning = degrees.slope.times(Constant::RADIAN);
        Vec2::new(Dual::new(x, -y * turning), Dual::new(y, x * turning))
    }

    #[inline]
    fn norm(vector: Vec2<Dual<T>>) -> Dual<T> {
        let at = vector.map(|v| v.value);
        let value = T::norm(at);
        Dual::new(value, (at / value).dot(vector.map(|v| v.slope)))
    }

    #[inline]
    fn degrees(direction: Vec2<Dual<T>>) -> Dual<T> {
        let at = direction.map(|v| v.value);
        let turning = at.cross(direction.map(|v| v.slope)) / at.norm2();
        Dual::new(T::degrees(at), turning.times(Constant::DEGREES))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ball;

    /// Compares each rule with a difference quotient.
    #[test]
    fn every_operation_propagates_its_derivative() {
        type Formula = fn(Dual) -> Dual;
        let c: Dual = Dual::exactly(1.75);
        assert_eq!(c.slope, 0.0);
        let formulas: [Formula; 9] = [
            |x| x * x + Dual::exactly(3.0) - x,
            |x| Dual::exactly(2.0) / (x * x),
            |x| (x * x * x).sqrt(),
            |x| -(x - Dual::exactly(4.0)).abs(),
            |x| x.min(Dual::exactly(0.5)) + x.scaled(4.0),
            |x| Dual::unit(x).x * Dual::unit(x).y,
            |x| Dual::norm(Vec2::new(x, x * x)),
            |x| Dual::degrees(Vec2::new(x, x * x)),
            |x| Vec2::new(x, Dual::exactly(1.0)).norm2(),
        ];
        let (at, h) = (1.375, 1e-5);
        for (i, formula) in formulas.into_iter().enumerate() {
            let read = |by: f64| formula(Dual::exactly(at + by)).value;
            let secant = (read(h) - read(-h)) / (2.0 * h);
            let found = formula(Dual::new(at, 1.0));
            assert_eq!(found.value, read(0.0), "{i}");
            assert!(
                (found.slope - secant).abs() < 1e-8,
                "{i}: {found:?} {secant}"
            );
        }
    }

    /// The slope of a constant is the slope with which the formulas of a step continue.
    #[test]
    fn constants_propagate_slopes_like_duals() {
        let [a, b] = [(2.5, 1.0), (0.75, -2.0)].map(|(v, s)| Constant::given(v).with_slope(s));
        let [x, y]: [Dual; 2] = [a, b].map(Dual::of);
        let pairs = [
            (a + b, x + y),
            (a - b, x - y),
            (a * b, x * y),
            (a / b, x / y),
            (-a, -x),
            (a.sqrt(), x.sqrt()),
            ((b - a).abs(), (y - x).abs()),
            (a.scaled(0.5), x.scaled(0.5)),
        ];
        for (constant, dual) in pairs {
            let of: Dual = Dual::of(constant);
            assert!((of.slope - dual.slope).abs() <= 1e-15, "{of:?} {dual:?}");
        }
    }

    /// The derivative over a ball contains those at its ends and in between.
    #[test]
    fn derivative_over_a_ball_contains_all_derivatives() {
        type Formula<T> = fn(Dual<T>) -> Dual<T>;
        fn formulas<T: Number>() -> [Formula<T>; 7] {
            [
                |x| x * x * x - x,
                |x| Dual::exactly(2.0) / (x * x),
                |x| (x * x * x).sqrt(),
                |x| (x - Dual::exactly(1.375)).abs(),
                |x| x.min(Dual::exactly(1.375)) * x,
                |x| Dual::norm(Vec2::new(x, x * x)) * Dual::unit(x).x,
                |x| Dual::degrees(Vec2::new(x, x * x)),
            ]
        }
        let (mid, radius) = (1.375, 0.0625);
        let ball = Dual::new(Ball::new(mid, radius), Ball::exactly(1.0));
        for (i, (of_ball, formula)) in formulas::<Ball>().iter().zip(formulas::<f64>()).enumerate()
        {
            let all = of_ball(ball);
            for k in -8..=8 {
                let at = mid + radius * f64::from(k) / 8.0;
                let here = formula(Dual::new(at, 1.0));
                let is_inside = |ball: Ball, value: f64| (value - ball.mid).abs() <= ball.radius;
                assert!(is_inside(all.value, here.value), "{i} at {at}: {all:?}");
                assert!(is_inside(all.slope, here.slope), "{i} at {at}: {all:?}");
            }
        }
    }
}
