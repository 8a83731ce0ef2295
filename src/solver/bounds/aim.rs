//! Bounds of links by two of their points.

use super::errors::{Errors, PointError, size};
use super::influence::Influences;
use super::limb::Limb;
use super::meeting::{Meeting, Met, meet};
use super::shape::{Shape, stretch};
use crate::solver::elements::Arm;
use crate::solver::state::State;
use crate::{Ball, PointId, Vec2};

/// An arm to a point whose error is known.
struct Towards<'a> {
    across: Vec2,
    /// 1 / |e|^2.
    inverse: f64,
    gain: f64,
    end: &'a PointError,
}

impl Meeting<f64> for Towards<'_> {
    #[inline(always)]
    fn gains(&self) -> f64 {
        self.gain
    }

    #[inline(always)]
    fn close(&self, order: usize, ends: Vec2) -> (f64, f64) {
        let gap = self.end.shift[order] - ends;
        (self.across.dot(gap) * self.inverse, size(gap))
    }

    #[inline(always)]
    fn sum(&self, parts: f64) -> f64 {
        parts
    }

    #[inline(always)]
    fn rest(&self, order: usize) -> f64 {
        self.end.left[order]
    }

    fn rest_by_rows(&self, order: usize, _: f64, _: &PointError, _: &mut Influences) -> f64 {
        self.end.left[order]
    }
}

/// The way along an arm to a point.
#[inline(always)]
pub(super) fn limb_of<const FUSED: bool>(
    arm: &Arm,
    end: PointId,
    state: &State,
) -> Limb<f64, FUSED> {
    let [x, p] = [end, arm.pivot].map(|point| &state.points[point.index()]);
    let link = &state.links[arm.link.index()];
    let stretch = stretch::<_, FUSED>(link.d);
    Limb::<_, FUSED>::new(x, p, link, &Shape::of_arm(arm), stretch)
}

impl Errors {
    /// A link by two of its points.
    #[inline(always)]
    pub(super) fn aim<const ROWS: bool>(
        &mut self,
        arm: &Arm,
        (end, e): (PointId, Vec2),
        met: Met<f64>,
        state: &State,
        enclosure: &mut State<Ball>,
    ) {
        let mut error = met.links;
        if ROWS && let Some(rest) = self.turn_by_rows(arm, (end, e), met.own) {
            error.rest = rest;
        }
        self.set_link(arm.link, &error, &state.links[arm.link.index()], enclosure);
    }

    /// A link both of whose ends are known.
    #[inline(always)]
    pub(super) fn aim_at<const ORDER: u8, const FUSED: bool, const ROWS: bool>(
        &mut self,
        arm: &Arm,
        end: PointId,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let limb = limb_of::<FUSED>(arm, end, state);
        let inverse = 1.0 / limb.e.norm2();
        let towards = Towards {
            across: limb.e.perp(),
            inverse,
            gain: limb.length * inverse,
            end: &self.points[end.index()],
        };
        let from = &self.points[arm.pivot.index()];
        let met = meet::<f64, ORDER, FUSED, ROWS>(&limb, from, &towards, &mut self.influences);
        let Some(met) = met else {
            return false;
        };
        self.aim::<ROWS>(arm, (end, limb.e), met, state, enclosure);
        true
    }

    /// What is left of a link with this way to an end, by rows of influences, when the way leaves so much open of
    /// itself; nothing where the link has no row.
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
