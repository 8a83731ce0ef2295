//! Places the driven link and its points: the driver's coordinate is the link's angle.

use super::riding_point::RideBackward;
use super::{Element, NoBackwardPass, StepOutcome};
use crate::solver::forces::Site;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, PointState, State};
use crate::{Constant, Input, LinkId, Number, PointId, Vec2};

/// The driven link, which has the driver's direction.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Crank {
    pub link: LinkId,
}

impl Element for Crank {
    const IS_FREQUENT: bool = true;
    const HAS_RESIDUALS: bool = true;
    type Back = NoBackwardPass;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.link));
    }

    fn inputs(&self, _reads: &mut impl FnMut(PlacedPart)) {}

    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        state.links[self.link.index()] = LinkState {
            d: direction,
            w: T::exactly(1.0),
            a: T::default(),
        };
        StepOutcome::Done
    }

    fn back(&self, _site: &Site<'_>) -> Option<NoBackwardPass> {
        None
    }
}

/// A point of the driven link, at `local` from the link's ground pivot.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Spin {
    pub point: PointId,
    pub pivot: PointId,
    pub local: Vec2<Constant>,
}

impl Element for Spin {
    const IS_FREQUENT: bool = true;
    const HAS_RESIDUALS: bool = true;
    type Back = RideBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Point(self.point));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.pivot));
    }

    /// X = P + R r, V = k x R r, A = -R r.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let r = Vec2::of(self.local).turned(direction);
        let v = r.perp();
        state.points[self.point.index()] = PointState {
            p: state.points[self.pivot.index()].p + r,
            v,
            a: v.perp(),
        };
        StepOutcome::Done
    }

    fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        place(&mut self.local);
    }

    fn back(&self, site: &Site<'_>) -> Option<RideBackward> {
        match site.input() {
            Input::Turn(link) => Some(RideBackward::new(site, [self.point, self.pivot], link)),
            Input::Push(_) => None,
        }
    }
}
