//! How a dyad is being stretched.

use crate::Vec2;

/// A sum of velocities or accelerations below this part of its largest term is rounding.
const ROUNDING: f64 = 1e-13;

/// The motion that stretches a dyad: its component along `toward` changes the reach, the distance of the pivots
/// or of pivot and guide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Stretching {
    pub(in crate::solver) toward: Vec2,
    /// How fast the reach grows, times the length of `toward`, by the driver's coordinate.
    pub(in crate::solver) growth: f64,
    /// The relative velocity of both ends, by the driver's coordinate.
    pub(in crate::solver) v: Vec2,
    /// Its derivative where it is zero.
    pub(in crate::solver) a: Vec2,
}

impl Stretching {
    /// The rate of the reach for unit speed and, up to a positive factor, unit reach: the cosine of an angle
    /// between links. `None` where nothing moves.
    pub(in crate::solver) fn rate(&self) -> Option<f64> {
        let rate = self.growth / self.v.norm();
        rate.is_finite().then_some(rate)
    }

    /// Whether nothing moves, and nothing begins to.
    pub(in crate::solver) fn rests(&self) -> bool {
        self.v == Vec2::ZERO && self.a == Vec2::ZERO
    }

    /// As [`Stretching::rate`], 0 where nothing moves; beside a standstill, towards `sense`, what begins the motion.
    pub(in crate::solver) fn rate_from(&self, sense: f64, is_still: bool) -> f64 {
        match is_still {
            true => self.rate_beside(sense),
            false => self.rate().unwrap_or(0.0),
        }
    }

    /// The sign that the rate has just beside a place at which the motion turns back, towards `sense`.
    pub(in crate::solver) fn rate_beside(&self, sense: f64) -> f64 {
        sense * self.toward.dot(self.a)
    }
}

/// Adds vectors that may cancel: a sum that is all rounding is zero.
pub(in crate::solver) fn sum<const N: usize>(terms: [Vec2; N]) -> Vec2 {
    let sum = terms.into_iter().fold(Vec2::ZERO, |sum, term| sum + term);
    let largest = terms.iter().fold(0.0, |most, term| term.norm().max(most));
    let is_rounding = sum.norm() <= ROUNDING * largest;
    if is_rounding { Vec2::ZERO } else { sum }
}
