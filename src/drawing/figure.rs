//! What is drawn, in world units: no cells, no glyphs.

use crate::Vec2;
use std::sync::Arc;

/// What a shape, and later a cell, stands for: colours are chosen by it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Role {
    /// Nothing is drawn.
    #[default]
    Empty,
    /// The frame: supports and their hatching.
    Ground,
    /// A guide on the ground.
    Guide,
    /// A moving link, with the number of its hue: below [`LINK_HUES`].
    Link(u8),
    /// The plate of a link of three or more joints, inside its edges.
    Plate(u8),
    /// The driven link, or the cylinder that drives.
    Driver,
    /// The inside of these.
    DriverPlate,
    /// Where the driver acts: the pins that it turns, or what it pushes.
    DriverPin,
    /// A joint between moving links.
    Joint,
    /// A joint on the ground.
    GroundPin,
    /// A block that slides along a guide.
    Slider,
    /// A point that merely rides on a link.
    Rider,
    /// A centre of mass.
    CentreOfMass,
    /// Where the linkage could be as well.
    Ghost,
    /// Where the linkage comes by elsewhere in its motion.
    Echo,
    /// Where a point comes by over the whole motion.
    Trace,
    /// A spring.
    Spring,
    /// An arrow of velocity.
    Velocity,
    /// An arrow of acceleration.
    Acceleration,
    /// A force or a moment, and its size.
    Force,
    /// What is pointed at somewhere else: in a list, in a table.
    Lit,
    /// A name.
    Label,
    /// The name of a moving link, with the number of its hue.
    LinkName(u8),
    /// An axis of a chart and its labels.
    Axis,
    /// A point of a chart, or the first curve of a plot.
    Datum,
    /// The second curve of a plot.
    Second,
    /// The third curve of a plot.
    Third,
    /// A point of a chart's best front, and the steps that join them.
    Front,
}

/// As many hues as can be told apart at a glance, and from the driver's.
pub const LINK_HUES: u8 = 5;

impl Role {
    /// What the name of a part is written as that is drawn as this: letters take more contrast than bars do.
    #[must_use]
    pub fn of_name(self) -> Role {
        match self {
            Role::Link(hue) => Role::LinkName(hue),
            other => other,
        }
    }

    /// Whether it is a moving part of the linkage, which is drawn as wide as the window allows.
    pub(super) fn is_body(self) -> bool {
        matches!(self, Role::Link(_) | Role::Driver | Role::Lit)
    }

    /// Whether it is the mark of a point of the linkage.
    pub(super) fn is_mark(self) -> bool {
        matches!(
            self,
            Role::DriverPin
                | Role::Joint
                | Role::GroundPin
                | Role::Slider
                | Role::Rider
                | Role::CentreOfMass
        )
    }

    /// Whether it lies behind the linkage.
    pub(super) fn is_behind(self) -> bool {
        matches!(
            self,
            Role::Ground
                | Role::Guide
                | Role::Plate(_)
                | Role::DriverPlate
                | Role::Ghost
                | Role::Echo
                | Role::Trace
                | Role::Spring
        )
    }

    /// What lies between the edges of a part that is drawn as this; nothing in what stands behind the linkage.
    pub(super) fn of_plate(self) -> Option<Role> {
        match self {
            Role::Link(hue) => Some(Role::Plate(hue)),
            Role::Driver => Some(Role::DriverPlate),
            _ => None,
        }
    }
}

/// A primitive in world units, y upwards.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A straight line.
    Line {
        /// Where it begins.
        from: Vec2,
        /// Where it ends.
        to: Vec2,
        /// What it stands for.
        role: Role,
    },
    /// A closed outline.
    Outline {
        /// Its corners in order.
        corners: Vec<Vec2>,
        /// What it stands for.
        role: Role,
    },
    /// What lies inside an outline: the plate of a link.
    Plate {
        /// The corners in order.
        corners: Vec<Vec2>,
        /// What it stands for.
        role: Role,
    },
    /// A spring.
    Spring {
        /// Its one end.
        from: Vec2,
        /// Its other end.
        to: Vec2,
    },
    /// A body wider than a line: the barrel of a cylinder.
    Barrel {
        /// The middle of its one end.
        from: Vec2,
        /// The middle of its other end.
        to: Vec2,
        /// What it stands for.
        role: Role,
    },
    /// A small mark: a joint, a rider, a centre of mass.
    Mark {
        /// Where.
        at: Vec2,
        /// What it stands for; the glyph follows from it.
        role: Role,
    },
    /// The support under a ground pin, with its hatching.
    Support {
        /// The pin.
        at: Vec2,
    },
    /// A guide that is fixed in the ground: two rails beside the way of its block where a window has room for them,
    /// else the line of that way.
    Guide {
        /// Where it begins.
        from: Vec2,
        /// Where it ends.
        to: Vec2,
        /// [`Role::Guide`], or [`Role::Lit`].
        role: Role,
    },
    /// Hatching along such a guide, to the right of its direction.
    Hatching {
        /// Where the guide begins.
        from: Vec2,
        /// Where it ends.
        to: Vec2,
    },
    /// A block that slides; a pin in it is a mark of its own.
    Block {
        /// Its middle.
        at: Vec2,
        /// The direction of its guide.
        along: Vec2,
    },
    /// Where a point comes by: a chain of straight lines, short enough to look like a curve.
    Trace {
        /// Its corners; one that is not finite is a gap. Shared, for it is the same in every frame.
        course: Arc<[Vec2]>,
    },
    /// An arrow from a point.
    Arrow {
        /// The point.
        from: Vec2,
        /// The tip.
        to: Vec2,
        /// [`Role::Velocity`], [`Role::Acceleration`] with its two heads, or [`Role::Force`] with its closed one.
        role: Role,
        /// Whether it is shorter than what it stands for; its shaft is then broken.
        cut: bool,
    },
    /// A moment about a place: an arrow around it.
    Moment {
        /// The place.
        at: Vec2,
        /// Whether it turns counter-clockwise.
        is_left: bool,
    },
    /// A name beside a point.
    Label {
        /// The point.
        at: Vec2,
        /// The name.
        text: String,
        /// Whose name it is.
        role: Role,
    },
}

impl Shape {
    fn is_finite(&self) -> bool {
        match self {
            Shape::Line { from, to, .. }
            | Shape::Barrel { from, to, .. }
            | Shape::Guide { from, to, .. }
            | Shape::Hatching { from, to }
            | Shape::Spring { from, to }
            | Shape::Arrow { from, to, .. } => from.is_finite() && to.is_finite(),
            // Gaps are a part of it.
            Shape::Trace { .. } => true,
            Shape::Outline { corners, .. } | Shape::Plate { corners, .. } => {
                corners.iter().all(|c| c.is_finite())
            }
            Shape::Mark { at, .. }
            | Shape::Support { at }
            | Shape::Moment { at, .. }
            | Shape::Label { at, .. } => at.is_finite(),
            Shape::Block { at, along, .. } => at.is_finite() && along.is_finite(),
        }
    }
}

/// Shapes in world units, every one finite but for the gaps of traces.
///
/// Of two shapes of the same kind the later one lies on top; kinds are ordered by the painter:
/// ghosts and traces below, then the ground, guides, plates, links, the driver, what is lit, arrows, marks, and names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    shapes: Vec<Shape>,
}

impl Figure {
    /// A figure of nothing.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a shape. One that is not finite is left out: there is no place to draw it.
    pub fn add(&mut self, shape: Shape) {
        if shape.is_finite() {
            self.shapes.push(shape);
        }
    }

    /// The shapes, in the order in which they were added.
    #[must_use]
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }
}
