//! How a dyad is being stretched.

use crate::Vec2;

/// A sum of velocities or accelerations below this part of its largest term is rounding.
const ROUNDING: f64 = 1e-13;

/// How fast a dyad is being stretched: how its reach changes, the distance of the pivots or of pivot and guide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Stretching {
    /// The direction in which the reach grows, not of unit length.
    pub(in crate::solver) toward: Vec2,
    /// How fast the reach grows, times the length of `toward`, by the driver's coordinate.
    pub(in crate::solver) growth: f64,
    /// How both ends move against each other, seen from the ground and from a link that carries one of them: relative
    /// to the frame of an input this stops, and turns back, as the input does.
    pub(in crate::solver) seen: [RelativeMotion; FRAMES],
}

/// The frames in which the ends of a dyad are looked at.
pub(in crate::solver) const FRAMES: usize = 2;

/// How one end of a dyad moves against the other.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct RelativeMotion {
    /// The velocity, by the driver's coordinate.
    pub(in crate::solver) v: Vec2,
    /// Its derivative where it is zero.
    pub(in crate::solver) a: Vec2,
}

impl Stretching {
    /// The rate of the reach for unit speed and, up to a positive factor, unit reach: the cosine of an angle
    /// between links. `None` where nothing moves.
    pub(in crate::solver) fn rate(&self) -> Option<f64> {
        let rate = self.growth / self.seen[0].v.norm();
        let moves = rate.is_finite() && !self.rests();
        moves.then_some(rate)
    }

    /// Whether nothing moves, and nothing begins to.
    pub(in crate::solver) fn rests(&self) -> bool {
        let mut seen = self.seen.iter();
        seen.any(|seen| seen.v == Vec2::ZERO && seen.a == Vec2::ZERO)
    }

    /// The sign that the rate has just beside a place at which the motion in a frame stops or turns back, towards
    /// `sense`.
    pub(in crate::solver) fn rate_beside(&self, frame: usize, sense: f64) -> f64 {
        sense * self.toward.dot(self.seen[frame].a)
    }
}

/// Adds vectors that may cancel: a sum that is all rounding is zero.
pub(in crate::solver) fn sum<const N: usize>(terms: [Vec2; N]) -> Vec2 {
    let sum = terms.into_iter().fold(Vec2::ZERO, |sum, term| sum + term);
    let largest = terms.iter().fold(0.0, |most, term| term.norm().max(most));
    let is_rounding = sum.norm() <= ROUNDING * largest;
    if is_rounding { Vec2::ZERO } else { sum }
}

/// A value that is all rounding against the largest of its terms is zero.
pub(in crate::solver) fn settled(value: f64, largest: f64) -> f64 {
    let is_rounding = value.abs() <= ROUNDING * largest;
    if is_rounding { 0.0 } else { value }
}
