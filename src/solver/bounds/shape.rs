//! Where a link carries a point, from what is given of both: to twice the digits.

use super::errors::size;
use crate::arithmetic::{Both, Halves, two_sum};
use crate::solver::elements::Arm;
use crate::{Constant, Number, Vec2};

#[inline(always)]
pub(super) fn is_zero(constant: Constant) -> bool {
    constant.hi == 0.0 && constant.lo == 0.0
}

/// The place of a point on a link, seen from another one, with the digits that a double leaves out; or two such.
#[derive(Clone, Copy)]
pub(super) struct Shape<T = f64> {
    pub local: Vec2<T>,
    pub low: Vec2<T>,
    /// How far it can be from what was meant.
    pub off: T,
    pub length: T,
    /// Whether it lies along the x axis of its link, as most do.
    pub is_straight: bool,
}

impl Shape {
    #[inline(always)]
    fn of(local: Vec2<Constant>, length: f64, is_straight: bool) -> Shape {
        Shape {
            local: local.map(|v| v.hi),
            low: local.map(|v| v.lo),
            off: local.x.radius + local.y.radius,
            length,
            is_straight,
        }
    }

    /// Of a point whose distance is not known.
    #[inline(always)]
    pub(super) fn at(local: Vec2<Constant>) -> Shape {
        let length = size(local.map(|v| v.hi));
        Shape::of(local, length, is_zero(local.y))
    }

    #[inline(always)]
    pub(super) fn of_arm(arm: &Arm) -> Shape {
        Shape::of(arm.local, arm.length.hi, arm.is_straight)
    }
}

impl Shape<Both> {
    #[inline(always)]
    pub(super) fn of_arms(near: &Arm, far: &Arm) -> Shape<Both> {
        let (a, b) = (Shape::of_arm(near), Shape::of_arm(far));
        Shape {
            local: Vec2::both(a.local, b.local),
            low: Vec2::both(a.low, b.low),
            off: Both([a.off, b.off]),
            length: Both([a.length, b.length]),
            is_straight: a.is_straight & b.is_straight,
        }
    }
}

/// By how much a computed direction is too short, as a part of itself: (1 - |d|^2) / 2, to twice the digits.
#[inline(always)]
pub(super) fn stretch<T: Number, const FUSED: bool>(d: Vec2<T>) -> T {
    let xx = Halves::<T, FUSED>::of(d.x).square();
    let yy = Halves::<T, FUSED>::of(d.y).square();
    // What is left for yy, and what that leaves out (Dekker). The difference of two that are all but equal is exact.
    let left = T::exactly(1.0) - xx.hi;
    let lost = (T::exactly(1.0) - left) - xx.hi;
    ((left - yy.hi) + (lost - (xx.lo + yy.lo))).scaled(0.5)
}

/// R(d) v to twice the digits, as two vectors, of a vector given to twice the digits.
#[inline(always)]
pub(super) fn turned_closely<T: Number, const FUSED: bool>(
    [v, low]: [Vec2<T>; 2],
    is_straight: bool,
    d: Vec2<T>,
) -> [Vec2<T>; 2] {
    let (lx, dx, dy) = (
        Halves::<T, FUSED>::of(v.x),
        Halves::of(d.x),
        Halves::of(d.y),
    );
    let (a, p) = (lx.times(dx), lx.times(dy));
    // Most points of a bar lie along its x axis.
    if is_straight {
        let low = Vec2::new(a.lo + low.x * d.x, p.lo + low.x * d.y);
        return [Vec2::new(a.hi, p.hi), low];
    }
    let low = low.turned(d);
    let ly = Halves::of(v.y);
    let (b, q) = (ly.times(dy), ly.times(dx));
    let (sx, lost_x) = two_sum(a.hi, -b.hi);
    let (sy, lost_y) = two_sum(p.hi, q.hi);
    let low = Vec2::new(
        lost_x + (a.lo - b.lo) + low.x,
        lost_y + (p.lo + q.lo) + low.y,
    );
    [Vec2::new(sx, sy), low]
}
