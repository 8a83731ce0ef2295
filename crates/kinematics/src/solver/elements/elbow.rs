//! Places a link that an input turns against another link, which carries the motor.

use super::{BackwardPass, Element, StepOutcome};
use crate::solver::forces::{ForceState, Site};
use crate::solver::further_inputs::{Following, InputMotion};
use crate::solver::plan::pruning::PlacedPart;
use crate::solver::state::{LinkState, State};
use crate::{LinkId, Number, Vec2};

/// One of two links whose relative angle is an input's coordinate; its direction follows from the
/// other one.
#[derive(Clone, Debug)]
pub(in crate::solver) struct Elbow {
    pub link: LinkId,
    pub from: LinkId,
    /// Whether the link carrying the motor is unknown and the turned link is known.
    pub is_seat: bool,
    /// The law by which the input follows the driver; `None` if it is the driver.
    pub following: Option<Following>,
}

impl Element for Elbow {
    type Back = ElbowBackward;

    fn outputs(&self, places: &mut impl FnMut(PlacedPart)) {
        places(PlacedPart::Link(self.link));
    }

    fn inputs(&self, reads: &mut impl FnMut(PlacedPart)) {
        reads(PlacedPart::Link(self.from));
    }

    /// theta = theta_from + p, so that w = w_from + p' and a = a_from + p''; with -p for the link
    /// that carries the motor.
    #[inline(always)]
    fn run<T: Number, const ORDER: u8>(
        &self,
        q: T,
        _direction: Vec2<T>,
        state: &mut State<T>,
    ) -> StepOutcome {
        let InputMotion { p, w, a } = InputMotion::of(self.following.as_ref(), q);
        let from = state.links[self.from.index()];
        let by = T::unit(p);
        state.links[self.link.index()] = if self.is_seat {
            LinkState {
                d: from.d.turned(by.conj()),
                w: from.w - w,
                a: from.a - a,
            }
        } else {
            LinkState {
                d: from.d.turned(by),
                w: from.w + w,
                a: from.a + a,
            }
        };
        StepOutcome::Done
    }

    fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        self.following.iter_mut().for_each(change);
    }

    fn back(&self, _site: &Site<'_>) -> Option<ElbowBackward> {
        Some(ElbowBackward { step: self.clone() })
    }
}

/// The backward pass: the motor resists the couple on the link, which passes on to the other link.
#[derive(Clone, Debug)]
pub(in crate::solver) struct ElbowBackward {
    step: Elbow,
}

impl BackwardPass for ElbowBackward {
    #[inline(always)]
    fn run<T: Number>(&self, state: &State<T>, forces: &mut ForceState<T>) {
        let Elbow {
            link,
            from,
            is_seat,
            following,
        } = &self.step;
        let couple = forces.links[link.index()];
        forces.links[from.index()] += couple;
        let effort = if *is_seat {
            T::default() - couple
        } else {
            couple
        };
        forces.drive_by(following.as_ref(), effort, state);
    }
}
