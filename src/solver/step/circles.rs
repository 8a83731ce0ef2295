//! Dyads of two circles: RRR, with arms of fixed length or one that a cylinder pushes.

use super::{ACCELERATION, Arm, Outcome, REACH_SLACK, VELOCITY};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Constant, LinkId, Number, PointId, Vec2};

/// Two circles, RRR. The shorter arm comes first: the point is measured from its pivot. The sign of
/// the group is +1 where the point lies on the left of near.pivot -> far.pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Circles {
    pub point: PointId,
    pub near: Arm,
    pub far: Arm,
    /// The squares of far - near and near + far, of which the square of the pivots' distance keeps its digits.
    least: Constant,
    most: Constant,
    /// (near - far)(near + far).
    squares: Constant,
    /// 1 / (2 near far)^2, which makes the product of the reaches the square of a sine.
    inverse_square: f64,
    /// Twice the distances of least and most, and how far they count as reached.
    ends: [f64; 2],
    slack: f64,
    pub group: usize,
}

impl Circles {
    pub(in crate::solver) fn new(point: PointId, arms: [Arm; 2], group: usize) -> Circles {
        let [a, b] = arms;
        let arms = if (a.length - b.length).hi <= 0.0 {
            [a, b]
        } else {
            [b, a]
        };
        Circles::measured(point, arms, group)
    }

    /// Measures the point from this pivot.
    pub(in crate::solver) fn measure_from(&mut self, pivot: PointId) {
        if self.near.pivot != pivot {
            *self = Circles::measured(self.point, [self.far, self.near], self.group);
        }
    }

    fn measured(point: PointId, [near, far]: [Arm; 2], group: usize) -> Circles {
        let (b, c) = (near.length, far.length);
        Circles {
            point,
            near,
            far,
            least: (c - b) * (c - b),
            most: (c + b) * (c + b),
            squares: (b - c) * (b + c),
            inverse_square: (2.0 * b.hi * c.hi).powi(-2),
            ends: [2.0 * (c - b).hi.abs(), 2.0 * (c + b).hi],
            slack: REACH_SLACK * (b.hi + c.hi),
            group,
        }
    }

    /// X = P + (x u + s h k x u) / u.u with u = Q - P, x = (u.u + b^2 - c^2) / 2 and h twice the area
    /// of the triangle of sides b, c, |u|: 16 A^2 = (d^2 - m^2)(M^2 - d^2), m = c - b, M = b + c.
    ///
    /// These are the factors of Kahan's product (Miscalculating Area and Angles of a Needle-like Triangle) two
    /// by two: d is found by its square, whose digits its root would only round once more.
    #[inline(always)]
    pub(super) fn run<T: Number, const ORDER: u8>(&self, state: &mut State<T>) -> Outcome {
        let u = self.between(state);
        let d2 = u.norm2();
        let (inner, outer) = self.reaches(d2);
        let product = inner * outer;
        state.measures[self.group] = product * T::exactly(self.inverse_square);
        let [least, most] = self.slacks();
        if !(inner.exceeds(least) && outer.exceeds(most)) {
            return Outcome::Unclear;
        }
        let x = (d2 + T::of(self.squares)).scaled(0.5);
        let inverse = T::exactly(1.0) / d2;
        let sh = state.signs[self.group].scaled(0.5) * product.sqrt();
        let e = (u * x + u.perp() * sh) * inverse;
        self.place::<T, ORDER>(e, e - u, sh, state);
        Outcome::Done
    }

    /// How far the square of the pivots' distance is above the least and below the most that the arms reach.
    #[inline(always)]
    fn reaches<T: Number>(&self, d2: T) -> (T, T) {
        (d2 - T::of(self.least), T::of(self.most) - d2)
    }

    /// What rounding leaves of the reaches: (d + slack)^2 - d^2.
    #[inline(always)]
    fn slacks<T: Number>(&self) -> [T; 2] {
        let slack = self.slack * T::GRAIN;
        self.ends.map(|d| T::exactly(slack * (d + slack)))
    }

