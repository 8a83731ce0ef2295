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
use crate::arithmetic::{Both, Halves, U, two_sum};
use crate::solver::elements::{ACCELERATION, Arm, VELOCITY};
use crate::solver::state::{LinkState, PointState};
use crate::{Constant, Number, Vec2};

/// What residuals in twice the precision still round, in parts of the size of their terms.
pub(super) const RESIDUAL: f64 = 32.0 * U * U;
/// What a short sum of products in doubles rounds, in parts of the size of its terms.
pub(super) const SUM: f64 = 8.0 * U;

/// A way between two points of a link, with its rates, and what they leave over; or two such at once.
pub(super) struct Limb<T, const FUSED: bool> {
    pub e: Vec2<T>,
    /// What e leaves out of the way.
    pub lost: Vec2<T>,
    pub w: Vec2<T>,
    pub a: Vec2<T>,
    pub rho: Vec2<T>,
    pub sigma: Vec2<T>,
    /// The sizes of e, w and a.
    pub sizes: [T; 3],
    /// How far rho and sigma can be from what they say.
    pub fuzz: [T; 2],
    halves: Vec2<Halves<T, FUSED>>,
}

/// What an arm is given by: the square of its length and its factor, each with the digits that a double leaves
/// out, and how far they can be off.
#[derive(Clone, Copy)]
pub(super) struct Shape<T = f64> {
    square: [T; 3],
    factor: Vec2<T>,
    low: Vec2<T>,
    off: T,
    /// Whether it lies along the x axis of its link, as most do.
    is_straight: bool,
}

impl Shape {
    #[inline(always)]
    pub(super) fn of(arm: &Arm) -> Shape {
        let Arm { square, factor, .. } = *arm;
        Shape {
            square: [square.hi, square.lo, square.radius],
            factor: Vec2::new(factor.x.hi, factor.y.hi),
            low: Vec2::new(factor.x.lo, factor.y.lo),
            off: factor.x.radius + factor.y.radius,
            is_straight: factor.y == Constant::default(),
        }
    }
}

impl Shape<Both> {
    #[inline(always)]
    pub(super) fn of_both(near: &Arm, far: &Arm) -> Shape<Both> {
        let (a, b) = (Shape::of(near), Shape::of(far));
        let square = |k: usize| Both([a.square[k], b.square[k]]);
        Shape {
            square: [square(0), square(1), square(2)],
            factor: Vec2::both(a.factor, b.factor),
            low: Vec2::both(a.low, b.low),
            off: Both([a.off, b.off]),
            is_straight: a.is_straight && b.is_straight,
        }
    }
}

/// x - p, and what that leaves out.
#[inline(always)]
pub(super) fn difference<T: Number>(x: Vec2<T>, p: Vec2<T>) -> [Vec2<T>; 2] {
    let (dx, lost_x) = two_sum(x.x, -p.x);
    let (dy, lost_y) = two_sum(x.y, -p.y);
    [Vec2::new(dx, dy), Vec2::new(lost_x, lost_y)]
}

