//! Random linkages and the poses of their couplers.

use crate::poses::dyad::FullDyad;
use crate::{PinConstraint, Pose, PoseTask, Proposal};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

/// A linkage given by its dyads: two pins in the body's frame, each with the element that holds it.
#[derive(Clone, Debug)]
pub(super) struct KnownDyads {
    pub task: PoseTask,
    pub dyads: [(PinConstraint, Vec2); 2],
}

/// A linkage given by its lengths, with the element that holds the second pin.
pub(super) struct KnownLengths {
    pub pivot: Vec2,
    pub crank: f64,
    pub coupler: f64,
    pub partner: PinConstraint,
    /// The rocker's length, or the distance of the slide's line from the pivot.
    pub rest: f64,
    /// The assembly, 1 or -1.
    pub side: f64,
    /// The body's origin, and its angle in degrees, relative to B and the coupler.
    pub body: (Vec2, f64),
}

impl KnownLengths {
    pub(super) fn four_bar(rng: &mut SeededRng) -> KnownLengths {
        let base = turned(rng.within(0.5, 3.0), rng.within(0.0, 360.0));
        let shape = KnownLengths::slider_crank(rng);
        KnownLengths {
            partner: PinConstraint::Rocker(shape.pivot + base),
            rest: rng.within(0.5, 3.0),
            ..shape
        }
    }

    pub(super) fn slider_crank(rng: &mut SeededRng) -> KnownLengths {
        let mut place = |size: f64| Vec2::new(rng.within(-size, size), rng.within(-size, size));
        let (pivot, origin) = (place(5.0), place(2.0));
        KnownLengths {
            pivot,
            crank: rng.within(0.4, 2.0),
            coupler: rng.within(0.5, 3.0),
            partner: PinConstraint::Slide(rng.within(0.0, 180.0)),
            rest: rng.within(-0.5, 0.5),
            side: if rng.between(0, 1) == 0 { 1.0 } else { -1.0 },
            body: (origin, rng.within(0.0, 360.0)),
        }
    }

    /// Returns B and C at a crank angle in degrees; `None` if the linkage does not reach it.
    fn pins(&self, crank: f64) -> Option<[Vec2; 2]> {
        let b = self.pivot + turned(self.crank, crank);
        let c = match self.partner {
            PinConstraint::Rocker(d) => {
                let base = d - b;
                let along =
                    (base.norm2() + self.coupler.powi(2) - self.rest.powi(2)) / (2.0 * base.norm());
                let height = (self.coupler.powi(2) - along.powi(2)).sqrt() * self.side;
                let unit = base / base.norm();
                b + unit * along + unit.perp() * height
            }
            PinConstraint::Slide(direction) => {
                let along = angle::unit(direction);
                let off = along.cross(b - self.pivot) - self.rest;
                let forth = (self.coupler.powi(2) - off.powi(2)).sqrt() * self.side;
                b + along * forth - along.perp() * off
            }
        };
        c.is_finite().then_some([b, c])
    }

    /// Returns the body's pose at a crank angle in degrees; `None` if the linkage does not reach
    /// it.
    pub(super) fn pose(&self, crank: f64) -> Option<Pose> {
        let [b, c] = self.pins(crank)?;
        let along = (c - b) / (c - b).norm();
        Some(Pose {
            at: b + self.body.0.turned(along),
            angle: angle::degrees(along) + self.body.1,
        })
    }

    pub(super) fn planted(&self, poses: Vec<Pose>) -> KnownDyads {
        let back = angle::unit(-self.body.1);
        let pins = [Vec2::ZERO, Vec2::new(self.coupler, 0.0)];
        let [b, c] = pins.map(|pin| (pin - self.body.0).turned(back));
        KnownDyads {
            task: PoseTask {
                poses,
                ..PoseTask::default()
            },
            dyads: [(PinConstraint::Rocker(self.pivot), b), (self.partner, c)],
        }
    }

    /// Returns the linkage at `count` random angles, at least `apart` degrees apart; `None` if it
    /// does not reach so many.
    pub(super) fn at_some(
        &self,
        rng: &mut SeededRng,
        count: usize,
        distance: f64,
    ) -> Option<KnownDyads> {
        let mut cranks: Vec<f64> = Vec::new();
        for _ in 0..200 {
            let crank = rng.within(0.0, 360.0);
            let is_apart = |other: &f64| {
                let off = (crank - other).rem_euclid(360.0);
                off.min(360.0 - off) >= distance
            };
            if cranks.len() < count && cranks.iter().all(is_apart) && self.pins(crank).is_some() {
                cranks.push(crank);
            }
        }
        let poses: Option<Vec<Pose>> = cranks.iter().map(|crank| self.pose(*crank)).collect();
        (cranks.len() == count).then_some(self.planted(poses?))
    }
}

