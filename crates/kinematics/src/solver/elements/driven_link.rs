//! Places a further link turned by an input whose angle follows the driver's coordinate.

use super::{BackwardPass, Element, StepOutcome};
use crate::solver::forces::{ForceState, Site};
use crate::solver::further_inputs::{Following, InputMotion};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::{LinkId, Number, Vec2};

/// A link whose angle follows the driver's coordinate.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Timed {
    pub link: LinkId,
    pub following: Following,
}

impl Element for Timed {
    type Back = TimedBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.link));
    }

    fn inputs(&self, _reads: &mut impl FnMut(PlacedPart)) {}

    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let InputMotion { p, w, a } = self.following.at(q);
        let d = T::unit(p);
        state.links[self.link.index()] = LinkState { d, w, a };
        StepOutcome::Done
    }

    fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        change(&mut self.following);
    }

    fn back(&self, _site: &Site<'_>) -> Option<TimedBackward> {
        Some(TimedBackward { step: self.clone() })
    }
}

/// The backward pass: the driver resists the couple on the link, through the law by which it
/// follows.
#[derive(Clone, Debug)]
pub(in crate::solver) struct TimedBackward {
    step: Timed,
}

impl BackwardPass for TimedBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let Timed { link, following } = &self.step;
        let couple = forces.links[link.index()];
        forces.drive_by(Some(following), couple, state);
    }
}
