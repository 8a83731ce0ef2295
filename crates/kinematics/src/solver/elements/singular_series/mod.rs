//! Expands dyads in series about positions where they may be singular.
//!
//! The square of a dyad's height (of the triangle, of half the chord, of the position along the
//! guide) is a product of series. If it begins with t^2p, its root is t^p times a series: the
//! height continues smoothly, for odd p with the opposite sign. Where the pivots of equal arms
//! meet, or a pin meets the pivot on its guide, the distance begins with a power of t as well, and
//! the common factor is divided out.
//!
//! Lengths and coordinates from one drawing are rounded independently. The square then begins with
//! rounding errors instead of zeros. A [`SingularShift`] moves a pivot or a guide just enough to make these
//! coefficients zero in double-double.

mod circle_line;
mod pair;
mod triangle;

pub(super) use circle_line::{Cut, turned};
pub(in crate::solver) use pair::Pair;
pub(super) use triangle::SeriesTriangle;

use crate::arithmetic::Series;
use crate::solver::state::State;
use crate::{Double, Number, PointId, Vec2};

/// Relative tolerance for a coefficient in double-double, with a margin for a long chain; a smaller
/// one counts as zero.
pub(in crate::solver) const ZERO: f64 = 1e-22;
/// Number of terms sufficient to determine how a square begins.
pub(super) const FEW_TERMS: usize = 16;

/// The shift that makes a dyad exactly singular: between its pivots, or of a guide across itself
/// and about its own point, in the solver's unit and in radians.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::solver) struct SingularShift {
    pub by: Vec2<Double>,
    /// Whether arms that differ by rounding count as equal: their pivots coincide.
    pub equal_arms: bool,
    /// The two close places at which the pivots of equal arms coincide, if they do so twice.
    pub pair: Option<Pair>,
}

impl SingularShift {
    /// Creates the shift that makes two pivots coincide.
    pub(in crate::solver) fn of_meeting(by: Vec2<Double>) -> SingularShift {
        SingularShift {
            by,
            equal_arms: true,
            pair: None,
        }
    }
}

/// A dyad's representation in series.
pub(super) trait InSeries {
    /// Returns the square of its height.
    fn square(&self) -> Series;

    /// Returns the square of its height with sizes and slopes.
    fn height(&self) -> Height;
}

/// The square of a dyad's height.
pub(in crate::solver) struct Height {
    pub square: Series,
    /// The size of each coefficient, against which rounding errors are measured.
    pub size: Series,
    /// The derivatives by the two components of a snap.
    pub slopes: [Series; 2],
}

/// Returns the height with the sign `side` for positive t, whose square begins with t to the power
/// of `order`.
pub(in crate::solver) fn root(square: Series, order: usize, side: f64) -> Series {
    let root = square.lowered(order).sqrt().raised(order / 2);
    if side < 0.0 { -root } else { root }
}

pub(super) fn between(from: PointId, to: PointId, state: &State<Series>) -> Vec2<Series> {
    state.points[to.index()].p - state.points[from.index()].p
}

/// Returns the square of a length, and its size.
pub(super) fn squared(u: Vec2<Series>) -> [Series; 2] {
    let size = size(u);
    [u.norm2(), size * size]
}

/// Returns the sizes of a vector's coefficients, independent of the axes' directions. Each is at
/// least as large as the motion as a whole suggests, because a coefficient that is zero but for
/// rounding does not show its own size.
pub(super) fn size(u: Vec2<Series>) -> Series {
    let norm = |n: usize| u.x.c[n].hi.hypot(u.y.c[n].hi);
    let known = u.x.known.min(u.y.known);
    let middle = known / 2;
    let largest = |from: usize| (from..known.min(from + 2)).map(norm).fold(0.0, f64::max);
    let falls = largest(middle) / largest(known.saturating_sub(2));
    // Within this radius the coefficients stop growing; it is at most 1.
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

/// Returns a vector between pivots, shifted by a snap.
pub(super) fn shifted(u: Vec2<Series>, snap: SingularShift, terms: usize) -> Vec2<Series> {
    u.map(|v| v.cut(terms)) + snap.by.map(Series::constant)
}

/// Divides by the square of a length. If the square begins with a power of t, the dividend must,
/// too, and the factor is cancelled. The same holds for the square of `pair`.
pub(super) fn quotient(
    dividend: Vec2<Series>,
    u: Vec2<Series>,
    d2: Series,
    pair: Option<Pair>,
) -> Vec2<Series> {
    if let Some(pair) = pair {
        let cancelled = |v: Series| v.divided(pair.squared()).0;
        return dividend.map(cancelled) / cancelled(d2);
    }
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
