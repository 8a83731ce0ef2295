//! Cognate linkages: the other linkages whose tracer draws the same curve (Roberts, 1875;
//! Chebyshev, 1878).
//!
//! Read as complex numbers, a four-bar A, B, C, D carries its tracer at P = B + k (C - B), k a
//! constant. Then
//!
//! ```text
//! E = A + (P - B),  F = E + k (B - A),  G = A + k (D - A)      F - G = k (C - D)
//! E = D + (P - C),  F = E + (1 - k) (C - D)                    F - G = (1 - k) (B - A)
//! ```
//!
//! so that A-E-F-G and G-F-E-D are four-bars too. Both have a coupler similar to the first one's,
//! which carries the same P. The links at A and D of both turn as the first coupler does. The link
//! at G turns as the first rocker in the former and as the first crank in the latter. The latter is
//! driven at G and keeps the times.
//!
//! For a slider-crank, D lies at infinity: F - A = k (C - A) runs along a line turned by the angle
//! of k. There is one cognate, whose crank turns as the first coupler does.
//!
//! Dijksman, Motion Geometry of Mechanisms (1976), chapter 7, covers both.

use super::{PinConstraint, Proposal};
use kinematics::{Vec2, angle};

/// Pins nearer to each other than this fraction of the linkage's largest length coincide.
const COINCIDENCE_TOLERANCE: f64 = 1e-12;

impl Proposal {
    /// Returns the cognates: two for a four-bar, with the one that keeps the times last, and one
    /// for a slider-crank.
    ///
    /// A cognate with a link of zero length is left out: then the tracer is on B or on C. The
    /// result is empty without a tracer, or if the coupler has zero length.
    ///
    /// At every point, the cognates' pins are given for the same position of the tracer; their
    /// sizes are in the task's unit.
    #[must_use]
    pub fn cognates(&self) -> Vec<Proposal> {
        let (Some(&[b, c]), Some(tracer)) = (self.places.first(), self.tracer) else {
            return Vec::new();
        };
        let coupler = c - b;
        let ratio = (tracer - b).turned(coupler.conj()) * (1.0 / coupler.norm2());
        let all = match self.partner {
            PinConstraint::Rocker(d) => vec![self.at_crank(ratio, d), self.at_rocker(ratio, d)],
            PinConstraint::Slide(along) => vec![self.sliding(ratio, along)],
        };
        all.into_iter().filter(Proposal::is_one).collect()
    }

    /// Returns the cognate A, E, F, G.
    fn at_crank(&self, ratio: Vec2, d: Vec2) -> Proposal {
        let a = self.pivot;
        Proposal {
            pivot: a,
            partner: PinConstraint::Rocker(third(a, d, ratio)),
            places: self.places.iter().map(|&at| pins(a, at, ratio)).collect(),
            tracer: self.tracer,
        }
    }

    /// Returns the cognate G, F, E, D.
    fn at_rocker(&self, ratio: Vec2, d: Vec2) -> Proposal {
        let rest = Vec2::X - ratio;
        let place = |&[b, c]: &[Vec2; 2]| {
            let [e, f] = pins(d, [c, b], rest);
            [f, e]
        };
        Proposal {
            pivot: third(self.pivot, d, ratio),
            partner: PinConstraint::Rocker(d),
            places: self.places.iter().map(place).collect(),
            tracer: self.tracer,
        }
    }

    fn sliding(&self, ratio: Vec2, along: f64) -> Proposal {
        let a = self.pivot;
        Proposal {
            pivot: a,
            partner: PinConstraint::Slide(angle::wrapped(along + angle::degrees(ratio))),
            places: self.places.iter().map(|&at| pins(a, at, ratio)).collect(),
            tracer: self.tracer,
        }
    }

    /// Returns `true` if every link has a length and all numbers are finite.
    fn is_one(&self) -> bool {
        let Some((crank, coupler, rocker)) = self.lengths() else {
            return false;
        };
        let rocker = rocker.unwrap_or(crank);
        let small = COINCIDENCE_TOLERANCE * crank.max(coupler).max(rocker);
        let is_finite = self.places.iter().flatten().all(|pin| pin.is_finite());
        is_finite
            && [crank, coupler, rocker]
                .iter()
                .all(|length| *length > small)
    }
}

/// Returns the pivot G, which belongs to neither the original crank nor the original rocker.
fn third(a: Vec2, d: Vec2, ratio: Vec2) -> Vec2 {
    a + (d - a).turned(ratio)
}

