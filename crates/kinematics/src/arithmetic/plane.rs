//! Vectors of the plane as the machine's vectors: one, (x, y), or two side by side, (x1, y1, x2, y2).
//!
//! A number that belongs to a vector stands in both of its places, and one that belongs to both vectors in all
//! four. So everything that is said of a way is written once, for one arm and for two at once, and nothing has to
//! change its place but where components meet.

use super::double::SPLITTER;
use crate::Vec2;
use fearless_simd::prelude::*;
pub(crate) use fearless_simd::{Fallback, Simd, f64x2, f64x4};
use fearless_simd::{mask64x2, mask64x4, u64x2, u64x4};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The bit of a double that is its sign.
const SIGN: u64 = 1 << 63;

/// One vector or two.
pub(crate) trait Plane:
    Copy
    + Add<Output = Self>
    + Add<f64, Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One vector.
    type One: Plane;

    /// A number in all places.
    #[must_use]
    fn all(self, value: f64) -> Self;

    /// The size, by place.
    #[must_use]
    fn abs(self) -> Self;

    /// The components of each vector in the other's place.
    #[must_use]
    fn crossed(self) -> Self;

    /// k x each vector.
    #[must_use]
    fn perp(self) -> Self;

    /// x * y - z, rounded once.
    #[must_use]
    fn times_less(self, y: Self, z: Self) -> Self;

    /// The sum of both vectors, for each; of one alone, this one.
    #[must_use]
    fn total(self) -> Self;

    /// Its x beside the other one's y.
    #[must_use]
    fn beside(self, other: Self) -> Self;

    /// Whether it is above another one in all places; not where one is no number.
    fn exceeds(self, other: Self) -> bool;

    /// The first vector.
    fn first(self) -> Self::One;

    /// One of the vectors.
    fn vector(self, which: usize) -> Vec2;

    /// The number that belongs to one of the vectors.
    #[inline(always)]
    fn number(self, which: usize) -> f64 {
        self.vector(which).x
    }

    /// The x of each vector in both places,
    #[inline(always)]
    #[must_use]
    fn x(self) -> Self {
        self.beside(self.crossed())
    }

    /// and the y.
    #[inline(always)]
    #[must_use]
    fn y(self) -> Self {
        self.crossed().beside(self)
    }

    /// The sum of the components' sizes.
    #[inline(always)]
    #[must_use]
    fn size(self) -> Self {
        self.abs().joined()
    }

    /// The sum of the components.
    #[inline(always)]
    #[must_use]
    fn joined(self) -> Self {
        self + self.crossed()
    }

    /// The scalar product.
    #[inline(always)]
    #[must_use]
    fn dot(self, other: Self) -> Self {
        (self * other).joined()
    }

    /// The product by place, as its rounded value and what that leaves out, exactly but for underflow (Dekker);
    /// `FUSED` to the same bits by fused multiplication and subtraction, in code that is compiled for it.
    #[inline(always)]
    #[must_use]
    fn times<const FUSED: bool>(self, other: Self) -> [Self; 2] {
        let product = self * other;
        if FUSED {
            return [product, self.times_less(other, product)];
        }
        let [(top, tail), (its_top, its_tail)] = [self, other].map(split);
        let rest = (top * its_top - product) + top * its_tail + tail * its_top;
        [product, rest + tail * its_tail]
    }

    /// The rounded sum, and what that leaves out (Knuth).
    #[inline(always)]
    #[must_use]
    fn plus(self, other: Self) -> [Self; 2] {
        let sum = self + other;
        let back = sum - self;
        [sum, (self - (sum - back)) + (other - back)]
    }
}

#[inline(always)]
fn split<V: Plane>(value: V) -> (V, V) {
    let much = value * SPLITTER;
    let top = much - (much - value);
    (top, value - top)
}

/// What vectors of any width do by place: one list, since no trait of the machine's vectors has all of it.
macro_rules! place_by_place {
    () => {
        #[inline(always)]
        fn all(self, value: f64) -> Self {
            Self::splat(self.simd, value)
        }

        #[inline(always)]
        fn abs(self) -> Self {
            SimdBase::abs(self)
        }

        #[inline(always)]
        fn crossed(self) -> Self {
            self.slide_within_blocks::<1>(self)
        }

        #[inline(always)]
        fn times_less(self, y: Self, z: Self) -> Self {
            self.mul_sub_precise(y, z)
        }

        #[inline(always)]
        fn exceeds(self, other: Self) -> bool {
            self.simd_gt(other).all_true()
        }
    };
}

impl<S: Simd> Plane for f64x2<S> {
    type One = Self;

    place_by_place!();

    #[inline(always)]
    fn perp(self) -> Self {
        let sign = u64x2::simd_from(self.simd, [SIGN, 0]);
        f64x2::from_bits(self.crossed().to_bits() ^ sign)
    }

    #[inline(always)]
    fn total(self) -> Self {
        self
    }

    #[inline(always)]
    fn beside(self, other: Self) -> Self {
        mask64x2::simd_from(self.simd, [0, -1]).select(other, self)
    }

    #[inline(always)]
    fn first(self) -> Self {
        self
    }

    #[inline(always)]
    fn vector(self, _: usize) -> Vec2 {
        Vec2::new(self[0], self[1])
    }
}

impl<S: Simd> Plane for f64x4<S> {
    type One = f64x2<S>;

    place_by_place!();

    #[inline(always)]
    fn perp(self) -> Self {
        let sign = u64x4::simd_from(self.simd, [SIGN, 0, SIGN, 0]);
        f64x4::from_bits(self.crossed().to_bits() ^ sign)
    }

    #[inline(always)]
    fn total(self) -> Self {
        self + others(self)
    }

    #[inline(always)]
    fn beside(self, other: Self) -> Self {
        mask64x4::simd_from(self.simd, [0, -1, 0, -1]).select(other, self)
    }

    #[inline(always)]
    fn first(self) -> f64x2<S> {
        self.split().0
    }

    #[inline(always)]
    fn vector(self, which: usize) -> Vec2 {
        Vec2::new(self[2 * which], self[2 * which + 1])
    }
}

/// Each vector in the place of the other one.
#[inline(always)]
pub(crate) fn others<S: Simd>(of: f64x4<S>) -> f64x4<S> {
    of.slide::<2>(of)
}

/// Each vector alone.
#[inline(always)]
pub(crate) fn halves<S: Simd>(of: f64x4<S>) -> [f64x2<S>; 2] {
    let (one, two) = of.split();
    [one, two]
}

/// Two vectors, side by side.
#[inline(always)]
pub(crate) fn both<S: Simd>(one: f64x2<S>, two: f64x2<S>) -> f64x4<S> {
    one.combine(two)
}

/// A vector in a register.
#[inline(always)]
pub(crate) fn vector<S: Simd>(simd: S, v: Vec2) -> f64x2<S> {
    f64x2::simd_from(simd, [v.x, v.y])
}

/// A number that belongs to a vector.
#[inline(always)]
pub(crate) fn number<S: Simd>(simd: S, value: f64) -> f64x2<S> {
    f64x2::splat(simd, value)
}

/// The components of two vectors in pairs: both x, both y.
#[inline(always)]
pub(crate) fn paired<S: Simd>(one: f64x2<S>, two: f64x2<S>) -> [f64x2<S>; 2] {
    [one.zip_low(two), one.zip_high(two)]
}