impl KnownDyads {
    pub(super) fn four_bar(rng: &mut SeededRng, count: usize, distance: f64) -> KnownDyads {
        loop {
            let shape = KnownLengths::four_bar(rng);
            if let Some(planted) = shape.at_some(rng, count, distance) {
                return planted;
            }
        }
    }

    pub(super) fn slider_crank(rng: &mut SeededRng, count: usize, distance: f64) -> KnownDyads {
        loop {
            let shape = KnownLengths::slider_crank(rng);
            if let Some(planted) = shape.at_some(rng, count, distance) {
                return planted;
            }
        }
    }

    /// Returns the difference between a known dyad and the nearest found one.
    pub(super) fn off(&self, which: usize, found: &[FullDyad]) -> f64 {
        let (by, pin) = self.dyads[which];
        found
            .iter()
            .map(|held| pin_distance(held, by, pin))
            .fold(f64::INFINITY, f64::min)
    }

    /// Returns `true` if the known linkage is among the proposals, driven at either pivot, within a
    /// tolerance.
    pub(super) fn is_among(&self, found: &[Proposal], within: f64) -> bool {
        let first = &self.task.poses[0];
        let [(PinConstraint::Rocker(pivot), b), (constraint, c)] = self.dyads else {
            return false;
        };
        let [b, c] = [b, c].map(|pin| first.at + pin.turned(angle::unit(first.angle)));
        let near = |p: Vec2, q: Vec2| (p - q).norm() <= within;
        let is_it = |linkage: &Proposal| {
            let is_partner = match (linkage.partner, constraint) {
                (PinConstraint::Rocker(d), PinConstraint::Rocker(e)) => near(d, e),
                (PinConstraint::Slide(p), PinConstraint::Slide(q)) => {
                    angle::unit(p).cross(angle::unit(q)).abs() <= within
                }
                (PinConstraint::Rocker(_), PinConstraint::Slide(_))
                | (PinConstraint::Slide(_), PinConstraint::Rocker(_)) => false,
            };
            let [p, q] = linkage.places[0];
            is_partner && near(linkage.pivot, pivot) && near(p, b) && near(q, c)
        };
        found
            .iter()
            .any(|linkage| is_it(linkage) || linkage.swapped().as_ref().is_some_and(is_it))
    }
}

fn pin_distance(held: &FullDyad, by: PinConstraint, pin: Vec2) -> f64 {
    let off = match (held.by, by) {
        (PinConstraint::Rocker(p), PinConstraint::Rocker(q)) => (p - q).norm(),
        (PinConstraint::Slide(p), PinConstraint::Slide(q)) => {
            angle::unit(p).cross(angle::unit(q)).abs()
        }
        (PinConstraint::Rocker(_), PinConstraint::Slide(_))
        | (PinConstraint::Slide(_), PinConstraint::Rocker(_)) => f64::INFINITY,
    };
    off.max((held.pin - pin).norm())
}

/// Returns a vector of a length at an angle in degrees from +x.
pub(super) fn turned(length: f64, degrees: f64) -> Vec2 {
    angle::unit(degrees) * length
}

/// Returns the largest deviation of a pin's distance from its pivot or slide, over all poses of all
/// proposals, computed in doubles from the poses themselves.
pub(super) fn worst_miss(task: &PoseTask, found: &[Proposal]) -> f64 {
    let mut worst: f64 = 0.0;
    for linkage in found {
        let [b, c] = linkage.places[0];
        let in_body =
            |pin: Vec2| (pin - task.poses[0].at).turned(angle::unit(task.poses[0].angle).conj());
        let [in_b, in_c] = [in_body(b), in_body(c)];
        for pose in &task.poses {
            let place = |pin: Vec2| pose.at + pin.turned(angle::unit(pose.angle));
            let crank = (place(in_b) - linkage.pivot).norm() - (b - linkage.pivot).norm();
            let other = match linkage.partner {
                PinConstraint::Rocker(d) => (place(in_c) - d).norm() - (c - d).norm(),
                PinConstraint::Slide(along) => angle::unit(along).cross(place(in_c) - c),
            };
            worst = worst.max(crank.abs()).max(other.abs());
        }
    }
    worst
}
