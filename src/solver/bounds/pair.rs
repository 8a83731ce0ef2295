//! Bounds of the dyads that stand on circles and on rails of the ground: the shifts of their joint by
//! the residuals of its two constraints, and what is left.
//!
//! A constraint F(X, P) = 0 with the gradient g by X is held against the computed state at each order;
//! for a circle, with e = X - P, w and a its rates,
//!
//! ```text
//! F = (|e|^2 - b^2) / 2         g.dX = g.dP - F
//! G = e.w                       g.dV = g.dV_P - G - w.(dX - dP)
//! H = e.a + |w|^2               g.dA = g.dA_P - H - a.(dX - dP) - 2 w.(dV - dV_P)
//! ```
//!
//! to the first order. That a solution is near, and how far at most, is proved first: within twice the
//! step the matrix changes by less than a quarter (Kantorovich; Krawczyk's operator in Rump,
//! Verification methods, Acta Numerica 19, 2010, section 13). What the first order leaves out is then
//! bounded, and so are the rates', whose equations are linear.

use super::errors::{Errors, PointError, size};
use super::influence::Influences;
use super::limb::{Limb, RESIDUAL, SUM};
use crate::arithmetic::{Halves, U, two_sum};
use crate::solver::state::{PointState, State};
use crate::solver::step::{ACCELERATION, Arm, CircleRail, Circles, VELOCITY};
use crate::{Ball, Constant, Double, PointId, Vec2};

/// The part of itself by which the matrix may change within the bound: beyond, nothing is proved.
const CONTRACTION: f64 = 0.25;
/// The rounding of an inverse of two rows, in units of its condition number.
const INVERSE: f64 = 16.0 * U;

/// One constraint on X where it was computed to be.
struct Row<'a> {
    gradient: Vec2,
    /// The rates of the gradient: w and a of a circle, nothing of a rail.
    w: Vec2,
    a: Vec2,
    /// The sizes of these.
    sizes: [f64; 3],
    /// Its value and rates there, with the shifts of the other point taken in.
    values: [f64; 3],
    /// How far these may be from the true ones but for what rounding makes of the shifts, and for the
    /// influences of earlier constraints.
    fuzz: [f64; 3],
    /// The error of the other point.
    from: &'a PointError,
    /// How fast the gradient changes with X.
    curvature: f64,
}

impl<'a> Row<'a> {
    /// (|X - P|^2 - b^2) / 2.
    #[inline(always)]
    fn circle<const ORDER: u8>(limb: &Limb, square: Constant, p: &'a PointError) -> Row<'a> {
        let Limb { e, w, a, .. } = *limb;
        let [length, speed, accel] = limb.sizes;
        let [stretch, off] = limb.stretch(square);
        let mut values = [stretch - e.dot(p.shift[0]), 0.0, 0.0];
        let mut fuzz = [off + length * p.own[0], 0.0, 0.0];
        if ORDER >= VELOCITY {
            values[1] = e.dot(limb.rho - p.shift[1]) - w.dot(p.shift[0]);
            fuzz[1] = length * (p.own[1] + limb.fuzz[0]) + speed * p.left[0];
        }
        if ORDER >= ACCELERATION {
            values[2] = e.dot(limb.sigma - p.shift[2]) + w.dot(limb.rho - p.shift[1] * 2.0)
                - a.dot(p.shift[0]);
            fuzz[2] = length * (p.own[2] + limb.fuzz[1])
                + speed * (limb.fuzz[0] + 2.0 * p.left[1])
                + accel * p.left[0];
        }
        Row {
            gradient: e,
            w,
            a,
            sizes: limb.sizes,
            values,
            fuzz,
            from: p,
            curvature: 1.0,
        }
    }

    /// n.(X - C) of a rail through C along t, and its rates.
    #[inline(always)]
    fn rail<const ORDER: u8>(
        x: &PointState,
        [through, along]: [Vec2<Constant>; 2],
        ground: &'a PointError,
    ) -> Row<'a> {
        let n = along.perp();
        let normal = n.map(|v| v.hi);
        let halves = normal.map(Halves::of);
        let across = |v: Vec2| {
            let (p, q) = (
                halves.x.times(Halves::of(v.x)),
                halves.y.times(Halves::of(v.y)),
            );
            let (sum, lost) = two_sum(p.hi, q.hi);
            sum + (lost + (p.lo + q.lo) + (n.x.lo * v.x + n.y.lo * v.y))
        };
        let turned = n.x.radius + n.y.radius + RESIDUAL;
        let way = Vec2::new(
            Double::sum(x.p.x, -through.x.hi),
            Double::sum(x.p.y, -through.y.hi),
        );
        let lost = Vec2::new(way.x.lo - through.x.lo, way.y.lo - through.y.lo);
        let way = way.map(|v| v.hi);
        let mut values = [across(way) + normal.dot(lost), 0.0, 0.0];
        let typed = through.x.radius + through.y.radius;
        let mut fuzz = [turned * size(way) + typed, 0.0, 0.0];
        if ORDER >= VELOCITY {
            values[1] = across(x.v);
            fuzz[1] = turned * size(x.v);
        }
        if ORDER >= ACCELERATION {
            values[2] = across(x.a);
            fuzz[2] = turned * size(x.a);
        }
        Row {
            gradient: normal,
            w: Vec2::ZERO,
            a: Vec2::ZERO,
            sizes: [size(normal), 0.0, 0.0],
            values,
            fuzz,
            from: ground,
            curvature: 0.0,
        }
    }
}

