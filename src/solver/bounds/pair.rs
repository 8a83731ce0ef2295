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

use super::errors::{Errors, PointError, larger};
use super::influence::Influences;
use super::limb::{Limb, SUM, Shape};
use super::row::Row;
use crate::arithmetic::{Both, U};
use crate::solver::elements::{ACCELERATION, Arm, CircleRail, Circles, VELOCITY};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Ball, Number, PointId, Vec2};

/// The part of itself by which the matrix may change within the bound: beyond, nothing is proved.
const CONTRACTION: f64 = 0.25;
/// The rounding of an inverse of two rows, in units of its condition number.
const INVERSE: f64 = 16.0 * U;

/// Two constraints on a point, and their inverse.
///
/// Points are told in each component. With C_i the larger part of a column, L_i, S_i and A_i the sums of those of a
/// gradient and its rates: what moves row i by r moves the point by C_i r at most, and what moves the other point of
/// that row by r moves it by K_i r, K_i = C_i L_i. No K_i is below (|x1 y2| + |y1 x2|) / |det|, by which the
/// determinant makes more of what its products round.
struct Pair<'a> {
    /// The other points.
    from: &'a PointError<Both>,
    columns: Vec2<Both>,
    /// L_i, C_i, and K_i.
    lengths: Both,
    sizes: Both,
    gains: Both,
    /// What the columns miss of being the inverse, in parts of what they move.
    skew: f64,
    /// By how much more the true inverse can make of a step.
    growth: f64,
    /// How far the way to one of the other points can be from the computed one, at most.
    reach: f64,
}

impl<'a> Pair<'a> {
    /// Proves that the true point is near; `values` are those of the rows with the shifts of the other points
    /// taken in.
    #[inline(always)]
    fn proved(rows: &Row<Both>, values: Both, from: &'a PointError<Both>) -> Option<Pair<'a>> {
        let (x, y) = (rows.gradient.x.swapped(), rows.gradient.y.swapped());
        let [det, _] = (rows.gradient.x * y - rows.gradient.y * x).0;
        let inverse = Both([1.0 / det, -1.0 / det]);
        let columns = Vec2::new(y * inverse, -(x * inverse));
        let lengths = rows.sizes[0];
        let sizes = x.abs().max(y.abs()) * inverse.abs();
        let gains = lengths * sizes;
        let norm = sizes.sum();
        let wobble = from.most[0].sum();
        let off = (sizes * (values.abs() + rows.fuzz[0])).sum();
        let carried = from.left[0] + Both::exactly(2.0 * SUM * wobble);
        let reach = off + (gains * carried).sum() + norm * wobble * wobble;
        let curvature = rows.curvature.0[0].max(rows.curvature.0[1]);
        let rounding = (INVERSE + U) * lengths.sum();
        let change = norm * (rounding + 2.0 * wobble + 4.0 * curvature * reach);
        // Written so that NaN proves nothing.
        if !(change <= CONTRACTION) {
            return None;
        }
        // 1 / (1 - 2 change) is no more.
        let growth = 1.0 + 4.0 * change;
        Some(Pair {
            from,
            columns,
            lengths,
            sizes,
            gains,
            skew: 2.0 * INVERSE * gains.0[0],
            growth,
            reach: reach * growth + wobble,
        })
    }

    #[inline(always)]
    fn step(&self, values: Both) -> Vec2 {
        let Vec2 { x, y } = self.columns;
        Vec2::new(-(x * values).sum(), -(y * values).sum())
    }

    /// How far what moves the rows moves the point.
    #[inline(always)]
    fn moved(&self, rows: Both) -> f64 {
        (self.sizes * rows).sum()
    }

    /// How far what moves the other points moves the point.
    #[inline(always)]
    fn carried(&self, others: Both) -> f64 {
        (self.gains * others).sum()
    }

    /// What the columns leave of the values of an order, missing the inverse, and what rounding does to these.
    #[inline(always)]
    fn missed(&self, order: usize, values: Both) -> f64 {
        self.skew * (self.moved(values.abs()) + self.carried(self.from.most[order]))
    }
}

/// How the rests of the two points that a joint stands on come to it: by rows of influences, or at once.
struct Standing<const ROWS: bool> {
    point: PointId,
    from: [Option<PointId>; 2],
}

impl<const ROWS: bool> Standing<ROWS> {
    /// What is left of an order: of what the rows miss by and what moves the point besides, and of what the other
    /// points move.
    #[inline(always)]
    fn left(
        &self,
        order: usize,
        (rows, besides): (Both, f64),
        pair: &Pair<'_>,
        influences: &mut Influences,
    ) -> f64 {
        if ROWS {
            return self.left_by_rows(order, (rows, besides), pair, influences);
        }
        let moved = pair.moved(rows) + pair.carried(pair.from.left[order]);
        pair.growth * (moved + besides)
    }

