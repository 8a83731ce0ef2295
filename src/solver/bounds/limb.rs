//! Two points of one link: what is left over of their motion about each other.
//!
//! With e from the one to the other, w and a its computed rates, and omega, alpha those of the link,
//!
//! ```text
//! w = omega k x e + rho          a = alpha k x e + omega k x w + sigma
//! ```
//!
//! where rho and sigma would be zero without rounding. They are found in twice the digits; everything
//! that follows from them is small, and doubles will do.

use super::errors::{LinkError, PointError, larger, size};
use crate::arithmetic::{Halves, U, two_sum};
use crate::solver::state::{LinkState, PointState};
use crate::solver::step::{ACCELERATION, Arm, VELOCITY};
use crate::{Constant, Double, Vec2};

/// What residuals in twice the precision still round, in parts of the size of their terms.
pub(super) const RESIDUAL: f64 = 32.0 * U * U;
/// What a short sum of products in doubles rounds, in parts of the size of its terms.
pub(super) const SUM: f64 = 8.0 * U;

/// A way between two points of a link, with its rates, and what they leave over.
pub(super) struct Limb {
    pub e: Vec2,
    /// What e leaves out of the way.
    pub lost: Vec2,
    pub w: Vec2,
    pub a: Vec2,
    pub rho: Vec2,
    pub sigma: Vec2,
    /// The sizes of e, w and a.
    pub sizes: [f64; 3],
    /// How far rho and sigma can be from what they say.
    pub fuzz: [f64; 2],
    halves: Vec2<Halves>,
}

#[inline(always)]
pub(super) fn difference(x: Vec2, p: Vec2) -> Vec2<Double> {
    Vec2::new(Double::sum(x.x, -p.x), Double::sum(x.y, -p.y))
}

impl Limb {
    /// From `p` to `x`.
    #[inline(always)]
    pub(super) fn new<const ORDER: u8>(x: &PointState, p: &PointState, link: &LinkState) -> Limb {
        let way = difference(x.p, p.p);
        let e = way.map(|v| v.hi);
        let mut limb = Limb {
            e,
            lost: way.map(|v| v.lo),
            w: Vec2::ZERO,
            a: Vec2::ZERO,
            rho: Vec2::ZERO,
            sigma: Vec2::ZERO,
            sizes: [size(e), 0.0, 0.0],
            fuzz: [0.0; 2],
            halves: e.map(Halves::of),
        };
        if ORDER >= VELOCITY {
            let rate = difference(x.v, p.v);
            let omega = Halves::of(link.w);
            limb.see_velocity(rate, link.w, omega);
            if ORDER >= ACCELERATION {
                let second = difference(x.a, p.a);
                limb.see_acceleration(second, rate, link, omega);
            }
        }
        limb
    }

    #[inline(always)]
    fn see_velocity(&mut self, rate: Vec2<Double>, w: f64, omega: Halves) {
        // w + omega (e.y, -e.x), the products largest and almost opposite.
        let part = |rate: Double, of: Halves, lost: f64, sign: f64| {
            let turned = omega.times(of);
            (rate.hi + sign * turned.hi) + (rate.lo + sign * (turned.lo + w * lost))
        };
        self.w = rate.map(|v| v.hi);
        self.rho = Vec2::new(
            part(rate.x, self.halves.y, self.lost.y, 1.0),
            part(rate.y, self.halves.x, self.lost.x, -1.0),
        );
        self.sizes[1] = size(self.w);
        let terms = self.sizes[1] + w.abs() * self.sizes[0];
        self.fuzz[0] = RESIDUAL * terms + SUM * size(self.rho);
    }

    #[inline(always)]
    fn see_acceleration(
        &mut self,
        second: Vec2<Double>,
        rate: Vec2<Double>,
        link: &LinkState,
        omega: Halves,
    ) {
        let alpha = Halves::of(link.a);
        let part = |a: Double, e: (Halves, f64), w: Double, sign: f64| {
            let (turning, driven) = (alpha.times(e.0), omega.times(Halves::of(w.hi)));
            let (sum, lost) = two_sum(turning.hi, driven.hi);
            let small = lost + (turning.lo + driven.lo) + (link.a * e.1 + link.w * w.lo);
            (a.hi + sign * sum) + (a.lo + sign * small)
        };
        self.a = second.map(|v| v.hi);
        self.sigma = Vec2::new(
            part(second.x, (self.halves.y, self.lost.y), rate.y, 1.0),
            part(second.y, (self.halves.x, self.lost.x), rate.x, -1.0),
        );
        let [length, speed, _] = self.sizes;
        self.sizes[2] = size(self.a);
        let terms = self.sizes[2] + link.a.abs() * length + link.w.abs() * speed;
        self.fuzz[1] = RESIDUAL * terms + SUM * size(self.sigma);
    }

