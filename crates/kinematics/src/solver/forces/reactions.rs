//! Propagates forces backwards through elements: forces on arms, guides and joints.
//!
//! The notation is that of the steps: X the placed joint, P and Q the pivots, e = X - P and f = X -
//! Q, t and n along and across a guide. F is the force accumulated on a point, M the couple
//! accumulated on a link. A force "on" a link comes from the pin or the guide.

use super::ForceState;
use super::site::{ArmSite, LineReaction};
use super::storage::Slot;
use crate::solver::elements::GuideLine;
use crate::solver::state::State;
use crate::{LinkId, Number, PointId, Vec2};

impl<T: Number> ForceState<T> {
    #[inline(always)]
    pub(in crate::solver) fn at(&self, point: PointId) -> Vec2<T> {
        self.points[point.index()]
    }

    #[inline(always)]
    pub(in crate::solver) fn couple(&self, link: LinkId) -> T {
        self.links[link.index()]
    }

    /// Applies a force to a link at the end of an arm. The pivot reacts to it.
    #[inline(always)]
    pub(in crate::solver) fn hold(&mut self, reach: &ArmSite, force: Vec2<T>, state: &State<T>) {
        self.points[reach.pivot.index()] += force;
        if !reach.legs.is_empty() {
            self.hold_over(reach, force, state);
            return;
        }
        self.note(reach.slots[0], force);
        self.note(reach.slots[1], -force);
    }

    /// Applies a force to an arm that spans several links. The locks keep each of them from
    /// turning.
    #[cold]
    fn hold_over(&mut self, reach: &ArmSite, force: Vec2<T>, state: &State<T>) {
        for leg in &reach.legs {
            self.note(leg.slots[0], force);
            self.note(leg.slots[1], -force);
            let [out, near] = leg.joints.map(|joint| state.points[joint.index()].p);
            if leg.link != reach.link {
                self.couples[leg.link.index()] += (out - near).cross(force);
            }
        }
    }

    #[inline(always)]
    pub(in crate::solver) fn note(&mut self, slot: Slot, force: Vec2<T>) {
        self.joints[slot] += force;
    }

    /// Applies the force of a joint on a line: `across` along its normal, at s from the point of
    /// the line.
    #[inline(always)]
    pub(in crate::solver) fn press(
        &mut self,
        hold: &LineReaction,
        line: Option<(&GuideLine, T)>,
        n: Vec2<T>,
        across: T,
    ) {
        let force = n * across;
        self.note(hold.carrier[0], force);
        self.note(hold.carrier[1], -force);
        if !hold.is_yoke {
            self.note(hold.guide, -force);
        }
        // A guide that moves with the joint presses on the point over which it slides.
        self.normals[hold.slide.index()] = if hold.is_yoke { across } else { -across };
        if let Some((line, s)) = line {
            self.points[line.through.index()] += force;
            self.links[line.link.index()] += s * across;
        }
    }

    /// Distributes the force at a joint to its two arms. With g on the far link, f x g = -M2 and e
    /// x (F - g) = -M1. Returns F - g, the force on the near one.
    #[inline(always)]
    pub(in crate::solver) fn share(
        &mut self,
        point: PointId,
        near: &ArmSite,
        far: &ArmSite,
        state: &State<T>,
    ) -> Vec2<T> {
        let at = |point: PointId| -> Vec2<T> { state.points[point.index()].p };
        let (e, f) = (at(point) - at(near.pivot), at(point) - at(far.pivot));
        let force = self.at(point);
        let one = self.couple(near.link) + e.cross(force);
        let g = (f * one + e * self.couple(far.link)) / e.cross(f);
        self.hold(far, g, state);
        self.hold(near, force - g, state);
        force - g
    }

    /// Returns the force across a line from a joint on it, with an arm e whose couple the line must
    /// balance: M + e x (F - N n) = 0, and e x n = e.t.
    #[inline(always)]
    pub(in crate::solver) fn across(
        &self,
        e: Vec2<T>,
        t: Vec2<T>,
        point: PointId,
        link: LinkId,
    ) -> T {
        (self.couple(link) + e.cross(self.at(point))) / e.dot(t)
    }
}
