//! Bounds of the dyads that stand on circles and on rails of the ground.

use super::aim::limb_of;
use super::errors::{Errors, PointError, size};
use super::influence::Influences;
use super::limb::Limb;
use super::meeting::{Meeting, Met, meet};
use super::rail::Rail;
use super::shape::{Shape, stretch};
use crate::arithmetic::{Both, U};
use crate::solver::elements::{Arm, CircleRail, Circles};
use crate::solver::state::{LinkState, PointState, State};
use crate::{Ball, Number, PointId, Vec2};

/// What a computed inverse rounds in long chains, in units of its condition number.
const INVERSE: f64 = 16.0 * U;

/// What an arm leaves open of a constraint along it: of its own, and of what its point carries. That is nothing where
/// a row says it, but for what the computed inverse makes of it.
fn open(length: f64, (own, left): (f64, f64), has_row: bool, condition: f64) -> f64 {
    let inexact = INVERSE * condition;
    let carried = if has_row { 0.0 } else { 1.0 };
    length * (own * (1.0 + inexact) + left * (carried + inexact))
}

/// Two arms, from end to end.
struct Pair<'a> {
    /// The ways, each in the place of the other one.
    others: Vec2<Both>,
    /// 1 / (e1 x e2).
    inverse: f64,
    gains: Both,
    lengths: Both,
    dyad: &'a Circles,
}

impl<'a> Pair<'a> {
    #[inline(always)]
    fn of<const FUSED: bool>(dyad: &'a Circles, limbs: &Limb<Both, FUSED>) -> Pair<'a> {
        let Vec2 { x, y } = limbs.e;
        let others = limbs.e.map(Both::swapped);
        let inverse = 1.0 / (x.0[0] * y.0[1] - y.0[0] * x.0[1]);
        Pair {
            others,
            inverse,
            gains: limbs.length.swapped() * Both::exactly(inverse.abs()),
            lengths: limbs.length,
            dyad,
        }
    }

    /// Says by rows how sources move the joint.
    fn write_rows(&self, rows: &mut Influences) {
        let gradients = [self.others.one(1), self.others.one(0)];
        let columns = [
            -self.others.one(0).perp() * self.inverse,
            self.others.one(1).perp() * self.inverse,
        ];
        let from = [Some(self.dyad.near.pivot), Some(self.dyad.far.pivot)];
        rows.pair(self.dyad.point, gradients, columns, from);
    }
}

impl Meeting<Both> for Pair<'_> {
    #[inline(always)]
    fn gains(&self) -> Both {
        self.gains
    }

    #[inline(always)]
    fn close(&self, _: usize, ends: Vec2<Both>) -> (Both, f64) {
        let gap = ends.one(1) - ends.one(0);
        let turning = self.others.dot(Vec2::both(gap, gap)) * Both::exactly(self.inverse);
        (turning, size(gap))
    }

    #[inline(always)]
    fn sum(&self, parts: Both) -> f64 {
        parts.sum()
    }

    #[inline(always)]
    fn rest(&self, _: usize) -> f64 {
        0.0
    }

    fn rest_by_rows(
        &self,
        order: usize,
        own: Both,
        from: &PointError<Both>,
        rows: &mut Influences,
    ) -> f64 {
        let Circles {
            point, near, far, ..
        } = self.dyad;
        if order == 0 {
            self.write_rows(rows);
        }
        let condition = (self.gains * self.lengths).nearest();
        let pivots = [near.pivot, far.pivot];
        let bounds = [0, 1].map(|i| {
            let here = (own.0[i], from.left[order].0[i]);
            open(
                self.lengths.0[i],
                here,
                rows.has_point(pivots[i]),
                condition,
            )
        });
        rows.bound(*point, order, bounds)
    }
}

/// An arm whose end is on a rail.
struct OnRail<'a> {
    rail: Rail,
    way: Vec2,
    /// 1 / (e . t).
    inverse: f64,
    gain: f64,
    length: f64,
    dyad: &'a CircleRail,
}

impl OnRail<'_> {
    /// As [`Pair::write_rows`].
    fn write_rows(&self, rows: &mut Influences) {
        let (n, e) = (self.rail.normal, self.way);
        // e . X = r and n . X = s where X = (-k x n r + k x e s) / (e x n), and e x n is e . t.
        let columns = [-n.perp() * self.inverse, e.perp() * self.inverse];
        let from = [Some(self.dyad.arm.pivot), None];
        rows.pair(self.dyad.point, [e, n], columns, from);
    }
}

impl Meeting<f64> for OnRail<'_> {
    #[inline(always)]
    fn gains(&self) -> f64 {
        self.gain
    }

    /// n . (k x e) is e . t.
    #[inline(always)]
    fn close(&self, order: usize, ends: Vec2) -> (f64, f64) {
        let gap = self.rail.values[order] + self.rail.normal.dot(ends);
        (-gap * self.inverse, gap.abs())
    }

    #[inline(always)]
    fn sum(&self, parts: f64) -> f64 {
        parts
    }

    #[inline(always)]
    fn rest(&self, order: usize) -> f64 {
        self.rail.fuzz[order]
    }

    fn rest_by_rows(
        &self,
        order: usize,
        own: f64,
        from: &PointError,
        rows: &mut Influences,
    ) -> f64 {
        if order == 0 {
            self.write_rows(rows);
        }
        let has_row = rows.has_point(self.dyad.arm.pivot);
        let condition = self.gain * self.length;
        let here = (own, from.left[order]);
        let bounds = [
            open(self.length, here, has_row, condition),
            self.rail.fuzz[order] * (1.0 + INVERSE * condition),
        ];
        rows.bound(self.dyad.point, order, bounds)
    }
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
        PointError {
            shift: [shift(0), shift(1), shift(2)],
            left: [left(0), left(1), left(2)],
        }
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
        let limbs = Limb::<_, FUSED>::new(
            &PointState::both(x, x),
            &ends,
            &links,
            &Shape::of_arms(near, far),
            stretch::<_, FUSED>(links.d),
        );
        let from = PointError::both(errors.point(near.pivot), errors.point(far.pivot));
        let pair = Pair::of(self, &limbs);
        let met = meet::<Both, ORDER, FUSED, ROWS>(&limbs, &from, &pair, &mut errors.influences);
        let Some(Met {
            joint,
            links: mut error,
            own,
        }) = met
        else {
            return false;
        };
        errors.set_point(self.point, &joint, state, enclosure);
        if ROWS {
            for (i, arm) in [near, far].into_iter().enumerate() {
                let (e, own) = (limbs.e.one(i), own.map(|own| own.0[i]));
                if let Some(rest) = errors.turn_by_rows(arm, (self.point, e), own) {
                    (0..3).for_each(|k| error.rest[k].0[i] = rest[k]);
                }
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
        let arm = &self.arm;
        let limb = limb_of::<FUSED>(arm, self.point, state);
        let x = &state.points[self.point.index()];
        let rail = Rail::new::<ORDER, FUSED>(x, [self.through, self.along]);
        let inverse = 1.0 / limb.e.cross(rail.normal);
        let on_rail = OnRail {
            rail,
            way: limb.e,
            inverse,
            gain: inverse.abs(),
            length: limb.length,
            dyad: self,
        };
        let from = &errors.points[arm.pivot.index()];
        let met = meet::<f64, ORDER, FUSED, ROWS>(&limb, from, &on_rail, &mut errors.influences);
        let Some(met) = met else {
            return false;
        };
        errors.set_point(self.point, &met.joint, state, enclosure);
        errors.aim::<ROWS>(arm, (self.point, limb.e), met, state, enclosure);
        true
    }
}
