//! Extents of the linkage's poses along its motion, for a window that follows it.
//!
//! A window that follows every pose would shake. A fixed window makes a linkage small if its motion
//! needs much more space than any single pose. Here the window depends on the driver's coordinate
//! alone, so that each place looks the same however it was reached. Its extents are the mean over
//! nearby poses, which changes slowly. The excess of poses beyond the mean is smoothed too: each
//! place takes the maximum over close places, and the mean of these is added.
//!
//! Places are spaced evenly along a turn. Between two limits they are denser towards the limits,
//! like the projection of evenly spaced points of a circle, because the linkage is fastest there.

use crate::Vec2;
use crate::drawing::bounds::Bounds;
use std::f64::consts::PI;

/// Number of places along the motion.
const PLACES: usize = 120;
/// Number of places on either side in the mean: 18 degrees of a turn.
const NEARBY: usize = 6;
/// Number of places on either side for the excess of poses beyond the mean.
const CLOSE: usize = 3;

/// The poses of a motion: the extents of each, and smoothed extents for windows.
#[derive(Clone, Debug, Default)]
pub(in crate::drawing) struct Poses {
    /// Start and length of the motion, in the driver's coordinate.
    start: f64,
    span: f64,
    /// `true` if the motion ends where it begins.
    closed: bool,
    /// The extents of the single pose at each place.
    alone: Vec<Bounds>,
    /// The smoothed extents that the window is fitted to at each place.
    smoothed: Vec<Bounds>,
    /// The extents of arrow tips at each place; empty without arrows.
    tips: Vec<Bounds>,
}

/// The extents that a window must contain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::drawing) struct PoseExtents {
    pub(in crate::drawing) linkage: Bounds,
    /// The extents of arrow tips; empty without arrows.
    pub(in crate::drawing) tips: Bounds,
}

impl Poses {
    /// Computes smoothed extents from poses; `met` holds coordinates in the motion and their
    /// extents.
    pub(in crate::drawing) fn new(
        [start, span]: [f64; 2],
        closed: bool,
        met: &[(f64, Bounds)],
    ) -> Poses {
        let mut poses = Poses {
            start,
            span,
            closed,
            ..Poses::default()
        };
        let known = met.iter().filter(|(_, space)| !space.is_empty());
        let met: Vec<(f64, Bounds)> = known
            .filter_map(|&(at, space)| Some((poses.place(at)?, space)))
            .collect();
        if met.is_empty() {
            return Poses::default();
        }
        let places = || (0..=PLACES).map(|place| place as f64);
        let alone = places().map(|place| {
            let nearest = met
                .iter()
                .min_by(|a, b| poses.far(a.0, place).total_cmp(&poses.far(b.0, place)));
            nearest.map_or_else(Bounds::default, |&(_, space)| space)
        });
        let alone: Vec<Bounds> = alone.collect();
        let means = poses.means(&alone, NEARBY);
        // Extents between two places are interpolated, so each must contain every pose up to the
        // other.
        let held = poses.union_near(&met, 1.0).into_iter().zip(&alone);
        let beyond = held.zip(&means).map(|((held, alone), mean)| Bounds {
            low: (held.with(*alone).low - mean.low).map(|by| by.min(0.0)),
            high: (held.with(*alone).high - mean.high).map(|by| by.max(0.0)),
        });
        let beyond: Vec<Bounds> = beyond.collect();
        let beyond = poses.means(&poses.union_within(&beyond, CLOSE), CLOSE);
        let smoothed = means.iter().zip(&beyond).map(|(mean, beyond)| Bounds {
            low: mean.low + beyond.low,
            high: mean.high + beyond.high,
        });
        poses.smoothed = smoothed.collect();
        poses.alone = alone;
        poses
    }

    /// Adds the extents of arrow tips at these coordinates.
    pub(in crate::drawing) fn with_tips(mut self, tips: &[(f64, Bounds)]) -> Poses {
        if self.smoothed.is_empty() {
            return self;
        }
        let known = tips.iter().filter(|(_, space)| !space.is_empty());
        let known = known.filter_map(|&(at, space)| Some((self.place(at)?, space)));
        // One coordinate may have hundreds of arrows; their extents are united first.
        let mut met: Vec<(f64, Bounds)> = Vec::new();
        for (place, space) in known {
            match met.last_mut() {
                Some((last, all)) if *last == place => *all = all.with(space),
                _ => met.push((place, space)),
            }
        }
        let held = self.union_near(&met, 1.0);
        self.tips = self.means(&self.union_within(&held, CLOSE), CLOSE);
        self
    }