    /// What a row moves is moved by the computed inverse.
    #[inline(never)]
    fn left_by_rows(
        &self,
        order: usize,
        (rows, besides): (Both, f64),
        pair: &Pair<'_>,
        influences: &mut Influences,
    ) -> f64 {
        let has_row = |p: Option<PointId>| p.is_some_and(|p| influences.has_point(p));
        let growth = pair.growth;
        let bounds = [0, 1].map(|i| {
            let by_row = if has_row(self.from[i]) { 1.0 } else { 0.0 };
            let carried = (growth - by_row) * pair.from.left[order].0[i];
            growth * rows.0[i] + pair.lengths.0[i] * (growth * besides + carried)
        });
        influences.bound(self.point, order, bounds)
    }
}

/// The error of a joint, twice, and bounds of e . of the rests of the ways to it and of their rates.
struct Found {
    x: PointError,
    twice: PointError<Both>,
    along: [Both; 2],
}

/// The error of a joint that two constraints place, each towards another point if there is one.
#[inline(always)]
fn solve<const ORDER: u8, const ROWS: bool>(
    rows: &Row<Both>,
    from: &PointError<Both>,
    standing: &Standing<ROWS>,
    influences: &mut Influences,
) -> Option<Found> {
    let Row { gradient, w, a, .. } = *rows;
    let values = rows.values[0] - gradient.dot(from.shift[0]);
    let pair = Pair::proved(rows, values, from)?;
    if ROWS {
        let gradients = [rows.gradient.one(0), rows.gradient.one(1)];
        let columns = [pair.columns.one(0), pair.columns.one(1)];
        influences.pair(standing.point, gradients, columns, standing.from);
    }
    let (mut x, mut twice) = (PointError::none(), PointError::none());
    let mut along = [Both::exactly(0.0); 2];

    x.shift[0] = pair.step(values);
    let near = pair.reach;
    let curvature = pair.moved(rows.curvature);
    let new = (
        rows.fuzz[0],
        pair.missed(0, values) + curvature * near * near,
    );
    x.settle(0, standing.left(0, new, &pair, influences));
    twice.repeat(&x, 0);
    let left = twice.left[0] + from.left[0];
    let most = twice.most[0] + from.most[0];
    along[0] = rows.held(0, values, twice.shift[0], most) + most * most;

    if ORDER >= VELOCITY {
        let way = twice.shift[0] - from.shift[0];
        let values = rows.values[1] + w.dot(way) - gradient.dot(from.shift[1]);
        x.shift[1] = pair.step(values);
        let coupled = rows.sizes[1] * (left + most.scaled(2.0 * SUM));
        let moving = pair.carried(from.left[1]);
        let turned = 2.0 * near * (larger(x.shift[1]) + moving + from.most[1].sum());
        let besides = pair.missed(1, values) + curvature * turned;
        let new = (rows.fuzz[1] + coupled, besides);
        x.settle(1, standing.left(1, new, &pair, influences));
        twice.repeat(&x, 1);
        let rate = twice.most[1] + from.most[1];
        along[1] = rows.held(1, values, twice.shift[1], rate) + coupled + (most * rate).scaled(2.0);
        if ORDER >= ACCELERATION {
            let rate_way = twice.shift[1] - from.shift[1];
            let values = rows.values[2] + a.dot(way) + w.dot(rate_way).scaled(2.0)
                - gradient.dot(from.shift[2]);
            x.shift[2] = pair.step(values);
            let left_rate = twice.left[1] + from.left[1];
            let coupled = rows.sizes[2] * (left + most.scaled(2.0 * SUM))
                + rows.sizes[1] * (left_rate + rate.scaled(2.0 * SUM)).scaled(2.0);
            let moving = pair.carried(from.left[2]);
            let turned = 2.0 * near * (larger(x.shift[2]) + moving + from.most[2].sum());
            let bent = rows.curvature * (rate * rate).scaled(2.0);
            let besides = pair.missed(2, values) + curvature * turned;
            let new = (rows.fuzz[2] + coupled + bent, besides);
            x.settle(2, standing.left(2, new, &pair, influences));
            twice.repeat(&x, 2);
        }
    }
    Some(Found { x, twice, along })
}

impl PointState<Both> {
    #[inline(always)]
    fn both(one: &PointState, two: &PointState) -> PointState<Both> {
        PointState {
            p: Vec2::both(one.p, two.p),
            v: Vec2::both(one.v, two.v),
            a: Vec2::both(one.a, two.a),
        }
    }
}

impl LinkState<Both> {
    #[inline(always)]
    fn both(one: &LinkState, two: &LinkState) -> LinkState<Both> {
        LinkState {
            d: Vec2::both(one.d, two.d),
            w: Both([one.w, two.w]),
            a: Both([one.a, two.a]),
        }
    }
}

impl PointError<Both> {
    #[inline(always)]
    fn both(one: &PointError, two: &PointError) -> PointError<Both> {
        let shift = |k: usize| Vec2::both(one.shift[k], two.shift[k]);
        let left = |k: usize| Both([one.left[k], two.left[k]]);
        let most = |k: usize| Both([one.most[k], two.most[k]]);
        PointError {
            shift: [shift(0), shift(1), shift(2)],
            left: [left(0), left(1), left(2)],
            most: [most(0), most(1), most(2)],
        }
    }

