//! Describes an element for the backward pass: the slots of the forces that pass through it.

use super::storage::{Slot, Slots};
use crate::solver::elements::{Arm, Pass, Step};
use crate::solver::plan::network::Network;
use crate::solver::plan::{GuideConstraint, Program};
use crate::{Input, LinkId, PointId, SlideId};

/// An arm of a link from a known pivot.
#[derive(Clone, Debug)]
pub(in crate::solver) struct ArmSite {
    pub pivot: PointId,
    pub link: LinkId,
    /// The slots of the forces on the link at the arm's end, and at its pivot.
    pub slots: [Slot; 2],
    /// All links of an arm that spans several links locked to each other.
    pub legs: Vec<LegSite>,
}

/// A link in the chain of an arm, between two of its joints.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct LegSite {
    pub link: LinkId,
    /// The outer joint, and the one nearer to the pivot. `slots` has the slots of the forces there.
    pub joints: [PointId; 2],
    pub slots: [Slot; 2],
}

/// A joint on a known line: the slots of its force across the line.
#[derive(Clone, Copy, Debug)]
pub(in crate::solver) struct LineReaction {
    pub slide: SlideId,
    /// Whether the guide moves with the joint, over a known point.
    pub is_yoke: bool,
    /// The slots on the link between the joint and the slide: at the joint, and at the sliding
    /// point.
    pub carrier: [Slot; 2],
    /// The slot on the guide's link at the point of the line.
    pub guide: Slot,
}

/// Returns the backward passes of a program, in the order of its steps.
pub(super) fn passes(network: &Network<'_>, program: &Program, slots: &Slots) -> Vec<Pass> {
    let steps = program.steps.iter().enumerate();
    let passes = steps.filter_map(|(at, step)| {
        step.back(&Site {
            at,
            network,
            program,
            slots,
        })
    });
    passes.collect()
}

/// An element with its context in the program.
pub(in crate::solver) struct Site<'a> {
    /// The index of its step.
    at: usize,
    network: &'a Network<'a>,
    program: &'a Program,
    slots: &'a Slots,
}

impl Site<'_> {
    /// Returns the input of the driver's coordinate.
    pub(in crate::solver) fn input(&self) -> Input {
        self.network.mechanism.driver().input
    }

    /// Returns the slot of the force on a link at one of its points.
    pub(in crate::solver) fn slot(&self, link: LinkId, point: PointId) -> Slot {
        self.slots.of(link, point)
    }

    /// Returns an arm of the element, to its end.
    pub(in crate::solver) fn reach(&self, arm: &Arm, end: PointId) -> ArmSite {
        let Arm { pivot, link, .. } = *arm;
        ArmSite {
            legs: self.legs(link),
            pivot,
            link,
            slots: [self.slots.of(link, end), self.slots.of(link, pivot)],
        }
    }

    /// Returns the arm of a cylinder, whose rod end is not a point of the barrel.
    pub(in crate::solver) fn barrel(&self, link: LinkId, pivot: PointId) -> ArmSite {
        ArmSite {
            pivot,
            link,
            slots: [self.slots.nowhere(), self.slots.of(link, pivot)],
            legs: Vec::new(),
        }
    }

    /// Returns the links of this step's arm, identified by `arm`.
    fn legs(&self, arm: LinkId) -> Vec<LegSite> {
        let legs = self.program.legs.iter();
        let legs = legs.filter(|(step, leg)| *step == self.at && leg.arm == arm);
        let legs = legs.map(|(_, leg)| LegSite {
            link: leg.link,
            joints: [leg.to, leg.from],
            slots: [leg.to, leg.from].map(|joint| self.slots.of(leg.link, joint)),
        });
        legs.collect()
    }

    /// Returns the slide of an arm that swings through a pin, and the links between the two.
    pub(in crate::solver) fn swung(&self, pin: PointId) -> (Option<SlideId>, Vec<LegSite>) {
        let Some(hold) = self.holds().next() else {
            return (None, Vec::new());
        };
        (Some(hold.slide), self.legs_between(hold, pin))
    }

    fn legs_between(&self, hold: GuideConstraint, pin: PointId) -> Vec<LegSite> {
        let Some(link) = hold.carrier else {
            return Vec::new();
        };
        let legs = self.legs(link);
        if !legs.is_empty() {
            return legs;
        }
        let joints = [self.slider(hold.slide), pin];
        let slots = joints.map(|joint| self.slots.of(link, joint));
        vec![LegSite {
            link,
            joints,
            slots,
        }]
    }

    fn slider(&self, slide: SlideId) -> PointId {
        self.network.mechanism.slide(slide).slider.point()
    }

    fn holds(&self) -> impl Iterator<Item = GuideConstraint> + '_ {
        let holds = self.program.holds.iter();
        holds.filter(|(step, _)| *step == self.at).map(|(_, h)| *h)
    }

    /// Returns the slots of the element's joint on one of its known lines.
    pub(in crate::solver) fn held(&self, which: usize, point: PointId) -> Option<LineReaction> {
        let hold = self.holds().nth(which)?;
        let nowhere = self.slots.nowhere();
        let slider = self.slider(hold.slide);
        let carrier = match hold.carrier {
            Some(link) if hold.is_yoke => [self.slots.of(link, point), nowhere],
            Some(link) => [self.slots.of(link, point), self.slots.of(link, slider)],
            None => [nowhere; 2],
        };
        let on = self
            .network
            .body(self.network.mechanism.slide(hold.slide).on);
        Some(LineReaction {
            slide: hold.slide,
            is_yoke: hold.is_yoke,
            carrier,
            guide: self.through(hold, on),
        })
    }

    /// Returns the slot of the joint on the guide's link through which the line runs. Without one,
    /// a step carries the force there.
    fn through(&self, hold: GuideConstraint, on: LinkId) -> Slot {
        let lines = self.program.steps.iter().find_map(|step| match step {
            Step::SlideReadout(travel) if travel.slide == hold.slide => Some(travel.line.through),
            _ => None,
        });
        lines.map_or(self.slots.nowhere(), |through| self.slots.of(on, through))
    }
}
