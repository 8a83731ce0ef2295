//! What the solver's formulas are written in: doubles, and whatever else can stand in for them.
//!
//! Every formula of a step is written once, over [`Number`]. In doubles it gives figures, in
//! [`Double`] figures of twice the precision, in [`Ball`](crate::Ball) figures with a bound, in
//! [`Lanes`](crate::Lanes) the figures of several states at once.

use crate::{Constant, Double, Vec2, angle};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// An arithmetic: its four operations, roots, and how constants come into it.
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
    /// Whether an operation takes no longer than to ask if it is needed.
    const IS_CHEAP: bool = true;
    /// What it rounds by, as a part of what doubles round by: 0 where it says of itself what it is off by.
    const GRAIN: f64 = 1.0;

    /// A constant of the mechanism: each arithmetic takes what it can hold.
    fn of(constant: Constant) -> Self;

    /// A double, exactly.
    #[must_use]
    fn exactly(value: f64) -> Self;

    /// The nearest double.
    fn nearest(self) -> f64;

    /// Whether it is a number at all, and not infinite.
    #[inline]
    #[must_use]
    fn is_finite(self) -> bool {
        self.nearest().is_finite()
    }

    /// Times a power of two, exactly.
    #[must_use]
    fn scaled(self, power_of_two: f64) -> Self;

    /// Times a constant.
    #[inline(always)]
    #[must_use]
    fn times(self, constant: Constant) -> Self {
        self * Self::of(constant)
    }

    /// Plus a constant.
    #[inline(always)]
    #[must_use]
    fn plus(self, constant: Constant) -> Self {
        self + Self::of(constant)
    }

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The size.
    #[must_use]
    fn abs(self) -> Self;

    /// The smaller of two.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// Whether it is certainly above another; not where one is no number.
    fn exceeds(self, other: Self) -> bool;

    /// This one, where rounding leaves open whether it or the other one holds: with a bound, both.
    #[must_use]
    fn either(self, _other: Self) -> Self {
        self
    }

    /// This one, where two ways to come to the same figure meet: no derivative where theirs differ.
    #[must_use]
    fn at_kink(self, _other: Self) -> Self {
        self
    }

    /// The unit vector at an angle in degrees, exactly reduced.
    fn unit(degrees: Self) -> Vec2<Self>;

    /// The length of a vector.
    #[must_use]
    fn norm(vector: Vec2<Self>) -> Self {
        vector.norm2().sqrt()
    }

    /// The direction of a vector in degrees, from 0 to below 360.
    fn degrees(direction: Vec2<Self>) -> Self;

    /// The same angle from 0 to below 360 degrees; adding a turn rounds.
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

    /// Without overflow.
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
    // With room for chains: 2^-49.
    const GRAIN: f64 = 8.0 * f64::EPSILON;

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

    /// What the nearest double leaves out turns by less than a rounding: its square counts for nothing.
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

    /// Of a finite angle; a remainder is exact.
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
