//! Random numbers for tests, from the kernel's generator.

use crate::numeric::SeededRng;

/// A generator that returns the same numbers for the same seed.
pub(crate) struct TestRng(SeededRng);

impl TestRng {
    pub(crate) fn new(seed: u64) -> TestRng {
        TestRng(SeededRng::new(seed))
    }

    /// Returns a number below `count`, or 0 if `count` is 0.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        let last = u32::try_from(count.saturating_sub(1)).unwrap();
        self.0.between(0, last) as usize
    }

    /// Returns a number below `count` as `u16`.
    #[cfg(feature = "tui")]
    pub(crate) fn small(&mut self, count: u16) -> u16 {
        u16::try_from(self.below(count.into())).unwrap()
    }

    /// Returns a number from `low` to `high`.
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0.within(low, high)
    }

    /// Returns any byte.
    pub(crate) fn byte(&mut self) -> u8 {
        u8::try_from(self.below(256)).unwrap()
    }

    /// Returns one of several elements.
    pub(crate) fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        self.0.one_of(all).unwrap()
    }
}
