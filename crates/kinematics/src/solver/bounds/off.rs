//! Holds errors in the machine's vectors, of one or two points or links at once.

use super::errors::{LinkError, PointError};
use super::link_vector::SUM;
use super::loaded_state::{Bodies, Places};
use crate::arithmetic::INFLATION;
use crate::arithmetic::plane::{Plane, Simd, both, f64x2, f64x4, halves, number, paired, vector};
use crate::solver::state::{LinkState, PointState};
use crate::{Ball, Vec2};

/// The errors of one or two points.
#[derive(Clone, Copy)]
pub(super) struct PointOff<V> {
    pub shift: [V; 3],
    pub left: [V; 3],
}

/// The errors of one or two links.
#[derive(Clone, Copy)]
pub(super) struct LinkOff<V> {
    pub stretch: V,
    pub turn: V,
    pub shift: [V; 2],
    pub rest: [V; 3],
}

/// The stored part of a link's errors in memory order, and its enclosures: midpoints and radii.
pub(super) struct Enclosed<V> {
    turn: V,
    shift: V,
    rest: V,
    rests: V,
    direction: [V; 2],
    rates: [V; 2],
}

/// Returns the rounding error of the sums that contain a shift.
#[inline(always)]
pub(super) fn rounding<V: Plane>(shift: V) -> V {
    shift.size() * SUM
}

/// Converts a rest to a ball. The rest is a sum of positive terms, each rounded to nearest, and is
/// widened by more than these can have lost. Dekker's short sum gives the rounding of the midpoint.
/// If the shift is the larger term, that rounding is below 4 u of the shift, and every rest is
/// larger.
#[inline(always)]
fn ball<V: Plane>(value: V, shift: V, rest: V) -> [V; 2] {
    let mid = value + shift;
    let lost = shift - (mid - value);
    [mid, rest * INFLATION + lost.abs()]
}

#[inline(always)]
fn balls<S: Simd>([mid, radius]: [f64x2<S>; 2]) -> [Ball; 2] {
    let [x, y] = paired(mid, radius);
    [Ball::new(x[0], x[1]), Ball::new(y[0], y[1])]
}

#[inline(always)]
fn vector_ball<S: Simd>(value: f64x2<S>, shift: f64x2<S>, rest: f64x2<S>) -> Vec2<Ball> {
    let [x, y] = balls(ball(value, shift, rest));
    Vec2::new(x, y)
}

#[inline(always)]
fn pairs<S: Simd>(one: [f64x2<S>; 3], two: [f64x2<S>; 3]) -> [f64x4<S>; 3] {
    [
        both(one[0], two[0]),
        both(one[1], two[1]),
        both(one[2], two[2]),
    ]
}

impl<V: Plane> PointOff<V> {
    /// Creates a zero error.
    #[inline(always)]
    pub(super) fn none(none: V) -> Self {
        PointOff {
            shift: [none; 3],
            left: [none; 3],
        }
    }

    /// Sets the shift and the rest of an order.
    #[inline(always)]
    pub(super) fn settle(&mut self, order: usize, shift: V, left: V) {
        self.shift[order] = shift;
        self.left[order] = left + rounding(shift);
    }
}

impl<S: Simd> PointOff<f64x2<S>> {
    #[inline(always)]
    pub(super) fn of(simd: S, error: &PointError) -> Self {
        PointOff {
            shift: error.shift.map(
                #[inline(always)]
                |shift| vector(simd, shift),
            ),
            left: error.left.map(
                #[inline(always)]
                |left| number(simd, left),
            ),
        }
    }

    #[inline(always)]
    pub(super) fn stored_error(&self) -> PointError {
        PointError {
            shift: self.shift.map(
                #[inline(always)]
                |shift| shift.vector(0),
            ),
            left: self.left.map(
                #[inline(always)]
                |left| left.number(0),
            ),
        }
    }

    #[inline(always)]
    pub(super) fn balls(&self, value: &Places<f64x2<S>>) -> PointState<Ball> {
        let Self { shift, left } = self;
        PointState {
            p: vector_ball(value.p, shift[0], left[0]),
            v: vector_ball(value.v, shift[1], left[1]),
            a: vector_ball(value.a, shift[2], left[2]),
        }
    }
}

impl<S: Simd> PointOff<f64x4<S>> {
    #[inline(always)]
    pub(super) fn both(one: &PointOff<f64x2<S>>, two: &PointOff<f64x2<S>>) -> Self {
        PointOff {
            shift: pairs(one.shift, two.shift),
            left: pairs(one.left, two.left),
        }
    }
}

impl<V: Plane> LinkOff<V> {
    /// Creates a zero error.
    #[inline(always)]
    pub(super) fn none(none: V) -> Self {
        LinkOff {
            stretch: none,
            turn: none,
            shift: [none; 2],
            rest: [none; 3],
        }
    }

    /// Returns the enclosures of these links, and the stored part of the errors.
    #[inline(always)]
    pub(super) fn enclosed(&self, links: &Bodies<V>) -> Enclosed<V> {
        let turning = links.d * self.stretch + links.d.perp() * self.turn;
        let shift = self.shift[0].with_y_of(self.shift[1]);
        let rests = self.rest[1].with_y_of(self.rest[2]);
        Enclosed {
            turn: self.stretch.with_y_of(self.turn),
            shift,
            rest: self.rest[0],
            rests,
            direction: ball(links.d, turning, self.rest[0]),
            rates: ball(links.rates, shift, rests),
        }
    }
}

impl<S: Simd> LinkOff<f64x2<S>> {
    #[inline(always)]
    pub(super) fn of(simd: S, error: &LinkError) -> Self {
        let ([w, a], [rest, rest_w, rest_a]) = (error.shift, error.rest);
        LinkOff {
            stretch: number(simd, error.turn.x),
            turn: number(simd, error.turn.y),
            shift: [number(simd, w), number(simd, a)],
            rest: [
                number(simd, rest),
                number(simd, rest_w),
                number(simd, rest_a),
            ],
        }
    }
}

impl<S: Simd> Enclosed<f64x4<S>> {
    #[inline(always)]
    fn half<const I: usize>(&self) -> Enclosed<f64x2<S>> {
        let [direction, rates] = [self.direction, self.rates];
        Enclosed {
            turn: halves(self.turn)[I],
            shift: halves(self.shift)[I],
            rest: halves(self.rest)[I],
            rests: halves(self.rests)[I],
            direction: [halves(direction[0])[I], halves(direction[1])[I]],
            rates: [halves(rates[0])[I], halves(rates[1])[I]],
        }
    }

    /// Returns the values of each link.
    #[inline(always)]
    pub(super) fn halves(&self) -> [Enclosed<f64x2<S>>; 2] {
        [self.half::<0>(), self.half::<1>()]
    }
}

impl<S: Simd> Enclosed<f64x2<S>> {
    #[inline(always)]
    pub(super) fn stored_error(&self) -> LinkError {
        LinkError {
            turn: self.turn.vector(0),
            shift: [self.shift[0], self.shift[1]],
            rest: [self.rest[0], self.rests[0], self.rests[1]],
        }
    }

    #[inline(always)]
    pub(super) fn balls(&self) -> LinkState<Ball> {
        let ([x, y], [w, a]) = (balls(self.direction), balls(self.rates));
        LinkState {
            d: Vec2::new(x, y),
            w,
            a,
        }
    }
}
