//! Random linkages and the poses of their couplers.

use crate::poses::dyad::FullDyad;
use crate::{Partner, Pose, PoseTask, Proposal};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

/// A linkage given by its dyads: two pins in the body's frame, each with the element that holds it.
#[derive(Clone, Debug)]
pub(super) struct Planted {
    pub task: PoseTask,
    pub dyads: [(Partner, Vec2); 2],
}

/// A linkage given by its lengths, with the element that holds the second pin.
pub(super) struct PlantedForm {
    pub pivot: Vec2,
    pub crank: f64,
    pub coupler: f64,
    pub partner: Partner,
    /// The rocker's length, or the distance of the slide's line from the pivot.
    pub rest: f64,
    /// The assembly, 1 or -1.
    pub side: f64,
    /// The body's origin, and its angle in degrees, relative to B and the coupler.
    pub body: (Vec2, f64),
}

impl PlantedForm {
    pub(super) fn four_bar(chance: &mut SeededRng) -> PlantedForm {
        let base = turned(chance.within(0.5, 3.0), chance.within(0.0, 360.0));
        let shape = PlantedForm::slider_crank(chance);
        PlantedForm {
            partner: Partner::Rocker(shape.pivot + base),
            rest: chance.within(0.5, 3.0),
            ..shape
        }
    }

    pub(super) fn slider_crank(chance: &mut SeededRng) -> PlantedForm {
        let mut place =
            |size: f64| Vec2::new(chance.within(-size, size), chance.within(-size, size));
        let (pivot, origin) = (place(5.0), place(2.0));
        PlantedForm {
            pivot,
            crank: chance.within(0.4, 2.0),
            coupler: chance.within(0.5, 3.0),
            partner: Partner::Slide(chance.within(0.0, 180.0)),
            rest: chance.within(-0.5, 0.5),
            side: if chance.between(0, 1) == 0 { 1.0 } else { -1.0 },
            body: (origin, chance.within(0.0, 360.0)),
        }
    }

    /// Returns B and C at a crank angle in degrees; `None` if the linkage does not reach it.
    fn pins(&self, crank: f64) -> Option<[Vec2; 2]> {
        let b = self.pivot + turned(self.crank, crank);
        let c = match self.partner {
            Partner::Rocker(d) => {
                let base = d - b;
                let along =
                    (base.norm2() + self.coupler.powi(2) - self.rest.powi(2)) / (2.0 * base.norm());
                let height = (self.coupler.powi(2) - along.powi(2)).sqrt() * self.side;
                let unit = base / base.norm();
                b + unit * along + unit.perp() * height
            }
            Partner::Slide(direction) => {
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

    pub(super) fn planted(&self, poses: Vec<Pose>) -> Planted {
        let back = angle::unit(-self.body.1);
        let pins = [Vec2::ZERO, Vec2::new(self.coupler, 0.0)];
        let [b, c] = pins.map(|pin| (pin - self.body.0).turned(back));
        Planted {
            task: PoseTask {
                poses,
                ..PoseTask::default()
            },
            dyads: [(Partner::Rocker(self.pivot), b), (self.partner, c)],
        }
    }

    /// Returns the linkage at `count` random angles, at least `apart` degrees apart; `None` if it
    /// does not reach so many.
    pub(super) fn at_some(
        &self,
        chance: &mut SeededRng,
        count: usize,
        apart: f64,
    ) -> Option<Planted> {
        let mut cranks: Vec<f64> = Vec::new();
        for _ in 0..200 {
            let crank = chance.within(0.0, 360.0);
            let is_apart = |other: &f64| {
                let off = (crank - other).rem_euclid(360.0);
                off.min(360.0 - off) >= apart
            };
            if cranks.len() < count && cranks.iter().all(is_apart) && self.pins(crank).is_some() {
                cranks.push(crank);
            }
        }
        let poses: Option<Vec<Pose>> = cranks.iter().map(|crank| self.pose(*crank)).collect();
        (cranks.len() == count).then_some(self.planted(poses?))
    }
}

impl Planted {
    pub(super) fn four_bar(chance: &mut SeededRng, count: usize, apart: f64) -> Planted {
        loop {
            let shape = PlantedForm::four_bar(chance);
            if let Some(planted) = shape.at_some(chance, count, apart) {
                return planted;
            }
        }
    }

    pub(super) fn slider_crank(chance: &mut SeededRng, count: usize, apart: f64) -> Planted {
        loop {
            let shape = PlantedForm::slider_crank(chance);
            if let Some(planted) = shape.at_some(chance, count, apart) {
                return planted;
            }
        }
    }

    /// Returns the difference between a known dyad and the nearest found one.
    pub(super) fn off(&self, which: usize, found: &[FullDyad]) -> f64 {
        let (by, pin) = self.dyads[which];
        found
            .iter()
            .map(|held| apart(held, by, pin))
            .fold(f64::INFINITY, f64::min)
    }

    /// Returns `true` if the known linkage is among the proposals, driven at either pivot, within a
    /// tolerance.
    pub(super) fn is_among(&self, found: &[Proposal], within: f64) -> bool {
        let first = &self.task.poses[0];
        let [(Partner::Rocker(pivot), b), (partner, c)] = self.dyads else {
            return false;
        };
        let [b, c] = [b, c].map(|pin| first.at + pin.turned(angle::unit(first.angle)));
        let near = |p: Vec2, q: Vec2| (p - q).norm() <= within;
        let is_it = |linkage: &Proposal| {
            let is_partner = match (linkage.partner, partner) {
                (Partner::Rocker(d), Partner::Rocker(e)) => near(d, e),
                (Partner::Slide(p), Partner::Slide(q)) => {
                    angle::unit(p).cross(angle::unit(q)).abs() <= within
                }
                (Partner::Rocker(_), Partner::Slide(_))
                | (Partner::Slide(_), Partner::Rocker(_)) => false,
            };
            let [p, q] = linkage.places[0];
            is_partner && near(linkage.pivot, pivot) && near(p, b) && near(q, c)
        };
        found
            .iter()
            .any(|linkage| is_it(linkage) || linkage.swapped().as_ref().is_some_and(is_it))
    }
}

fn apart(held: &FullDyad, by: Partner, pin: Vec2) -> f64 {
    let off = match (held.by, by) {
        (Partner::Rocker(p), Partner::Rocker(q)) => (p - q).norm(),
        (Partner::Slide(p), Partner::Slide(q)) => angle::unit(p).cross(angle::unit(q)).abs(),
        (Partner::Rocker(_), Partner::Slide(_)) | (Partner::Slide(_), Partner::Rocker(_)) => {
            f64::INFINITY
        }
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
                Partner::Rocker(d) => (place(in_c) - d).norm() - (c - d).norm(),
                Partner::Slide(along) => angle::unit(along).cross(place(in_c) - c),
            };
            worst = worst.max(crank.abs()).max(other.abs());
        }
    }
    worst
}
