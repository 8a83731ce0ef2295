//! Plane vectors, and the few products that planar kinematics is written in.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A vector of the plane: a position, a displacement, a direction or a rate of one of these.
///
/// Read as the complex number `x + i y` it also stands for a rotation: see [`Vec2::turned`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// Component along the frame's x axis.
    pub x: f64,
    /// Component along the frame's y axis.
    pub y: f64,
}

impl Vec2 {
    /// The null vector.
    pub const ZERO: Vec2 = Vec2::new(0.0, 0.0);
    /// The unit vector along x: as a rotation, none at all.
    pub const X: Vec2 = Vec2::new(1.0, 0.0);

    /// The vector (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Vec2 { x, y }
    }

    /// The scalar product.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Vec2) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The out-of-plane component of the vector product: positive where `other` lies to the left.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Vec2) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// `k x self`: turned by +90 degrees, counter-clockwise.
    #[inline]
    #[must_use]
    pub fn perp(self) -> Vec2 {
        Vec2::new(-self.y, self.x)
    }

    /// The square of the length.
    #[inline]
    #[must_use]
    pub fn norm2(self) -> f64 {
        self.dot(self)
    }

    /// The length, without overflow.
    #[must_use]
    pub fn norm(self) -> f64 {
        self.x.hypot(self.y)
    }

    /// Turned by the angle of the unit vector `direction`: the complex product.
    #[inline]
    #[must_use]
    pub fn turned(self, direction: Vec2) -> Vec2 {
        Vec2::new(
            direction.x * self.x - direction.y * self.y,
            direction.x * self.y + direction.y * self.x,
        )
    }

    /// Mirrored in the x axis: as a rotation, the one that undoes it.
    #[inline]
    #[must_use]
    pub fn conj(self) -> Vec2 {
        Vec2::new(self.x, -self.y)
    }

    /// The direction in radians, from -pi to pi; 0 for the null vector.
    #[must_use]
    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    /// Whether both components are finite.
    #[must_use]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Vec2 {
    type Output = Vec2;
    #[inline]
    fn add(self, o: Vec2) -> Vec2 {
        Vec2::new(self.x + o.x, self.y + o.y)
    }
}

impl AddAssign for Vec2 {
    #[inline]
    fn add_assign(&mut self, o: Vec2) {
        *self = *self + o;
    }
}

impl Sub for Vec2 {
    type Output = Vec2;
    #[inline]
    fn sub(self, o: Vec2) -> Vec2 {
        Vec2::new(self.x - o.x, self.y - o.y)
    }
}

impl Neg for Vec2 {
    type Output = Vec2;
    #[inline]
    fn neg(self) -> Vec2 {
        Vec2::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vec2 {
    type Output = Vec2;
    #[inline]
    fn mul(self, s: f64) -> Vec2 {
        Vec2::new(self.x * s, self.y * s)
    }
}

impl Div<f64> for Vec2 {
    type Output = Vec2;
    #[inline]
    fn div(self, s: f64) -> Vec2 {
        Vec2::new(self.x / s, self.y / s)
    }
}
