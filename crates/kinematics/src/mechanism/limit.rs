//! Limits: coordinates of a mechanism that stay between two stops.

use super::{Body, Input, LinkId, SlideId, id};
use crate::angle::TURN;

id!(
    /// A limit: a coordinate with a stop at each end.
    LimitId
);

/// Turns that a driver may be held to, as a motion that comes round is told turn by turn.
pub const MOST_TURNS: f64 = 1000.0;

/// The coordinate that a limit holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitOf {
    /// The driver's own.
    Driver,
    /// The position along a slide: the stroke of a cylinder, the length of a slot.
    Slide(SlideId),
    /// The angle of a link as seen from a body.
    Angle {
        /// The link.
        link: LinkId,
        /// From where it is seen.
        from: Body,
    },
    /// The driver's own, by the ends of the table of this input.
    Table(Input),
}

/// A coordinate that stays between two stops: the motion ends where it meets one.
///
/// Positions are in the scene's length unit, angles in degrees. An angle is followed along the motion from
/// where the scene opens, at the turn at which it lies between the two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// What is held.
    pub of: LimitOf,
    /// Its least value.
    pub low: f64,
    /// Its greatest value.
    pub high: f64,
}

impl Limit {
    /// The ends are finite and in order; those of an angle are less than a turn apart, or going round would come to
    /// the other side of a stop. A driver may turn more often.
    pub(super) fn is_sound(&self, input: Option<Input>) -> bool {
        let (fits, widest) = match self.of {
            LimitOf::Driver if matches!(input, Some(Input::Turn(_))) => (true, MOST_TURNS * TURN),
            LimitOf::Driver | LimitOf::Slide(_) | LimitOf::Table(_) => (true, f64::INFINITY),
            LimitOf::Angle { link, from } => (from != Body::Link(link), TURN),
        };
        let are_finite = self.low.is_finite() && self.high.is_finite();
        fits && are_finite && self.low < self.high && self.high - self.low < widest
    }
}