/// Two constraints on a point, and their inverse.
struct Pair<'a> {
    rows: [Row<'a>; 2],
    columns: [Vec2; 2],
    /// What the columns miss of being the inverse, in parts of the sizes of the other row.
    skew: f64,
    /// By how much more the true inverse can make of a step.
    growth: f64,
    /// How far the true point can be from the computed one, at most.
    reach: f64,
}

impl<'a> Pair<'a> {
    /// Proves that the true point is near.
    #[inline(always)]
    fn proved(rows: [Row<'a>; 2]) -> Option<Pair<'a>> {
        let [one, two] = &rows;
        let (g, h) = (one.gradient, two.gradient);
        let inverse = 1.0 / g.cross(h);
        let columns = [
            Vec2::new(h.y, -h.x) * inverse,
            Vec2::new(-g.y, g.x) * inverse,
        ];
        let norm = (columns[0].norm2() + columns[1].norm2()).sqrt();
        let off = |row: &Row<'_>| {
            let most = row.from.most[0];
            row.values[0].abs() + row.fuzz[0] + row.sizes[0] * row.from.left[0] + most * most
        };
        let reach = size(columns[0]) * off(one) + size(columns[1]) * off(two);
        let curvature = 1.5 * one.curvature.max(two.curvature);
        let wobble = one.from.most[0] + two.from.most[0];
        let rounding = (INVERSE + U) * (one.sizes[0] + two.sizes[0]);
        let change = norm * (rounding + wobble + curvature * 2.0 * reach);
        // Written so that NaN proves nothing.
        if !(change <= CONTRACTION) {
            return None;
        }
        let growth = 1.0 / (1.0 - 2.0 * change);
        Some(Pair {
            columns,
            skew: INVERSE * inverse.abs(),
            growth,
            reach: reach * growth,
            rows,
        })
    }

    #[inline(always)]
    fn step(&self, values: [f64; 2]) -> Vec2 {
        -(self.columns[0] * values[0] + self.columns[1] * values[1])
    }

    /// How far earlier sources alone can move a solution.
    #[inline(always)]
    fn moved(&self, order: usize) -> f64 {
        let [one, two] = &self.rows;
        size(self.columns[0]) * one.sizes[0] * one.from.left[order]
            + size(self.columns[1]) * two.sizes[0] * two.from.left[order]
    }

    /// Bounds of what is left of the two equations of an order, from what is left of each, when the shift
    /// was found from `values`: with what the columns miss of being the inverse, and rounding, which is
    /// no more.
    #[inline(always)]
    fn sources(&self, order: usize, values: [f64; 2], left: [f64; 2]) -> [f64; 2] {
        let [g, h] = [self.rows[0].sizes[0], self.rows[1].sizes[0]];
        let held = |i: usize, length: f64| {
            left[i] + values[i].abs() + length * self.rows[i].from.most[order]
        };
        let skew = self.skew * (h * held(0, g) + g * held(1, h));
        [
            (left[0] + g * skew) * self.growth,
            (left[1] + h * skew) * self.growth,
        ]
    }
}

/// The error of a joint, and bounds of what is left of its two constraints.
struct Found {
    x: PointError,
    sources: [[f64; 2]; 3],
}

/// The error of a joint that two constraints place, each towards another point if there is one.
#[inline(always)]
fn solve<const ORDER: u8>(
    point: PointId,
    rows: [Row<'_>; 2],
    from: [Option<PointId>; 2],
    influences: &mut Influences,
) -> Option<Found> {
    let pair = Pair::proved(rows)?;
    let [one, two] = &pair.rows;
    influences.pair(point, [one.gradient, two.gradient], pair.columns, from);
    let mut x = PointError::default();
    let mut sources = [[0.0; 2]; 3];

    let values = [one.values[0], two.values[0]];
    x.shift[0] = pair.step(values);
    let gap = |row: &Row<'_>| pair.reach + row.from.most[0];
    let left = |row: &Row<'_>| row.fuzz[0] + 0.5 * row.curvature * gap(row) * gap(row);
    sources[0] = pair.sources(0, values, [left(one), left(two)]);
    influences.bound(0, sources[0]);
    x.rest[0] = influences.of_point(point, 0);
    x.settle(0);

    if ORDER >= VELOCITY {
        let value = |row: &Row<'_>| row.values[1] + row.w.dot(x.shift[0]);
        let values = [value(one), value(two)];
        x.shift[1] = pair.step(values);
        let shift = size(x.shift[1]) + pair.moved(1);
        let left = |row: &Row<'_>| {
            let (near, speed) = (gap(row), row.sizes[1]);
            let coupled = speed * (x.left[0] + SUM * (x.most[0] + row.from.most[0]));
            row.fuzz[1] + coupled + row.curvature * near * (shift + row.from.most[1])
        };
        sources[1] = pair.sources(1, values, [left(one), left(two)]);
        influences.bound(1, sources[1]);
        x.rest[1] = influences.of_point(point, 1);
        x.settle(1);
    }
    if ORDER >= ACCELERATION {
        let value =
            |row: &Row<'_>| row.values[2] + row.a.dot(x.shift[0]) + 2.0 * row.w.dot(x.shift[1]);
        let values = [value(one), value(two)];
        x.shift[2] = pair.step(values);
        let shift = size(x.shift[2]) + pair.moved(2);
        let left = |row: &Row<'_>| {
            let [_, speed, accel] = row.sizes;
            let near = [0, 1].map(|k| x.most[k] + row.from.most[k]);
            let coupled =
                accel * (x.left[0] + SUM * near[0]) + 2.0 * speed * (x.left[1] + SUM * near[1]);
            let beyond = gap(row) * (shift + row.from.most[2]) + near[1] * near[1];
            row.fuzz[2] + coupled + row.curvature * beyond
        };
        sources[2] = pair.sources(2, values, [left(one), left(two)]);
        influences.bound(2, sources[2]);
        x.rest[2] = influences.of_point(point, 2);
        x.settle(2);
    }
    Some(Found { x, sources })
}

