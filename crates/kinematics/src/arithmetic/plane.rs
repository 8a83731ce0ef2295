//! Implements plane vectors on the machine's vector registers: one, (x, y), or two, (x1, y1, x2,
//! y2).
//!
//! A scalar that belongs to a vector fills both of its lanes; one that belongs to both vectors
//! fills all four. A formula is therefore written once, for one vector or for two at once, and
//! lanes are exchanged only where components are combined.

use super::double::SPLITTER;
use crate::Vec2;
use fearless_simd::prelude::*;
pub(crate) use fearless_simd::{Fallback, Simd, f64x2, f64x4};
use fearless_simd::{mask64x2, mask64x4, u64x2, u64x4};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The sign bit of a double.
const SIGN: u64 = 1 << 63;

/// One plane vector, or two in one register.
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
    /// The type of a single vector.
    type One: Plane;

    /// Returns a vector with `value` in all lanes.
    #[must_use]
    fn all(self, value: f64) -> Self;

    /// Returns the absolute value of each lane.
    #[must_use]
    fn abs(self) -> Self;

    /// Swaps the components of each vector.
    #[must_use]
    fn crossed(self) -> Self;

    /// Returns k x v for each vector v.
    #[must_use]
    fn perp(self) -> Self;

    /// Returns x * y - z, rounded once.
    #[must_use]
    fn times_less(self, y: Self, z: Self) -> Self;

    /// Returns the sum of both vectors in each place; a single vector is returned unchanged.
    #[must_use]
    fn total(self) -> Self;

    /// Returns the x components of `self` with the y components of `other`.
    #[must_use]
    fn with_y_of(self, other: Self) -> Self;

    /// Returns `true` if every lane is greater than `other`'s; `false` if one is NaN.
    fn exceeds(self, other: Self) -> bool;

    /// Returns the first vector.
    fn first(self) -> Self::One;

    /// Returns one of the vectors.
    fn vector(self, which: usize) -> Vec2;

    /// Returns the scalar that belongs to one of the vectors.
    #[inline(always)]
    fn number(self, which: usize) -> f64 {
        self.vector(which).x
    }

    /// Returns the x component of each vector in both of its lanes.
    #[inline(always)]
    #[must_use]
    fn x(self) -> Self {
        self.with_y_of(self.crossed())
    }

    /// Returns the y component of each vector in both of its lanes.
    #[inline(always)]
    #[must_use]
    fn y(self) -> Self {
        self.crossed().with_y_of(self)
    }

    /// Returns the sum of the components' absolute values.
    #[inline(always)]
    #[must_use]
    fn size(self) -> Self {
        self.abs().joined()
    }

    /// Returns the sum of the components.
    #[inline(always)]
    #[must_use]
    fn joined(self) -> Self {
        self + self.crossed()
    }

    /// Returns the scalar product.
    #[inline(always)]
    #[must_use]
    fn dot(self, other: Self) -> Self {
        (self * other).joined()
    }

    /// Returns the lane-wise product as its rounded value and rounding error; exact except for
    /// underflow (Dekker). With `FUSED`, it uses fused multiply-subtract with the same bits, in
    /// code compiled for that.
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

    /// Returns the rounded sum and its rounding error (Knuth).
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

/// Lane-wise methods for vectors of any width, in one macro because no trait of the vector library
/// has all of them.
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
    fn with_y_of(self, other: Self) -> Self {
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
    fn with_y_of(self, other: Self) -> Self {
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

/// Exchanges the two vectors.
#[inline(always)]
pub(crate) fn others<S: Simd>(of: f64x4<S>) -> f64x4<S> {
    of.slide::<2>(of)
}

/// Splits the two vectors.
#[inline(always)]
pub(crate) fn halves<S: Simd>(of: f64x4<S>) -> [f64x2<S>; 2] {
    let (one, two) = of.split();
    [one, two]
}

/// Combines two vectors in one register.
#[inline(always)]
pub(crate) fn both<S: Simd>(one: f64x2<S>, two: f64x2<S>) -> f64x4<S> {
    one.combine(two)
}

/// Loads a vector into a register.
#[inline(always)]
pub(crate) fn vector<S: Simd>(simd: S, v: Vec2) -> f64x2<S> {
    f64x2::simd_from(simd, [v.x, v.y])
}

/// Fills both lanes with a scalar.
#[inline(always)]
pub(crate) fn number<S: Simd>(simd: S, value: f64) -> f64x2<S> {
    f64x2::splat(simd, value)
}

/// Regroups the components of two vectors: both x, both y.
#[inline(always)]
pub(crate) fn paired<S: Simd>(one: f64x2<S>, two: f64x2<S>) -> [f64x2<S>; 2] {
    [one.zip_low(two), one.zip_high(two)]
}
