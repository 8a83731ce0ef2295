//! Implements forward differentiation by one given length.

use crate::{Constant, Number, Vec2, angle};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number with its derivative by the length under study.
///
/// Every operation propagates both by the rules of calculus. The derivative of a formula is
/// therefore as accurate as the formula itself, without a step size or truncation error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// The derivative of the value.
    pub slope: f64,
}

impl Dual {
    /// Creates a number with its derivative.
    #[inline]
    #[must_use]
    pub const fn new(value: f64, slope: f64) -> Dual {
        Dual { value, slope }
    }
}

/// Relative tolerance for two derivatives computed in different ways.
const EQUALITY_TOLERANCE: f64 = 1e-12;

impl Add for Dual {
    type Output = Dual;
    #[inline]
    fn add(self, o: Dual) -> Dual {
        Dual::new(self.value + o.value, self.slope + o.slope)
    }
}

impl AddAssign for Dual {
    #[inline]
    fn add_assign(&mut self, o: Dual) {
        *self = *self + o;
    }
}

impl Sub for Dual {
    type Output = Dual;
    #[inline]
    fn sub(self, o: Dual) -> Dual {
        Dual::new(self.value - o.value, self.slope - o.slope)
    }
}

impl Neg for Dual {
    type Output = Dual;
    #[inline]
    fn neg(self) -> Dual {
        Dual::new(-self.value, -self.slope)
    }
}

impl Mul for Dual {
    type Output = Dual;
    #[inline]
    fn mul(self, o: Dual) -> Dual {
        let slope = self.value * o.slope + self.slope * o.value;
        Dual::new(self.value * o.value, slope)
    }
}

impl Div for Dual {
    type Output = Dual;
    #[inline]
    fn div(self, o: Dual) -> Dual {
        let value = self.value / o.value;
        Dual::new(value, (self.slope - value * o.slope) / o.value)
    }
}

impl Number for Dual {
    #[inline]
    fn of(constant: Constant) -> Dual {
        Dual::new(constant.hi, constant.slope)
    }

    #[inline]
    fn exactly(value: f64) -> Dual {
        Dual::new(value, 0.0)
    }

    #[inline]
    fn nearest(self) -> f64 {
        self.value
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Dual {
        Dual::new(self.value * power_of_two, self.slope * power_of_two)
    }

    #[inline]
    fn sqrt(self) -> Dual {
        let root = self.value.sqrt();
        Dual::new(root, self.slope / (2.0 * root))
    }

    #[inline]
    fn abs(self) -> Dual {
        if self.value < 0.0 { -self } else { self }
    }

    #[inline]
    fn min(self, o: Dual) -> Dual {
        if o.value < self.value { o } else { self }
    }

    #[inline]
    fn exceeds(self, o: Dual) -> bool {
        self.value > o.value
    }

    /// Treats slopes that differ only by rounding errors as equal.
    fn at_kink(self, other: Dual) -> Dual {
        let distance = (self.slope - other.slope).abs();
        let maximum = self.slope.abs().max(other.slope.abs());
        match distance <= EQUALITY_TOLERANCE * maximum {
            true => self,
            false => Dual::new(self.value, f64::NAN),
        }
    }

    #[inline]
    fn unit(degrees: Dual) -> Vec2<Dual> {
        let Vec2 { x, y } = angle::unit(degrees.value);
        let turning = degrees.slope.to_radians();
        Vec2::new(Dual::new(x, -y * turning), Dual::new(y, x * turning))
    }

    /// Avoids overflow.
    #[inline]
    fn norm(vector: Vec2<Dual>) -> Dual {
        let value = vector.x.value.hypot(vector.y.value);
        let along = vector.nearest() / value;
        Dual::new(value, along.dot(vector.map(|v| v.slope)))
    }

    #[inline]
    fn degrees(direction: Vec2<Dual>) -> Dual {
        let at = direction.nearest();
        let turning = at.cross(direction.map(|v| v.slope)) / at.norm2();
        Dual::new(angle::degrees(at), turning.to_degrees())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares each rule with a difference quotient.
    #[test]
    fn every_operation_propagates_its_derivative() {
        type Formula = fn(Dual) -> Dual;
        let c = Dual::exactly(1.75);
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
        let [x, y] = [a, b].map(Dual::of);
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
            let of = Dual::of(constant);
            assert!((of.slope - dual.slope).abs() <= 1e-15, "{of:?} {dual:?}");
        }
    }
}
