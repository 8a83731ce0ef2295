//! The plan of a mechanism: groups in their order, for people; steps, for the solver.

use super::coupled::Coupled;
use super::step::Step;
use crate::{Constant, Element, LinkId, PointId, Vec2};

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

/// The groups of a mechanism in the order in which they are solved.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The groups, the driver's first.
    pub groups: Vec<Group>,
    /// Degrees of freedom by rank: 1 for a mechanism that opens.
    pub mobility: usize,
    /// Elements with a constraint that repeats others and was set aside.
    pub redundant: Vec<Element>,
}

/// A constraint that must hold whether or not the steps are built on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Watch {
    pub element: Element,
    pub gauge: Gauge,
}

/// How far a watched constraint is from holding.
#[derive(Clone, Copy, Debug)]
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
        line: super::step::Line,
    },
    /// A driven point at the driver's coordinate along a line of a body.
    Pushed {
        point: PointId,
        line: super::step::Line,
    },
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
    pub watches: Vec<Watch>,
}
