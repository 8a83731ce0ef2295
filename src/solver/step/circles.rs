//! Dyads of two circles: RRR, with arms of fixed length or one that a cylinder pushes.

use super::{ACCELERATION, Arm, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, PointState, State};
use crate::{LinkId, PointId, Vec2};

/// Two circles, RRR. The shorter arm comes first: the point is measured from its pivot. The sign of
/// the group is +1 where the point lies on the left of near.pivot -> far.pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Circles {
    pub point: PointId,
    pub near: Arm,
    pub far: Arm,
    /// far - near and near + far, each as a sum of two doubles: the factors of Kahan's product
    /// for a triangle keep their digits without sorting.
    difference: (f64, f64),
    sum: (f64, f64),
    /// (near - far)(near + far).
    squares: f64,
    /// 1 / (2 near far)^2, which makes the product of the factors the square of a sine.
    inverse_square: f64,
    slack: f64,
    pub group: usize,
}

/// a - b as the rounded difference and what it left out (Knuth's two-sum).
fn two_diff(a: f64, b: f64) -> (f64, f64) {
    let d = a - b;
    let back = d - a;
    (d, (a - (d - back)) - (b + back))
}

impl Circles {
    pub(in crate::solver) fn new(point: PointId, arms: [Arm; 2], group: usize) -> Circles {
        let [a, b] = arms;
        let (near, far) = if a.length <= b.length { (a, b) } else { (b, a) };
        Circles {
            point,
            near,
            far,
            difference: two_diff(far.length, near.length),
            sum: two_diff(far.length, -near.length),
            squares: (near.length - far.length) * (near.length + far.length),
            inverse_square: (2.0 * near.length * far.length).powi(-2),
            slack: REACH_SLACK * (near.length + far.length),
            group,
        }
    }

    /// X = P + (x u + s h k x u) / u.u with u = Q - P, x = (u.u + b^2 - c^2) / 2 and h twice the area
    /// of the triangle of sides b, c, |u|: 16 A^2 = (d-m)(d+m)(M-d)(M+d), m = c - b, M = b + c
    /// (Kahan, Miscalculating Area and Angles of a Needle-like Triangle; here m and M carry their
    /// rounding errors, so that no sorting is needed).
    ///
    /// Then V_P + w1 k x e = V_Q + w2 k x f with f = X - Q, and e x f = s h.
    #[inline]
    pub(super) fn run<const ORDER: u8>(&self, state: &mut State) -> Outcome {
        let p = state.points[self.near.pivot.index()];
        let q = state.points[self.far.pivot.index()];
        let u = q.p - p.p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let inner = (d - self.difference.0) - self.difference.1;
        let outer = (self.sum.0 - d) + self.sum.1;
        let product = (inner * ((d + self.difference.0) + self.difference.1))
            * (outer * ((self.sum.0 + d) + self.sum.1));
        state.measures[self.group] = product * self.inverse_square;
        let x = 0.5 * (d2 + self.squares);
        let inverse = 1.0 / d2;
        let reach = inner.min(outer);
        // Written so that NaN does not pass.
        if !(reach > self.slack) {
            return self.stretch(reach, p.p, u, x, state);
        }
        let sh = state.signs[self.group] * (0.5 * product.sqrt());
        let e = (u * x + u.perp() * sh) * inverse;
        let f = e - u;
        let mut point = PointState {
            p: p.p + e,
            ..PointState::default()
        };
        let (mut near, mut far) = (LinkState::default(), LinkState::default());
        near.d = e.turned(self.near.factor);
        far.d = f.turned(self.far.factor);
        if ORDER >= VELOCITY {
            let scale = 1.0 / sh;
            let dv = q.v - p.v;
            near.w = f.dot(dv) * scale;
            far.w = e.dot(dv) * scale;
            point.v = p.v + e.perp() * near.w;
            if ORDER >= ACCELERATION {
                let da = (q.a - p.a) + e * (near.w * near.w) - f * (far.w * far.w);
                near.a = f.dot(da) * scale;
                far.a = e.dot(da) * scale;
                point.a = p.a + e.perp() * near.a - e * (near.w * near.w);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.near.link.index()] = near;
        state.links[self.far.link.index()] = far;
        Outcome::Done
    }

    /// The arms in line, if within rounding they reach each other: positions alone. The nearer arm
    /// keeps its length also where the pivots all but coincide.
    #[cold]
    fn stretch(&self, reach: f64, p: Vec2, u: Vec2, x: f64, state: &mut State) -> Outcome {
        let distance = u.norm();
        // Equal arms about one pivot: the point could be anywhere around it.
        if distance <= self.slack || !(reach >= -self.slack) {
            return Outcome::Open;
        }
        let e = u * (self.near.length.copysign(x) / distance);
        state.points[self.point.index()].p = p + e;
        state.links[self.near.link.index()].d = e.turned(self.near.factor);
        state.links[self.far.link.index()].d = (e - u).turned(self.far.factor);
        Outcome::Stretched
    }
}

/// An arm whose end is pushed along a guide of its own link, and a circle: a cylinder. The sign is +1
/// where the point lies on the left of pivot -> far.pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Cylinder {
    pub point: PointId,
    pub pivot: PointId,
    pub link: LinkId,
    /// The guide's point and direction in the frame of the link, from the pivot.
    pub through: Vec2,
    pub along: Vec2,
    pub far: Arm,
    pub group: usize,
}

