//! Defines the arithmetic of the solver's formulas: a trait for doubles and their substitutes.
//!
//! Every formula of a step is written once, over [`Number`]. Doubles give values, [`Double`] gives
//! double-double precision, [`Ball`](crate::Ball) gives bounds, [`Lanes`](crate::Lanes) give
//! several states at once.

use crate::{Constant, Double, Vec2, angle};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// An arithmetic: the four operations, roots, and the conversion of constants.
pub trait Number:
    Copy
    + Debug
    + Default
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Whether an operation costs no more than a test whether it is needed.
    const IS_CHEAP: bool = true;
    /// The rounding error relative to that of doubles; 0 if the type bounds its own error.
    const RELATIVE_ROUNDING: f64 = 1.0;
    /// Whether constants that depend on others are computed in this arithmetic. Their stored derivatives
    /// hold at the stored value only, not within the radius.
    const DERIVES_CONSTANTS: bool = false;

    /// Converts a constant of the mechanism, keeping as much as the type can hold.
    fn of(constant: Constant) -> Self;

    /// Converts a double, exactly.
    #[must_use]
    fn exactly(value: f64) -> Self;

    /// Returns the nearest double.
    fn nearest(self) -> f64;

    /// Returns `true` if the number is neither infinite nor NaN.
    #[inline]
    #[must_use]
    fn is_finite(self) -> bool {
        self.nearest().is_finite()
    }

    /// Multiplies by a power of two, exactly.
    #[must_use]
    fn scaled(self, power_of_two: f64) -> Self;

    /// Multiplies by a constant.
    #[inline(always)]
    #[must_use]
    fn times(self, constant: Constant) -> Self {
        self * Self::of(constant)
    }

    /// Adds a constant.
    #[inline(always)]
    #[must_use]
    fn plus(self, constant: Constant) -> Self {
        self + Self::of(constant)
    }

    /// Returns the square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Returns the absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// Returns the smaller of two numbers.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// Returns `true` if it is certainly greater than `other`; `false` if one is NaN.
    fn exceeds(self, other: Self) -> bool;

    /// Returns this number if rounding leaves open which of the two holds. Types with a bound
    /// enclose both.
    #[must_use]
    fn either(self, _other: Self) -> Self {
        self
    }

    /// Returns this number where two branches of a function meet. A type with a derivative loses it
    /// if the branches' derivatives differ.
    #[must_use]
    fn at_kink(self, _other: Self) -> Self {
        self
    }

    /// Returns the unit vector at an angle in degrees, exactly reduced.
    fn unit(degrees: Self) -> Vec2<Self>;

    /// Returns the length of a vector.
    #[must_use]
    fn norm(vector: Vec2<Self>) -> Self {
        vector.norm2().sqrt()
    }

    /// Returns the direction of a vector in degrees, in [0, 360).
    fn degrees(direction: Vec2<Self>) -> Self;

    /// Returns the equivalent angle in [0, 360) degrees; adding a turn rounds.
    #[must_use]
    fn wrapped(degrees: Self) -> Self {
        let near = degrees.nearest();
        let rest = near % angle::TURN;
        let turn = Self::exactly(angle::TURN);
        let within = (degrees - Self::exactly(near)) + Self::exactly(rest);
        let positive = if rest < 0.0 { within + turn } else { within };
        if positive.nearest() >= angle::TURN {
            positive - turn
        } else {
            positive
        }
    }
}

impl Number for f64 {
    #[inline]
    fn of(constant: Constant) -> f64 {
        constant.hi
    }

    #[inline]
    fn exactly(value: f64) -> f64 {
        value
    }

    #[inline]
    fn nearest(self) -> f64 {
        self
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> f64 {
        self * power_of_two
    }

    #[inline]
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }

    #[inline]
    fn abs(self) -> f64 {
        f64::abs(self)
    }

    #[inline]
    fn min(self, other: f64) -> f64 {
        f64::min(self, other)
    }

    #[inline]
    fn exceeds(self, other: f64) -> bool {
        self > other
    }

    #[inline]
    fn unit(degrees: f64) -> Vec2 {
        angle::unit(degrees)
    }

    /// Avoids overflow.
    #[inline]
    fn norm(vector: Vec2) -> f64 {
        vector.x.hypot(vector.y)
    }

    #[inline]
    fn wrapped(degrees: f64) -> f64 {
        angle::wrapped(degrees)
    }

    #[inline]
    fn degrees(direction: Vec2) -> f64 {
        angle::degrees(direction)
    }
}

impl Number for Double {
    const IS_CHEAP: bool = false;
    // 2^-49, with a margin for chains of operations.
    const RELATIVE_ROUNDING: f64 = 8.0 * f64::EPSILON;

    #[inline]
    fn of(constant: Constant) -> Double {
        constant.value()
    }

    #[inline]
    fn exactly(value: f64) -> Double {
        Double::exactly(value)
    }

    #[inline]
    fn nearest(self) -> f64 {
        self.hi
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> Double {
        Double::scaled(self, power_of_two)
    }

    #[inline]
    fn sqrt(self) -> Double {
        Double::sqrt(self)
    }

    #[inline]
    fn abs(self) -> Double {
        Double::abs(self)
    }

    #[inline]
    fn min(self, other: Double) -> Double {
        if (self - other).hi < 0.0 { self } else { other }
    }

    #[inline]
    fn exceeds(self, other: Double) -> bool {
        (self - other).hi > 0.0
    }

    /// Rotates by `degrees.lo`, which is less than a rounding error of a double, so that its square
    /// is negligible.
    fn unit(degrees: Double) -> Vec2<Double> {
        let near = Double::unit(degrees.hi);
        if degrees.lo == 0.0 {
            return near;
        }
        let rest = Double::exactly(degrees.lo) * Double::RADIAN;
        near.turned(Vec2::new(Double::ONE, rest))
    }

    fn degrees(direction: Vec2<Double>) -> Double {
        let degrees = Double::degrees(direction);
        if degrees.hi < 0.0 {
            degrees + Double::exactly(angle::TURN)
        } else {
            degrees
        }
    }
}

/// Single precision, for comparison.
impl Number for f32 {
    #[inline]
    fn of(constant: Constant) -> f32 {
        f64::of(constant) as f32
    }

    #[inline]
    fn exactly(value: f64) -> f32 {
        value as f32
    }

    #[inline]
    fn nearest(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn scaled(self, power_of_two: f64) -> f32 {
        self * power_of_two as f32
    }

    #[inline]
    fn sqrt(self) -> f32 {
        f32::sqrt(self)
    }

    #[inline]
    fn abs(self) -> f32 {
        f32::abs(self)
    }

    #[inline]
    fn min(self, other: f32) -> f32 {
        f32::min(self, other)
    }

    #[inline]
    fn exceeds(self, other: f32) -> bool {
        self > other
    }

    /// Requires a finite angle; the remainder is exact.
    #[inline]
    fn unit(degrees: f32) -> Vec2<f32> {
        let (sin, cos) = (degrees % 360.0).to_radians().sin_cos();
        Vec2::new(cos, sin)
    }

    #[inline]
    fn degrees(direction: Vec2<f32>) -> f32 {
        let degrees = direction.y.atan2(direction.x).to_degrees();
        if degrees < 0.0 {
            degrees + 360.0
        } else {
            degrees
        }
    }
}
