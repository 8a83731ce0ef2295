//! Preferences in the path's frame, as far as a search can take them into account.

use super::linear::LinkagePlace;
use super::shape::{LinkageForm, LinkageShape};
use crate::Preferences;
use kinematics::Vec2;

/// The preferences for a linkage, apart from its path.
#[derive(Clone, Copy, Debug)]
pub(super) struct SearchPreferences {
    full_turn: bool,
    /// The minimum sine of the transmission angle.
    sine: f64,
    /// Two opposite corners of a box for the pivots.
    inside: Option<[Vec2; 2]>,
    /// The maximum ratio of two lengths.
    ratio: f64,
    /// Whether the crank should reach the points in their order.
    pub(super) ordered: bool,
}

impl SearchPreferences {
    /// Converts the preferences; `place` maps a point of the task to the path's frame. The crank of
    /// a closed path turns fully in any case.
    pub(super) fn of(
        preferences: &Preferences,
        closed: bool,
        place: impl Fn(Vec2) -> Vec2,
    ) -> SearchPreferences {
        let transmission = preferences.transmission.unwrap_or(0.0);
        SearchPreferences {
            full_turn: preferences.full_turn && !closed,
            sine: transmission.to_radians().sin(),
            inside: preferences.inside.map(|corners| corners.map(place)),
            ratio: preferences.ratio.unwrap_or(f64::INFINITY),
            ordered: preferences.ordered,
        }
    }

    /// Returns `true` if there is a preference that a search does not meet by itself.
    pub(super) fn has_searched_preference(&self) -> bool {
        self.full_turn || self.sine > 0.0 || self.inside.is_some() || self.ratio.is_finite()
    }

    /// Returns how much a linkage violates the preferences while its crank moves between two
    /// angles, in degrees; 0 if it meets all. Lengths count in sizes of the path, ratios by their
    /// logarithm, angles by their sine.
    pub(super) fn violation(
        &self,
        shape: &LinkageShape,
        place: &LinkagePlace,
        [low, high]: [f64; 2],
    ) -> f64 {
        let (_, sine) = shape.worst_between(low, high);
        let turn = match self.full_turn {
            true => shape.worst_between(0.0, 360.0).0,
            false => 0.0,
        };
        let is_four_bar = shape.form == LinkageForm::FourBar;
        let outside = self.inside.map_or(0.0, |corners| {
            let far = place.origin + place.scale * shape.ground;
            let far = if is_four_bar {
                outside(corners, far)
            } else {
                0.0
            };
            outside(corners, place.origin) + far
        });
        let lengths = match is_four_bar {
            true => [shape.crank, 1.0, shape.far, shape.ground],
            false => [shape.crank, 1.0, 1.0, 1.0],
        };
        let sizes = lengths.map(f64::abs);
        let longest = sizes.iter().copied().fold(0.0, f64::max);
        let shortest = sizes.iter().copied().fold(f64::INFINITY, f64::min);
        let ratio = (longest / (shortest * self.ratio)).ln().max(0.0);
        (self.sine - sine).max(0.0) + turn + outside + ratio
    }
}

/// Returns the distance of a point from the box of two opposite corners; 0 inside it.
fn outside([one, other]: [Vec2; 2], p: Vec2) -> f64 {
    let beyond = |v: f64, a: f64, b: f64| (a.min(b) - v).max(v - a.max(b)).max(0.0);
    beyond(p.x, one.x, other.x).hypot(beyond(p.y, one.y, other.y))
}
