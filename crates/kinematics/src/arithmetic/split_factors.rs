//! Computes exact products of numbers that occur in several products.

use super::double::split;

/// A number with its two halves, split once, so that exact products cost half as much.
///
/// With `FUSED`, products are exact by fused multiply-add, with the same bits, and nothing is
/// split. Use this only in code compiled for that instruction: see [`fused`](super::fused).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halves<const FUSED: bool> {
    whole: f64,
    top: f64,
    tail: f64,
}

/// A product as its rounded value `hi` and rounding error `lo`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Product {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl<const FUSED: bool> Halves<FUSED> {
    /// Splits a number.
    #[inline(always)]
    pub(crate) fn of(complete: f64) -> Self {
        let (top, tail) = if FUSED {
            (complete, 0.0)
        } else {
            split(complete)
        };
        Halves {
            whole: complete,
            top,
            tail,
        }
    }

    /// Returns the product; exact except for underflow (Dekker).
    #[inline(always)]
    pub(crate) fn times(self, o: Self) -> Product {
        let hi = self.whole * o.whole;
        if FUSED {
            let lo = self.whole.mul_add(o.whole, -hi);
            return Product { hi, lo };
        }
        let lo =
            ((self.top * o.top - hi) + self.top * o.tail + self.tail * o.top) + self.tail * o.tail;
        Product { hi, lo }
    }

    /// Returns the square; exact except for underflow.
    #[inline(always)]
    pub(crate) fn square(self) -> Product {
        if FUSED {
            return self.times(self);
        }
        let hi = self.whole * self.whole;
        let twice = 2.0 * self.top;
        let lo = ((self.top * self.top - hi) + twice * self.tail) + self.tail * self.tail;
        Product { hi, lo }
    }
}
