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
    [u.norm2(), u.map(Series::majorant).norm2()]
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
