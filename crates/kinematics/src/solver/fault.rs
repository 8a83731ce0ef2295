use crate::{ElementId, LimitId, LinkId, PointId, Vec2};
use thiserror::Error;

/// Why a mechanism as a whole cannot be solved. Carries ids; a scene knows the lines.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Fault {
    /// Mobility other than one.
    #[error("the mobility is {mobility}, not 1")]
    Mobility {
        /// Degrees of freedom, the driver's included.
        mobility: usize,
        /// Constraints that repeat others.
        redundant: usize,
        /// What these belong to, and what they repeat.
        repeating: Vec<ElementId>,
        /// Links that the driver does not determine.
        floating: Vec<LinkId>,
        /// Whether rounding hides what is free: a mechanism next to this one may have none.
        is_unclear: bool,
    },
    /// More constraints than the motion allows, and they do not agree (an immobile structure).
    #[error("over-constrained: the parts do not fit by {misfit:e}")]
    OverConstrained {
        /// The element set aside as redundant that does not fit.
        element: ElementId,
        /// What it repeats at the start, where that can be told: any of these may be the wrong one.
        others: Vec<ElementId>,
        /// By how much, in the scene's length unit; of slides that hold one link at two angles, at the
        /// end of the longest length.
        misfit: f64,
        /// At which coordinate of the driver.
        at: f64,
    },
    /// A group that cannot be closed at the start.
    #[error("the loop cannot close at the start, by {gap:e}")]
    Open {
        /// The joint that cannot be placed.
        point: PointId,
        /// The links that ought to meet there.
        links: Vec<LinkId>,
        /// The distance that is missing, in the scene's length unit.
        gap: f64,
    },
    /// The start does not choose between the assemblies of a group.
    #[error("the start does not say which assembly is meant")]
    Vague {
        /// The joint whose position would decide.
        point: PointId,
        /// Where it can be.
        choices: Vec<Vec2>,
        /// What else is open then: the groups that are solved after it, each with all before it at their first
        /// choices.
        behind: Vec<OpenChoice>,
    },
    /// The scene opens exactly where two assemblies of a dyad meet and the motion passes: no position
    /// tells which way it goes on.
    #[error("the start is a change point, where two ways lead on")]
    ChangePoint {
        /// What names the dyad.
        group: ElementId,
    },
    /// The mechanism is assembled beyond a stop where the scene opens.
    #[error("it opens beyond a stop, at {value}")]
    BeyondStop {
        /// The limit that is passed.
        limit: LimitId,
        /// The value of its coordinate there, in degrees or the scene's length unit.
        value: f64,
    },
    /// Two stops that hold the mechanism where the scene opens: the one allows no way down, the other none up.
    #[error("two stops hold it where it opens")]
    HeldByStops {
        /// The limit that ends the way down.
        down: LimitId,
        /// The limit that ends the way up.
        up: LimitId,
    },
    /// A pick that its group does not have.
    #[error("the group has no such assembly, but {found}")]
    NoChoice {
        /// What names the group.
        group: ElementId,
        /// How many assemblies it has here; 0 where nothing of that name has any choice.
        found: usize,
    },
    /// A coupled group for which no assembly was found near the start.
    #[error("no assembly was found near the start")]
    NotAssembled {
        /// Points of the group whose start positions would help.
        points: Vec<PointId>,
        /// The smallest misfit reached, in the scene's length unit.
        gap: f64,
    },
    /// Constraints that determine no position: parallel guides, mostly.
    #[error("the group is singular")]
    Singular {
        /// The elements of the group.
        elements: Vec<ElementId>,
        /// Whether it is so only where the scene opens: at a change point or a dead point.
        is_here_only: bool,
    },
}

/// A group that can be assembled in several ways, of which the start says none.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenChoice {
    /// The joint whose position would decide.
    pub point: PointId,
    /// Where it can be, in the scene's unit.
    pub choices: Vec<Vec2>,
}

impl Fault {
    /// A group that is open, whatever is open behind it.
    pub(super) fn vague(point: PointId, choices: Vec<Vec2>) -> Fault {
        let behind = Vec::new();
        Fault::Vague {
            point,
            choices,
            behind,
        }
    }
}
