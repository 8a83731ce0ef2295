//! The plan of a mechanism: groups in their order, for people; steps, for the solver.

use super::coupled::Coupled;
use super::elements::Step;
use super::fault::Fault;
use super::following::Following;
use super::frame::Frame;
use super::network::Network;
use crate::mechanism::id;
use crate::{Constant, ElementId, LinkId, Mechanism, PointId, SlideId, Vec2};

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
    /// A coupled group, by Newton.
    Coupled {
        /// The number of unknowns solved for at once.
        unknowns: usize,
    },
}

impl GroupKind {
    /// The class of a dyad by its joints from pivot to pivot: R turns, P slides.
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

    /// How many unknowns a coupled group solves for at once.
    #[must_use]
    pub fn unknowns(self) -> Option<usize> {
        match self {
            GroupKind::Coupled { unknowns } => Some(unknowns),
            _ => None,
        }
    }
}

/// Which of its assemblies a group is to take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pick {
    /// Of a dyad with two links: its joint lies on the left of the line from the pivot of its first
    /// link to that of its second, first as in the mechanism. Of one with a guide: the joint lies
    /// further along the guide than the foot of the link's pivot, or the arm's guide runs from its
    /// pivot towards the pin. Where the dyad is at a change point, it will be so just beyond it, the
    /// driver's coordinate growing.
    Plus,
    /// The other one.
    Minus,
    /// Of a coupled group, counted from 1 in the order of [`super::Solver::choices`].
    Number(usize),
}

id!(
    /// A group of a [`Plan`].
    GroupId
);

/// A smallest set of links and points that is solved at once.
#[derive(Clone, Debug)]
pub struct Group {
    /// How it is solved.
    pub kind: GroupKind,
    /// The point that names it: the inner joint of a dyad.
    pub point: Option<PointId>,
    /// The links that it places.
    pub links: Vec<LinkId>,
    /// The points that it places, riders and centres of mass included.
    pub points: Vec<PointId>,
}

impl Group {
    /// What names it: the joint of a dyad, the first of a coupled group, the arm of an RPR.
    #[must_use]
    pub fn name(&self) -> Option<ElementId> {
        let arm = self.links.first().map(|&link| ElementId::Link(link));
        match self.kind {
            GroupKind::Driver => None,
            GroupKind::Rpr => arm,
            _ => self.point.map(ElementId::Point).or(arm),
        }
    }

    /// Whether it can have more than one assembly.
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
    /// Degrees of freedom by rank: as many as there are inputs for a mechanism that opens.
    pub mobility: usize,
    /// Elements with a constraint that repeats others and was set aside.
    pub redundant: Vec<ElementId>,
}

impl Plan {
    /// The groups of a mechanism, whether or not it can be assembled.
    ///
    /// # Errors
    /// What makes the mechanism impossible by its structure: see [`Fault`].
    pub fn of(mechanism: &Mechanism) -> Result<Plan, Fault> {
        let network = Network::new(mechanism, Frame::of(mechanism));
        let ordering = super::order::ordering(&network, &[])?;
        let dyads = super::chain::Dyads::Closed;
        let (plan, _) = super::chain::build(&network, &ordering, dyads)?;
        Ok(plan)
    }

    /// One group; `None` where the id is that of another plan.
    #[must_use]
    pub fn group(&self, id: GroupId) -> Option<&Group> {
        self.groups.get(id.index())
    }

    /// The groups with their ids, in the order in which they are solved.
    pub fn numbered(&self) -> impl Iterator<Item = (GroupId, &Group)> {
        (0..).map(GroupId::new).zip(&self.groups)
    }

    /// The group of a name, if there is one with choices.
    #[must_use]
    pub fn named(&self, name: ElementId) -> Option<GroupId> {
        let mut groups = self.numbered();
        let found = groups.find(|(_, g)| g.has_choices() && g.name() == Some(name));
        found.map(|(id, _)| id)
    }
}

/// A constraint that must hold whether or not the steps are built on it.
#[derive(Clone, Debug)]
pub(super) struct WatchedConstraint {
    pub element: ElementId,
    pub gauge: Gauge,
}

/// How far a watched constraint is from holding.
#[derive(Clone, Debug)]
pub(super) enum Gauge {
    /// The distance of two points.
    Distance {
        from: PointId,
        to: PointId,
        length: Constant,
    },
    /// The direction in which a link sees one of its points from another.
    Direction {
        from: PointId,
        to: PointId,
        link: LinkId,
        /// A unit vector in the link's frame; not finite where the points are one.
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
        /// How the input follows the driver; none where it is the driver.
        following: Option<Following>,
    },
    /// A link at the coordinate of its input from the one that its motor sits on.
    Turned {
        link: LinkId,
        from: LinkId,
        /// How the input follows the driver; none where it is the driver.
        following: Option<Following>,
    },
}

/// A slide that holds a joint on a known line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hold {
    pub slide: SlideId,
    /// The link between the joint and the slide, if the joint is not the sliding point itself.
    pub carrier: Option<LinkId>,
    /// Whether it is the guide that moves with the joint, over a point that is known.
    pub is_yoke: bool,
}

/// A link on the way of an arm that spans several links of one class: from joint to joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    /// The link at the arm's end, by which the arm is known.
    pub arm: LinkId,
    pub link: LinkId,
    pub from: PointId,
    pub to: PointId,
}

impl Program {
    /// Hands out every place that it was made of, always in the same order, and follows what becomes of them.
    pub(super) fn vary(&mut self, place: &mut impl FnMut(&mut Vec2<Constant>)) {
        self.points.iter_mut().for_each(&mut *place);
        for step in &mut self.steps {
            step.vary(&mut self.coupled, place);
        }
    }
}

/// What the solver runs: the steps in order, and what they start from.
#[derive(Clone, Debug)]
pub(super) struct Program {
    pub steps: Vec<Step>,
    /// The first step of every group, and the end.
    pub group_starts: Vec<usize>,
    pub coupled: Vec<Coupled>,
    /// The places of constant points and the directions of constant links; all others are overwritten.
    pub points: Vec<Vec2<Constant>>,
    pub links: Vec<Vec2<Constant>>,
    pub watches: Vec<WatchedConstraint>,
    /// By their places among the steps, in order: through what those with a guide hold their joint.
    pub holds: Vec<(usize, Hold)>,
    /// Likewise: the links of their arms, the last one of each arm first, where these are several.
    pub legs: Vec<(usize, Leg)>,
}
