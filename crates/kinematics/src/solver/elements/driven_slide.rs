//! Places a driven slide: its input's coordinate is its position along the guide.

use super::riding_point::carried;
use super::{BackwardPass, Element, StepOutcome};
use crate::solver::forces::{ForceState, Site, Slot};
use crate::solver::further_inputs::{Following, InputMotion};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::State;
use crate::{Constant, LinkId, Number, PointId, SlideId, Vec2};

/// A driven slide: the point lies at `along p` on a link, relative to `base`, with p the coordinate
/// of its input.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Push {
    pub point: PointId,
    pub base: PointId,
    pub link: LinkId,
    pub along: Vec2<Constant>,
    pub slide: SlideId,
    /// The law by which its input follows the driver; `None` if it is the driver.
    pub following: Option<Following>,
}

impl Element for Push {
    type Back = PushBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.base));
        reads(PlacedPart::Link(self.link));
    }

    /// Like a point that rides on the link, plus, with tau the guide's direction, V' = V + p' tau
    /// and A' = A + 2 w p' k x tau + p'' tau.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let base = state.points[self.base.index()];
        let link = state.links[self.link.index()];
        let along = Vec2::of(self.along);
        let InputMotion { p, w, a } = InputMotion::of(self.following.as_ref(), q);
        let mut pushed = carried::<T, ORDER>(&base, &link, along * p);
        let mut tau = along.turned(link.d);
        if self.following.is_some() {
            pushed.a += tau * a;
            tau = tau * w;
        }
        pushed.v += tau;
        pushed.a += tau.perp() * link.w.scaled(2.0);
        state.points[self.point.index()] = pushed;
        StepOutcome::Done
    }

    fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        self.following.iter_mut().for_each(change);
    }

    fn back(&self, site: &Site<'_>) -> Option<PushBackward> {
        Some(PushBackward {
            step: self.clone(),
            slot: site.slot(self.link, self.base),
        })
    }
}

/// The backward pass: the driver takes the force along the guide, the guide takes the rest.
#[derive(Clone, Debug)]
pub(in crate::solver) struct PushBackward {
    step: Push,
    slot: Slot,
}

impl BackwardPass for PushBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let Push {
            point,
            base,
            link,
            along,
            slide,
            ..
        } = self.step;
        let force = forces.at(point);
        let r = state.points[point.index()].p - state.points[base.index()].p;
        let tau = Vec2::of(along).turned(state.links[link.index()].d);
        forces.note(self.slot, -force);
        forces.points[base.index()] += force;
        forces.links[link.index()] += r.cross(force);
        forces.drive_by(self.step.following.as_ref(), force.dot(tau), state);
        forces.normals[slide.index()] = -tau.cross(force);
    }
}
