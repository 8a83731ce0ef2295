//! Defines limits: coordinates of a mechanism bounded by two stops.

use super::{Body, Input, LinkId, SlideId, id};
use crate::angle::TURN;

id!(
    /// The id of a limit: a coordinate with a stop at each end.
    LimitId
);

/// Maximum number of turns to which a driver may be limited, because reports list a repeating
/// motion turn by turn.
pub const MAX_TURNS: f64 = 1000.0;

/// The coordinate that a limit bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitOf {
    /// The driver's coordinate.
    Driver,
    /// The position along a slide: the stroke of a cylinder, the length of a slot.
    Slide(SlideId),
    /// The angle of a link relative to a body.
    Angle {
        /// The link.
        link: LinkId,
        /// The body from which the angle is measured.
        from: Body,
    },
    /// The driver's coordinate, bounded by the ends of this input's table.
    Table(Input),
}

impl LimitOf {
    /// Returns `true` for the coordinate of a link or a slide, which is limited whatever drives it.
    #[must_use]
    pub fn is_of_element(self) -> bool {
        match self {
            LimitOf::Slide(_) | LimitOf::Angle { .. } => true,
            LimitOf::Driver | LimitOf::Table(_) => false,
        }
    }
}

/// A coordinate bounded by two stops: the motion ends where it meets one.
///
/// Positions are in the scene's length unit, angles in degrees. An angle is tracked along the
/// motion from the start position, on the turn where it lies between the stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The bounded coordinate.
    pub of: LimitOf,
    /// The minimum of the coordinate.
    pub low: f64,
    /// The maximum of the coordinate.
    pub high: f64,
}

impl Limit {
    /// Checks that the ends are finite and in order. An angle's ends must be less than a turn
    /// apart, or a full turn would reach the other side of a stop. A driver may turn up to
    /// `MAX_TURNS`.
    pub(super) fn is_valid(&self, input: Option<Input>) -> bool {
        let (fits, widest) = match self.of {
            LimitOf::Driver if matches!(input, Some(Input::Turn(_))) => (true, MAX_TURNS * TURN),
            LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Table(_) => (true, f64::INFINITY),
            LimitOf::Angle { link, from } => (from != Body::Link(link), TURN),
        };
        let are_finite = self.low.is_finite() && self.high.is_finite();
        fits && are_finite && self.low < self.high && self.high - self.low < widest
    }
}
