//! Computes in double-double where a link carries a point, from the given numbers of both.

use super::errors::size;
use crate::arithmetic::plane::{Plane, Simd, both, f64x2, f64x4, number};
use crate::solver::elements::Arm;
use crate::{Constant, Vec2};

#[inline(always)]
pub(super) fn is_zero(constant: Constant) -> bool {
    constant.hi == 0.0 && constant.lo == 0.0
}

/// The position of a point on a link relative to another one, in double-double; or two such
/// positions.
#[derive(Clone, Copy)]
pub(super) struct LinkShape<V> {
    /// The coordinate along the x axis, as high and low part. `across` is the one perpendicular to
    /// it.
    along: [V; 2],
    across: [V; 2],
    /// The maximum error of the given numbers.
    pub off: V,
    pub length: V,
    /// `true` if the vector lies on the x axis of the link, as most points do.
    is_straight: bool,
}

impl<S: Simd> LinkShape<f64x2<S>> {
    #[inline(always)]
    fn of(simd: S, local: Vec2<Constant>, length: f64, is_straight: bool) -> Self {
        let Vec2 { x, y } = local;
        LinkShape {
            along: [number(simd, x.hi), number(simd, x.lo)],
            across: [number(simd, y.hi), number(simd, y.lo)],
            off: number(simd, x.radius + y.radius),
            length: number(simd, length),
            is_straight,
        }
    }

    /// Creates the shape of a point whose distance is unknown.
    #[inline(always)]
    pub(super) fn at(simd: S, local: Vec2<Constant>) -> Self {
        let length = size(local.map(|v| v.hi));
        LinkShape::of(simd, local, length, is_zero(local.y))
    }

    /// Creates the shape of a direction.
    pub(super) fn unit(simd: S, direction: Vec2<Constant>) -> Self {
        LinkShape::of(simd, direction, 1.0, false)
    }

    #[inline(always)]
    pub(super) fn of_arm(simd: S, arm: &Arm) -> Self {
        LinkShape::of(simd, arm.local, arm.length.hi, arm.is_straight)
    }
}

impl<S: Simd> LinkShape<f64x4<S>> {
    #[inline(always)]
    pub(super) fn of_arms(simd: S, near: &Arm, far: &Arm) -> Self {
        let (a, b) = (LinkShape::of_arm(simd, near), LinkShape::of_arm(simd, far));
        LinkShape {
            along: [both(a.along[0], b.along[0]), both(a.along[1], b.along[1])],
            across: [
                both(a.across[0], b.across[0]),
                both(a.across[1], b.across[1]),
            ],
            off: both(a.off, b.off),
            length: both(a.length, b.length),
            is_straight: a.is_straight & b.is_straight,
        }
    }
}

impl<V: Plane> LinkShape<V> {
    /// Returns the position on a link with this direction in double-double, as two vectors.
    #[inline(always)]
    pub(super) fn turned<const FUSED: bool>(&self, d: V) -> [V; 2] {
        let [x, x_low] = self.along;
        let [along, rest] = x.times::<FUSED>(d);
        let rest = rest + x_low * d;
        // Most points of a bar lie on its x axis.
        if self.is_straight {
            return [along, rest];
        }
        let ([y, y_low], normal) = (self.across, d.perp());
        let [across, rest_across] = y.times::<FUSED>(normal);
        let [sum, lost] = along.plus(across);
        [sum, lost + (rest + (rest_across + y_low * normal))]
    }
}

/// Returns the relative amount by which a computed direction is too short: (1 - |d|^2) / 2, in
/// double-double.
#[inline(always)]
pub(super) fn stretch<V: Plane, const FUSED: bool>(d: V) -> V {
    let [square, rest] = d.times::<FUSED>(d);
    let (xx, yy, one) = (square.x(), square.y(), d.all(1.0));
    // The remainder for yy, and its low part (Dekker). The difference of two nearly equal numbers
    // is exact.
    let left = one - xx;
    let lost = (one - left) - xx;
    ((left - yy) + (lost - rest.joined())) * 0.5
}
