//! By how much a point, as computed, misses a rail of the ground.

use super::errors::size;
use super::limb::RESIDUAL;
use crate::arithmetic::Halves;
use crate::solver::elements::{ACCELERATION, VELOCITY};
use crate::solver::state::PointState;
use crate::{Constant, Vec2, arithmetic::two_sum};

/// n . (X - C) of a rail through C along t, and its rates, found in twice the digits; and how far these can be from
/// the true ones.
pub(super) struct Rail {
    pub normal: Vec2,
    pub values: [f64; 3],
    pub fuzz: [f64; 3],
}

impl Rail {
    #[inline(always)]
    pub(super) fn new<const ORDER: u8, const FUSED: bool>(
        x: &PointState,
        [through, along]: [Vec2<Constant>; 2],
    ) -> Rail {
        let n = along.perp();
        let normal = Vec2::new(n.x.hi, n.y.hi);
        let halves = normal.map(Halves::<f64, FUSED>::of);
        let across = |v: Vec2| {
            let p = halves.x.times(Halves::of(v.x));
            let q = halves.y.times(Halves::of(v.y));
            // What this sum rounds is of the second order, as the sum is of the first.
            (p.hi + q.hi) + ((p.lo + q.lo) + (n.x.lo * v.x + n.y.lo * v.y))
        };
        let turned = n.x.radius + n.y.radius + RESIDUAL;
        let (dx, lost_x) = two_sum(x.p.x, -through.x.hi);
        let (dy, lost_y) = two_sum(x.p.y, -through.y.hi);
        let lost = Vec2::new(lost_x - through.x.lo, lost_y - through.y.lo);
        let way = Vec2::new(dx, dy);
        let typed = through.x.radius + through.y.radius;
        let value = across(way) + normal.dot(lost);
        let mut rail = Rail {
            normal,
            values: [value, 0.0, 0.0],
            fuzz: [turned * size(way) + typed, 0.0, 0.0],
        };
        if ORDER >= VELOCITY {
            (rail.values[1], rail.fuzz[1]) = (across(x.v), turned * size(x.v));
        }
        if ORDER >= ACCELERATION {
            (rail.values[2], rail.fuzz[2]) = (across(x.a), turned * size(x.a));
        }
        rail
    }
}