impl Circles {
    #[inline]
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = &state.points[self.point.index()];
        let limb = |arm: &Arm| {
            let link = &state.links[arm.link.index()];
            Limb::new::<ORDER>(x, &state.points[arm.pivot.index()], link)
        };
        let limbs = [limb(&self.near), limb(&self.far)];
        let pivots = [self.near.pivot, self.far.pivot];
        let [p, q] = pivots.map(|pivot| &errors.points[pivot.index()]);
        let rows = [
            Row::circle::<ORDER>(&limbs[0], self.near.square, p),
            Row::circle::<ORDER>(&limbs[1], self.far.square, q),
        ];
        let from = pivots.map(Some);
        let found = solve::<ORDER>(self.point, rows, from, &mut errors.influences);
        let Some(Found { x, sources }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        let along = |i: usize| [sources[0][i], sources[1][i]];
        errors.aim::<ORDER>(
            &self.near,
            self.point,
            &limbs[0],
            along(0),
            state,
            enclosure,
        );
        errors.aim::<ORDER>(&self.far, self.point, &limbs[1], along(1), state, enclosure);
        true
    }
}

impl CircleRail {
    #[inline]
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = &state.points[self.point.index()];
        let arm = &self.arm;
        let link = &state.links[arm.link.index()];
        let limb = Limb::new::<ORDER>(x, &state.points[arm.pivot.index()], link);
        let ground = PointError::default();
        let pivot = &errors.points[arm.pivot.index()];
        let rows = [
            Row::circle::<ORDER>(&limb, arm.square, pivot),
            Row::rail::<ORDER>(x, [self.through, self.along], &ground),
        ];
        let from = [Some(arm.pivot), None];
        let found = solve::<ORDER>(self.point, rows, from, &mut errors.influences);
        let Some(Found { x, sources }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        let along = [sources[0][0], sources[1][0]];
        errors.aim::<ORDER>(arm, self.point, &limb, along, state, enclosure);
        true
    }
}
