//! Random numbers for tests, from the kernel's generator.

use kinematics::numeric::SeededRng;

/// A generator that returns the same numbers for the same seed.
pub(crate) struct TestRng(SeededRng);

impl TestRng {
    pub(crate) fn new(seed: u64) -> TestRng {
        TestRng(SeededRng::new(seed))
    }

    /// Returns an integer below `count`, which must not be zero.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        let last = u32::try_from(count - 1).unwrap();
        self.0.between(0, last) as usize
    }

    /// Returns a number from `low` to `high`.
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0.within(low, high)
    }

    /// Returns `true` with this probability.
    pub(crate) fn is(&mut self, part: f64) -> bool {
        self.within(0.0, 1.0) < part
    }

    /// Returns 1 or -1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.is(0.5) { 1.0 } else { -1.0 }
    }

    /// Returns one of several values.
    pub(crate) fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}
