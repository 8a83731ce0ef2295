//! Exact products of numbers that take part in several of them.

use super::double::split;
use crate::Number;

/// A number and its two halves, split once: products of such are exact at half the price.
///
/// `FUSED` they are exact by fused multiplication and addition, to the same bits, and nothing is split. That is
/// for code that is compiled for it: see [`fused`](super::fused).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halves<T, const FUSED: bool> {
    whole: T,
    top: T,
    tail: T,
}

/// A product as its rounded value and what that leaves out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Product<T = f64> {
    pub(crate) hi: T,
    pub(crate) lo: T,
}

impl<T: Number, const FUSED: bool> Halves<T, FUSED> {
    /// Splits a number.
    #[inline(always)]
    pub(crate) fn of(whole: T) -> Self {
        let (top, tail) = if FUSED {
            (whole, T::default())
        } else {
            split(whole)
        };
        Halves { whole, top, tail }
    }

    /// The product, exactly but for underflow (Dekker).
    #[inline(always)]
    pub(crate) fn times(self, o: Self) -> Product<T> {
        let hi = self.whole * o.whole;
        if FUSED {
            let lo = self.whole.fused(o.whole, -hi);
            return Product { hi, lo };
        }
        let lo =
            ((self.top * o.top - hi) + self.top * o.tail + self.tail * o.top) + self.tail * o.tail;
        Product { hi, lo }
    }

    /// The square.
    #[inline(always)]
    pub(crate) fn square(self) -> Product<T> {
        if FUSED {
            return self.times(self);
        }
        let hi = self.whole * self.whole;
        let twice = self.top.scaled(2.0);
        let lo = ((self.top * self.top - hi) + twice * self.tail) + self.tail * self.tail;
        Product { hi, lo }
    }
}
