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

use super::{Dyad, POSITION, Swing};
use crate::arithmetic::{Series, TERMS};
use crate::solver::state::State;
use crate::{Double, LinkId, Number, PointId, Vec2};

/// What a coefficient can be off by in twice the precision, as a part of its size, with room for a long
/// chain: less is a zero.
pub(in crate::solver) const ZERO: f64 = 1e-22;
/// So many terms tell how a square begins.
const FEW: usize = 16;

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

/// The square of a dyad's height.
pub(in crate::solver) struct Height {
    pub square: Series,
    /// Its size, coefficient by coefficient: what roundings are measured against.
    pub size: Series,
    /// How it changes with the two parts of a snap.
    pub slopes: [Series; 2],
}

impl Dyad<'_> {
    /// What the dyad is stretched by - the distance of its pivots squared, or the distance of pivot and
    /// guide - where that is extreme its arms can be in line; and its size.
    pub(in crate::solver) fn reach(self, state: &State<Series>) -> [Series; 2] {
        match (self, self.pivots(state)) {
            (Dyad::CircleRail(c), _) => c.cut(Snap::default(), FEW, state).1.reach(),
            (Dyad::CircleLine(c), _) => c.cut(Snap::default(), FEW, state).1.reach(),
            (_, u) => squared(u.unwrap_or_default().map(|v| v.cut(FEW))),
        }
    }

    /// From pivot to pivot, where it has two.
    pub(in crate::solver) fn pivots(self, state: &State<Series>) -> Option<Vec2<Series>> {
        match self {
            Dyad::Circles(c) => Some(between(c.near.pivot, c.far.pivot, state)),
            Dyad::Cylinder(c) => Some(between(c.pivot, c.far.pivot, state)),
            Dyad::Swing(s) => Some(between(s.pivot, s.pin, state)),
            Dyad::CircleRail(_) | Dyad::CircleLine(_) => None,
        }
    }

    /// Whether both its pivots move.
    pub(in crate::solver) fn is_afloat(self, state: &State<Series>) -> bool {
        let moves = |p: PointId| {
            let Vec2 { x, y } = state.points[p.index()].p;
            [x, y].iter().any(|v| v.c[1..].iter().any(|c| c.hi != 0.0))
        };
        match self {
            Dyad::Circles(c) => moves(c.near.pivot) && moves(c.far.pivot),
            Dyad::Cylinder(c) => moves(c.pivot) && moves(c.far.pivot),
            Dyad::Swing(s) => moves(s.pivot) && moves(s.pin),
            Dyad::CircleRail(_) | Dyad::CircleLine(_) => false,
        }
    }

    /// The square of its height.
    pub(in crate::solver) fn square(self, q: Series, snap: Snap, state: &State<Series>) -> Series {
        match self {
            Dyad::Circles(c) => c.triangle(snap, TERMS, state).square(),
            Dyad::Cylinder(c) => c.triangle_of(q, snap, TERMS, state).square(),
            Dyad::CircleRail(c) => c.cut(snap, TERMS, state).1.square(),
            Dyad::CircleLine(c) => c.cut(snap, TERMS, state).1.square(),
            Dyad::Swing(s) => s.square(snap, TERMS, state),
        }
    }

    /// The first few terms of that, with their sizes and slopes.
    pub(in crate::solver) fn height(self, q: Series, snap: Snap, state: &State<Series>) -> Height {
        match self {
            Dyad::Circles(c) => c.triangle(snap, FEW, state).height(),
            Dyad::Cylinder(c) => c.triangle_of(q, snap, FEW, state).height(),
            Dyad::CircleRail(c) => c.cut(snap, FEW, state).1.height(),
            Dyad::CircleLine(c) => c.cut(snap, FEW, state).1.height(),
            Dyad::Swing(s) => s.height(snap, state),
        }
    }

    /// From pivot to pivot where these may meet, that is where the arms are equal within `slack`.
    pub(in crate::solver) fn meeting(
        self,
        q: Series,
        slack: f64,
        state: &State<Series>,
    ) -> Option<Vec2<Double>> {
        let miss = match self {
            Dyad::Circles(c) => (c.near.length - c.far.length).hi,
            Dyad::Cylinder(c) => {
                (c.arm_square(q.cut(1)).sqrt() - Series::of(c.far.length)).nearest()
            }
            Dyad::Swing(s) => s.offset.hi,
            Dyad::CircleRail(_) | Dyad::CircleLine(_) => return None,
        };
        let u = self.pivots(state).filter(|_| miss.abs() <= slack)?;
        Some(u.map(|v| v.c[0]))
    }

    /// The square of its height where its transmission angle is right.
    pub(in crate::solver) fn right_angle(self, q: Series, state: &State<Series>) -> f64 {
        match self {
            Dyad::Circles(c) => c.near.square.hi * c.far.square.hi,
            Dyad::Cylinder(c) => c.arm_square(q.cut(1)).nearest() * c.far.square.hi,
            Dyad::CircleRail(c) => c.arm.square.hi,
            Dyad::CircleLine(c) => c.arm.square.hi,
            Dyad::Swing(s) => between(s.pivot, s.pin, state)
                .map(|v| v.cut(1))
                .norm2()
                .nearest(),
        }
    }

    /// Places the dyad with this height, signed.
    pub(in crate::solver) fn run_through(
        self,
        q: Series,
        snap: Snap,
        height: Series,
        state: &mut State<Series>,
    ) {
        match self {
            Dyad::Circles(c) => {
                let triangle = c.triangle(snap, TERMS, state);
                let e = triangle.arm(height);
                c.place::<Series, POSITION>(e, e - triangle.u, height, state);
            }
            Dyad::Cylinder(c) => {
                let triangle = c.triangle_of(q, snap, TERMS, state);
                let e = triangle.arm(height);
                c.place::<Series, POSITION>(q, e, e - triangle.u, height, state);
            }
            Dyad::CircleRail(c) => c.run_through(snap, height, state),
            Dyad::CircleLine(c) => c.run_through(snap, height, state),
            Dyad::Swing(s) => s.run_through(snap, height, state),
        }
    }

    /// What it places, in series.
    pub(in crate::solver) fn placed(
        self,
        state: &State<Series>,
    ) -> impl Iterator<Item = Vec2<Series>> + '_ {
        let (point, links) = self.outputs();
        let point = point.map(|p: PointId| state.points[p.index()].p);
        let links = links.into_iter().flatten();
        let links: Vec<_> = links.map(|l: LinkId| state.links[l.index()].d).collect();
        point.into_iter().chain(links)
    }
}

