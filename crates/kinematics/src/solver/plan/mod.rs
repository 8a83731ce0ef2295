//! Defines the plan of a mechanism: groups in solving order for users, steps for the solver.

pub(super) mod network;
pub(super) mod order;
pub(super) mod pruning;

use super::coupled::Coupled;
use super::elements::Step;
use super::fault::Fault;
use super::frame::Frame;
use super::further_inputs::Following;
use crate::mechanism::id;
use crate::{Constant, ElementId, LinkId, Mechanism, PointId, SlideId, Vec2};
use network::Network;

/// How a group is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupKind {
    /// The driven link or slide.
    Driver,
    /// Two links and three pins: circle and circle.
    Rrr,
    /// Pin, pin, slide: circle and line.
    Rrp,
    /// Pin, slide, pin: an arm that slides through a pin.
    Rpr,
    /// Slide, pin, slide: two lines.
    Prp,
    /// Pin, slide, slide: two lines.
    Rpp,
    /// A coupled group, solved by Newton's method.
    Coupled {
        /// The number of unknowns solved for at once.
        unknowns: usize,
    },
}

impl GroupKind {
    /// Returns the class of a dyad by its joints from pivot to pivot: R is a revolute joint, P a
    /// prismatic one.
    #[must_use]
    pub fn class(self) -> Option<&'static str> {
        match self {
            GroupKind::Rrr => Some("RRR"),
            GroupKind::Rrp => Some("RRP"),
            GroupKind::Rpr => Some("RPR"),
            GroupKind::Prp => Some("PRP"),
            GroupKind::Rpp => Some("RPP"),
            GroupKind::Driver | GroupKind::Coupled { .. } => None,
        }
    }

    /// Returns the number of unknowns that a coupled group solves for at once.
    #[must_use]
    pub fn unknowns(self) -> Option<usize> {
        match self {
            GroupKind::Coupled { unknowns } => Some(unknowns),
            _ => None,
        }
    }
}

/// The assembly that a group is to take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AssemblyChoice {
    /// The positive side of a dyad. For two links: the joint lies on the left of the line from the
    /// pivot of the first link to that of the second, in the mechanism's order. For a link and a
    /// guide: the joint lies further along the guide than the foot of the link's pivot. For an arm:
    /// its guide runs from its pivot towards the pin. At a change point, this describes the
    /// position just past it, as the driver's coordinate increases.
    Plus,
    /// The negative side of a dyad.
    Minus,
    /// The number of a coupled group's assembly, counted from 1 in the order of
    /// [`super::Solver::choices`].
    Number(usize),
}

id!(
    /// A group of a [`Plan`].
    GroupId
);

/// A minimal set of links and points solved together.
#[derive(Clone, Debug)]
pub struct Group {
    /// The method by which it is solved.
    pub kind: GroupKind,
    /// The point after which it is named: the inner joint of a dyad.
    pub point: Option<PointId>,
    /// The links placed by the group.
    pub links: Vec<LinkId>,
    /// The points placed by the group, including riders and centres of mass.
    pub points: Vec<PointId>,
}

impl Group {
    /// Returns the element after which the group is named: the joint of a dyad, the first joint of
    /// a coupled group, the arm of an RPR.
    #[must_use]
    pub fn name(&self) -> Option<ElementId> {
        let arm = self.links.first().map(|&link| ElementId::Link(link));
        match self.kind {
            GroupKind::Driver => None,
            GroupKind::Rpr => arm,
            _ => self.point.map(ElementId::Point).or(arm),
        }
    }

    /// Returns `true` if the group can have more than one assembly.
    #[must_use]
    pub fn has_choices(&self) -> bool {
        !matches!(
            self.kind,
            GroupKind::Driver | GroupKind::Prp | GroupKind::Rpp
        )
    }
}

/// The groups of a mechanism in the order in which they are solved.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The groups by [`GroupId`], the driver's first.
    pub groups: Vec<Group>,
    /// Degrees of freedom by rank: the number of inputs, for a mechanism that opens.
    pub mobility: usize,
    /// Elements with a redundant constraint that was set aside.
    pub redundant: Vec<ElementId>,
}

impl Plan {
    /// Plans a mechanism, whether or not it can be assembled.
    ///
    /// # Errors
    /// Returns the reason why the structure of the mechanism is impossible: see [`Fault`].
    pub fn of(mechanism: &Mechanism) -> Result<Plan, Fault> {
        let network = Network::new(mechanism, Frame::of(mechanism));
        let ordering = order::ordering(&network, &[])?;
        let dyads = super::chain::Dyads::Closed;
        let (plan, _) = super::chain::build(&network, &ordering, dyads)?;
        Ok(plan)
    }

