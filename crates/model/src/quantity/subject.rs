//! Identifies solver quantities by subject and aspect.

use crate::expression::{Dimension, Kind, Revolution};
use crate::scene::VectorKind;
use crate::solver::Order;
use crate::{Input, LinkId, PointId, SlideId};

/// The element or pair of elements that a quantity describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    /// The driver.
    Driver,
    /// A point.
    Point(PointId),
    /// A link: its direction and rotation.
    Link(LinkId),
    /// A slide, as a vector from the sliding point back to `through`.
    Slide(SlideId),
    /// The vector from one point to another.
    Between(PointId, PointId),
    /// The driver's effort, or a share of it.
    Drive(Share),
    /// The force on a link at a joint.
    Joint(LinkId, PointId),
    /// The force and moment of the whole mechanism on the frame.
    Frame,
    /// The residual of the frame's force and moment in the equilibrium of the whole.
    FrameResidual,
}

/// A share of the driver's effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Share {
    /// The total effort.
    Total,
    /// The effort against loads and springs.
    Load,
    /// The effort against weights.
    Gravity,
    /// The effort against inertia.
    Inertia,
    /// The residual of the virtual work of all loads.
    Residual,
}

impl Share {
    /// The shares that follow the total, in the order of columns.
    pub(super) const PARTS: [Share; 4] =
        [Share::Load, Share::Gravity, Share::Inertia, Share::Residual];

    /// Returns the last part of the column name, following that of the quantity.
    pub(super) fn name(self) -> Option<&'static str> {
        match self {
            Share::Total => None,
            Share::Load => Some("load"),
            Share::Gravity => Some("gravity"),
            Share::Inertia => Some("inertia"),
            Share::Residual => Some("residual"),
        }
    }
}

impl From<VectorKind> for Subject {
    fn from(kind: VectorKind) -> Self {
        match kind {
            VectorKind::Link(link) => Subject::Link(link),
            VectorKind::Slide(slide) => Subject::Slide(slide),
            VectorKind::Between(tail, head) => Subject::Between(tail, head),
        }
    }
}

/// The aspect of a subject that a quantity measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aspect {
    /// Position along x.
    X,
    /// Position along y.
    Y,
    /// Velocity along x.
    Vx,
    /// Velocity along y.
    Vy,
    /// Acceleration along x.
    Ax,
    /// Acceleration along y.
    Ay,
    /// Direction in degrees, in [0, 360); the driver's is not wrapped.
    Angle,
    /// Angular velocity in rad/s.
    Omega,
    /// Angular acceleration in rad/s^2.
    Alpha,
    /// Length; for a slide the signed position along the guide.
    Length,
    /// First time derivative of the length.
    Rate,
    /// Second time derivative of the length.
    Accel,
    /// Torque of a turning driver, in N m, counter-clockwise.
    Torque,
    /// Force of a pushing driver, in N, along its guide.
    Force,
    /// Power in W.
    Power,
    /// Force along x in N.
    Fx,
    /// Force along y in N.
    Fy,
    /// Force of a guide on the slider, in N, along the guide's direction turned by +90 degrees.
    Normal,
    /// Moment in N m, counter-clockwise: of a guide on a link without rotation about the link's
    /// origin; of the whole on the frame about the scene's origin.
    Moment,
}

impl Aspect {
    /// Returns the effort of an input: a torque, or a force along a guide.
    #[must_use]
    pub fn effort_of(input: Input) -> Aspect {
        match input {
            Input::Turn(_) => Aspect::Torque,
            Input::Push(_) => Aspect::Force,
        }
    }