    /// Writes the dyad where X = P + e = Q + f. V_P + w1 k x e = V_Q + w2 k x f, and e x f = s h.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        e: Vec2<T>,
        f: Vec2<T>,
        sh: T,
        state: &mut State<T>,
    ) {
        let p = state.points[self.near.pivot.index()];
        let q = state.points[self.far.pivot.index()];
        let mut point = PointState::fixed(p.p + e);
        let mut near = LinkState::fixed(self.near.direction(e));
        let mut far = LinkState::fixed(self.far.direction(f));
        if ORDER >= VELOCITY {
            let scale = T::exactly(1.0) / sh;
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
    }

    /// Whether the arms reach each other within rounding, and say a direction.
    pub(super) fn is_in_reach<T: Number>(&self, state: &State<T>) -> bool {
        let u = self.between(state);
        let d2 = u.norm2();
        let (inner, outer) = self.reaches(d2);
        let [least, most] = self.slacks::<T>();
        let is_open = (-least).exceeds(inner) || (-most).exceeds(outer);
        let slack = T::exactly(self.slack * T::GRAIN);
        // Equal arms about one pivot: the point could be anywhere around it.
        d2.is_finite() && T::norm(u).exceeds(slack) && !is_open
    }

    /// The arms in line: positions alone. The nearer arm keeps its length also where the pivots all but
    /// coincide.
    pub(super) fn align<T: Number>(&self, state: &mut State<T>) {
        let u = self.between(state);
        let x = u.norm2() + T::exactly(self.squares.hi);
        let length = T::of(self.near.length);
        let along = if x.nearest() < 0.0 { -length } else { length };
        let e = u * (along / T::norm(u));
        self.place::<T, { super::POSITION }>(e, e - u, T::default(), state);
    }

    /// From pivot to pivot.
    #[inline(always)]
    fn between<T: Number>(&self, state: &State<T>) -> Vec2<T> {
        let at = |pivot: PointId| state.points[pivot.index()].p;
        at(self.far.pivot) - at(self.near.pivot)
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
    pub through: Vec2<Constant>,
    pub along: Vec2<Constant>,
    pub far: Arm,
    pub group: usize,
}

/// The triangle of a cylinder's pivots and its pin.
#[derive(Clone, Copy)]
struct Triangle<T> {
    /// The square of the arm, and its length.
    rho2: T,
    rho: T,
    /// From pivot to pivot.
    u: Vec2<T>,
    d2: T,
    /// How far the arms are from their inner and outer reach.
    inner: T,
    outer: T,
    /// 16 A^2.
    product: T,
}

impl Cylinder {
    /// The square of the arm.
    #[inline(always)]
    pub(in crate::solver) fn arm_square<T: Number>(&self, q: T) -> T {
        (Vec2::of(self.through) + Vec2::of(self.along) * q).norm2()
    }

    #[inline(always)]
    fn triangle<T: Number>(&self, q: T, state: &State<T>) -> Triangle<T> {
        let rho2 = self.arm_square(q);
        let (rho, c) = (rho2.sqrt(), T::of(self.far.length));
        let u = state.points[self.far.pivot.index()].p - state.points[self.pivot.index()].p;
        let d2 = u.norm2();
        let d = d2.sqrt();
        let difference = (rho - c).abs();
        let (inner, outer) = (d - difference, (rho + c) - d);
        let product = (inner * (d + difference)) * (outer * ((rho + c) + d));
        Triangle {
            rho2,
            rho,
            u,
            d2,
            inner,
            outer,
            product,
        }
    }

    /// From the pivot to the point, for e x f = `sh`.
    #[inline(always)]
    fn arm<T: Number>(&self, of: &Triangle<T>, sh: T) -> Vec2<T> {
        let c = T::of(self.far.length);
        let x = (of.d2 + (of.rho - c) * (of.rho + c)).scaled(0.5);
        (of.u * x + of.u.perp() * sh) / of.d2
    }

    /// The arm is r = through + along q in its link's frame: a circle whose radius varies.
    /// Otherwise as [`Circles`].
    pub(super) fn run<T: Number, const ORDER: u8>(&self, q: T, state: &mut State<T>) -> Outcome {
        let of = self.triangle(q, state);
        let c = self.far.length.hi;
        let scale = of.rho2 * T::exactly(4.0 * c * c);
        state.measures[self.group] = of.product / scale;
        let slack = (of.rho + T::exactly(c)).scaled(REACH_SLACK * T::GRAIN);
        if !of.inner.min(of.outer).exceeds(slack) {
            return Outcome::Unclear;
        }
        let sh = state.signs[self.group] * of.product.sqrt().scaled(0.5);
        let e = self.arm(&of, sh);
        self.place::<T, ORDER>(q, e, e - of.u, sh, state);
        Outcome::Done
    }

    /// Writes the dyad where X = P + e = Q + f. With tau the guide's direction in the ground,
    /// V = V_P + w k x e + tau and A = A_P + alpha k x e - w^2 e + 2 w k x tau.
    #[inline(always)]
    pub(in crate::solver) fn place<T: Number, const ORDER: u8>(
        &self,
        q: T,
        e: Vec2<T>,
        f: Vec2<T>,
        sh: T,
        state: &mut State<T>,
    ) {
        let local = Vec2::of(self.through) + Vec2::of(self.along) * q;
        let p = state.points[self.pivot.index()];
        let far = state.points[self.far.pivot.index()];
        let mut point = PointState::fixed(p.p + e);
        let mut barrel = LinkState::fixed(e.turned(local.conj()) / local.norm2());
        let mut link = LinkState::fixed(self.far.direction(f));
        if ORDER >= VELOCITY {
            let scale = T::exactly(1.0) / sh;
            let tau = Vec2::of(self.along).turned(barrel.d);
            let dv = far.v - p.v - tau;
            barrel.w = f.dot(dv) * scale;
            link.w = e.dot(dv) * scale;
            point.v = far.v + f.perp() * link.w;
            if ORDER >= ACCELERATION {
                let coriolis = tau.perp() * barrel.w.scaled(2.0);
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
    }

    /// As [`Circles::is_in_reach`].
    pub(super) fn is_in_reach<T: Number>(&self, q: T, state: &State<T>) -> bool {
        let of = self.triangle(q, state);
        let size = of.rho + T::exactly(self.far.length.hi);
        let slack = size.scaled(REACH_SLACK * T::GRAIN);
        let misses = |reach: T| (-slack).exceeds(reach);
        let has_direction = of.rho.exceeds(T::default()) && of.d2.sqrt().exceeds(slack);
        of.d2.is_finite() && has_direction && !misses(of.inner) && !misses(of.outer)
    }

    /// As [`Circles::align`].
    pub(super) fn align<T: Number>(&self, q: T, state: &mut State<T>) {
        let of = self.triangle(q, state);
        let e = self.arm(&of, T::default());
        self.place::<T, { super::POSITION }>(q, e, e - of.u, T::default(), state);
    }
}