/// A height with this sign for positive t, whose square begins with t to the power of `order`.
pub(in crate::solver) fn root(square: Series, order: usize, side: f64) -> Series {
    let root = square.lowered(order).sqrt().raised(order / 2);
    if side < 0.0 { -root } else { root }
}

fn between(from: PointId, to: PointId, state: &State<Series>) -> Vec2<Series> {
    state.points[to.index()].p - state.points[from.index()].p
}

/// The square of a length, and its size.
fn squared(u: Vec2<Series>) -> [Series; 2] {
    [u.norm2(), u.map(Series::majorant).norm2()]
}

fn shifted(u: Vec2<Series>, snap: Snap, terms: usize) -> Vec2<Series> {
    u.map(|v| v.cut(terms)) + snap.by.map(Series::constant)
}

/// A quotient by the square of a length, which may begin with a power of t, and the dividend then with it.
fn quotient(dividend: Vec2<Series>, u: Vec2<Series>, d2: Series) -> Vec2<Series> {
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

impl Swing {
    fn arm(&self, snap: Snap, terms: usize, state: &State<Series>) -> (Vec2<Series>, Series) {
        let w = shifted(between(self.pivot, self.pin, state), snap, terms);
        let offset = if snap.equal_arms {
            Series::default()
        } else {
            Series::of(self.offset)
        };
        (w, offset)
    }

    /// s^2 = w^2 - e^2.
    fn square(&self, snap: Snap, terms: usize, state: &State<Series>) -> Series {
        let (w, e) = self.arm(snap, terms, state);
        w.norm2() - e * e
    }

    fn height(&self, snap: Snap, state: &State<Series>) -> Height {
        let (w, e) = self.arm(snap, FEW, state);
        let [d2, size] = squared(w);
        Height {
            square: d2 - e * e,
            size: size + e * e,
            slopes: [w.x.scaled(2.0), w.y.scaled(2.0)],
        }
    }

    fn run_through(&self, snap: Snap, s: Series, state: &mut State<Series>) {
        let (w, e) = self.arm(snap, TERMS, state);
        let t = quotient(w.turned(Vec2::new(s, -e)), w, w.norm2());
        self.place::<Series, POSITION>(t, s, state);
    }
}
