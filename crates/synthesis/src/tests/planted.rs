//! Linkages with a known motion, computed by the tests' own formulas: two circles, or a circle and
//! a line, by the law of cosines.

use crate::{PinConstraint, Proposal};
use kinematics::numeric::SeededRng;
use kinematics::{Vec2, angle};

/// A linkage, given by its lengths.
#[derive(Clone, Debug)]
pub(crate) struct KnownLinkage {
    pub(crate) pivot: Vec2,
    /// The other pivot, or the slide's angle; the slide's line passes A at the distance `rocker`.
    pub(crate) far: PinConstraint,
    pub(crate) crank: f64,
    pub(crate) coupler: f64,
    pub(crate) rocker: f64,
    /// The tracer relative to B in coupler lengths, along B-C and perpendicular to it.
    pub(crate) arm: Vec2,
    /// The crank's first angle, in degrees.
    pub(crate) start: f64,
    pub(crate) sign: f64,
    /// The minimum part of the coupler perpendicular to the base line: it keeps the linkage away
    /// from dead points.
    pub(crate) across: f64,
}

impl KnownLinkage {
    pub(crate) fn random(rng: &mut SeededRng, slides: bool) -> KnownLinkage {
        let mut place = |maximum: f64| Vec2::new(maximum * rng.even(), maximum * rng.even());
        let (pivot, d, arm) = (place(3.0), place(3.0), place(1.5));
        let mut length = || 10_f64.powf(0.5 * rng.even());
        let [crank, coupler, rocker] = [length(), length(), length()];
        let start = 180.0 * rng.even();
        KnownLinkage {
            pivot,
            far: if slides {
                PinConstraint::Slide(180.0 * rng.even())
            } else {
                PinConstraint::Rocker(d)
            },
            crank,
            coupler,
            rocker: if slides {
                0.5 * crank * rng.even()
            } else {
                rocker
            },
            arm,
            start,
            sign: rng.even().signum(),
            across: 0.1,
        }
    }

    /// Returns the longest length.
    pub(crate) fn size(&self) -> f64 {
        let ground = match self.far {
            PinConstraint::Rocker(d) => (d - self.pivot).norm(),
            PinConstraint::Slide(_) => 0.0,
        };
        let lengths = [self.crank, self.coupler, self.rocker.abs(), ground];
        lengths.into_iter().fold(0.0, f64::max)
    }

    /// Returns B, C and the tracer at a rotation of the crank, in degrees; `None` near a dead point
    /// and beyond it.
    pub(crate) fn at(&self, turn: f64) -> Option<[Vec2; 3]> {
        let b = self.pivot + angle::unit(self.start + turn) * self.crank;
        let (e, x) = match self.far {
            PinConstraint::Rocker(d) => {
                let g = d - b;
                let l = g.norm();
                let squares = l * l + self.coupler * self.coupler - self.rocker * self.rocker;
                (g * (1.0 / l), 0.5 * squares / l)
            }
            PinConstraint::Slide(along) => {
                let normal = angle::unit(along).perp();
                (normal, self.rocker - normal.dot(b - self.pivot))
            }
        };
        let h = (self.coupler * self.coupler - x * x).sqrt();
        if !(h > self.across * self.coupler) {
            return None;
        }
        let c = b + e * x + e.perp() * (self.sign * h);
        Some([b, c, b + (c - b).turned(self.arm)])
    }

    /// Returns the linkage as a proposal at these rotations of its crank; `None` if it does not
    /// reach one of them.
    pub(crate) fn proposal(&self, turns: &[f64]) -> Option<Proposal> {
        let all: Option<Vec<_>> = turns.iter().map(|turn| self.at(*turn)).collect();
        let all = all?;
        Some(Proposal {
            pivot: self.pivot,
            partner: self.far,
            places: all.iter().map(|[b, c, _]| [*b, *c]).collect(),
            tracer: all.first().map(|[_, _, p]| *p),
        })
    }
}

/// Returns the position of a proposal's tracer at a point of the task.
pub(crate) fn tracer(proposal: &Proposal, point: usize) -> Vec2 {
    let [b, c] = proposal.places[0];
    let k = c - b;
    let arm = (proposal.tracer.unwrap() - b).turned(k.conj()) * (1.0 / k.norm2());
    let [b, c] = proposal.places[point];
    b + (c - b).turned(arm)
}