    /// Takes an order of one point for both.
    #[inline(always)]
    fn repeat(&mut self, of: &PointError, order: usize) {
        self.shift[order] = Vec2::both(of.shift[order], of.shift[order]);
        self.left[order] = Both::exactly(of.left[order]);
        self.most[order] = Both::exactly(of.most[order]);
    }
}

impl Circles {
    #[inline(always)]
    pub(super) fn enclose<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &self,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let (near, far) = (&self.near, &self.far);
        let point = |p: PointId| &state.points[p.index()];
        let link = |arm: &Arm| &state.links[arm.link.index()];
        let x = point(self.point);
        let ends = PointState::both(point(near.pivot), point(far.pivot));
        let links = LinkState::both(link(near), link(far));
        let limbs = Limb::<Both, FUSED>::new::<ORDER>(&PointState::both(x, x), &ends, &links);
        let shapes = Shape::of_both(near, far);
        let rows = Row::circle::<ORDER, FUSED>(&limbs, &shapes);
        let from = PointError::both(errors.point(near.pivot), errors.point(far.pivot));
        let standing = Standing::<ROWS> {
            point: self.point,
            from: [Some(near.pivot), Some(far.pivot)],
        };
        let found = solve::<ORDER, ROWS>(&rows, &from, &standing, &mut errors.influences);
        let Some(Found { x, twice, along }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        let (mut error, gain) = limbs.link_error::<ORDER>(&shapes, &links, [&twice, &from], along);
        let new = error.rest;
        for k in 0..=ORDER as usize {
            error.rest[k] += gain * (twice.left[k] + from.left[k]);
        }
        for (i, arm) in [near, far].into_iter().enumerate() {
            if ROWS && errors.influences.has_link(arm.link) {
                let new = [0, 1, 2].map(|k| new[k].0[i]);
                let ends = (self.point, limbs.e.one(i));
                let rest = errors.turn_by_rows(arm, ends, new, gain.0[i]);
                (0..3).for_each(|k| error.rest[k].0[i] = rest[k]);
            }
        }
        errors.set_links([near.link, far.link], &error, &links, enclosure);
        true
    }
}

impl CircleRail {
    #[inline(always)]
    pub(super) fn enclose<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &self,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = &state.points[self.point.index()];
        let arm = &self.arm;
        let link = &state.links[arm.link.index()];
        let limb = Limb::<f64, FUSED>::new::<ORDER>(x, &state.points[arm.pivot.index()], link);
        let shape = Shape::of(arm);
        let circle = Row::circle::<ORDER, FUSED>(&limb, &shape);
        let rail = Row::rail::<ORDER, FUSED>(x, [self.through, self.along]);
        let from = PointError::both(errors.point(arm.pivot), &PointError::none());
        let standing = Standing::<ROWS> {
            point: self.point,
            from: [Some(arm.pivot), None],
        };
        let rows = Row::both(&circle, &rail);
        let found = solve::<ORDER, ROWS>(&rows, &from, &standing, &mut errors.influences);
        let Some(Found { x, along, .. }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        let along = [along[0].0[0], along[1].0[0]];
        errors.aim::<ORDER, FUSED, ROWS>(arm, self.point, (&limb, &shape), along, state, enclosure);
        true
    }
}