impl Cylinder {
    /// The arm is r = through + along q in its link's frame: a circle whose radius varies, with
    /// V = V_P + w k x e + tau and A = A_P + alpha k x e - w^2 e + 2 w k x tau, tau the guide's
    /// direction in the ground. Otherwise as [`Circles`].
    pub(super) fn run<const ORDER: u8>(&self, q: f64, state: &mut State) -> Outcome {
        let local = self.through + self.along * q;
        let rho2 = local.norm2();
        let (rho, c) = (rho2.sqrt(), self.far.length);
        let p = state.points[self.pivot.index()];
        let far = state.points[self.far.pivot.index()];
        let u = far.p - p.p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let (inner, outer) = (d - (rho - c).abs(), (rho + c) - d);
        let product = (inner * (d + (rho - c).abs())) * (outer * ((rho + c) + d));
        state.measures[self.group] = product / (4.0 * rho2 * c * c);
        let slack = REACH_SLACK * (rho + c);
        if !(inner >= -slack && outer >= -slack && rho > 0.0) {
            return Outcome::Open;
        }
        let stretched = inner <= slack || outer <= slack;
        if stretched && d <= slack {
            // Equal arms about one pivot, as above.
            return Outcome::Open;
        }
        let sh = if stretched {
            0.0
        } else {
            state.signs[self.group] * 0.5 * product.sqrt()
        };
        let x = 0.5 * (d2 + (rho - c) * (rho + c));
        let e = (u * x + u.perp() * sh) / d2;
        let f = e - u;
        let mut point = PointState {
            p: p.p + e,
            ..PointState::default()
        };
        let mut barrel = LinkState {
            d: e.turned(local.conj()) / rho2,
            ..LinkState::default()
        };
        let mut link = LinkState {
            d: f.turned(self.far.factor),
            ..LinkState::default()
        };
        if ORDER >= VELOCITY && !stretched {
            let scale = 1.0 / sh;
            let tau = self.along.turned(barrel.d);
            let dv = far.v - p.v - tau;
            barrel.w = f.dot(dv) * scale;
            link.w = e.dot(dv) * scale;
            point.v = far.v + f.perp() * link.w;
            if ORDER >= ACCELERATION {
                let coriolis = tau.perp() * (2.0 * barrel.w);
                let da =
                    (far.a - p.a) - coriolis + e * (barrel.w * barrel.w) - f * (link.w * link.w);
                barrel.a = f.dot(da) * scale;
                link.a = e.dot(da) * scale;
                point.a = far.a + f.perp() * link.a - f * (link.w * link.w);
            }
        }
        state.points[self.point.index()] = point;
        state.links[self.link.index()] = barrel;
        state.links[self.far.link.index()] = link;
        if stretched {
            Outcome::Stretched
        } else {
            Outcome::Done
        }
    }
}
