//! Computes means over a smooth cycle by the trapezoidal rule.
//!
//! For a smooth periodic function its error decreases faster than any power of the number of places
//! (Trefethen and Weideman 2014, The exponentially convergent trapezoidal rule, SIAM Review 56).
//! The number of places is doubled until two rules agree.

use super::torque_pieces::Sampler;
use super::{CHANNELS, MOMENT, TORQUES};

/// The means of the channels and of their squares; the squares of the force's components add up to
/// that of the force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Means {
    pub(super) mean: [f64; CHANNELS],
    pub(super) square: [f64; CHANNELS],
}

/// Means and their error estimate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Periodic {
    pub(super) means: Means,
    /// The largest difference between the last two rules, relative to the channel's size.
    pub(super) error: f64,
    pub(super) places: usize,
}

const FIRST: usize = 32;
const MAX_COUNT: usize = 8192;
/// The difference below which two rules are equal in double precision.
const RULE_TOLERANCE: f64 = 1e-14;
/// The offset of the first place, in steps: change points are at round angles.
const PLACE_OFFSET: f64 = 0.37;

/// Computes the means over the travel. Returns `None` if a place has no values, or if the rules do
/// not agree to `most` relative to the channels' `size`.
pub(super) fn periodic(
    sampler: &mut Sampler,
    size: impl Fn(usize) -> f64,
    maximum: f64,
) -> Option<Periodic> {
    let length = sampler.course.length();
    let step = length / FIRST as f64;
    let mut sums = Means::default();
    for k in 0..FIRST {
        sums.add(sampler.channels((k as f64 + PLACE_OFFSET) * step)?);
    }
    let mut places = FIRST;
    let mut means = sums.over(places);
    let mut last = f64::INFINITY;
    while places < MAX_COUNT {
        // Half-way between the existing places.
        let step = length / places as f64;
        let first = PLACE_OFFSET * length / FIRST as f64 + 0.5 * step;
        for k in 0..places {
            sums.add(sampler.channels((first + k as f64 * step) % length)?);
        }
        places *= 2;
        let finer = sums.over(places);
        let error = means.differs(&finer, &size);
        means = finer;
        // Rounding errors do not decrease further.
        if error <= RULE_TOLERANCE || (error <= maximum && error >= 0.5 * last) {
            return Some(Periodic {
                means,
                error,
                places,
            });
        }
        last = error;
    }
    None
}

impl Means {
    fn add(&mut self, channels: [f64; CHANNELS]) {
        for (i, v) in channels.into_iter().enumerate() {
            self.mean[i] += v;
            self.square[i] += v * v;
        }
    }

    fn over(&self, count: usize) -> Means {
        Means {
            mean: self.mean.map(|v| v / count as f64),
            square: self.square.map(|v| v / count as f64),
        }
    }

    fn differs(&self, other: &Means, size: impl Fn(usize) -> f64) -> f64 {
        let one = |channel: usize| {
            let size = size(channel);
            let mean = (self.mean[channel] - other.mean[channel]).abs();
            let square = (self.square[channel] - other.square[channel]).abs();
            let share = (mean / size).max(square / (size * size));
            if size > 0.0 { share } else { 0.0 }
        };
        (0..CHANNELS).map(one).fold(0.0, f64::max)
    }

    /// Returns the root mean square of the force on the ground.
    pub(super) fn force(&self) -> f64 {
        self.square[TORQUES..MOMENT]
            .iter()
            .sum::<f64>()
            .max(0.0)
            .sqrt()
    }

    pub(super) fn root(&self, channel: usize) -> f64 {
        self.square[channel].max(0.0).sqrt()
    }
}
