//! What is counted and timed of one method.

use super::findings::{IterationCounts, MethodErrors};
use crate::solver::Deviation;
use std::collections::BTreeMap;
use std::time::Duration;

/// A result further away than this part of the longest length is another assembly, or no result.
const MISSED: f64 = 0.1;

/// The largest deviations, and how often there was none.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    worst: Deviation,
    pub(super) tried: u64,
    pub(super) failures: u64,
    /// How often so many iterations were taken.
    iterations: BTreeMap<u32, u64>,
}

impl Tally {
    /// Notes the deviation of one result, `None` where there was none; whether it was met.
    pub(super) fn note(&mut self, deviation: Option<Deviation>) -> bool {
        self.tried += 1;
        let met = deviation.filter(|d| d.is_finite() && d.position <= MISSED);
        match met {
            Some(deviation) => self.worst = self.worst.max(deviation),
            None => self.failures += 1,
        }
        met.is_some()
    }

    /// Notes how many iterations a result has taken, if its method counts them.
    pub(super) fn count(&mut self, iterations: Option<u32>) {
        if let Some(iterations) = iterations {
            *self.iterations.entry(iterations).or_default() += 1;
        }
    }

    /// How many iterations were taken.
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

    /// The errors as parts of the largest velocity and acceleration.
    pub(super) fn errors(&self, sizes: Deviation) -> Option<MethodErrors> {
        let part = |error: f64, size: f64| if error > 0.0 { error / size } else { 0.0 };
        (self.failures < self.tried).then(|| MethodErrors {
            position: self.worst.position,
            velocity: part(self.worst.velocity, sizes.velocity),
            acceleration: part(self.worst.acceleration, sizes.acceleration),
        })
    }
}

/// A sample takes at least this long: a thousand times what a clock takes to be read.
const SHORTEST: Duration = Duration::from_micros(500);
/// And is no more than so many repetitions, should the clock stand still.
const MOST: usize = 1 << 20;

/// Seconds for one of something, sampled by as many repetitions as a clock can tell.
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

    /// Runs something as often as its argument says, `most` times at the most, and keeps the time of
    /// one as a sample; false where that was too short, and the next will be twice as often.
    pub(super) fn take(
        &mut self,
        clock: &mut dyn FnMut() -> Duration,
        most: usize,
        run: impl FnOnce(usize),
    ) -> bool {
        let count = self.count.min(most);
        let begun = clock();
        run(count);
        let taken = clock().saturating_sub(begun);
        if taken < SHORTEST && count < MOST {
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
    fn what_is_far_away_is_a_failure_and_no_error() {
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
    fn iterations_are_told_by_median_and_most() {
        let mut tally = Tally::default();
        assert_eq!(tally.iterations(), None);
        for count in [Some(4), Some(9), None, Some(3), Some(4), Some(3)] {
            tally.count(count);
        }
        let counts = IterationCounts { median: 4, most: 9 };
        assert_eq!(tally.iterations(), Some(counts));
    }

    #[test]
    fn a_method_that_was_right_nowhere_has_no_errors() {
        let mut tally = Tally::default();
        tally.note(None);
        assert_eq!(tally.errors(Deviation::default()), None);
    }

    /// A clock that knows what each repetition takes.
    #[test]
    fn samples_are_long_enough_for_the_clock() {
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
    fn a_clock_that_stands_still_ends_it_too() {
        let mut watch = Stopwatch::default();
        for _ in 0..21 {
            watch.take(&mut || Duration::ZERO, usize::MAX, |_| {});
        }
        assert_eq!(watch.samples().len(), 1);
    }
}
