//! Computes the distance of a computed point from a rail of the ground.

use super::link_vector::RESIDUAL;
use super::loaded_state::Places;
use crate::arithmetic::plane::{Plane, Simd, f64x2, number, vector};
use crate::{Constant, Vec2};

/// n . (X - C) of a rail through C along t, and its rates, computed in double-double, with the
/// bounds of their errors.
pub(super) struct Rail<S: Simd> {
    pub normal: f64x2<S>,
    pub values: [f64x2<S>; 3],
    pub fuzz: [f64x2<S>; 3],
}

/// Returns n . v of vectors given with their low parts. The rounding error of its last sum is of
/// second order, since that sum itself is of first order.
#[inline(always)]
fn across<V: Plane, const FUSED: bool>([n, low]: [V; 2], v: V, lost: V) -> V {
    let [product, rest] = n.times::<FUSED>(v);
    product.joined() + (rest + low * v + n * lost).joined()
}

impl<S: Simd> Rail<S> {
    #[inline(always)]
    pub(super) fn new<const FUSED: bool>(
        simd: S,
        x: &Places<f64x2<S>>,
        [through, along]: [Vec2<Constant>; 2],
    ) -> Rail<S> {
        let n = along.perp();
        let n = [vector(simd, n.map(|v| v.hi)), vector(simd, n.map(|v| v.lo))];
        let turned = number(simd, along.x.radius + along.y.radius + RESIDUAL);
        let [way, lost] = x.p.plus(-vector(simd, through.map(|v| v.hi)));
        let typed = through.x.radius + through.y.radius;
        let none = number(simd, 0.0);
        let lost = lost - vector(simd, through.map(|v| v.lo));
        Rail {
            normal: n[0],
            values: [
                across::<_, FUSED>(n, way, lost),
                across::<_, FUSED>(n, x.v, none),
                across::<_, FUSED>(n, x.a, none),
            ],
            fuzz: [
                turned * way.size() + typed,
                turned * x.v.size(),
                turned * x.a.size(),
            ],
        }
    }
}
