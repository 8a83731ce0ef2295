//! Measures the cost of solving a state, occasionally and not for every frame, and keeps the
//! displayed value steady.

use crate::report::time_text;
use std::time::{Duration, Instant};

/// Number of batches per measurement; the result is their median.
const BATCHES: usize = 5;
/// Approximate duration of a batch. A batch has at least one state.
const BATCH: Duration = Duration::from_micros(10);
/// Maximum number of states in a batch.
const MAX_STATES: u32 = 256;
/// Maximum relative change of a measurement that does not update the displayed value: the
/// resolution of the clock on a busy machine.
const EQUALITY_TOLERANCE: f64 = 0.2;
/// Significant digits of the displayed value.
const DIGITS: usize = 2;
/// Minimum time between two measurements.
pub(crate) const PAUSE: Duration = Duration::from_secs(1);

/// The displayed cost of a state, in seconds.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cost {
    shown: Option<f64>,
}

impl Cost {
    /// Measures the duration of `solve`.
    pub(crate) fn measure(&mut self, mut solve: impl FnMut()) {
        let mut time = |states: u32| {
            let started = Instant::now();
            (0..states).for_each(|_| solve());
            started.elapsed().as_secs_f64() / f64::from(states)
        };
        // The first call warms up and determines the number of states in a batch.
        let first = time(1).max(1e-9);
        let states = (1..=MAX_STATES)
            .rev()
            .find(|&n| f64::from(n) * first <= BATCH.as_secs_f64());
        let mut batches: [f64; BATCHES] = std::array::from_fn(|_| time(states.unwrap_or(1)));
        batches.sort_by(f64::total_cmp);
        self.take(batches[BATCHES / 2]);
    }

    fn take(&mut self, seconds: f64) {
        let stays = |shown: f64| (seconds - shown).abs() <= EQUALITY_TOLERANCE * shown;
        if !self.shown.is_some_and(stays) {
            self.shown = Some(seconds);
        }
    }

    /// Formats the cost: `61 ns`, `2.3 us`, `14 ms`.
    pub(crate) fn text(self) -> Option<String> {
        self.shown.map(|seconds| time_text(seconds, DIGITS))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn format_duration(seconds: f64) -> String {
        let mut cost = Cost::default();
        cost.take(seconds);
        cost.text().unwrap()
    }

    #[test]
    fn durations_show_two_digits_and_a_unit() {
        assert_eq!(format_duration(61.3e-9), "61 ns");
        assert_eq!(format_duration(9.96e-9), "10 ns");
        assert_eq!(format_duration(999.6e-9), "1.0 us");
        assert_eq!(format_duration(2.34e-6), "2.3 us");
        assert_eq!(format_duration(142e-9), "142 ns");
        assert_eq!(format_duration(0.0142), "14 ms");
        assert_eq!(format_duration(2.0), "2.0 s");
        assert_eq!(Cost::default().text(), None);
    }

    #[test]
    fn shown_duration_ignores_small_changes() {
        let mut cost = Cost::default();
        for seconds in [61e-9, 65e-9, 55e-9, 70e-9] {
            cost.take(seconds);
            assert_eq!(cost.text().unwrap(), "61 ns");
        }
        cost.take(90e-9);
        assert_eq!(cost.text().unwrap(), "90 ns");
    }

    #[test]
    fn measurement_is_limited_to_few_batches() {
        let mut cost = Cost::default();
        let mut states = 0;
        cost.measure(|| states += 1);
        assert!(cost.text().is_some());
        assert!(states <= 1 + BATCHES as u32 * MAX_STATES, "{states}");
    }
}
