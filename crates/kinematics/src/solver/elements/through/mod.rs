//! Dyads in series, at places where they may be singular.
//!
//! The square of a dyad's height (of the triangle, of half the chord, of the way along the guide) is a
//! product of series. Where it begins with t^2p, its root is t^p times a series: the height goes on
//! smoothly, and with odd p on the other side. Where the pivots of equal arms meet, or a pin meets the
//! pivot that its guide runs through, the distance begins with a power of t as well, and the common
//! factor is divided out.
//!
//! Lengths and coordinates that come from one drawing are rounded one by one: then the square begins
//! with coefficients that are roundings instead of zeros. A [`Snap`] moves a pivot, or a guide, by so
//! much that they are zeros to twice the precision.

mod cut;
mod triangle;

pub(super) use cut::{Cut, turned};
pub(super) use triangle::SeriesTriangle;

use crate::arithmetic::Series;
use crate::solver::state::State;
use crate::{Double, Number, PointId, Vec2};

/// What a coefficient can be off by in twice the precision, as a part of its size, with room for a long
/// chain: less is a zero.
pub(in crate::solver) const ZERO: f64 = 1e-22;
/// So many terms tell how a square begins.
pub(super) const FEW: usize = 16;

/// By how much a dyad is shifted to be singular exactly: between pivots, or of a guide across itself and
/// about its own point, in the solver's unit and in radians.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::solver) struct Snap {
    pub by: Vec2<Double>,
    /// Whether arms that differ by a rounding count as equal: their pivots meet.
    pub equal_arms: bool,
}

impl Snap {
    /// What brings two pivots together.
    pub(in crate::solver) fn of_meeting(by: Vec2<Double>) -> Snap {
        Snap {
            by,
            equal_arms: true,
        }
    }
}

/// A dyad as it stands in series.
pub(super) trait InSeries {
    /// The square of its height.
    fn square(&self) -> Series;

    /// The same with its sizes and slopes.
    fn height(&self) -> Height;
}

/// The square of a dyad's height.
pub(in crate::solver) struct Height {
    pub square: Series,
    /// Its size, coefficient by coefficient: what roundings are measured against.
    pub size: Series,
    /// How it changes with the two parts of a snap.
    pub slopes: [Series; 2],
}

/// A height with this sign for positive t, whose square begins with t to the power of `order`.
pub(in crate::solver) fn root(square: Series, order: usize, side: f64) -> Series {
    let root = square.lowered(order).sqrt().raised(order / 2);
    if side < 0.0 { -root } else { root }
}

pub(super) fn between(from: PointId, to: PointId, state: &State<Series>) -> Vec2<Series> {
    state.points[to.index()].p - state.points[from.index()].p
}

/// The square of a length, and its size.
pub(super) fn squared(u: Vec2<Series>) -> [Series; 2] {
    let size = size(u);
    [u.norm2(), size * size]
}

/// The sizes of a vector's coefficients, whatever the directions of the axes. None is smaller than the
/// motion as a whole lets expect: of one that is zero but for its rounding that says nothing.
pub(super) fn size(u: Vec2<Series>) -> Series {
    let norm = |n: usize| u.x.c[n].hi.hypot(u.y.c[n].hi);
    let known = u.x.known.min(u.y.known);
    let middle = known / 2;
    let largest = |from: usize| (from..known.min(from + 2)).map(norm).fold(0.0, f64::max);
    let falls = largest(middle) / largest(known.saturating_sub(2));
    // Within this radius the coefficients grow no further, but none is wider than the unit.
    let power = 1.0 / known.saturating_sub(2 + middle).max(1) as f64;
    let radius = if 0.0 < falls && falls < 1.0 {
        falls.powf(power)
    } else {
        1.0
    };
    let moved = |n: usize| norm(n) * radius.powi(n as i32);
    let moves = (1..known).map(moved).fold(0.0, f64::max);
    let mut size = Series {
        known,
        ..Series::default()
    };
    for n in 0..known {
        let floor = if n == 0 {
            0.0
        } else {
            moves / radius.powi(n as i32)
        };
        size.c[n] = Double::exactly(norm(n).max(floor));
    }
    size
}

/// A vector between pivots, moved by a snap.
pub(super) fn shifted(u: Vec2<Series>, snap: Snap, terms: usize) -> Vec2<Series> {
    u.map(|v| v.cut(terms)) + snap.by.map(Series::constant)
}

/// A quotient by the square of a length, which may begin with a power of t, and the dividend then with it.
pub(super) fn quotient(dividend: Vec2<Series>, u: Vec2<Series>, d2: Series) -> Vec2<Series> {
    let meets = u.x.nearest() == 0.0 && u.y.nearest() == 0.0;
    let order = if meets {
        d2.valuation(&squared(u)[1], ZERO)
    } else {
        None
    };
    match order {
        Some(order) => dividend.map(|v| v.lowered(order)) / d2.lowered(order),
        None => dividend / d2,
    }
}