    /// Returns a group; `None` if the id belongs to another plan.
    #[must_use]
    pub fn group(&self, id: GroupId) -> Option<&Group> {
        self.groups.get(id.index())
    }

    /// Returns the groups with their ids, in solving order.
    pub fn numbered(&self) -> impl Iterator<Item = (GroupId, &Group)> {
        (0..).map(GroupId::new).zip(&self.groups)
    }

    /// Returns the group with choices of this name, if there is one.
    #[must_use]
    pub fn named(&self, name: ElementId) -> Option<GroupId> {
        let mut groups = self.numbered();
        let found = groups.find(|(_, g)| g.has_choices() && g.name() == Some(name));
        found.map(|(id, _)| id)
    }
}

/// A constraint that must hold even if the steps are not built on it.
#[derive(Clone, Debug)]
pub(super) struct WatchedConstraint {
    pub element: ElementId,
    pub gauge: Gauge,
}

/// The equation by which the misfit of a watched constraint is measured.
#[derive(Clone, Debug)]
pub(super) enum Gauge {
    /// The distance of two points.
    Distance {
        from: PointId,
        to: PointId,
        length: Constant,
    },
    /// The direction from one of a link's points to another.
    Direction {
        from: PointId,
        to: PointId,
        link: LinkId,
        /// A unit vector in the link's frame; not finite if the points coincide.
        along: Vec2<Constant>,
    },
    /// A point on a line of a body.
    OnLine {
        point: PointId,
        line: super::elements::GuideLine,
    },
    /// A driven point at the coordinate of its input along a line of a body.
    Pushed {
        point: PointId,
        line: super::elements::GuideLine,
        /// How the input follows the driver; `None` for the driver itself.
        following: Option<Following>,
    },
    /// A link at the coordinate of its input relative to the link that carries its motor.
    Turned {
        link: LinkId,
        from: LinkId,
        /// How the input follows the driver; `None` for the driver itself.
        following: Option<Following>,
    },
}

/// A slide that constrains a joint to a known line.
#[derive(Clone, Copy, Debug)]
pub(super) struct GuideConstraint {
    pub slide: SlideId,
    /// The link between the joint and the slide, if the joint is not the sliding point itself.
    pub carrier: Option<LinkId>,
    /// Whether the guide moves with the joint, over a known point.
    pub is_yoke: bool,
}

/// A link in the chain of an arm that spans several links of one class, from joint to joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The link at the arm's end, which identifies the arm.
    pub arm: LinkId,
    pub link: LinkId,
    pub from: PointId,
    pub to: PointId,
}

impl Program {
    /// Calls `place` for every place from which the program was built, always in the same order,
    /// and updates the values derived from it.
    pub(super) fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        self.points.iter_mut().for_each(&mut *place);
        for step in &mut self.steps {
            step.vary(&mut self.coupled, place);
        }
    }

    /// Calls `change` for the law of every input, wherever the program has a copy of it.
    pub(super) fn change_laws(&mut self, change: &mut impl FnMut(&mut Following)) {
        for step in &mut self.steps {
            step.change_laws(&mut self.coupled, change);
        }
        for watch in &mut self.watches {
            match &mut watch.gauge {
                Gauge::Pushed { following, .. } | Gauge::Turned { following, .. } => {
                    following.iter_mut().for_each(&mut *change);
                }
                Gauge::Distance { .. } | Gauge::Direction { .. } | Gauge::OnLine { .. } => {}
            }
        }
    }
}

/// The program that the solver runs: the steps in order, and their constants.
#[derive(Clone, Debug)]
pub(super) struct Program {
    pub steps: Vec<Step>,
    /// The index of the first step of every group, and the number of steps.
    pub group_starts: Vec<usize>,
    pub coupled: Vec<Coupled>,
    /// The positions of constant points and the directions of constant links. All others are
    /// overwritten.
    pub points: Vec<Vec2<Constant>>,
    pub links: Vec<Vec2<Constant>>,
    pub watches: Vec<WatchedConstraint>,
    /// The guide constraints of steps with a guide, by step index in increasing order.
    pub holds: Vec<(usize, GuideConstraint)>,
    /// The legs of arms that span several links, by step index in increasing order. The last leg of
    /// each arm comes first.
    pub legs: Vec<(usize, Leg)>,
}
