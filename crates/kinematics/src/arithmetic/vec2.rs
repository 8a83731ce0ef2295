//! Implements plane vectors with the products used in planar kinematics.

use crate::{Constant, Number};
use nalgebra::{Point2, Vector2};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A plane vector: a position, a displacement, a direction or a rate of one of these.
///
/// As the complex number `x + i y`, a unit vector also represents a rotation: see [`Vec2::turned`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2<T = f64> {
    /// The component along the frame's x axis.
    pub x: T,
    /// The component along the frame's y axis.
    pub y: T,
}

impl<T> Vec2<T> {
    /// Creates the vector (x, y).
    #[inline(always)]
    #[must_use]
    pub const fn new(x: T, y: T) -> Self {
        Vec2 { x, y }
    }

    /// Applies a function to each component.
    #[inline(always)]
    #[must_use]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Vec2<U> {
        Vec2::new(f(self.x), f(self.y))
    }
}

impl<T: Number> Vec2<T> {
    /// Converts a constant vector.
    #[inline(always)]
    #[must_use]
    pub fn of(constant: Vec2<Constant>) -> Self {
        constant.map(T::of)
    }

    /// Returns the scalar product.
    #[inline(always)]
    #[must_use]
    pub fn dot(self, other: Vec2<T>) -> T {
        self.x * other.x + self.y * other.y
    }

    /// Returns the out-of-plane component of the vector product: positive if `other` is to the
    /// left.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, other: Vec2<T>) -> T {
        self.x * other.y - self.y * other.x
    }

    /// Returns `k x self`: the vector turned by +90 degrees, counter-clockwise.
    #[inline(always)]
    #[must_use]
    pub fn perp(self) -> Vec2<T> {
        Vec2::new(-self.y, self.x)
    }

    /// Returns the square of the length.
    #[inline(always)]
    #[must_use]
    pub fn norm2(self) -> T {
        self.dot(self)
    }

    /// Returns the length.
    #[must_use]
    pub fn norm(self) -> T {
        T::norm(self)
    }

    /// Returns the vector turned by the angle of the unit vector `direction`: the complex product.
    #[inline(always)]
    #[must_use]
    pub fn turned(self, direction: Vec2<T>) -> Vec2<T> {
        Vec2::new(
            direction.x * self.x - direction.y * self.y,
            direction.x * self.y + direction.y * self.x,
        )
    }

    /// Returns the vector reflected in the x axis: as a rotation, the inverse.
    #[inline(always)]
    #[must_use]
    pub fn conj(self) -> Vec2<T> {
        Vec2::new(self.x, -self.y)
    }

    /// Multiplies by a constant.
    #[inline(always)]
    #[must_use]
    pub fn times(self, constant: Constant) -> Vec2<T> {
        self.map(|v| v.times(constant))
    }

    /// Adds a constant.
    #[inline(always)]
    #[must_use]
    pub fn plus(self, constant: Vec2<Constant>) -> Vec2<T> {
        Vec2::new(self.x.plus(constant.x), self.y.plus(constant.y))
    }

    /// Multiplies by a power of two, exactly.
    #[inline(always)]
    #[must_use]
    pub fn scaled(self, power_of_two: f64) -> Vec2<T> {
        self.map(|v| v.scaled(power_of_two))
    }

    /// Returns the nearest vector of doubles.
    #[inline(always)]
    #[must_use]
    pub fn nearest(self) -> Vec2 {
        self.map(T::nearest)
    }
}

impl Vec2 {
    /// The null vector.
    pub const ZERO: Vec2 = Vec2::new(0.0, 0.0);
    /// The unit vector along x: as a rotation, the identity.
    pub const X: Vec2 = Vec2::new(1.0, 0.0);

    /// Returns the direction in radians, from -pi to pi; 0 for the null vector.
    #[must_use]
    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    /// Returns `true` if both components are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }

    /// Converts the vector to another arithmetic, exactly.
    #[inline(always)]
    #[must_use]
    pub fn exactly<T: Number>(self) -> Vec2<T> {
        self.map(T::exactly)
    }
}

impl<T: Number> Add for Vec2<T> {
    type Output = Vec2<T>;
    #[inline(always)]
    fn add(self, o: Vec2<T>) -> Vec2<T> {
        Vec2::new(self.x + o.x, self.y + o.y)
    }
}

impl<T: Number> AddAssign for Vec2<T> {
    #[inline(always)]
    fn add_assign(&mut self, o: Vec2<T>) {
        *self = *self + o;
    }
}

impl<T: Number> Sub for Vec2<T> {
    type Output = Vec2<T>;
    #[inline(always)]
    fn sub(self, o: Vec2<T>) -> Vec2<T> {
        Vec2::new(self.x - o.x, self.y - o.y)
    }
}

impl<T: Number> Neg for Vec2<T> {
    type Output = Vec2<T>;
    #[inline(always)]
    fn neg(self) -> Vec2<T> {
        Vec2::new(-self.x, -self.y)
    }
}

impl<T: Number> Mul<T> for Vec2<T> {
    type Output = Vec2<T>;
    #[inline(always)]
    fn mul(self, s: T) -> Vec2<T> {
        Vec2::new(self.x * s, self.y * s)
    }
}

impl<T: Number> Div<T> for Vec2<T> {
    type Output = Vec2<T>;
    #[inline(always)]
    fn div(self, s: T) -> Vec2<T> {
        Vec2::new(self.x / s, self.y / s)
    }
}

/// Conversions to and from nalgebra's vectors and points, for use at the edge of the library.
impl From<Vec2> for Vector2<f64> {
    fn from(v: Vec2) -> Vector2<f64> {
        Vector2::new(v.x, v.y)
    }
}

impl From<Vector2<f64>> for Vec2 {
    fn from(v: Vector2<f64>) -> Vec2 {
        Vec2::new(v.x, v.y)
    }
}

impl From<Vec2> for Point2<f64> {
    fn from(v: Vec2) -> Point2<f64> {
        Point2::new(v.x, v.y)
    }
}

impl From<Point2<f64>> for Vec2 {
    fn from(p: Point2<f64>) -> Vec2 {
        Vec2::new(p.x, p.y)
    }
}
