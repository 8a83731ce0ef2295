//! Loads computed points and links into the machine's vectors, one or two at once.

use crate::Vec2;
use crate::arithmetic::plane::{Simd, both, f64x2, f64x4, vector};
use crate::solver::state::{LinkState, PointState};

/// The positions, velocities and accelerations of points.
#[derive(Clone, Copy)]
pub(super) struct Places<V> {
    pub p: V,
    pub v: V,
    pub a: V,
}

impl<S: Simd> Places<f64x2<S>> {
    #[inline(always)]
    pub(super) fn of(simd: S, point: &PointState) -> Self {
        Places {
            p: vector(simd, point.p),
            v: vector(simd, point.v),
            a: vector(simd, point.a),
        }
    }
}

impl<S: Simd> Places<f64x4<S>> {
    #[inline(always)]
    pub(super) fn both(one: &Places<f64x2<S>>, two: &Places<f64x2<S>>) -> Self {
        Places {
            p: both(one.p, two.p),
            v: both(one.v, two.v),
            a: both(one.a, two.a),
        }
    }
}

/// The directions and rates of links.
#[derive(Clone, Copy)]
pub(super) struct Bodies<V> {
    pub d: V,
    /// The angular velocity in x, the angular acceleration in y.
    pub rates: V,
}

impl<S: Simd> Bodies<f64x2<S>> {
    #[inline(always)]
    pub(super) fn of(simd: S, link: &LinkState) -> Self {
        Bodies {
            d: vector(simd, link.d),
            rates: vector(simd, Vec2::new(link.w, link.a)),
        }
    }
}

impl<S: Simd> Bodies<f64x4<S>> {
    #[inline(always)]
    pub(super) fn both(one: &Bodies<f64x2<S>>, two: &Bodies<f64x2<S>>) -> Self {
        Bodies {
            d: both(one.d, two.d),
            rates: both(one.rates, two.rates),
        }
    }
}