    /// (|e|^2 - b^2) / 2, and how far that can be from what is true of the points.
    #[inline(always)]
    pub(super) fn stretch(&self, square: Constant) -> [f64; 2] {
        let (xx, yy) = (self.halves.x.square(), self.halves.y.square());
        // Largest terms first; what each sum loses joins the small ones.
        let (sum, lost) = two_sum(xx.hi, yy.hi);
        let (rest, lost_too) = two_sum(sum, -square.hi);
        let small = (lost + lost_too) + (xx.lo + yy.lo) - square.lo;
        let stretch = 0.5 * (rest + (small + 2.0 * self.e.dot(self.lost)));
        let fuzz = 0.5 * square.radius + RESIDUAL * square.hi + 2.0 * U * stretch.abs();
        [stretch, fuzz]
    }

    /// e factor - d: from the computed direction to that of the way.
    #[inline(always)]
    fn turn(&self, factor: Vec2<Constant>, d: Vec2) -> Vec2 {
        let (x, fx) = (&self.halves, Halves::of(factor.x.hi));
        let low = |a: Constant, e: f64, lost: f64| a.lo * e + a.hi * lost;
        let (px, py) = (fx.times(x.x), fx.times(x.y));
        let rest = Vec2::new(
            low(factor.x, self.e.x, self.lost.x),
            low(factor.x, self.e.y, self.lost.y),
        );
        // Most arms lie along the x axis of their link.
        if factor.y == Constant::default() {
            return Vec2::new(
                (px.hi - d.x) + (px.lo + rest.x),
                (py.hi - d.y) + (py.lo + rest.y),
            );
        }
        let fy = Halves::of(factor.y.hi);
        let (qx, qy) = (fy.times(x.y), fy.times(x.x));
        let (sx, lost_x) = two_sum(px.hi, -qx.hi);
        let (sy, lost_y) = two_sum(py.hi, qy.hi);
        let over_x = low(factor.y, self.e.y, self.lost.y);
        let over_y = low(factor.y, self.e.x, self.lost.x);
        Vec2::new(
            (sx - d.x) + (lost_x + (px.lo - qx.lo) + (rest.x - over_x)),
            (sy - d.y) + (lost_y + (py.lo + qy.lo) + (rest.y + over_y)),
        )
    }

    /// e - R(d) local: from where the link carries the point to where it was put.
    #[inline(always)]
    pub(super) fn miss(&self, local: Vec2<Constant>, d: Vec2) -> Vec2 {
        let [carried, low] = turned_closely(local, d);
        (self.e - carried) + (self.lost - low)
    }

    /// The errors of the link whose arm this is, with what is new in their rests: beside those of the ends'.
    /// `along` bounds e . of the rests of e and w.
    #[inline(always)]
    pub(super) fn link_error<const ORDER: u8>(
        &self,
        arm: &Arm,
        link: &LinkState,
        [x, p]: [&PointError; 2],
        along: [f64; 2],
    ) -> LinkError {
        let [length, speed, _] = self.sizes;
        let inverse = 1.0 / self.e.norm2();
        let gain = length * inverse;
        let most = |order: usize| x.most[order] + p.most[order];
        let mut error = LinkError::default();

        let e = x.shift[0] - p.shift[0];
        let factor = arm.factor.map(|v| v.hi);
        let turn = self.turn(arm.factor, link.d);
        error.direction = turn + e.turned(factor);
        let meant = (arm.factor.x.radius + arm.factor.y.radius) * length;
        let rounding = 2.0 * RESIDUAL + SUM * (size(turn) + 2.0 * size(factor) * most(0));
        error.rest[0] = meant + rounding;
        error.along = along[0] * inverse + error.rest[0];
        if ORDER < VELOCITY {
            return error;
        }

        let omega = link.w.abs();
        let w = x.shift[1] - p.shift[1];
        error.shift[0] = (self.e.cross(self.rho + w) - link.w * self.e.dot(e)) * inverse;
        // As long as the way does not lose two fifths of its length, twice the gain covers its inverse.
        let keeps = 5.0 * most(0) <= length;
        let short = if keeps { 2.0 * gain } else { f64::INFINITY };
        let terms = size(self.rho) + 2.0 * (most(1) + omega * most(0));
        let spin = short * terms;
        let left = self.fuzz[0] + 2.0 * spin * most(0) + SUM * terms;
        error.rest[1] = gain * left + omega * along[0] * inverse;
        if ORDER < ACCELERATION {
            return error;
        }

        let alpha = link.a.abs();
        let a = x.shift[2] - p.shift[2];
        let skew = self.e.dot(self.rho);
        error.shift[1] = (self.e.cross(self.sigma + a)
            - link.a * self.e.dot(e)
            - error.shift[0] * skew
            - link.w * self.e.dot(w))
            * inverse;
        let terms = size(self.sigma)
            + 2.0 * (most(2) + alpha * most(0) + omega * most(1))
            + spin * (speed + 2.0 * most(1));
        let left = self.fuzz[1] + 2.0 * (short * terms * most(0) + spin * most(1)) + SUM * terms;
        error.rest[2] =
            gain * left + (alpha * along[0] + omega * along[1] + 2.0 * skew.abs() * spin) * inverse;
        error
    }

