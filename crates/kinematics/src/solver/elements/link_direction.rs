//! Computes the direction of a link with two known points.

use super::{ACCELERATION, Arm, BackwardPass, Element, StepOutcome, VELOCITY};
use crate::solver::forces::{ArmSite, ForceState, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::{Constant, Number, PointId, Vec2};

/// The direction of a link with two known points.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Aim {
    pub arm: Arm,
    pub end: PointId,
}

impl Element for Aim {
    const HAS_RESIDUALS: bool = true;
    type Back = AimBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.arm.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.arm.pivot));
        reads(PlacedPart::Point(self.end));
    }

    /// With e = X - P: w = e x (V_X - V_P) / r^2, and alpha likewise, because e x (w^2 e) = 0.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let arm = &self.arm;
        let (p, x) = (
            state.points[arm.pivot.index()],
            state.points[self.end.index()],
        );
        let e = x.p - p.p;
        let mut link = LinkState {
            d: arm.direction(e),
            ..LinkState::default()
        };
        let length = arm.length::<T>();
        let scale = T::exactly(1.0) / (length * length);
        if ORDER >= VELOCITY {
            link.w = e.cross(x.v - p.v) * scale;
        }
        if ORDER >= ACCELERATION {
            link.a = e.cross(x.a - p.a) * scale;
        }
        state.links[arm.link.index()] = link;
        StepOutcome::Done
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        self.arm = self.arm.varied(place);
    }

    fn back(&self, site: &Site<'_>) -> Option<AimBackward> {
        Some(AimBackward {
            arm: site.reach(&self.arm, self.end),
            end: self.end,
        })
    }
}

/// The backward pass: the link's ends resist the couple on the link.
#[derive(Clone, Debug)]
pub(in crate::solver) struct AimBackward {
    arm: ArmSite,
    end: PointId,
}

impl BackwardPass for AimBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let at = |point: PointId| -> Vec2<T> { state.points[point.index()].p };
        let e = at(self.end) - at(self.arm.pivot);
        let force = -(e.perp() * (forces.couple(self.arm.link) / e.norm2()));
        forces.hold(&self.arm, force, state);
        let back = forces.at(self.end) - force;
        forces.points[self.end.index()] = back;
    }
}