impl<T: Number, const FUSED: bool> Limb<T, FUSED> {
    /// From `p` to `x`.
    #[inline(always)]
    pub(super) fn new<const ORDER: u8>(
        x: &PointState<T>,
        p: &PointState<T>,
        link: &LinkState<T>,
    ) -> Self {
        let [e, lost] = difference(x.p, p.p);
        let none = T::default();
        let nowhere = Vec2::new(none, none);
        let mut limb = Limb {
            e,
            lost,
            w: nowhere,
            a: nowhere,
            rho: nowhere,
            sigma: nowhere,
            sizes: [size(e), none, none],
            fuzz: [none; 2],
            halves: Vec2::new(Halves::of(e.x), Halves::of(e.y)),
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
    fn see_velocity(&mut self, [w, low]: [Vec2<T>; 2], spin: T, omega: Halves<T, FUSED>) {
        // w + omega (e.y, -e.x), the products largest and almost opposite.
        let (y, x) = (omega.times(self.halves.y), omega.times(self.halves.x));
        self.w = w;
        self.rho = Vec2::new(
            (w.x + y.hi) + (low.x + (y.lo + spin * self.lost.y)),
            (w.y - x.hi) + (low.y - (x.lo + spin * self.lost.x)),
        );
        self.sizes[1] = size(w);
        let terms = self.sizes[1] + spin.abs() * self.sizes[0];
        self.fuzz[0] = terms.scaled(RESIDUAL) + size(self.rho).scaled(SUM);
    }

    #[inline(always)]
    fn see_acceleration(
        &mut self,
        [a, low]: [Vec2<T>; 2],
        [w, w_low]: [Vec2<T>; 2],
        link: &LinkState<T>,
        omega: Halves<T, FUSED>,
    ) {
        let alpha = Halves::of(link.a);
        // alpha e + omega w, of one component.
        let part = |e: Halves<T, FUSED>, lost: T, w: T, low: T| {
            let (turning, driven) = (alpha.times(e), omega.times(Halves::of(w)));
            let (sum, rest) = two_sum(turning.hi, driven.hi);
            let small = rest + (turning.lo + driven.lo) + (link.a * lost + link.w * low);
            (sum, small)
        };
        let y = part(self.halves.y, self.lost.y, w.y, w_low.y);
        let x = part(self.halves.x, self.lost.x, w.x, w_low.x);
        self.a = a;
        self.sigma = Vec2::new((a.x + y.0) + (low.x + y.1), (a.y - x.0) + (low.y - x.1));
        let [length, speed, _] = self.sizes;
        self.sizes[2] = size(a);
        let terms = self.sizes[2] + link.a.abs() * length + link.w.abs() * speed;
        self.fuzz[1] = terms.scaled(RESIDUAL) + size(self.sigma).scaled(SUM);
    }

    /// (|e|^2 - b^2) / 2, and how far that can be from what is true of the points.
    #[inline(always)]
    pub(super) fn stretch(&self, shape: &Shape<T>) -> [T; 2] {
        let [square, low, radius] = shape.square;
        let (xx, yy) = (self.halves.x.square(), self.halves.y.square());
        // Largest terms first; what their sum loses joins the small ones. The difference loses nothing, or less than
        // a rounding of the stretch.
        let (sum, lost) = two_sum(xx.hi, yy.hi);
        let rest = sum - square;
        let small = lost + (xx.lo + yy.lo) - low;
        let stretch = (rest + (small + self.e.dot(self.lost).scaled(2.0))).scaled(0.5);
        let fuzz = radius.scaled(0.5) + square.scaled(RESIDUAL) + stretch.abs().scaled(4.0 * U);
        [stretch, fuzz]
    }

    /// e factor - d: from the computed direction to that of the way.
    #[inline(always)]
    fn turn(&self, shape: &Shape<T>, d: Vec2<T>) -> Vec2<T> {
        let Shape { factor, low, .. } = *shape;
        let (e, lost, halves) = (self.e, self.lost, &self.halves);
        let fx = Halves::of(factor.x);
        let (px, py) = (fx.times(halves.x), fx.times(halves.y));
        let rest = Vec2::new(
            low.x * e.x + factor.x * lost.x,
            low.x * e.y + factor.x * lost.y,
        );
        if shape.is_straight {
            return Vec2::new(
                (px.hi - d.x) + (px.lo + rest.x),
                (py.hi - d.y) + (py.lo + rest.y),
            );
        }
        let fy = Halves::of(factor.y);
        let (qx, qy) = (fy.times(halves.y), fy.times(halves.x));
        let (sx, lost_x) = two_sum(px.hi, -qx.hi);
        let (sy, lost_y) = two_sum(py.hi, qy.hi);
        let over_x = low.y * e.y + factor.y * lost.y;
        let over_y = low.y * e.x + factor.y * lost.x;
        Vec2::new(
            (sx - d.x) + (lost_x + (px.lo - qx.lo) + (rest.x - over_x)),
            (sy - d.y) + (lost_y + (py.lo + qy.lo) + (rest.y + over_y)),
        )
    }

    /// The errors of the link whose arm this is, with all that is left of them but for what the rests of the ends
    /// move; and by how much these move its angle. `along` bounds e . of the rests of e and w.
    #[inline(always)]
    pub(super) fn link_error<const ORDER: u8>(
        &self,
        shape: &Shape<T>,
        link: &LinkState<T>,
        [x, p]: [&PointError<T>; 2],
        along: [T; 2],
    ) -> (LinkError<T>, T) {
        let [length, speed, _] = self.sizes;
        let inverse = T::exactly(1.0) / self.e.norm2();
        let gain = length * inverse;
        let most = |order: usize| (x.most[order] + p.most[order]).scaled(2.0);
        let mut error = LinkError::none();

        let e = x.shift[0] - p.shift[0];
        let turn = self.turn(shape, link.d);
        let off = most(0);
        error.direction = turn + e.turned(shape.factor);
        let rounding = (size(turn) + size(shape.factor) * off).scaled(SUM);
        error.rest[0] = shape.off * length + rounding + T::exactly(2.0 * RESIDUAL);
        error.along = along[0] * inverse + error.rest[0];
        if ORDER < VELOCITY {
            return (error, gain);
        }

        let omega = link.w.abs();
        let w = x.shift[1] - p.shift[1];
        error.shift[0] = (self.e.cross(self.rho + w) - link.w * self.e.dot(e)) * inverse;
        // As long as the way does not lose two fifths of its length, twice the gain covers its inverse.
        let keeps = length.exceeds(off * T::exactly(2.5));
        let short = if keeps {
            gain.scaled(2.0)
        } else {
            T::exactly(f64::INFINITY)
        };
        let terms = size(self.rho) + most(1) + omega * off;
        let spin = short * terms;
        let left = self.fuzz[0] + spin * off + terms.scaled(SUM);
        error.rest[1] = gain * left + omega * along[0] * inverse;
        if ORDER < ACCELERATION {
            return (error, gain);
        }

        let alpha = link.a.abs();
        let a = x.shift[2] - p.shift[2];
        let skew = self.e.dot(self.rho);
        error.shift[1] = (self.e.cross(self.sigma + a)
            - link.a * self.e.dot(e)
            - error.shift[0] * skew
            - link.w * self.e.dot(w))
            * inverse;
        let terms =
            size(self.sigma) + (most(2) + alpha * off + omega * most(1)) + spin * (speed + most(1));
        let left = self.fuzz[1] + (short * terms * off + spin * most(1)) + terms.scaled(SUM);
        error.rest[2] = gain * left
            + (alpha * along[0] + omega * along[1] + (skew.abs() * spin).scaled(2.0)) * inverse;
        (error, gain)
    }
}

/// The derivative of a link's angle by a way on it.
pub(super) fn across(e: Vec2) -> Vec2 {
    e.perp() * (1.0 / e.norm2())
}

impl<const FUSED: bool> Limb<f64, FUSED> {
    /// e - R(d) local: from where the link carries the point to where it was put.
    #[inline(always)]
    fn miss(&self, local: Vec2<Constant>, d: Vec2) -> Vec2 {
        let [carried, low] = turned_closely::<FUSED>(local, d);
        (self.e - carried) + (self.lost - low)
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
        let mut error = PointError::none();

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
pub(super) fn turned_closely<const FUSED: bool>(v: Vec2<Constant>, d: Vec2) -> [Vec2; 2] {
    let (lx, ly) = (Halves::<f64, FUSED>::of(v.x.hi), Halves::of(v.y.hi));
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
