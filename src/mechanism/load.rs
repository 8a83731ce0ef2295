//! What acts on a mechanism besides gravity and inertia: loads, springs and presses.

use super::{Body, LinkId, PointId, SlideId};
use crate::Vec2;

/// A value over a coordinate: straight lines between knots, constant beyond the ends.
///
/// Without knots it is 1 everywhere: a factor that changes nothing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Profile {
    knots: Vec<[f64; 2]>,
}

impl Profile {
    /// Through these knots, each a coordinate and its value; `None` unless the coordinates grow from
    /// knot to knot and all numbers are finite.
    #[must_use]
    pub fn new(knots: Vec<[f64; 2]>) -> Option<Profile> {
        let grows = knots.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        let finite = knots.iter().flatten().all(|v| v.is_finite());
        (grows && finite).then_some(Profile { knots })
    }

    /// The knots, each a coordinate and its value.
    #[must_use]
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// Whether it is 1 everywhere.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.knots.is_empty()
    }
}

/// An end of a slide's travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StrokeEnd {
    /// Where the position along the guide is least.
    Least,
    /// Where it is greatest.
    Greatest,
}

/// Something that acts on the mechanism. Friction is not modelled.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Load {
    /// A force at a point.
    Force {
        /// Where it acts. At a pin joint it acts on the pin.
        point: PointId,
        /// Its components in N, in the frame of `frame`.
        force: Vec2,
        /// The ground, or the link with which the force turns.
        frame: Body,
        /// The factor over the driver's coordinate (deg, not wrapped, or the length unit). Where the
        /// knots of a turned driver span whole turns, it repeats.
        over: Profile,
    },
    /// A torque on a link.
    Torque {
        /// The loaded link.
        link: LinkId,
        /// Its size in N m, counter-clockwise.
        torque: f64,
        /// The factor over the driver's coordinate, as of a force.
        over: Profile,
    },
    /// What a press does before the end of its stroke: a force on what slides, against it along the guide,
    /// while it moves towards that end. None on the way back; a driver of no speed is taken for one that
    /// goes forward.
    Press {
        /// The slide that presses, its guide on the ground.
        slide: SlideId,
        /// Which end it works at: bottom dead centre.
        end: StrokeEnd,
        /// The force in N over the distance from that end, in the scene's length unit; nothing
        /// further away than the last knot.
        curve: Profile,
    },
    /// A spring and a damper in parallel between two points.
    Spring {
        /// One end.
        from: PointId,
        /// The other end.
        to: PointId,
        /// In N/m.
        stiffness: f64,
        /// The length without a force, in the scene's length unit.
        length: f64,
        /// In N s/m, of the rate of the distance.
        damping: f64,
    },
}

impl Load {
    /// A force that is constant in the ground's frame.
    #[must_use]
    pub fn force(point: PointId, force: Vec2) -> Load {
        Load::Force {
            point,
            force,
            frame: Body::Ground,
            over: Profile::default(),
        }
    }

    /// A constant torque.
    #[must_use]
    pub fn torque(link: LinkId, torque: f64) -> Load {
        Load::Torque {
            link,
            torque,
            over: Profile::default(),
        }
    }

    /// Whether all its numbers are finite, and those that must be are not negative.
    pub(super) fn is_sound(&self) -> bool {
        match self {
            Load::Force { force, .. } => force.is_finite(),
            Load::Torque { torque, .. } => torque.is_finite(),
            Load::Press { curve, .. } => curve.knots.first().is_some_and(|knot| knot[0] >= 0.0),
            Load::Spring {
                from,
                to,
                stiffness,
                length,
                damping,
            } => {
                let numbers = [stiffness, length, damping];
                from != to && numbers.iter().all(|v| v.is_finite() && **v >= 0.0)
            }
        }
    }
}
