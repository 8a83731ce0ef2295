//! Bounds the dyads on circles and on rails of the ground.

use super::errors::Errors;
use super::influence::Influences;
use super::link_vector::LinkVector;
use super::loaded_state::{Bodies, Places};
use super::meeting::{ArmClosure, meet};
use super::off::PointOff;
use super::rail::Rail;
use super::shape::{LinkShape, stretch};
use super::two_point_link::arm_vector;
use crate::Ball;
use crate::arithmetic::U;
use crate::arithmetic::plane::{Plane, Simd, both, f64x2, f64x4, number, others};
use crate::solver::elements::{CircleRail, Circles};
use crate::solver::state::State;

/// Rounding error of a computed inverse in long chains, in units of its condition number.
const INVERSE: f64 = 16.0 * U;

/// Returns the error that an arm leaves open in a constraint along it: its own, and that of its
/// pivot. The pivot's row covers the latter if there is one, except for the error of the computed
/// inverse.
fn open(length: f64, (own, left): (f64, f64), has_row: bool, condition: f64) -> f64 {
    let inexact = INVERSE * condition;
    let carried = if has_row { 0.0 } else { 1.0 };
    length * (own * (1.0 + inexact) + left * (carried + inexact))
}

/// Two arms that meet at their ends.
struct ArmPair<'a, S: Simd> {
    /// The vectors of the arms, swapped.
    others: f64x4<S>,
    /// The swapped vectors divided by e1 x e2, with the opposite sign for the second arm.
    turning: f64x4<S>,
    gains: f64x4<S>,
    lengths: f64x4<S>,
    dyad: &'a Circles,
}

impl<'a, S: Simd> ArmPair<'a, S> {
    #[inline(always)]
    fn of<const FUSED: bool>(dyad: &'a Circles, arm_vectors: &LinkVector<f64x4<S>, FUSED>) -> Self {
        let opposite = others(arm_vectors.e);
        // e2 . (k x e1) is e1 x e2.
        let inverse = opposite.all(1.0) / opposite.dot(arm_vectors.across[0]);
        ArmPair {
            others: opposite,
            turning: opposite * inverse,
            gains: others(arm_vectors.length) * inverse.abs(),
            lengths: arm_vectors.length,
            dyad,
        }
    }

    /// Writes the row of the joint.
    fn write_rows(&self, rows: &mut Influences) {
        let gradients = [self.others.vector(1), self.others.vector(0)];
        let columns = [
            -self.turning.vector(0).perp(),
            -self.turning.vector(1).perp(),
        ];
        let from = [Some(self.dyad.near.pivot), Some(self.dyad.far.pivot)];
        rows.pair(self.dyad.point, gradients, columns, from);
    }
}

impl<S: Simd> ArmClosure<f64x4<S>> for ArmPair<'_, S> {
    #[inline(always)]
    fn gains(&self) -> f64x4<S> {
        self.gains
    }

    /// Returns the rotations and the gap. The second arm has the gap with the opposite sign.
    #[inline(always)]
    fn close(&self, _: usize, ends: f64x4<S>) -> (f64x4<S>, f64x4<S>) {
        let gap = others(ends) - ends;
        (self.turning.dot(gap), gap.size())
    }

    #[inline(always)]
    fn with_rest(&self, _: usize, ends: f64x4<S>) -> f64x4<S> {
        ends
    }

    fn rest_by_rows(
        &self,
        order: usize,
        own: f64x4<S>,
        from: &PointOff<f64x4<S>>,
        rows: &mut Influences,
    ) -> f64 {
        let Circles {
            point, near, far, ..
        } = self.dyad;
        if order == 0 {
            self.write_rows(rows);
        }
        let condition = (self.gains * self.lengths).number(0);
        let pivots = [near.pivot, far.pivot];
        let bounds = [0, 1].map(|i| {
            let here = (own.number(i), from.left[order].number(i));
            open(
                self.lengths.number(i),
                here,
                rows.has_point(pivots[i]),
                condition,
            )
        });
        rows.bound(*point, order, bounds)
    }
}

/// An arm whose end is on a rail.
struct RailArm<'a, S: Simd> {
    rail: Rail<S>,
    way: f64x2<S>,
    /// 1 / (e . t).
    inverse: f64x2<S>,
    length: f64x2<S>,
    dyad: &'a CircleRail,
}

impl<S: Simd> RailArm<'_, S> {
    /// Writes the row of the joint. As [`ArmPair::write_rows`].
    fn write_rows(&self, rows: &mut Influences) {
        let [n, e] = [self.rail.normal, self.way].map(|v| v.vector(0));
        let inverse = self.inverse.number(0);
        // e . X = r and n . X = s where X = (-k x n r + k x e s) / (e x n), and e x n is e . t.
        let columns = [-n.perp() * inverse, e.perp() * inverse];
        let from = [Some(self.dyad.arm.pivot), None];
        rows.pair(self.dyad.point, [e, n], columns, from);
    }
}