    pub(super) const POINT: [Aspect; 6] = [
        Aspect::X,
        Aspect::Y,
        Aspect::Vx,
        Aspect::Vy,
        Aspect::Ax,
        Aspect::Ay,
    ];
    /// The aspects of a rotating element, by [`Order`].
    pub const TURNING: [Aspect; 3] = [Aspect::Angle, Aspect::Omega, Aspect::Alpha];
    /// The aspects of a joint.
    pub(super) const JOINT: [Aspect; 2] = [Aspect::Fx, Aspect::Fy];
    /// The aspects of the frame.
    pub(super) const FRAME: [Aspect; 3] = [Aspect::Fx, Aspect::Fy, Aspect::Moment];
    /// The aspects of an element of variable length, by [`Order`].
    pub const STRETCHING: [Aspect; 3] = [Aspect::Length, Aspect::Rate, Aspect::Accel];
    /// The aspects that are derivatives of one another, by [`Order`].
    const DERIVATIVES: [[Aspect; 3]; 4] = [
        [Aspect::X, Aspect::Vx, Aspect::Ax],
        [Aspect::Y, Aspect::Vy, Aspect::Ay],
        Aspect::TURNING,
        Aspect::STRETCHING,
    ];

    /// Returns the part of the column name behind the dot.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Aspect::X => "x",
            Aspect::Y => "y",
            Aspect::Vx => "vx",
            Aspect::Vy => "vy",
            Aspect::Ax => "ax",
            Aspect::Ay => "ay",
            Aspect::Angle => "angle",
            Aspect::Omega => "omega",
            Aspect::Alpha => "alpha",
            Aspect::Length => "length",
            Aspect::Rate => "rate",
            Aspect::Accel => "accel",
            Aspect::Torque => "torque",
            Aspect::Force => "force",
            Aspect::Power => "power",
            Aspect::Fx => "fx",
            Aspect::Fy => "fy",
            Aspect::Normal => "normal",
            Aspect::Moment => "moment",
        }
    }

    /// Returns the order to which a state must be solved for it.
    #[must_use]
    pub fn order(self) -> Order {
        match self.place_in_derivatives() {
            Some((_, 0)) => Order::Position,
            Some((_, 1)) => Order::Velocity,
            Some(_) => Order::Acceleration,
            None => Order::Force,
        }
    }

    /// Returns the time derivative, if a state has it.
    pub(super) fn rate(self) -> Option<Aspect> {
        let (derivatives, order) = self.place_in_derivatives()?;
        derivatives.get(order + 1).copied()
    }

    /// Returns its list of derivatives and its place there; `None` for forces.
    fn place_in_derivatives(self) -> Option<([Aspect; 3], usize)> {
        Aspect::DERIVATIVES.into_iter().find_map(|list| {
            let order = list.iter().position(|own| *own == self)?;
            Some((list, order))
        })
    }

    /// Returns the dimension.
    pub(super) fn dimension(self) -> Dimension {
        let rate = |times: usize, of: Dimension| (0..times).fold(of, |of, _| of.rate());
        match self {
            Aspect::Angle => Dimension::DEGREES,
            Aspect::Omega => rate(1, Dimension::DEGREES),
            Aspect::Alpha => rate(2, Dimension::DEGREES),
            Aspect::X | Aspect::Y | Aspect::Length => Dimension::LENGTH,
            Aspect::Vx | Aspect::Vy | Aspect::Rate => rate(1, Dimension::LENGTH),
            Aspect::Ax | Aspect::Ay | Aspect::Accel => rate(2, Dimension::LENGTH),
            Aspect::Torque | Aspect::Moment => Dimension::MOMENT,
            Aspect::Force | Aspect::Fx | Aspect::Fy | Aspect::Normal => Dimension::FORCE,
            Aspect::Power => rate(1, Dimension::MOMENT),
        }
    }

    /// Returns the kind in a formula.
    pub(super) fn kind(self, subject: Subject) -> Kind {
        match (self, subject) {
            // The driver's angle counts turns.
            (Aspect::Angle, Subject::Driver) => Kind::direction(Revolution::Counted),
            (Aspect::Angle, _) => Kind::direction(Revolution::Wrapped),
            _ => Kind::plain(self.dimension()),
        }
    }

    /// Returns the unit, in a scene with the length unit `length`.
    #[must_use]
    pub fn unit(self, length: &str) -> String {
        self.dimension().symbol(length)
    }
}
