//! The driver's travel through one cycle.
//!
//! A driver that turns fully continues through whole turns; one with limits moves to and fro. The
//! travel w counts from 0 in the driver's own unit and always increases. At a limit that is a dead
//! point the torque can grow like 1 / sqrt(d) with the distance d from it, while its work stays
//! finite. There the travel is defined by q = low + (high - low) sin^2(phi / 2), which makes the
//! integrand smooth.

use crate::solver::Range;
use std::f64::consts::PI;

/// The travel of the driver through a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclePath {
    /// The minimum coordinate, in degrees or in the scene's length unit.
    pub low: f64,
    /// The maximum coordinate.
    pub high: f64,
    /// `true` if the cycle is periodic, `false` if the driver moves to and fro.
    pub is_periodic: bool,
    /// `true` if at least one end is a dead point.
    pub ends_at_dead_point: bool,
    /// `true` if the coordinate decreases first, because the driver's speed is negative.
    pub falls: bool,
}

/// The driver's place in the cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PathPosition {
    /// The driver's coordinate.
    pub(super) at: f64,
    /// `true` on the way back, with the opposite of the given speed.
    pub(super) back: bool,
    /// The derivative of the coordinate by the travel: 1 or -1, except between dead points.
    pub(super) weight: f64,
}

impl CyclePath {
    /// Creates the cycle of a motion: the period of a turning driver, repeated for loads with
    /// longer periods, or the range to and fro.
    #[must_use]
    pub fn new(range: Range, repeats: u32, falls: bool, dead_points: &[f64]) -> CyclePath {
        let (low, high, is_periodic) = match range {
            Range::Full { period } => (0.0, period * f64::from(repeats.max(1)), true),
            Range::Limited { low, high } => (low, high, false),
        };
        let is_dead = |end: &f64| dead_points.contains(end);
        CyclePath {
            low,
            high,
            is_periodic,
            ends_at_dead_point: !is_periodic && (is_dead(&low) || is_dead(&high)),
            falls,
        }
    }

    /// Creates the cycle of a part of the motion, to and fro.
    #[must_use]
    pub fn between(low: f64, high: f64, falls: bool, dead_points: &[f64]) -> CyclePath {
        CyclePath::new(Range::Limited { low, high }, 1, falls, dead_points)
    }

    /// Returns the length of the travel, in the driver's unit.
    #[must_use]
    pub fn length(&self) -> f64 {
        let once = self.high - self.low;
        if self.is_periodic { once } else { 2.0 * once }
    }

    /// Returns the travel until the driver first passes a coordinate, modulo the cycle if that is
    /// periodic. Returns `None` if it never does.
    #[must_use]
    pub fn way(&self, at: f64) -> Option<f64> {
        let at = if self.is_periodic {
            self.low + (at - self.low).rem_euclid(self.length())
        } else {
            at
        };
        let mut travels = Vec::new();
        self.ways(at, 0.0, &mut travels);
        travels.first().copied()
    }

    /// Returns the driver's place after this travel.
    pub(super) fn place(&self, travel: f64) -> PathPosition {
        let once = self.high - self.low;
        let back = !self.is_periodic && travel > once;
        let gone = if back { 2.0 * once - travel } else { travel };
        let sense = if back == self.falls { 1.0 } else { -1.0 };
        let (start, end) = if self.falls {
            (self.high, self.low)
        } else {
            (self.low, self.high)
        };
        if !self.ends_at_dead_point {
            // Each half is counted from its own end, so that both ends are exact.
            let (first, forth) = if self.is_periodic || 2.0 * gone < once {
                (start, gone)
            } else {
                (end, gone - once)
            };
            let at = if self.falls {
                first - forth
            } else {
                first + forth
            };
            return PathPosition {
                at,
                back,
                weight: sense,
            };
        }
        let phi = PI * gone / once;
        // Each half is counted from its own end, so that no digits are lost next to it.
        let part = |phi: f64| (0.5 * phi).sin().powi(2);
        let at = if 2.0 * gone < once {
            start + (end - start) * part(phi)
        } else {
            end - (end - start) * part(PI - phi)
        };
        PathPosition {
            at,
            back,
            weight: sense * 0.5 * PI * phi.sin(),
        }
    }

    /// Adds the travels at which the driver passes a coordinate; `every` is the coordinate's
    /// period, or 0.
    pub(super) fn ways(&self, at: f64, every: f64, to: &mut Vec<f64>) {
        let first = if every > 0.0 {
            self.low + (at - self.low).rem_euclid(every)
        } else {
            at
        };
        let mut at = first;
        while self.low <= at && at <= self.high {
            self.add_ways(at, to);
            at += every;
            if every <= 0.0 {
                break;
            }
        }
    }

    fn add_ways(&self, at: f64, to: &mut Vec<f64>) {
        let once = self.high - self.low;
        let up = if self.falls {
            self.high - at
        } else {
            at - self.low
        };
        let gone = if self.ends_at_dead_point {
            once * 2.0 / PI * (up / once).sqrt().asin()
        } else {
            up
        };
        to.push(gone);
        if !self.is_periodic {
            to.push(2.0 * once - gone);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITED: Range = Range::Limited {
        low: -10.0,
        high: 30.0,
    };

    #[test]
    fn full_turn_path_runs_in_either_direction() {
        let range = Range::Full { period: 360.0 };
        let up = CyclePath::new(range, 2, false, &[]);
        assert_eq!((up.length(), up.place(400.0).at), (720.0, 400.0));
        let down = CyclePath::new(range, 1, true, &[]);
        let place = down.place(90.0);
        assert_eq!((place.at, place.back, place.weight), (270.0, false, -1.0));
        let mut travels = Vec::new();
        up.ways(-30.0, 360.0, &mut travels);
        down.ways(90.0, 0.0, &mut travels);
        assert_eq!(travels, [330.0, 690.0, 270.0]);
    }

    #[test]
    fn limited_path_runs_there_and_back() {
        for dead in [&[][..], &[30.0]] {
            for falls in [false, true] {
                let course = CyclePath::new(LIMITED, 1, falls, dead);
                assert_eq!(course.length(), 80.0);
                let mut travels = Vec::new();
                course.ways(5.0, 0.0, &mut travels);
                assert_eq!(travels.len(), 2);
                let places = [course.place(travels[0]), course.place(travels[1])];
                assert!(
                    places.iter().all(|p| (p.at - 5.0).abs() < 1e-13),
                    "{places:?}"
                );
                assert!(!places[0].back && places[1].back);
                // The weight is the derivative of the coordinate by the travel.
                let slope = course.place(travels[0] + 1e-4).at - course.place(travels[0] - 1e-4).at;
                assert!((slope / 2e-4 - places[0].weight).abs() < 1e-7);
                assert_eq!(places[0].weight < 0.0, falls);
            }
        }
    }
}
