//! Bounds links determined by two of their points.

use super::errors::{Errors, size};
use super::influence::Influences;
use super::link_vector::LinkVector;
use super::loaded_state::{Bodies, Places};
use super::meeting::{ArmClosure, ClosureErrors, meet};
use super::off::PointOff;
use super::shape::{LinkShape, stretch};
use crate::arithmetic::plane::{Plane, Simd, f64x2, number};
use crate::solver::elements::Arm;
use crate::solver::state::State;
use crate::{Ball, PointId, Vec2};

/// An arm to a point with a known error.
struct AimedArm<'a, S: Simd> {
    across: f64x2<S>,
    /// 1 / |e|^2.
    inverse: f64x2<S>,
    gain: f64x2<S>,
    end: &'a PointOff<f64x2<S>>,
}

impl<S: Simd> ArmClosure<f64x2<S>> for AimedArm<'_, S> {
    #[inline(always)]
    fn gains(&self) -> f64x2<S> {
        self.gain
    }

    #[inline(always)]
    fn close(&self, order: usize, ends: f64x2<S>) -> (f64x2<S>, f64x2<S>) {
        let gap = self.end.shift[order] - ends;
        (self.across.dot(gap) * self.inverse, gap.size())
    }

    #[inline(always)]
    fn with_rest(&self, order: usize, ends: f64x2<S>) -> f64x2<S> {
        ends + self.end.left[order]
    }

    fn rest_by_rows(
        &self,
        order: usize,
        own: f64x2<S>,
        _: &PointOff<f64x2<S>>,
        _: &mut Influences,
    ) -> f64 {
        // The rotation closes the gap only across the vector. Along the vector, its own error
        // remains.
        (self.end.left[order] + own).number(0)
    }
}

/// Returns the vector along an arm to a point, on this link.
#[inline(always)]
pub(super) fn arm_vector<S: Simd, const FUSED: bool>(
    simd: S,
    arm: &Arm,
    (end, link): (&Places<f64x2<S>>, &Bodies<f64x2<S>>),
    state: &State,
) -> LinkVector<f64x2<S>, FUSED> {
    let pivot = Places::of(simd, &state.points[arm.pivot.index()]);
    let stretch = stretch::<_, FUSED>(link.d);
    LinkVector::new(end, &pivot, link, &LinkShape::of_arm(simd, arm), stretch)
}

impl Errors {
    /// Encloses a link determined by two of its points.
    #[inline(always)]
    pub(super) fn aim<S: Simd, const FUSED: bool>(
        &mut self,
        arm: &Arm,
        (end, e): (PointId, f64x2<S>),
        met: ClosureErrors<f64x2<S>>,
        body: &Bodies<f64x2<S>>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let mut error = met.links;
        if self.influences.is_long_chain::<FUSED>() {
            let own = met.own.map(|own| own.number(0));
            if let Some(rest) = self.turn_by_rows(arm, (end, e.vector(0)), own) {
                error.rest = rest.map(|rest| number(e.simd, rest));
            }
        }
        self.set_link(arm.link, &error.enclosed(body), state, enclosure);
    }

    /// Encloses a link with two known ends.
    #[inline(always)]
    pub(super) fn aim_at<S: Simd, const FUSED: bool>(
        &mut self,
        simd: S,
        order: u8,
        arm: &Arm,
        end: PointId,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let x = Places::of(simd, &state.points[end.index()]);
        let body = Bodies::of(simd, &state.links[arm.link.index()]);
        let arm_vector = arm_vector::<_, FUSED>(simd, arm, (&x, &body), state);
        let inverse = x.p.all(1.0) / arm_vector.e.dot(arm_vector.e);
        let towards = AimedArm {
            across: arm_vector.across[0],
            inverse,
            gain: arm_vector.length * inverse,
            end: &PointOff::of(simd, self.point(end)),
        };
        let from = PointOff::of(simd, self.point(arm.pivot));
        let met = meet(order, &arm_vector, &from, &towards, &mut self.influences);
        let Some(met) = met else {
            return false;
        };
        self.aim::<_, FUSED>(arm, (end, arm_vector.e), met, &body, state, enclosure);
        true
    }

    /// Returns the rests of a link along this vector to an end, by influence rows. `own` is the
    /// error that the vector itself leaves open. `None` if the link has no row.
    #[inline(never)]
    pub(super) fn turn_by_rows(
        &mut self,
        arm: &Arm,
        (end, e): (PointId, Vec2),
        own: [f64; 3],
    ) -> Option<[f64; 3]> {
        if !self.influences.has_link(arm.link) {
            return None;
        }
        let inverse = 1.0 / e.norm2();
        let gain = size(e) * inverse;
        let lefts = [end, arm.pivot].map(|point| self.left_without_row(point));
        let new = [0, 1, 2].map(|k| gain * (own[k] + lefts[0][k] + lefts[1][k]));
        let across = e.perp() * inverse;
        let ends = [end, arm.pivot];
        Some(self.influences.between(arm.link, new, across, ends))
    }
}
