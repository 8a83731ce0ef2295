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

use super::errors::{Errors, PointError, larger, size};
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
    /// Its value and rates there, and how far these may be from the true ones.
    values: [f64; 3],
    fuzz: [f64; 3],
    /// The error of the other point.
    from: &'a PointError,
    /// How fast the gradient changes with X.
    curvature: f64,
}

impl<'a> Row<'a> {
    /// (|X - P|^2 - b^2) / 2.
    #[inline(always)]
    fn circle<const ORDER: u8>(limb: &Limb, square: Constant, from: &'a PointError) -> Row<'a> {
        let Limb { e, w, a, .. } = *limb;
        let [length, speed, _] = limb.sizes;
        let [stretch, off] = limb.stretch(square);
        let mut values = [stretch, 0.0, 0.0];
        let mut fuzz = [off, 0.0, 0.0];
        if ORDER >= VELOCITY {
            values[1] = e.dot(limb.rho);
            fuzz[1] = length * limb.fuzz[0];
        }
        if ORDER >= ACCELERATION {
            values[2] = e.dot(limb.sigma) + w.dot(limb.rho);
            fuzz[2] = length * limb.fuzz[1] + speed * limb.fuzz[0];
        }
        Row {
            gradient: e,
            w,
            a,
            sizes: limb.sizes,
            values,
            fuzz,
            from,
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

impl Row<'_> {
    /// What the shift of the point leaves of the value of an order, which was found without it.
    #[inline(always)]
    fn held(&self, order: usize, value: f64, shift: Vec2, most: f64) -> f64 {
        let left = value + self.gradient.dot(shift);
        left.abs() + self.fuzz[order] + 2.0 * SUM * self.sizes[0] * most
    }
}

/// Two constraints on a point, and their inverse.
///
/// With C_i the size of a column, L_i, S_i and A_i those of a gradient and its rates: what moves row i by r moves
/// the point by C_i r at most; and as C_1 = L_2 / |det| and C_2 = L_1 / |det|, what moves one of the other
/// points by r moves it by K r at most, K = L_1 L_2 / |det|.
struct Pair<'a> {
    rows: [Row<'a>; 2],
    columns: [Vec2; 2],
    /// C_i, and K.
    sizes: [f64; 2],
    gain: f64,
    /// What the columns miss of being the inverse, in parts of what they move.
    skew: f64,
    /// By how much more the true inverse can make of a step.
    growth: f64,
    /// How far the true point can be from the computed one, at most; and the same of the other points, summed.
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
        let scale = inverse.abs();
        let lengths = [one.sizes[0], two.sizes[0]];
        let sizes = [lengths[1] * scale, lengths[0] * scale];
        let gain = lengths[0] * sizes[0];
        let norm = sizes[0] + sizes[1];
        let wobble = one.from.most[0] + two.from.most[0];
        let off = |i: usize| sizes[i] * (rows[i].values[0].abs() + rows[i].fuzz[0]);
        let reach = off(0) + off(1) + gain * wobble + norm * wobble * wobble;
        let curvature = one.curvature.max(two.curvature);
        let rounding = (INVERSE + U) * (lengths[0] + lengths[1]);
        let change = norm * (rounding + 2.0 * wobble + 4.0 * curvature * reach);
        // Written so that NaN proves nothing.
        if !(change <= CONTRACTION) {
            return None;
        }
        // 1 / (1 - 2 change) is no more.
        let growth = 1.0 + 4.0 * change;
        Some(Pair {
            columns,
            sizes,
            gain,
            skew: 2.0 * INVERSE * gain,
            growth,
            reach: reach * growth,
            rows,
        })
    }

    #[inline(always)]
    fn step(&self, values: [f64; 2]) -> Vec2 {
        -(self.columns[0] * values[0] + self.columns[1] * values[1])
    }

    /// A sum over rows, each by how far it moves the point.
    #[inline(always)]
    fn over_rows(&self, of: impl Fn(&Row<'_>) -> f64) -> f64 {
        self.sizes[0] * of(&self.rows[0]) + self.sizes[1] * of(&self.rows[1])
    }

    /// A sum over the other points.
    #[inline(always)]
    fn over_points(&self, of: impl Fn(&PointError) -> f64) -> f64 {
        of(self.rows[0].from) + of(self.rows[1].from)
    }
}

/// How the rests of the two points that a joint stands on come to it: by rows of influences, or at once.
struct Standing {
    point: PointId,
    from: [Option<PointId>; 2],
    has_row: bool,
    /// Which of them has a row.
    have_rows: [bool; 2],
}

impl Standing {
    #[inline(always)]
    fn new(point: PointId, from: [Option<PointId>; 2], influences: &Influences) -> Standing {
        Standing {
            point,
            from,
            has_row: influences.has_point(point),
            have_rows: from.map(|p| p.is_some_and(|p| influences.has_point(p))),
        }
    }

    /// What is left of an order: of what is new, and of what the other points move.
    #[inline(always)]
    fn left(&self, order: usize, new: f64, pair: &Pair<'_>, influences: &mut Influences) -> f64 {
        let Pair { growth, gain, .. } = *pair;
        if !self.has_row {
            return growth * (new + gain * pair.over_points(|p| p.left[order]));
        }
        // What a row moves is moved by the computed inverse.
        let carried = |i: usize| {
            let part = if self.have_rows[i] {
                growth - 1.0
            } else {
                growth
            };
            part * pair.rows[i].from.left[order]
        };
        let new = growth * new + gain * (carried(0) + carried(1));
        influences.bound(self.point, order, new)
    }
}

/// The error of a joint, and bounds of e . of the rests of the ways to it and of their rates.
struct Found {
    x: PointError,
    along: [[f64; 2]; 2],
}

/// The error of a joint that two constraints place, each towards another point if there is one.
#[inline(always)]
fn solve<const ORDER: u8>(
    rows: [Row<'_>; 2],
    standing: &Standing,
    influences: &mut Influences,
) -> Option<Found> {
    let pair = Pair::proved(rows)?;
    let [one, two] = &pair.rows;
    if standing.has_row {
        let gradients = [one.gradient, two.gradient];
        influences.pair(standing.point, gradients, pair.columns, standing.from);
    }
    let mut x = PointError::default();
    let mut along = [[0.0; 2]; 2];
    let moved = |k: usize, values: [f64; 2]| {
        let shifts = pair.sizes[0] * values[0].abs() + pair.sizes[1] * values[1].abs();
        pair.skew * (shifts + pair.gain * pair.over_points(|p| p.most[k]))
    };

    let value = |row: &Row<'_>| row.values[0] - row.gradient.dot(row.from.shift[0]);
    let values = [value(one), value(two)];
    x.shift[0] = pair.step(values);
    let near = pair.reach + pair.over_points(|p| p.most[0]);
    let curvature = pair.over_rows(|row| row.curvature);
    let new = moved(0, values) + pair.over_rows(|row| row.fuzz[0]) + curvature * near * near;
    x.settle(0, standing.left(0, new, &pair, influences));
    let left = x.left[0] + pair.over_points(|p| p.left[0]);
    let most = x.most[0] + pair.over_points(|p| p.most[0]);
    for (i, row) in pair.rows.iter().enumerate() {
        let off = row.held(0, values[i], x.shift[0], most);
        along[i][0] = off + most * most;
    }

    if ORDER >= VELOCITY {
        let value = |row: &Row<'_>| {
            row.values[1] + row.w.dot(x.shift[0] - row.from.shift[0])
                - row.gradient.dot(row.from.shift[1])
        };
        let values = [value(one), value(two)];
        x.shift[1] = pair.step(values);
        let speed = pair.over_rows(|row| row.sizes[1]);
        let turned = 2.0 * near * (larger(x.shift[1]) + pair.over_points(|p| p.most[1]));
        let moving = pair.gain * pair.over_points(|p| p.left[1]);
        let new = moved(1, values)
            + pair.over_rows(|row| row.fuzz[1])
            + speed * (left + 2.0 * SUM * most)
            + curvature * (turned + 2.0 * near * moving);
        x.settle(1, standing.left(1, new, &pair, influences));
        let rate = x.most[1] + pair.over_points(|p| p.most[1]);
        for (i, row) in pair.rows.iter().enumerate() {
            let off = row.held(1, values[i], x.shift[1], rate);
            along[i][1] = off + row.sizes[1] * (left + 2.0 * SUM * most) + 2.0 * most * rate;
        }
        if ORDER >= ACCELERATION {
            let value = |row: &Row<'_>| {
                row.values[2]
                    + row.a.dot(x.shift[0] - row.from.shift[0])
                    + 2.0 * row.w.dot(x.shift[1] - row.from.shift[1])
                    - row.gradient.dot(row.from.shift[2])
            };
            let values = [value(one), value(two)];
            x.shift[2] = pair.step(values);
            let left_rate = x.left[1] + pair.over_points(|p| p.left[1]);
            let accel = pair.over_rows(|row| row.sizes[2]);
            let turned = 2.0 * near * (larger(x.shift[2]) + pair.over_points(|p| p.most[2]));
            let moving = pair.gain * pair.over_points(|p| p.left[2]);
            let new = moved(2, values)
                + pair.over_rows(|row| row.fuzz[2])
                + accel * (left + 2.0 * SUM * most)
                + 2.0 * speed * (left_rate + 2.0 * SUM * rate)
                + curvature * (turned + 2.0 * near * moving + 2.0 * rate * rate);
            x.settle(2, standing.left(2, new, &pair, influences));
        }
    }
    Some(Found { x, along })
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
        let standing = Standing::new(self.point, pivots.map(Some), &errors.influences);
        let found = solve::<ORDER>(rows, &standing, &mut errors.influences);
        let Some(Found { x, along }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        for (i, arm) in [&self.near, &self.far].into_iter().enumerate() {
            errors.aim::<ORDER>(arm, self.point, &limbs[i], along[i], state, enclosure);
        }
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
        let standing = Standing::new(self.point, from, &errors.influences);
        let found = solve::<ORDER>(rows, &standing, &mut errors.influences);
        let Some(Found { x, along }) = found else {
            return false;
        };
        errors.set_point(self.point, &x, state, enclosure);
        errors.aim::<ORDER>(arm, self.point, &limb, along[0], state, enclosure);
        true
    }
}
