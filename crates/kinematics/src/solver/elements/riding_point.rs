//! Places a point that rides on a link with a known direction and another known point.

use super::{ACCELERATION, BackwardPass, Element, StepOutcome, VELOCITY};
use crate::solver::forces::{ForceState, Site, Slot};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::{Constant, LinkId, Number, PointId, Vec2};

/// A point at `local` on a link, relative to another point of the same link.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Ride {
    pub point: PointId,
    pub base: PointId,
    pub link: LinkId,
    pub local: Vec2<Constant>,
}

/// Computes X = P + R(d) r, V = V_P + w k x r, A = A_P + alpha k x r - w^2 r.
#[inline(always)]
pub(super) fn carried<T: Number, const ORDER: u8>(
    base: &PointState<T>,
    link: &LinkState<T>,
    local: Vec2<T>,
) -> PointState<T> {
    let r = local.turned(link.d);
    let mut point = PointState {
        p: base.p + r,
        ..PointState::default()
    };
    if ORDER >= VELOCITY {
        point.v = base.v + r.perp() * link.w;
    }
    if ORDER >= ACCELERATION {
        point.a = base.a + r.perp() * link.a - r * (link.w * link.w);
    }
    point
}

impl Element for Ride {
    const IS_FREQUENT: bool = true;
    const HAS_RESIDUALS: bool = true;
    type Back = RideBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.base));
        reads(PlacedPart::Link(self.link));
    }

    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let base = state.points[self.base.index()];
        let link = state.links[self.link.index()];
        let point = carried::<T, ORDER>(&base, &link, Vec2::of(self.local));
        state.points[self.point.index()] = point;
        StepOutcome::Done
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        place(&mut self.local);
    }

    fn back(&self, site: &Site<'_>) -> Option<RideBackward> {
        Some(RideBackward::new(site, [self.point, self.base], self.link))
    }
}

/// The backward pass of a point of a link: the link carries the force from the point to the base.
#[derive(Clone, Debug)]
pub(in crate::solver) struct RideBackward {
    points: [PointId; 2],
    link: LinkId,
    /// The slots for the force on the link at the point and at the base.
    slots: [Slot; 2],
}

impl RideBackward {
    pub(super) fn new(site: &Site<'_>, points: [PointId; 2], link: LinkId) -> RideBackward {
        RideBackward {
            points,
            link,
            slots: points.map(|point| site.slot(link, point)),
        }
    }
}

impl BackwardPass for RideBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let [point, base] = self.points;
        let force = forces.at(point);
        let r = state.points[point.index()].p - state.points[base.index()].p;
        forces.note(self.slots[0], force);
        forces.note(self.slots[1], -force);
        forces.points[base.index()] += force;
        forces.links[self.link.index()] += r.cross(force);
    }
}
