//! One constraint on a joint, held against the computed state at each order: see [`pair`](super::pair).

use super::errors::size;
use super::limb::{Limb, RESIDUAL, SUM, Shape};
use crate::arithmetic::{Both, Halves, two_sum};
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::state::PointState;
use crate::{Constant, Number, Vec2};

/// One constraint on X where it was computed to be; or two of them.
pub(super) struct Row<T = f64> {
    pub gradient: Vec2<T>,
    /// The rates of the gradient: w and a of a circle, nothing of a rail.
    pub w: Vec2<T>,
    pub a: Vec2<T>,
    /// The sizes of these.
    pub sizes: [T; 3],
    /// Its value and rates there, and how far these may be from the true ones.
    pub values: [T; 3],
    pub fuzz: [T; 3],
    /// How fast the gradient changes with X.
    pub curvature: T,
}

impl<T: Number> Row<T> {
    /// (|X - P|^2 - b^2) / 2.
    #[inline(always)]
    pub(super) fn circle<const ORDER: u8, const FUSED: bool>(
        limb: &Limb<T, FUSED>,
        shape: &Shape<T>,
    ) -> Row<T> {
        let Limb { e, w, a, .. } = *limb;
        let [length, speed, _] = limb.sizes;
        let [stretch, off] = limb.stretch(shape);
        let none = T::default();
        let mut values = [stretch, none, none];
        let mut fuzz = [off, none, none];
        if ORDER >= VELOCITY {
            values[1] = e.dot(limb.rho);
            fuzz[1] = length * limb.fuzz[0];
        }
        if ORDER >= ACCELERATION {
            values[2] = e.dot(limb.sigma) + w.dot(limb.rho);
            fuzz[2] = length * limb.fuzz[1] + speed * limb.fuzz[0];
        }
        Row {
            gradient: e,
            w,
            a,
            sizes: limb.sizes,
            values,
            fuzz,
            curvature: T::exactly(1.0),
        }
    }
}

impl Row {
    /// n.(X - C) of a rail through C along t, and its rates.
    #[inline(always)]
    pub(super) fn rail<const ORDER: u8, const FUSED: bool>(
        x: &PointState,
        [through, along]: [Vec2<Constant>; 2],
    ) -> Row {
        let n = along.perp();
        let normal = Vec2::new(n.x.hi, n.y.hi);
        let halves = Vec2::new(Halves::<f64, FUSED>::of(normal.x), Halves::of(normal.y));
        let across = |v: Vec2| {
            let (p, q) = (
                halves.x.times(Halves::of(v.x)),
                halves.y.times(Halves::of(v.y)),
            );
            let (sum, lost) = two_sum(p.hi, q.hi);
            sum + (lost + (p.lo + q.lo) + (n.x.lo * v.x + n.y.lo * v.y))
        };
        let turned = n.x.radius + n.y.radius + RESIDUAL;
        let (dx, lost_x) = two_sum(x.p.x, -through.x.hi);
        let (dy, lost_y) = two_sum(x.p.y, -through.y.hi);
        let lost = Vec2::new(lost_x - through.x.lo, lost_y - through.y.lo);
        let way = Vec2::new(dx, dy);
        let mut values = [across(way) + normal.dot(lost), 0.0, 0.0];
        let typed = through.x.radius + through.y.radius;
        let mut fuzz = [turned * size(way) + typed, 0.0, 0.0];
        if ORDER >= VELOCITY {
            values[1] = across(x.v);
            fuzz[1] = turned * size(x.v);
        }
        if ORDER >= ACCELERATION {
            values[2] = across(x.a);
            fuzz[2] = turned * size(x.a);
        }
        Row {
            gradient: normal,
            w: Vec2::ZERO,
            a: Vec2::ZERO,
            sizes: [size(normal), 0.0, 0.0],
            values,
            fuzz,
            curvature: 0.0,
        }
    }
}

impl Row<Both> {
    #[inline(always)]
    pub(super) fn both(one: &Row, two: &Row) -> Row<Both> {
        let both = |a: &[f64; 3], b: &[f64; 3]| {
            let at = |k: usize| Both([a[k], b[k]]);
            [at(0), at(1), at(2)]
        };
        Row {
            gradient: Vec2::both(one.gradient, two.gradient),
            w: Vec2::both(one.w, two.w),
            a: Vec2::both(one.a, two.a),
            sizes: both(&one.sizes, &two.sizes),
            values: both(&one.values, &two.values),
            fuzz: both(&one.fuzz, &two.fuzz),
            curvature: Both([one.curvature, two.curvature]),
        }
    }

    /// What the shift of the point leaves of the values of an order, which were found without it.
    #[inline(always)]
    pub(super) fn held(&self, order: usize, values: Both, shift: Vec2<Both>, most: Both) -> Both {
        let left = values + self.gradient.dot(shift);
        left.abs() + self.fuzz[order] + (self.sizes[0] * most).scaled(2.0 * SUM)
    }
}
