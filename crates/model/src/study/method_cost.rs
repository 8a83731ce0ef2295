//! Counts and times one method.

use super::findings::{IterationCounts, MethodErrors};
use crate::solver::Deviation;
use std::collections::BTreeMap;
use std::time::Duration;

/// The error, relative to the longest length, beyond which a result counts as another assembly, or
/// as no result.
const MISSED: f64 = 0.1;

/// The largest deviations, and the number of failures.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    worst: Deviation,
    pub(super) tried: u64,
    pub(super) failures: u64,
    /// The number of results by their number of iterations.
    iterations: BTreeMap<u32, u64>,
}

impl Tally {
    /// Notes the deviation of one result, `None` if there was none; returns `true` if the result
    /// counts as found.
    pub(super) fn note(&mut self, deviation: Option<Deviation>) -> bool {
        self.tried += 1;
        let met = deviation.filter(|d| d.is_finite() && d.position <= MISSED);
        match met {
            Some(deviation) => self.worst = self.worst.max(deviation),
            None => self.failures += 1,
        }
        met.is_some()
    }

    /// Notes the number of iterations of a result, if its method counts them.
    pub(super) fn count(&mut self, iterations: Option<u32>) {
        if let Some(iterations) = iterations {
            *self.iterations.entry(iterations).or_default() += 1;
        }
    }

    /// Returns the median and the maximum number of iterations; `None` if none were counted.
    pub(super) fn iterations(&self) -> Option<IterationCounts> {
        let all: u64 = self.iterations.values().sum();
        let mut so_far = 0;
        let mut median = self.iterations.iter().skip_while(|(_, often)| {
            so_far += **often;
            2 * so_far < all
        });
        Some(IterationCounts {
            median: *median.next()?.0,
            most: *self.iterations.last_key_value()?.0,
        })
    }

    /// Returns the errors, those of rates relative to the largest velocity and acceleration; `None`
    /// if every result failed.
    pub(super) fn errors(&self, sizes: Deviation) -> Option<MethodErrors> {
        let part = |error: f64, size: f64| if error > 0.0 { error / size } else { 0.0 };
        (self.failures < self.tried).then(|| MethodErrors {
            position: self.worst.position,
            velocity: part(self.worst.velocity, sizes.velocity),
            acceleration: part(self.worst.acceleration, sizes.acceleration),
        })
    }
}

/// Minimum duration of a sample: a thousand times the time of reading a clock.
const MIN_LEN: Duration = Duration::from_micros(500);
/// Maximum number of repetitions per sample, in case the clock does not advance.
const MAX_COUNT: usize = 1 << 20;

/// A stopwatch for short operations; a sample repeats an operation until the clock can resolve it.
#[derive(Clone, Debug)]
pub(super) struct Stopwatch {
    count: usize,
    samples: Vec<f64>,
}

impl Default for Stopwatch {
    fn default() -> Self {
        Stopwatch {
            count: 1,
            samples: Vec::new(),
        }
    }
}

impl Stopwatch {
    pub(super) fn samples(&self) -> &[f64] {
        &self.samples
    }

    /// Calls `run` with a number of repetitions, `most` at the maximum, and stores the time of one
    /// repetition as a sample. Returns `false` if the time was too short; the next call then has
    /// twice the repetitions.
    pub(super) fn take(
        &mut self,
        clock: &mut dyn FnMut() -> Duration,
        maximum: usize,
        run: impl FnOnce(usize),
    ) -> bool {
        let count = self.count.min(maximum);
        let started = clock();
        run(count);
        let taken = clock().saturating_sub(started);
        if taken < MIN_LEN && count < MAX_COUNT {
            self.count = count.max(self.count / 2) * 2;
            return false;
        }
        self.samples.push(taken.as_secs_f64() / count as f64);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn off(position: f64) -> Option<Deviation> {
        Some(Deviation {
            position,
            velocity: 2.0 * position,
            acceleration: 0.0,
        })
    }

    #[test]
    fn far_solutions_count_as_failures() {
        let mut tally = Tally::default();
        for deviation in [off(1e-9), off(0.5), off(f64::NAN), None, off(1e-12)] {
            tally.note(deviation);
        }
        assert_eq!((tally.tried, tally.failures), (5, 3));
        let sizes = Deviation {
            position: 0.0,
            velocity: 4.0,
            acceleration: 0.0,
        };
        let errors = tally.errors(sizes).unwrap();
        assert_eq!((errors.position, errors.velocity), (1e-9, 0.5e-9));
        assert_eq!(errors.acceleration, 0.0);
    }

    #[test]
    fn iterations_report_median_and_maximum() {
        let mut tally = Tally::default();
        assert_eq!(tally.iterations(), None);
        for count in [Some(4), Some(9), None, Some(3), Some(4), Some(3)] {
            tally.count(count);
        }
        let counts = IterationCounts { median: 4, most: 9 };
        assert_eq!(tally.iterations(), Some(counts));
    }

    #[test]
    fn method_without_successes_has_no_errors() {
        let mut tally = Tally::default();
        tally.note(None);
        assert_eq!(tally.errors(Deviation::default()), None);
    }

    /// The clock advances by 700 ns for each repetition.
    #[test]
    fn stopwatch_doubles_repetitions_until_long_enough() {
        let now = std::cell::Cell::new(Duration::ZERO);
        let one = Duration::from_nanos(700);
        let mut watch = Stopwatch::default();
        let mut tries = 0;
        while watch.samples().is_empty() {
            tries += 1;
            watch.take(&mut || now.get(), usize::MAX, |count| {
                now.set(now.get() + one * u32::try_from(count).unwrap());
            });
        }
        assert_eq!(tries, 11, "1, 2, 4, ... 1024 repetitions");
        assert!((watch.samples()[0] - 700e-9).abs() < 1e-12);
    }

    #[test]
    fn stopwatch_ends_with_a_stopped_clock() {
        let mut watch = Stopwatch::default();
        for _ in 0..21 {
            watch.take(&mut || Duration::ZERO, usize::MAX, |_| {});
        }
        assert_eq!(watch.samples().len(), 1);
    }
}