impl<S: Simd> ArmClosure<f64x2<S>> for RailArm<'_, S> {
    #[inline(always)]
    fn gains(&self) -> f64x2<S> {
        self.inverse.abs()
    }

    /// Returns the rotation and the gap. n . (k x e) is e . t.
    #[inline(always)]
    fn close(&self, order: usize, ends: f64x2<S>) -> (f64x2<S>, f64x2<S>) {
        let gap = self.rail.values[order] + self.rail.normal.dot(ends);
        (-gap * self.inverse, gap.abs())
    }

    #[inline(always)]
    fn with_rest(&self, order: usize, ends: f64x2<S>) -> f64x2<S> {
        ends + self.rail.fuzz[order]
    }

    fn rest_by_rows(
        &self,
        order: usize,
        own: f64x2<S>,
        from: &PointOff<f64x2<S>>,
        rows: &mut Influences,
    ) -> f64 {
        if order == 0 {
            self.write_rows(rows);
        }
        let has_row = rows.has_point(self.dyad.arm.pivot);
        let length = self.length.number(0);
        let condition = self.gains().number(0) * length;
        let here = (own.number(0), from.left[order].number(0));
        let bounds = [
            open(length, here, has_row, condition),
            self.rail.fuzz[order].number(0) * (1.0 + INVERSE * condition),
        ];
        rows.bound(self.dyad.point, order, bounds)
    }
}

impl Circles {
    #[inline(always)]
    pub(super) fn enclose<S: Simd, const FUSED: bool>(
        &self,
        simd: S,
        order: u8,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let (near, far) = (&self.near, &self.far);
        let x = Places::of(simd, &state.points[self.point.index()]);
        let pivots = Places::both(
            &Places::of(simd, &state.points[near.pivot.index()]),
            &Places::of(simd, &state.points[far.pivot.index()]),
        );
        let links = Bodies::both(
            &Bodies::of(simd, &state.links[near.link.index()]),
            &Bodies::of(simd, &state.links[far.link.index()]),
        );
        let arm_vectors = LinkVector::<_, FUSED>::new(
            &Places::both(&x, &x),
            &pivots,
            &links,
            &LinkShape::of_arms(simd, near, far),
            stretch::<_, FUSED>(links.d),
        );
        let from = PointOff::both(
            &PointOff::of(simd, errors.point(near.pivot)),
            &PointOff::of(simd, errors.point(far.pivot)),
        );
        let pair = ArmPair::of(self, &arm_vectors);
        let met = meet(order, &arm_vectors, &from, &pair, &mut errors.influences);
        let Some(mut met) = met else {
            return false;
        };
        errors.set_point(self.point, &met.joint, &x, state, enclosure);
        if errors.influences.is_long_chain::<FUSED>() {
            let rests = [(near, 0), (far, 1)].map(|(arm, i)| {
                let own = met.own.map(|own| own.number(i));
                let by_rows = errors.turn_by_rows(arm, (self.point, arm_vectors.e.vector(i)), own);
                by_rows.unwrap_or_else(|| met.links.rest.map(|rest| rest.number(i)))
            });
            let rest = |which: usize, k: usize| number(simd, rests[which][k]);
            met.links.rest = [0, 1, 2].map(|k| both(rest(0, k), rest(1, k)));
        }
        let [one, two] = met.links.enclosed(&links).halves();
        errors.set_link(near.link, &one, state, enclosure);
        errors.set_link(far.link, &two, state, enclosure);
        true
    }
}

impl CircleRail {
    #[inline(always)]
    pub(super) fn enclose<S: Simd, const FUSED: bool>(
        &self,
        simd: S,
        order: u8,
        state: &State,
        errors: &mut Errors,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let arm = &self.arm;
        let x = Places::of(simd, &state.points[self.point.index()]);
        let body = Bodies::of(simd, &state.links[arm.link.index()]);
        let arm_vector = arm_vector::<_, FUSED>(simd, arm, (&x, &body), state);
        let rail = Rail::new::<FUSED>(simd, &x, [self.through, self.along]);
        // e x n.
        let inverse = x.p.all(1.0) / rail.normal.dot(arm_vector.across[0]);
        let on_rail = RailArm {
            rail,
            way: arm_vector.e,
            inverse,
            length: arm_vector.length,
            dyad: self,
        };
        let from = PointOff::of(simd, errors.point(arm.pivot));
        let met = meet(order, &arm_vector, &from, &on_rail, &mut errors.influences);
        let Some(met) = met else {
            return false;
        };
        errors.set_point(self.point, &met.joint, &x, state, enclosure);
        errors.aim::<_, FUSED>(
            arm,
            (self.point, arm_vector.e),
            met,
            &body,
            state,
            enclosure,
        );
        true
    }
}
