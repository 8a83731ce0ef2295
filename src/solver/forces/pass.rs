//! The steps of a plan as they are run backwards: each with the places where the forces that pass it are
//! noted.

use super::slots::{Slot, Slots};
use crate::solver::network::Network;
use crate::solver::plan::{Hold, Program};
use crate::solver::step::{Arm, Line, Step};
use crate::{Constant, Input, LinkId, PointId, SlideId, Vec2};

/// One step backwards.
#[derive(Clone, Debug)]
pub(super) enum Pass {
    /// A point of a link, seen from another one: the link carries its force there.
    Carry {
        point: PointId,
        base: PointId,
        link: LinkId,
        /// The force on the link at the point, and at the base.
        slots: [Slot; 2],
    },
    /// The driven slide.
    Push {
        point: PointId,
        base: PointId,
        link: LinkId,
        slot: Slot,
        along: Vec2<Constant>,
        slide: SlideId,
    },
    /// A link both of whose ends were known: what turns it, its ends resist.
    Aim { arm: Reach, end: PointId },
    /// A link that keeps its angle to another one.
    Lock { link: LinkId, to: LinkId },
    /// RRR.
    Circles {
        point: PointId,
        near: Reach,
        far: Reach,
    },
    /// RRR with a driven arm.
    Cylinder {
        point: PointId,
        barrel: Reach,
        along: Vec2<Constant>,
        far: Reach,
        slide: Option<SlideId>,
    },
    /// RRP on the ground.
    CircleRail {
        point: PointId,
        arm: Reach,
        along: Vec2<Constant>,
        hold: Held,
    },
    /// RRP.
    CircleLine {
        point: PointId,
        arm: Reach,
        line: Line,
        hold: Held,
    },
    /// RPR.
    Swing {
        pivot: PointId,
        pin: PointId,
        link: LinkId,
        along: Vec2<Constant>,
        slot: Slot,
        slide: Option<SlideId>,
        /// The links between the pin and the slide.
        legs: Vec<Leg>,
    },
    /// PRP and RPP.
    Lines {
        point: PointId,
        lines: [Line; 2],
        holds: [Held; 2],
    },
    /// A coupled group.
    Coupled { index: usize },
}

/// An arm of a link from a known pivot.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    pub pivot: PointId,
    pub link: LinkId,
    /// The force on the link at the arm's end, and at its pivot.
    pub slots: [Slot; 2],
    /// Where the arm goes over several links that are locked to each other, all of them.
    pub legs: Vec<Leg>,
}

/// A link on the way of an arm, between two of its joints.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub link: LinkId,
    /// The joint further out, and the one nearer to the pivot; and the places of the forces there.
    pub joints: [PointId; 2],
    pub slots: [Slot; 2],
}

/// A joint on a known line: where its force across the line is noted.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    pub slide: SlideId,
    /// Whether the guide moves with the joint, over a known point.
    pub is_yoke: bool,
    /// On the link between the joint and the slide: at the joint, and at the sliding point.
    pub carrier: [Slot; 2],
    /// On the guide's link at the point that the line runs through.
    pub guide: Slot,
}

/// The passes of a program, in the order of its steps.
pub(super) fn passes(network: &Network<'_>, program: &Program, slots: &Slots) -> Vec<Pass> {
    let maker = Maker {
        network,
        program,
        slots,
    };
    let steps = program.steps.iter().enumerate();
    steps.filter_map(|(i, step)| maker.pass(i, step)).collect()
}

struct Maker<'a> {
    network: &'a Network<'a>,
    program: &'a Program,
    slots: &'a Slots,
}

