//! Computes a slide's position and rates along its guide.

use super::{Element, GuideLine, NoBackwardPass, StepOutcome};
use crate::solver::forces::Site;
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State, TravelState};
use crate::{Number, PointId, SlideId, Vec2};

/// The position and rates of a slide along its guide.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct SlideReadout {
    pub slide: SlideId,
    pub point: PointId,
    pub line: GuideLine,
}

impl Element for SlideReadout {
    const HAS_RESIDUALS: bool = true;
    type Back = NoBackwardPass;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Slide(self.slide));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Point(self.point));
        self.line.inputs().into_iter().for_each(reads);
    }

    /// X - Q = s t: s' = t.(V_X - V_Q), s'' = t.(A_X - A_Q) + w^2 s.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let guide = self.line.at(state);
        let x = state.points[self.point.index()];
        let s = guide.t.dot(x.p - guide.q.p);
        state.travels[self.slide.index()] = TravelState {
            s,
            v: guide.t.dot(x.v - guide.q.v),
            a: guide.t.dot(x.a - guide.q.a) + guide.w * guide.w * s,
            guide: LinkState {
                d: guide.t,
                w: guide.w,
                a: guide.a,
            },
        };
        StepOutcome::Done
    }

    fn back(&self, _site: &Site<'_>) -> Option<NoBackwardPass> {
        None
    }
}
