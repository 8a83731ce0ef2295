//! Runs successive searches on several cores and reports their common progress.

use kinematics::parallel;

/// The number of threads and the receiver of the completed part.
pub(super) struct Stages<'w> {
    threads: usize,
    watch: &'w mut dyn FnMut(f64) -> bool,
    is_on: bool,
}

impl<'w> Stages<'w> {
    pub(super) fn new(threads: usize, watch: &'w mut dyn FnMut(f64) -> bool) -> Stages<'w> {
        Stages {
            threads,
            watch,
            is_on: true,
        }
    }

    /// Returns `true` unless the search was stopped.
    pub(super) fn is_on(&self) -> bool {
        self.is_on
    }

    /// Runs `count` pieces of work, which advance the progress from one part to another, and
    /// returns their results in order. After a stop, none of them starts.
    pub(super) fn each<T: Send>(
        &mut self,
        [from, to]: [f64; 2],
        count: usize,
        work: impl Fn(usize) -> T + Sync,
    ) -> Vec<T> {
        if !self.is_on {
            return Vec::new();
        }
        let work = |(): &mut (), i: usize| work(i);
        parallel::each(count, self.threads, || (), work, &mut |part| {
            // A piece that ends after a stop must not cancel the stop.
            self.is_on &= (self.watch)(from + (to - from) * part);
            self.is_on
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stop_prevents_all_later_stages() {
        let mut parts = Vec::new();
        let mut watch = |part| {
            parts.push(part);
            parts.len() != 2
        };
        let mut stages = Stages::new(1, &mut watch);
        assert!(stages.each([0.0, 0.5], 4, |i| i).len() >= 2 && !stages.is_on());
        assert!(stages.each([0.5, 1.0], 4, |i| i).is_empty());
        assert_eq!(parts[..2], [0.125, 0.25]);
    }
}
