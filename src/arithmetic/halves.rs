//! Exact products of numbers that take part in several of them.

use super::Double;
use super::double::split;

/// A double and its two halves, split once: products of such are exact at half the price.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halves {
    whole: f64,
    top: f64,
    tail: f64,
}

impl Halves {
    /// Splits a double.
    #[inline(always)]
    pub(crate) fn of(whole: f64) -> Halves {
        let (top, tail) = split(whole);
        Halves { whole, top, tail }
    }

    /// The product, exactly but for underflow (Dekker).
    #[inline(always)]
    pub(crate) fn times(self, o: Halves) -> Double {
        let hi = self.whole * o.whole;
        let lo =
            ((self.top * o.top - hi) + self.top * o.tail + self.tail * o.top) + self.tail * o.tail;
        Double { hi, lo }
    }

    /// The square.
    #[inline(always)]
    pub(crate) fn square(self) -> Double {
        let hi = self.whole * self.whole;
        let lo = ((self.top * self.top - hi) + 2.0 * self.top * self.tail) + self.tail * self.tail;
        Double { hi, lo }
    }
}