    /// By how much the rests of the way move the link's angle.
    #[inline(always)]
    pub(super) fn gain(&self) -> f64 {
        self.sizes[0] / self.e.norm2()
    }

    /// The derivative of the link's angle by the way.
    #[inline(always)]
    pub(super) fn across(&self) -> Vec2 {
        self.e.perp() * (1.0 / self.e.norm2())
    }

    /// The errors of a point that rides on a link, from those of its base and of the link, with what is new
    /// in their rests.
    #[inline(always)]
    pub(super) fn point_error<const ORDER: u8>(
        &self,
        local: Vec2<Constant>,
        link: &LinkState,
        base: &PointError,
        turned: &LinkError,
    ) -> PointError {
        let [length, speed, _] = self.sizes;
        let mut error = PointError::default();

        let miss = self.miss(local, link.d);
        let reach = local.map(|v| v.hi);
        let e = reach.turned(turned.direction) - miss;
        error.shift[0] = base.shift[0] + e;
        let new = length * turned.along
            + swing_rest(local, turned)
            + RESIDUAL * length
            + SUM * (size(miss) + base.most[0]);
        error.left[0] = new;
        if ORDER < VELOCITY {
            return error;
        }

        let rest_e = length * turned.rest[0] + new;
        let most_e = larger(e) + rest_e;
        let omega = link.w.abs();
        let w = self.e.perp() * turned.shift[0] + e.perp() * link.w - self.rho;
        error.shift[1] = base.shift[1] + w;
        let spin = turned.most_rate(1);
        let new = omega * rest_e
            + spin * most_e
            + self.fuzz[0]
            + SUM * (length * spin + omega * most_e + base.most[1]);
        error.left[1] = new;
        if ORDER < ACCELERATION {
            return error;
        }

        let rest_w = length * turned.rest[1] + new;
        let most_w = larger(w) + rest_w;
        let alpha = link.a.abs();
        let a = self.e.perp() * turned.shift[1]
            + e.perp() * link.a
            + self.w.perp() * turned.shift[0]
            + w.perp() * link.w
            - self.sigma;
        error.shift[2] = base.shift[2] + a;
        let gain = turned.most_rate(2);
        error.left[2] = alpha * rest_e
            + speed * turned.rest[1]
            + omega * rest_w
            + gain * most_e
            + spin * most_w
            + self.fuzz[1]
            + SUM * (length * gain + alpha * most_e + speed * spin + omega * most_w + base.most[2]);
        error
    }
}

/// R(d) v to twice the digits, as two vectors.
#[inline(always)]
pub(super) fn turned_closely(v: Vec2<Constant>, d: Vec2) -> [Vec2; 2] {
    let (lx, ly) = (Halves::of(v.x.hi), Halves::of(v.y.hi));
    let (dx, dy) = (Halves::of(d.x), Halves::of(d.y));
    let (a, p) = (lx.times(dx), lx.times(dy));
    let low = v.map(|v| v.lo).turned(d);
    // Most points of a bar lie along its x axis.
    if v.y == Constant::default() {
        return [Vec2::new(a.hi, p.hi), Vec2::new(a.lo + low.x, p.lo + low.y)];
    }
    let (b, q) = (ly.times(dy), ly.times(dx));
    let (sx, lost_x) = two_sum(a.hi, -b.hi);
    let (sy, lost_y) = two_sum(p.hi, q.hi);
    let low = Vec2::new(
        lost_x + (a.lo - b.lo) + low.x,
        lost_y + (p.lo + q.lo) + low.y,
    );
    [Vec2::new(sx, sy), low]
}

/// What is new in the rest of a point that a link swings: the digits of its place, and rounding.
#[inline(always)]
pub(super) fn swing_rest(local: Vec2<Constant>, turned: &LinkError) -> f64 {
    let reach = size(local.map(|v| v.hi));
    let typed = 1.5 * (local.x.radius + local.y.radius);
    let swung = turned.rest[0] + size(turned.direction);
    typed + RESIDUAL * reach + 2.0 * SUM * reach * swung
}
