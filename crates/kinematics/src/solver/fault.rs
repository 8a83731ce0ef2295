use crate::{ElementId, LimitId, LinkId, PointId, Vec2};
use thiserror::Error;

/// The reason why a mechanism as a whole cannot be solved. Carries ids; a scene knows the lines.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Fault {
    /// Mobility other than one.
    #[error("the mobility is {mobility}, not 1")]
    Mobility {
        /// Degrees of freedom, the driver's included.
        mobility: usize,
        /// Constraints that repeat others.
        redundant: usize,
        /// The elements of these constraints, and those that they repeat.
        repeating: Vec<ElementId>,
        /// Links that the driver does not determine.
        floating: Vec<LinkId>,
        /// Whether rounding hides the free motion: a slightly different mechanism may not have it.
        is_unclear: bool,
    },
    /// Redundant constraints that contradict each other (an immobile structure).
    #[error("over-constrained: the parts do not fit by {misfit:e}")]
    OverConstrained {
        /// The redundant element that does not fit.
        element: ElementId,
        /// The elements that it repeats at the start, if known: any of these may be the wrong one.
        others: Vec<ElementId>,
        /// The misfit, in the scene's length unit. For slides that fix one link at two angles, it
        /// is measured at the end of the longest length.
        misfit: f64,
        /// The driver's coordinate of the misfit.
        at: f64,
    },
    /// A group that cannot be closed at the start.
    #[error("the loop cannot close at the start, by {gap:e}")]
    Open {
        /// The joint that cannot be placed.
        point: PointId,
        /// The links that should meet there.
        links: Vec<LinkId>,
        /// The remaining gap, in the scene's length unit.
        gap: f64,
    },
    /// A start that does not choose between the assemblies of a group.
    #[error("the start does not say which assembly is meant")]
    Vague {
        /// The joint whose position would decide.
        point: PointId,
        /// The possible positions of the joint.
        choices: Vec<Vec2>,
        /// The further open choices: the groups after it, each with the first choices of all groups
        /// before it.
        behind: Vec<OpenChoice>,
    },
    /// An opening exactly where two assemblies of a dyad meet and the motion passes through, or so
    /// close to such a point of a coupled group that its positions have too few digits. They cannot
    /// determine the branch on which the motion continues.
    #[error("the start is a change point, where two motions continue")]
    ChangePoint {
        /// The element after which the group is named.
        group: ElementId,
        /// Whether the group is a dyad, of which a side can be chosen.
        has_sides: bool,
    },
    /// A further input that moves so much faster than the driver that it cannot be followed.
    #[error("input {number} moves too fast to be followed")]
    FastInput {
        /// The number of the input, from 1 in the order of the scene.
        number: usize,
    },
    /// An assembly that opens beyond a stop.
    #[error("it opens beyond a stop, at {value}")]
    BeyondStop {
        /// The limit beyond which it lies.
        limit: LimitId,
        /// The value of its coordinate, in degrees or the scene's length unit.
        value: f64,
    },
    /// Two stops that lock the mechanism where the scene opens: one blocks the motion downwards,
    /// the other upwards.
    #[error("two stops hold it where it opens")]
    HeldByStops {
        /// The limit that ends the motion downwards.
        down: LimitId,
        /// The limit that ends the motion upwards.
        up: LimitId,
    },
    /// A pick that its group does not have.
    #[error("the group has no such assembly, but {found}")]
    NoChoice {
        /// The element after which the group is named.
        group: ElementId,
        /// The number of assemblies that it has here; 0 if there is no group of that name with
        /// choices.
        found: usize,
    },
    /// A coupled group for which no assembly was found near the start.
    #[error("no assembly was found near the start")]
    NotAssembled {
        /// Points of the group for which start positions would help.
        points: Vec<PointId>,
        /// The smallest misfit reached, in the scene's length unit.
        gap: f64,
    },
    /// Constraints that do not determine a position, such as parallel guides.
    #[error("the group is singular")]
    Singular {
        /// The elements of the group.
        elements: Vec<ElementId>,
        /// `true` if the group is singular only at the initial position: at a change point or a
        /// dead point.
        is_here_only: bool,
    },
}

/// A group with several assemblies between which the start does not choose.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenChoice {
    /// The joint whose position would decide.
    pub point: PointId,
    /// The possible positions of the joint, in the scene's unit.
    pub choices: Vec<Vec2>,
}

impl Fault {
    /// Creates the fault of a group with an open choice, without the groups after it.
    pub(super) fn vague(point: PointId, choices: Vec<Vec2>) -> Fault {
        let after = Vec::new();
        Fault::Vague {
            point,
            choices,
            behind: after,
        }
    }
}
