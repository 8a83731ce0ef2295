//! Implements double-double arithmetic: a value is the sum of two doubles.
//!
//! It is used for the rounding errors of constants, for residuals, and for whole runs of the solver
//! as a reference. It needs no fused operation, so that the bits are the same on every machine.

use crate::Vec2;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Veltkamp's constant 2^27 + 1, which splits a double into two halves.
pub(super) const SPLITTER: f64 = 134_217_729.0;

/// Returns a + b as the rounded sum and its rounding error (Knuth).
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let back = sum - a;
    (sum, (a - (sum - back)) + (b - back))
}

/// Returns a + b as the rounded sum and its rounding error, for |a| >= |b| (Dekker).
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

#[inline(always)]
pub(super) fn split(a: f64) -> (f64, f64) {
    let t = SPLITTER * a;
    let top = t - (t - a);
    (top, a - top)
}

/// Returns a b as the rounded product and its rounding error (Dekker); exact except for underflow.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    (product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2)
}

/// A number as `hi + lo`, where `hi` is the nearest double: 106 bits.
///
/// Sums and products are accurate to about 2^-104 of the larger operand (Joldes, Muller and
/// Popescu, Tight and rigorous error bounds for basic building blocks of double-word arithmetic,
/// 2017).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Double {
    /// The nearest double.
    pub hi: f64,
    /// The remainder beyond `hi`.
    pub lo: f64,
}

impl Double {
    /// Zero.
    pub const ZERO: Double = Double { hi: 0.0, lo: 0.0 };
    /// One.
    pub const ONE: Double = Double { hi: 1.0, lo: 0.0 };
    /// pi / 180.
    pub const RADIAN: Double = Double {
        hi: 0.017_453_292_519_943_295,
        lo: 2.948_652_270_870_168_7e-19,
    };
    /// 180 / pi.
    pub const DEGREES: Double = Double {
        hi: 57.295_779_513_082_32,
        lo: -1.987_849_567_057_628_2e-15,
    };

    /// Creates a number from a double, exactly.
    #[inline]
    #[must_use]
    pub const fn exactly(value: f64) -> Double {
        Double { hi: value, lo: 0.0 }
    }

    /// Returns a + b of two doubles, exactly.
    #[inline]
    #[must_use]
    pub fn sum(a: f64, b: f64) -> Double {
        let (hi, lo) = two_sum(a, b);
        Double { hi, lo }
    }

    /// Multiplies by a power of two, exactly.
    #[inline]
    #[must_use]
    pub fn scaled(self, power_of_two: f64) -> Double {
        Double {
            hi: self.hi * power_of_two,
            lo: self.lo * power_of_two,
        }
    }

    /// Returns the square root; zero for zero.
    #[must_use]
    pub fn sqrt(self) -> Double {
        let root = self.hi.sqrt();
        if root == 0.0 {
            return Double::ZERO;
        }
        // Two Newton steps: each doubles the digits.
        let step = |x: Double| {
            let rest = self - x * x;
            x + Double::exactly(rest.hi / (2.0 * root))
        };
        step(step(Double::exactly(root)))
    }

    /// Returns the absolute value.
    #[must_use]
    pub fn abs(self) -> Double {
        if self.hi < 0.0 { -self } else { self }
    }

    /// Returns the unit vector at `degrees` from +x, counter-clockwise; exact at multiples of 90
    /// degrees.
    #[must_use]
    pub fn unit(degrees: f64) -> Vec2<Double> {
        let turn = degrees % 360.0;
        let quadrant = (turn / 90.0).round();
        // Exact by Sterbenz's lemma: 90 q is within 45 of the angle.
        let (sin, cos) = Double::exactly(turn - 90.0 * quadrant).sin_cos();
        let (x, y) = match quadrant.rem_euclid(4.0) as u8 {
            0 => (cos, sin),
            1 => (-sin, cos),
            2 => (-cos, -sin),
            _ => (sin, -cos),
        };
        Vec2::new(x, y)
    }

