//! Solves for the unknowns in which the path is linear.
//!
//! Read as complex numbers, the tracer of a linkage of known shape is
//!
//! ```text
//! P = A + s a e + z u
//! ```
//!
//! with A its pivot, s the size and turning of the ground, e and u the directions of crank and
//! coupler, and z the tracer seen from B along the coupler. For any e and u, the unknowns A, s and
//! z follow by least squares (variable projection: Golub and Pereyra, 1973). At most two complex
//! unknowns remain, since A is eliminated by the means. A given pivot eliminates unknowns: with D
//! given, P - D = s (a e - g) + z u, with both s = (D - A) / g.

use super::shape::LinkageShape;
use super::task::{GivenPivots, TargetPath};
use kinematics::{Vec2, angle};

/// The placement of a linkage of known shape.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinkagePlace {
    /// The position of A.
    pub(super) origin: Vec2,
    /// The size and turning of the ground, as a complex number.
    pub(super) scale: Vec2,
    /// The vector from B to the tracer, relative to the coupler, as a complex number.
    pub(super) arm: Vec2,
}

/// The best placement for the path and its quality.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    pub(super) place: LinkagePlace,
    /// The weighted mean square of the misses.
    pub(super) square: f64,
    /// The sum over all points by how much the links are too short.
    pub(super) short: f64,
}

/// Relative weight of a ridge term: it penalises linkages a hundred times the path's size, and
/// keeps columns distinct that would coincide without it.
const RIDGE: f64 = 1e-8;

impl GivenPivots {
    /// Returns the known parts of the linear problem: the origin from which the path is seen, and
    /// the factor of g in the column of s.
    #[inline]
    pub(super) fn known_parts(self) -> (Vec2, f64) {
        match self {
            GivenPivots::Free => (Vec2::ZERO, 0.0),
            GivenPivots::Crank(a) | GivenPivots::Both(a, _) => (a, 0.0),
            GivenPivots::Rocker(d) => (d, 1.0),
        }
    }
}

impl Projection {
    /// Computes the best placement of a shape with its crank at these angles, in degrees, one per
    /// point.
    #[inline]
    pub(super) fn of(
        goal: &TargetPath,
        held: GivenPivots,
        shape: &LinkageShape,
        angles: impl Iterator<Item = f64>,
    ) -> Projection {
        let (seen, part) = held.known_parts();
        let back = Vec2::new(part * shape.ground, 0.0);
        let fixed = match held {
            GivenPivots::Both(a, d) => Some((d - a) * (1.0 / shape.ground)),
            GivenPivots::Free | GivenPivots::Crank(_) | GivenPivots::Rocker(_) => None,
        };
        let mut sums = ProjectionSums::default();
        let mut short = 0.0;
        for ((&point, &weight), degrees) in goal.points.iter().zip(&goal.weights).zip(angles) {
            let e = angle::unit(degrees);
            let at = shape.coupling(e);
            short += at.short;
            let crank = e * shape.crank - back;
            let target = match fixed {
                Some(scale) => point - seen - crank.turned(scale),
                None => point - seen,
            };
            sums.add(weight, crank, at.u, target);
        }
        let (scale, arm, square) = match (held, fixed) {
            (_, Some(scale)) => {
                let arm = sums.ut * (1.0 / (1.0 + RIDGE));
                (scale, arm, sums.tt - arm.dot(sums.ut))
            }
            (GivenPivots::Free, None) => sums.centred().two(),
            (_, None) => sums.two(),
        };
        let origin = match held {
            GivenPivots::Free => sums.t - sums.p.turned(scale) - sums.u.turned(arm),
            GivenPivots::Crank(a) | GivenPivots::Both(a, _) => a,
            GivenPivots::Rocker(d) => d - scale * shape.ground,
        };
        Projection {
            place: LinkagePlace { origin, scale, arm },
            square: square.max(0.0),
            short,
        }
    }
}

/// Weighted means of the products of the two columns p and u and of the target t.
#[derive(Clone, Copy, Debug, Default)]
struct ProjectionSums {
    p: Vec2,
    u: Vec2,
    t: Vec2,
    pp: f64,
    uu: f64,
    tt: f64,
    pu: Vec2,
    pt: Vec2,
    ut: Vec2,
}

impl ProjectionSums {
    #[inline(always)]
    fn add(&mut self, weight: f64, p: Vec2, u: Vec2, t: Vec2) {
        let (wp, wu) = (p * weight, u * weight);
        self.p += wp;
        self.u += wu;
        self.t += t * weight;
        self.pp += wp.dot(p);
        self.uu += wu.dot(u);
        self.tt += weight * t.norm2();
        self.pu += u.turned(wp.conj());
        self.pt += t.turned(wp.conj());
        self.ut += t.turned(wu.conj());
    }

    /// Returns the sums about the means.
    fn centred(&self) -> ProjectionSums {
        ProjectionSums {
            pp: self.pp - self.p.norm2(),
            uu: self.uu - self.u.norm2(),
            tt: self.tt - self.t.norm2(),
            pu: self.pu - self.u.turned(self.p.conj()),
            pt: self.pt - self.t.turned(self.p.conj()),
            ut: self.ut - self.t.turned(self.u.conj()),
            ..*self
        }
    }

    /// Returns the least-squares factors of both columns and the residual's square.
    fn two(&self) -> (Vec2, Vec2, f64) {
        let (pp, uu) = (self.pp + RIDGE * self.uu.max(self.pp), self.uu + RIDGE);
        let determinant = pp * uu - self.pu.norm2();
        if !(determinant > 0.0) {
            return (Vec2::ZERO, Vec2::ZERO, self.tt);
        }
        let per = 1.0 / determinant;
        let scale = (self.pt * uu - self.ut.turned(self.pu)) * per;
        let arm = (self.ut * pp - self.pt.turned(self.pu.conj())) * per;
        (scale, arm, self.tt - scale.dot(self.pt) - arm.dot(self.ut))
    }
}