/// Returns E and F for a crank about `a` with the pins B and C.
fn pins(a: Vec2, [b, c]: [Vec2; 2], ratio: Vec2) -> [Vec2; 2] {
    let e = a + (c - b).turned(ratio);
    [e, e + (b - a).turned(ratio)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::planted::{KnownLinkage, tracer};
    use kinematics::numeric::SeededRng;

    /// Drives each cognate by its own crank with its own lengths: it must draw the points of the
    /// first linkage at every angle.
    #[test]
    fn cognates_draw_same_curve() {
        let mut rng = SeededRng::new(11);
        let (mut four_bars, mut sliders) = (0, 0);
        for _ in 0..3000 {
            let planted = KnownLinkage::random(&mut rng, four_bars > 2 * sliders);
            let turns: Vec<f64> = (0..360).map(f64::from).collect();
            let Some(first) = planted.proposal(&turns) else {
                continue;
            };
            let found = first.cognates();
            match first.partner {
                PinConstraint::Rocker(_) => {
                    four_bars += 1;
                    assert_eq!(found.len(), 2);
                }
                PinConstraint::Slide(_) => {
                    sliders += 1;
                    assert_eq!(found.len(), 1);
                }
            }
            for cognate in &found {
                holds(&first, cognate);
                // The cognates of a cognate are the first linkage and the other cognate: the family
                // is closed.
                let family = cognate.cognates();
                let is_back = |p: &Proposal| (p.pivot - first.pivot).norm() < 1e-9 * planted.size();
                assert!(
                    family
                        .iter()
                        .flat_map(|p| [Some(p.clone()), p.swapped()])
                        .flatten()
                        .any(|p| is_back(&p))
                        || family.iter().any(is_back)
                );
            }
        }
        assert!(four_bars > 50 && sliders > 25, "{four_bars} {sliders}");
    }

    /// Checks that the cognate's lengths stay constant and that it draws the same curve.
    fn holds(first: &Proposal, cognate: &Proposal) {
        let (crank, coupler, rocker) = cognate.lengths().unwrap();
        let ground = match cognate.partner {
            PinConstraint::Rocker(d) => (d - cognate.pivot).norm(),
            PinConstraint::Slide(_) => crank,
        };
        let size = crank.max(coupler).max(ground).max(rocker.unwrap_or(0.0));
        let near = 1e-12 * size.max(first.tracer.unwrap().norm());
        for (j, [b, c]) in cognate.places.iter().enumerate() {
            assert!(((*b - cognate.pivot).norm() - crank).abs() < near);
            assert!(((*c - *b).norm() - coupler).abs() < near);
            match cognate.partner {
                PinConstraint::Rocker(d) => {
                    assert!(((*c - d).norm() - rocker.unwrap()).abs() < near);
                }
                PinConstraint::Slide(along) => {
                    let run = *c - cognate.places[0][1];
                    assert!(run.cross(angle::unit(along)).abs() < near);
                }
            }
            let miss = (tracer(cognate, j) - tracer(first, j)).norm();
            assert!(miss < near, "{miss} at {j}");
        }
    }

    #[test]
    fn last_four_bar_cognate_keeps_times() {
        let mut rng = SeededRng::new(5);
        let turns: Vec<f64> = (0..40).map(|k| 9.0 * f64::from(k)).collect();
        let first = loop {
            let planted = KnownLinkage::random(&mut rng, false);
            if let Some(first) = planted.proposal(&turns) {
                break first;
            }
        };
        let cognates = first.cognates();
        let last = cognates.last().unwrap();
        let start = angle::degrees(last.places[0][0] - last.pivot);
        for (j, turn) in turns.iter().enumerate() {
            let here = angle::degrees(last.places[j][0] - last.pivot);
            assert!(angle::wrapped(here - start - turn).abs() < 1e-9);
        }
    }

    /// Places the tracer on the coupler's line and on a pin, and leaves it out.
    #[test]
    fn tracer_on_pin_has_fewer_cognates() {
        let turns: Vec<f64> = (0..120).map(|k| 3.0 * f64::from(k)).collect();
        let bar = |arm| KnownLinkage {
            pivot: Vec2::new(3.0, -1.0),
            far: PinConstraint::Rocker(Vec2::new(7.0, 0.5)),
            crank: 1.0,
            coupler: 4.0,
            rocker: 3.0,
            arm,
            start: 20.0,
            sign: 1.0,
            across: 0.1,
        };
        for along in [-0.7, 0.4, 0.5, 1.9] {
            let first = bar(Vec2::new(along, 0.0)).proposal(&turns).unwrap();
            let found = first.cognates();
            assert_eq!(found.len(), 2);
            found.iter().for_each(|cognate| holds(&first, cognate));
        }
        // With the tracer on B the curve is the crank's circle, on C the rocker's. One of the
        // cognates then has a link of zero length.
        for arm in [Vec2::ZERO, Vec2::X] {
            let first = bar(arm).proposal(&turns).unwrap();
            let found = first.cognates();
            assert_eq!(found.len(), 1);
            holds(&first, &found[0]);
        }
        let mut none = bar(Vec2::X * 0.5).proposal(&turns).unwrap();
        none.tracer = None;
        assert_eq!(none.cognates(), []);
        let mut short = bar(Vec2::X * 0.5).proposal(&turns).unwrap();
        short.places.iter_mut().for_each(|pins| pins[1] = pins[0]);
        assert_eq!(short.cognates(), []);
    }
}