    /// Returns the sine and cosine of at most about 45 degrees by Taylor series: after 28 terms,
    /// they are below 2^-110.
    fn sin_cos(self) -> (Double, Double) {
        let x = self * Double::RADIAN;
        let (mut sin, mut cos) = (Double::ZERO, Double::ZERO);
        let mut term = Double::ONE;
        for n in 0..28_u8 {
            let signed = if n & 2 == 0 { term } else { -term };
            if n % 2 == 0 {
                cos += signed;
            } else {
                sin += signed;
            }
            term = term * x / Double::exactly(f64::from(n + 1));
        }
        (sin, cos)
    }

    /// Returns the direction of a vector in degrees, from -180 to 180.
    #[must_use]
    pub fn degrees(direction: Vec2<Double>) -> Double {
        let near = direction.y.hi.atan2(direction.x.hi).to_degrees();
        // The remainder is the small angle from the approximate direction to the true one,
        // approximated by its sine.
        let unit = Double::unit(near);
        let length = direction.norm2().sqrt();
        let rest = unit.cross(direction) / length;
        Double::exactly(near) + rest * Double::DEGREES
    }
}

impl Add for Double {
    type Output = Double;
    #[inline]
    fn add(self, o: Double) -> Double {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Double { hi, lo }
    }
}

impl AddAssign for Double {
    #[inline]
    fn add_assign(&mut self, o: Double) {
        *self = *self + o;
    }
}

impl Sub for Double {
    type Output = Double;
    #[inline]
    fn sub(self, o: Double) -> Double {
        self + -o
    }
}

impl Neg for Double {
    type Output = Double;
    #[inline]
    fn neg(self) -> Double {
        Double {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Mul for Double {
    type Output = Double;
    #[inline]
    fn mul(self, o: Double) -> Double {
        let (p, e) = two_product(self.hi, o.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * o.lo + self.lo * o.hi));
        Double { hi, lo }
    }
}

impl Div for Double {
    type Output = Double;
    #[inline]
    fn div(self, o: Double) -> Double {
        let first = self.hi / o.hi;
        let rest = self - o * Double::exactly(first);
        let second = rest.hi / o.hi;
        let rest = rest - o * Double::exactly(second);
        let third = rest.hi / o.hi;
        let (hi, lo) = quick_two_sum(first, second);
        Double { hi, lo } + Double::exactly(third)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(value: Double, hi: f64, lo: f64) {
        let off = value - Double { hi, lo };
        assert!(off.hi.abs() < 1e-31 * hi.abs().max(1.0), "{value:?}");
    }

    #[test]
    fn quotients_and_square_roots_have_double_double_precision() {
        let third = Double::ONE / Double::exactly(3.0);
        assert!((third * Double::exactly(3.0) - Double::ONE).hi.abs() < 1e-31);
        let root = Double::exactly(2.0).sqrt();
        assert_near(root, std::f64::consts::SQRT_2, -9.667_293_313_452_914e-17);
        assert_eq!(Double::exactly(9.0).sqrt(), Double::exactly(3.0));
        assert_eq!(Double::ZERO.sqrt(), Double::ZERO);
    }

    #[test]
    fn square_roots_of_squares_are_exact() {
        for x in [0.1, 250.0 / 256.0, 1.000_000_001, 3.7e-5] {
            let x = Double::exactly(x);
            assert_eq!((x * x).sqrt(), x);
        }
    }

    #[test]
    fn unit_vectors_have_exact_length_and_angle() {
        assert_eq!(Double::unit(450.0), Vec2::new(Double::ZERO, Double::ONE));
        let half = Double::unit(-30.0).y + Double::exactly(0.5);
        assert!(half.hi.abs() < 1e-31, "{half:?}");
        for k in 0..720_u16 {
            let angle = f64::from(k) * 0.517 - 180.0;
            let unit = Double::unit(angle);
            assert!((unit.norm2() - Double::ONE).hi.abs() < 1e-30);
            let back = Double::degrees(unit) - Double::exactly(angle);
            let off = back.hi.abs().min((back.hi.abs() - 360.0).abs());
            assert!(off < 1e-28, "{angle}: {off:e}");
        }
    }
}