    /// Adds further extents at every place, as a function of the coordinate.
    pub(in crate::drawing) fn with_extents(mut self, other: impl Fn(f64) -> Bounds) -> Poses {
        for index in 0..self.smoothed.len() {
            let there = other(self.coordinate(index as f64));
            self.alone[index] = self.alone[index].with(there);
            self.smoothed[index] = self.smoothed[index].with(there);
        }
        self
    }

    /// Returns for each place the union of the extents met within `near` places.
    fn union_near(&self, met: &[(f64, Bounds)], near: f64) -> Vec<Bounds> {
        let mut spaces = vec![Bounds::default(); PLACES + 1];
        // In a closed motion, places near one end are near the other too.
        let rounds: &[f64] = if self.closed {
            &[-1.0, 0.0, 1.0]
        } else {
            &[0.0]
        };
        for &(at, space) in met {
            for round in rounds {
                let at_round = at + round * PLACES as f64;
                for index in places_between(at_round - near, at_round + near) {
                    if self.far(at, index as f64) <= near + 1e-9 {
                        spaces[index] = spaces[index].with(space);
                    }
                }
            }
        }
        spaces
    }

    /// Returns for each place the union of extents within `near` places.
    fn union_within(&self, spaces: &[Bounds], near: usize) -> Vec<Bounds> {
        let met = spaces.iter().enumerate();
        let met: Vec<(f64, Bounds)> = met.map(|(at, space)| (at as f64, *space)).collect();
        self.union_near(&met, near as f64)
    }

    /// Returns for each place the mean of extents over `near` places on either side.
    fn means(&self, spaces: &[Bounds], near: usize) -> Vec<Bounds> {
        let mean = |index| mean(spaces, index, near, self.closed);
        (0..=PLACES).map(mean).collect()
    }

    /// Returns the distance of two places, cyclic for a closed motion.
    fn far(&self, a: f64, b: f64) -> f64 {
        let distance = (a - b).abs();
        if self.closed {
            distance.min(PLACES as f64 - distance)
        } else {
            distance
        }
    }

    /// Returns `true` if the motion ends where it begins.
    pub(in crate::drawing) fn is_closed(&self) -> bool {
        self.closed
    }

    /// Returns coordinates along the motion, each in the middle of one of `count` parts; none
    /// without a motion.
    pub(in crate::drawing) fn steps(&self, count: usize) -> impl Iterator<Item = f64> {
        let count = if self.smoothed.is_empty() { 0 } else { count };
        let places = (0..count).map(move |k| (k as f64 + 0.5) / count as f64 * PLACES as f64);
        places.map(|place| self.coordinate(place))
    }

    /// Returns how much of the motion lies before a coordinate, from 0 to 1; `None` without a
    /// motion.
    pub(in crate::drawing) fn share(&self, at: f64) -> Option<f64> {
        self.smoothed.last()?;
        Some(self.place(at)? / PLACES as f64)
    }

    /// Returns the fractional place of a coordinate; `None` if it is not finite.
    fn place(&self, at: f64) -> Option<f64> {
        let share = (at - self.start) / self.span;
        let share = if self.closed {
            share.rem_euclid(1.0)
        } else {
            (1.0 - 2.0 * share.clamp(0.0, 1.0)).acos() / PI
        };
        share.is_finite().then_some(share * PLACES as f64)
    }

    /// Returns the coordinate of a place.
    fn coordinate(&self, place: f64) -> f64 {
        let share = place / PLACES as f64;
        let share = if self.closed {
            share
        } else {
            (1.0 - (PI * share).cos()) / 2.0
        };
        self.start + self.span * share
    }