impl Maker<'_> {
    fn pass(&self, at: usize, step: &Step) -> Option<Pass> {
        Some(match *step {
            Step::Crank { .. } | Step::Travel { .. } => return None,
            Step::Spin { point, pivot, .. } => {
                let Input::Turn(link) = self.network.mechanism.driver().input else {
                    return None;
                };
                self.carry(point, pivot, link)
            }
            Step::Ride {
                point, base, link, ..
            } => self.carry(point, base, link),
            Step::Push {
                point,
                base,
                link,
                along,
                ..
            } => Pass::Push {
                point,
                base,
                link,
                slot: self.slots.of(link, base),
                along,
                slide: self.driven_slide()?,
            },
            Step::Aim { arm, end } => Pass::Aim {
                arm: self.reach(at, &arm, end),
                end,
            },
            Step::Lock { link, to, .. } => Pass::Lock { link, to },
            Step::Circles(c) => Pass::Circles {
                point: c.point,
                near: self.reach(at, &c.near, c.point),
                far: self.reach(at, &c.far, c.point),
            },
            Step::Cylinder(c) => Pass::Cylinder {
                point: c.point,
                barrel: Reach {
                    pivot: c.pivot,
                    link: c.link,
                    slots: [self.slots.nowhere(), self.slots.of(c.link, c.pivot)],
                    legs: Vec::new(),
                },
                along: c.along,
                far: self.reach(at, &c.far, c.point),
                slide: self.driven_slide(),
            },
            Step::CircleRail(c) => Pass::CircleRail {
                point: c.point,
                arm: self.reach(at, &c.arm, c.point),
                along: c.along,
                hold: self.hold(at, 0, c.point)?,
            },
            Step::CircleLine(c) => Pass::CircleLine {
                point: c.point,
                arm: self.reach(at, &c.arm, c.point),
                line: c.line,
                hold: self.hold(at, 0, c.point)?,
            },
            Step::Swing(s) => {
                let hold = self.holds(at).next();
                let legs = hold.map_or_else(Vec::new, |hold| self.swung(at, hold, s.pin));
                Pass::Swing {
                    pivot: s.pivot,
                    pin: s.pin,
                    link: s.link,
                    along: s.along,
                    slot: self.slots.of(s.link, s.pivot),
                    slide: hold.map(|hold| hold.slide),
                    legs,
                }
            }
            Step::Lines {
                point,
                first,
                second,
                ..
            } => Pass::Lines {
                point,
                lines: [first, second],
                holds: [self.hold(at, 0, point)?, self.hold(at, 1, point)?],
            },
            Step::Coupled { index } => Pass::Coupled { index },
        })
    }

    fn carry(&self, point: PointId, base: PointId, link: LinkId) -> Pass {
        Pass::Carry {
            point,
            base,
            link,
            slots: [self.slots.of(link, point), self.slots.of(link, base)],
        }
    }

    fn reach(&self, at: usize, arm: &Arm, end: PointId) -> Reach {
        let Arm { pivot, link, .. } = *arm;
        Reach {
            legs: self.legs(at, link),
            pivot,
            link,
            slots: [self.slots.of(link, end), self.slots.of(link, pivot)],
        }
    }

    /// The links on the way of the arm of a step that is known by this one.
    fn legs(&self, at: usize, arm: LinkId) -> Vec<Leg> {
        let legs = self.program.legs.iter();
        let legs = legs.filter(|(step, leg)| *step == at && leg.arm == arm);
        let legs = legs.map(|(_, leg)| Leg {
            link: leg.link,
            joints: [leg.to, leg.from],
            slots: [leg.to, leg.from].map(|joint| self.slots.of(leg.link, joint)),
        });
        legs.collect()
    }

    /// The links between a pin and what slides on an arm.
    fn swung(&self, at: usize, hold: Hold, pin: PointId) -> Vec<Leg> {
        let Some(link) = hold.carrier else {
            return Vec::new();
        };
        let legs = self.legs(at, link);
        if !legs.is_empty() {
            return legs;
        }
        let joints = [self.slider(hold.slide), pin];
        let slots = joints.map(|joint| self.slots.of(link, joint));
        vec![Leg {
            link,
            joints,
            slots,
        }]
    }

    fn driven_slide(&self) -> Option<SlideId> {
        match self.network.mechanism.driver().input {
            Input::Turn(_) => None,
            Input::Push(slide) => Some(slide),
        }
    }

    fn slider(&self, slide: SlideId) -> PointId {
        self.network.mechanism.slide(slide).slider.point()
    }

    fn holds(&self, at: usize) -> impl Iterator<Item = Hold> + '_ {
        let holds = self.program.holds.iter();
        holds.filter(move |(step, _)| *step == at).map(|(_, h)| *h)
    }

    fn hold(&self, at: usize, which: usize, point: PointId) -> Option<Held> {
        let hold = self.holds(at).nth(which)?;
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
        Some(Held {
            slide: hold.slide,
            is_yoke: hold.is_yoke,
            carrier,
            guide: self.through(hold, on),
        })
    }

    /// Where the guide's line runs through a joint of its link, that joint feels what the guide is
    /// given; else a step carries it there.
    fn through(&self, hold: Hold, on: LinkId) -> Slot {
        let lines = self.program.steps.iter().find_map(|step| match step {
            Step::Travel { slide, line, .. } if *slide == hold.slide => Some(line.through),
            _ => None,
        });
        lines.map_or(self.slots.nowhere(), |through| self.slots.of(on, through))
    }
}
