//! Places a link that keeps its angle to another link.

use super::{BackwardPass, Element, StepOutcome};
use crate::solver::forces::{ForceState, Site};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::State;
use crate::{Constant, LinkId, Number, Vec2};

/// A link that keeps its angle to another link.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct Lock {
    pub link: LinkId,
    pub to: LinkId,
    pub turn: Vec2<Constant>,
}

impl Element for Lock {
    const HAS_RESIDUALS: bool = true;
    type Back = LockBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Link(self.to));
    }

    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        _q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let mut locked = state.links[self.to.index()];
        locked.d = locked.d.turned(Vec2::of(self.turn));
        state.links[self.link.index()] = locked;
        StepOutcome::Done
    }

    fn back(&self, _site: &Site<'_>) -> Option<LockBackward> {
        Some(LockBackward {
            link: self.link,
            to: self.to,
        })
    }
}

/// The backward pass: the lock passes the couple on.
#[derive(Clone, Debug)]
pub(in crate::solver) struct LockBackward {
    link: LinkId,
    to: LinkId,
}

impl BackwardPass for LockBackward {
    #[inline(always)]
    fn run<T: Number>(&self, _state: &State<T>, forces: &mut ForceState<T>) {
        let couple = forces.couple(self.link);
        forces.couples[self.link.index()] += couple;
        forces.links[self.to.index()] += couple;
    }
}