    /// Returns the extents for a window at a coordinate; `None` if no pose of the motion is known.
    pub(in crate::drawing) fn extents_at(&self, at: f64) -> Option<PoseExtents> {
        let last = self.smoothed.len().checked_sub(1)?;
        let place = self.place(at)?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the last place"
        )]
        let before = (place as usize).min(last);
        let between = |spaces: &[Bounds]| {
            let [from, to] = [before, (before + 1).min(last)].map(|at| spaces.get(at).copied());
            let [from, to] = [from, to].map(Option::unwrap_or_default);
            from.towards(to, place - before as f64)
        };
        Some(PoseExtents {
            linkage: between(&self.smoothed),
            tips: between(&self.tips),
        })
    }

    /// Returns a sample of poses spread over the motion: the extents of each alone, and those for a
    /// window.
    pub(in crate::drawing) fn some(&self) -> impl Iterator<Item = (Bounds, PoseExtents)> {
        let spaces = self
            .smoothed
            .iter()
            .enumerate()
            .map(|(index, smoothed)| PoseExtents {
                linkage: *smoothed,
                tips: self.tips.get(index).copied().unwrap_or_default(),
            });
        self.alone.iter().copied().zip(spaces).step_by(SOME)
    }
}

/// Every fourth place suffices to choose a window: 12 degrees of a turn.
const SOME: usize = 4;

/// Returns the places from the one before `low` to the one after `high`.
fn places_between(low: f64, high: f64) -> std::ops::RangeInclusive<usize> {
    let last = PLACES as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the last place"
    )]
    let [first, end] = [low.floor(), high.ceil()].map(|place| place.clamp(0.0, last) as usize);
    first..=end
}

/// Returns the mean of the extents around a place.
fn mean(spaces: &[Bounds], index: usize, near: usize, closed: bool) -> Bounds {
    let (mut low, mut high, mut count) = (Vec2::ZERO, Vec2::ZERO, 0.0);
    for k in 0..=2 * near {
        let there = if closed {
            // The last place equals the first.
            Some((index + PLACES + k - near) % PLACES)
        } else {
            (index + k)
                .checked_sub(near)
                .filter(|&there| there < spaces.len())
        };
        if let Some(there) = there.filter(|&there| !spaces[there].is_empty()) {
            low += spaces[there].low;
            high += spaces[there].high;
            count += 1.0;
        }
    }
    if count == 0.0 {
        return Bounds::default();
    }
    Bounds {
        low: low / count,
        high: high / count,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(x: f64, y: f64) -> Bounds {
        let at = Vec2::new(x, y);
        Bounds { low: at, high: at }
    }

    proptest! {
        /// The extents at a coordinate contain the pose at that coordinate.
        #[test]
        fn extents_contain_their_pose(
            walls in prop::collection::vec((-9.0..9.0, -9.0..9.0), 2..300),
            closed in any::<bool>(),
        ) {
            let span = 360.0;
            let at = |share: f64| {
                let share = if closed { share } else { (1.0 - (PI * share).cos()) / 2.0 };
                30.0 + span * share
            };
            let count = walls.len() as f64 - 1.0;
            let met: Vec<(f64, Bounds)> = walls
                .iter()
                .enumerate()
                .map(|(k, &(x, y))| (at(k as f64 / count), point(x, y)))
                .collect();
            let poses = Poses::new([30.0, span], closed, &met);
            for &(at, pose) in &met {
                let space = poses.extents_at(at).expect("there are poses").linkage;
                prop_assert!(space.low.x <= pose.low.x + 1e-9 && pose.high.x <= space.high.x + 1e-9);
                prop_assert!(space.low.y <= pose.low.y + 1e-9 && pose.high.y <= space.high.y + 1e-9);
            }
        }
    }

    #[test]
    fn extents_are_periodic_and_absent_without_poses() {
        let met: Vec<(f64, Bounds)> = (0..=240)
            .map(|k| {
                let at = f64::from(k) * 1.5;
                let position = crate::angle::unit(at);
                (at, point(position.x, position.y))
            })
            .collect();
        let poses = Poses::new([0.0, 360.0], true, &met);
        let (end, start) = (
            poses.extents_at(359.999_999).unwrap(),
            poses.extents_at(0.0).unwrap(),
        );
        let (end, start) = (end.linkage, start.linkage);
        assert!((end.low - start.low).norm() < 1e-6);
        let (again, first) = (
            poses.extents_at(725.0).unwrap(),
            poses.extents_at(5.0).unwrap(),
        );
        let (again, first) = (again.linkage, first.linkage);
        assert!((again.low - first.low).norm() < 1e-9 && (again.high - first.high).norm() < 1e-9);
        for none in [Poses::default(), Poses::new([0.0, 1.0], false, &[])] {
            assert_eq!(none.extents_at(3.0), None);
        }
        assert_eq!(poses.extents_at(f64::NAN), None);
    }
}
