//! Shapes of a drawing in world units, independent of cells and glyphs.

use crate::Vec2;
use std::sync::Arc;

/// The kind of part that a shape or a cell shows; colours are chosen by it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Role {
    /// An empty cell.
    #[default]
    Empty,
    /// The frame: supports and their hatching.
    Ground,
    /// A guide on the ground.
    Guide,
    /// A moving link, with the number of its hue, below [`LINK_HUES`].
    Link(u8),
    /// The plate of a link of three or more joints, inside its edges.
    Plate(u8),
    /// The driven link, or the driving cylinder.
    Driver,
    /// The inside of the driven link or the driving cylinder.
    DriverPlate,
    /// A point where the driver acts: a pin that it turns, or the point that it pushes.
    DriverPin,
    /// A joint between moving links.
    Joint,
    /// A joint on the ground.
    GroundPin,
    /// A block that slides along a guide.
    Slider,
    /// A coupler point: a point of a link that is not a joint.
    Rider,
    /// A centre of mass.
    CentreOfMass,
    /// Another possible position of the linkage.
    Ghost,
    /// The linkage at another place of its motion.
    Echo,
    /// The path of a point over the whole motion.
    Trace,
    /// The part of a path that its point has just left behind.
    Trail,
    /// A spring.
    Spring,
    /// An arrow of velocity.
    Velocity,
    /// An arrow of acceleration.
    Acceleration,
    /// A force or a moment, and its size.
    Force,
    /// A part selected elsewhere: in a list, in a table.
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

/// Number of link hues that are distinguishable at a glance from each other and from the driver's
/// hue.
pub const LINK_HUES: u8 = 5;

impl Role {
    /// Returns the role of the name of a part with this role. Letters need more contrast than bars.
    #[must_use]
    pub fn of_name(self) -> Role {
        match self {
            Role::Link(hue) => Role::LinkName(hue),
            other => other,
        }
    }

    /// Returns `true` for a moving part of the linkage, which is drawn as wide as the window
    /// allows.
    pub(super) fn is_body(self) -> bool {
        matches!(self, Role::Link(_) | Role::Driver | Role::Lit)
    }

    /// Returns `true` for the mark of a point of the linkage.
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

    /// Returns `true` for parts that lie behind the linkage.
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
                | Role::Trail
                | Role::Spring
        )
    }

    /// Returns the role of the area between the edges of a part; `None` except for links and the
    /// driver.
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
        /// The first end.
        from: Vec2,
        /// The other end.
        to: Vec2,
        /// The part's role.
        role: Role,
    },
    /// A closed outline.
    Outline {
        /// The corners in order.
        corners: Vec<Vec2>,
        /// The part's role.
        role: Role,
    },
    /// The inside of an outline: a link's plate.
    Plate {
        /// The corners in order.
        corners: Vec<Vec2>,
        /// The part's role.
        role: Role,
    },
    /// A spring.
    Spring {
        /// The first end.
        from: Vec2,
        /// The other end.
        to: Vec2,
    },
    /// A body wider than a line: the barrel of a cylinder.
    Barrel {
        /// The middle of the first end.
        from: Vec2,
        /// The middle of the other end.
        to: Vec2,
        /// The part's role.
        role: Role,
    },
    /// A cylinder's rod, thinner than its barrel.
    Rod {
        /// The end in the barrel's mouth.
        from: Vec2,
        /// The end outside.
        to: Vec2,
        /// The part's role.
        role: Role,
    },
    /// A small mark: a joint, a coupler point, a centre of mass.
    Mark {
        /// The point.
        at: Vec2,
        /// The part's role, which determines the glyph.
        role: Role,
    },
    /// The support under a ground pin, with its hatching.
    Support {
        /// The pin.
        at: Vec2,
    },
    /// A guide fixed to the ground: two rails along the path of its block if the window is large
    /// enough, or else one line.
    Guide {
        /// The first end.
        from: Vec2,
        /// The other end.
        to: Vec2,
        /// [`Role::Guide`] or [`Role::Lit`].
        role: Role,
    },
    /// Hatching along a ground guide, to the right of its direction.
    Hatching {
        /// The guide's first end.
        from: Vec2,
        /// The guide's other end.
        to: Vec2,
    },
    /// A sliding block, without the mark of its pin.
    Block {
        /// The middle.
        at: Vec2,
        /// The direction of its guide.
        along: Vec2,
    },
    /// The path of a point: a chain of straight lines, short enough to look like a curve.
    Trace {
        /// The corners; one that is not finite is a gap. Shared, because every frame has the same
        /// path.
        course: Arc<[Vec2]>,
        /// [`Role::Trace`], or [`Role::Trail`] for a part of a path.
        role: Role,
    },
    /// An arrow from a point.
    Arrow {
        /// The tail.
        from: Vec2,
        /// The tip.
        to: Vec2,
        /// [`Role::Velocity`], [`Role::Acceleration`] with two heads, or [`Role::Force`] with a
        /// closed head.
        role: Role,
        /// `true` if the arrow is shorter than its vector to scale; its shaft is then broken.
        cut: bool,
    },
    /// A moment about a point: an arrow around it.
    Moment {
        /// The point.
        at: Vec2,
        /// `true` if the moment is counter-clockwise.
        is_left: bool,
    },
    /// A name next to a point.
    Label {
        /// The point.
        at: Vec2,
        /// The name.
        text: String,
        /// The role of the named part.
        role: Role,
    },
}

impl Shape {
    fn is_finite(&self) -> bool {
        match self {
            Shape::Line { from, to, .. }
            | Shape::Barrel { from, to, .. }
            | Shape::Rod { from, to, .. }
            | Shape::Guide { from, to, .. }
            | Shape::Hatching { from, to }
            | Shape::Spring { from, to }
            | Shape::Arrow { from, to, .. } => from.is_finite() && to.is_finite(),
            // A point that is not finite is a gap in the trace.
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

/// Shapes in world units; all are finite, except for the gaps of traces.
///
/// If two shapes have the same kind, the later one lies on top. The renderer orders the kinds:
/// ghosts and traces below, then the ground, guides, plates, links, the driver, highlighted parts,
/// arrows, marks, and names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    shapes: Vec<Shape>,
}

impl Figure {
    /// Creates an empty figure.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a shape; one that is not finite is ignored.
    pub fn add(&mut self, shape: Shape) {
        if shape.is_finite() {
            self.shapes.push(shape);
        }
    }

    /// Removes all names except the selected one.
    #[cfg(feature = "tui")]
    pub(crate) fn remove_names(&mut self) {
        let is_name = |shape: &Shape| match shape {
            Shape::Label { role, .. } => *role != Role::Lit,
            _ => false,
        };
        self.shapes.retain(|shape| !is_name(shape));
    }

    /// Returns the shapes in the order in which they were added.
    #[must_use]
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }
}
