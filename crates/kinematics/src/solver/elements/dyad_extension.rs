//! Describes how a dyad is being stretched.

use crate::Vec2;

/// A sum of velocities or accelerations below this fraction of its largest term counts as rounding
/// error.
const ROUNDING: f64 = 1e-13;

/// The rate at which a dyad is being stretched, that is, the distance of its pivots, or of pivot
/// and guide, changes.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Stretching {
    /// The direction in which the distance grows, not normalized.
    pub(in crate::solver) toward: Vec2,
    /// The growth rate of the distance, times the length of `toward`, by the driver's coordinate.
    pub(in crate::solver) growth: f64,
    /// The relative motion of both ends, seen from the ground and from a link that carries one of
    /// them. Relative to the frame of an input, it stops and reverses together with the input.
    pub(in crate::solver) seen: [RelativeMotion; FRAMES],
}

/// Number of frames from which the ends of a dyad are observed.
pub(in crate::solver) const FRAMES: usize = 2;

/// The motion of one end of a dyad relative to the other.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct RelativeMotion {
    /// The velocity, by the driver's coordinate.
    pub(in crate::solver) v: Vec2,
    /// The derivative of the velocity where the velocity is zero.
    pub(in crate::solver) a: Vec2,
}

impl Stretching {
    /// Returns the rate of the distance for unit speed and, up to a positive factor, unit distance:
    /// the cosine of an angle between links. Returns `None` at rest.
    pub(in crate::solver) fn rate(&self) -> Option<f64> {
        let rate = self.growth / self.seen[0].v.norm();
        let moves = rate.is_finite() && !self.is_at_rest();
        moves.then_some(rate)
    }

    /// Returns `true` if the ends are at rest relative to each other, without acceleration.
    pub(in crate::solver) fn is_at_rest(&self) -> bool {
        let mut seen = self.seen.iter();
        seen.any(|seen| seen.v == Vec2::ZERO && seen.a == Vec2::ZERO)
    }

    /// Returns the sign of the rate just next to a position where the motion in a frame stops or
    /// reverses, on the side of `sense`.
    pub(in crate::solver) fn adjacent_rate_sign(&self, frame: usize, sense: f64) -> f64 {
        sense * self.toward.dot(self.seen[frame].a)
    }
}

/// Adds vectors that may cancel; returns zero for a sum that is only rounding error.
pub(in crate::solver) fn sum<const N: usize>(terms: [Vec2; N]) -> Vec2 {
    let sum = terms.into_iter().fold(Vec2::ZERO, |sum, term| sum + term);
    let largest = terms
        .iter()
        .fold(0.0, |maximum, term| term.norm().max(maximum));
    let is_rounding = sum.norm() <= ROUNDING * largest;
    if is_rounding { Vec2::ZERO } else { sum }
}

/// Returns the value, or zero if it is only rounding error compared with its largest term.
pub(in crate::solver) fn settled(value: f64, largest: f64) -> f64 {
    let is_rounding = value.abs() <= ROUNDING * largest;
    if is_rounding { 0.0 } else { value }
}
