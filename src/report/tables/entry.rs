//! Values of the tables with their proved error bounds: single ones, and plane vectors.

use crate::{Vec2, angle};
use std::f64::consts::FRAC_PI_2;

/// One value of a vector's column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// The value; `None` if it does not exist.
    pub value: Option<f64>,
    /// Whether the scene gives it; if not, it was computed.
    pub given: bool,
    /// The error bound in its own unit; `None` if nothing was proved. Given values are taken as
    /// exact.
    pub bound: Option<f64>,
}

impl Entry {
    /// A missing value.
    pub(crate) const NONE: Entry = Entry {
        value: None,
        given: false,
        bound: None,
    };

    /// Creates a value given by the scene.
    pub(in crate::report) const fn given(value: f64) -> Entry {
        Entry {
            value: Some(value),
            given: true,
            bound: Some(0.0),
        }
    }

    /// Returns the bound; `None` if the value does not exist, or if nothing was proved.
    pub(in crate::report) fn proved(&self) -> Option<f64> {
        self.value.and(self.bound)
    }

    /// Returns the value for display: zero if it is small and within its error bound.
    #[must_use]
    pub fn display_value(&self) -> Option<f64> {
        self.value.map(|value| display_value(value, self.bound))
    }

    /// Returns the error bound for display: if a value is shown as zero, it includes the hidden
    /// value.
    #[must_use]
    pub fn display_bound(&self) -> Option<f64> {
        display_bound(self.value?, self.bound)
    }
}

/// Larger values are shown even if the bound does not distinguish them from zero. Near a change
/// point bounds are wide although the values are good: a zero would be the only visible error.
pub(in crate::report) const NOISE: f64 = 1e-6;
/// Without a bound, only values up to this size are shown as zero.
const NOTHING: f64 = 1e-15;

/// Returns a value for display: zero if it is small and within its error bound.
pub(in crate::report) fn display_value(value: f64, bound: Option<f64>) -> f64 {
    let zero = value.abs() <= bound.map_or(NOTHING, |bound| bound.min(NOISE));
    if zero { 0.0 } else { value }
}

/// Returns the error bound of a value for display; `None` if nothing was proved.
pub(in crate::report) fn display_bound(value: f64, bound: Option<f64>) -> Option<f64> {
    let hidden = (value - display_value(value, bound)).abs();
    bound.map(|bound| match hidden {
        0.0 => bound,
        hidden => (bound + hidden).next_up(),
    })
}

/// A plane vector in the ground frame, by components and by magnitude and direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneVector {
    /// The components, in the scene's unit (per s, per s^2), or in N.
    pub components: Vec2,
    /// The magnitude.
    pub magnitude: f64,
    /// The direction in degrees from 0 to below 360; `None` for the null vector.
    pub direction: Option<f64>,
    /// The error bounds of x, y, magnitude and direction; `None` if nothing was proved.
    pub bounds: [Option<f64>; 4],
}

impl PlaneVector {
    pub(in crate::report) fn new(components: Vec2, bounds: [Option<f64>; 2]) -> PlaneVector {
        let magnitude = components.norm();
        let [x, y] = bounds;
        let error = x.zip(y).map(|(x, y)| Vec2::new(x, y).norm());
        // Covers the rounding errors of the norm, the arc tangent, and the bounds.
        let rounded =
            |value: f64, bound: f64| (bound + 2.0 * f64::EPSILON * value) * ROUND_UP_FACTOR;
        // A vector with a relative error s is turned by at most asin(s), which is at most pi/2 s.
        let turned = |error: f64| {
            let share = error / magnitude * ROUND_UP_FACTOR;
            let turned = (share * FRAC_PI_2).to_degrees();
            (share < 1.0).then(|| rounded(angle::TURN, turned))
        };
        // A vector that may be null has no direction.
        let is_null = magnitude <= error.unwrap_or(0.0);
        let direction = (!is_null).then(|| angle::degrees(components));
        PlaneVector {
            components,
            magnitude,
            direction,
            bounds: [
                x,
                y,
                error.map(|e| rounded(magnitude, e)),
                error.and_then(turned),
            ],
        }
    }

    /// Returns x, y, magnitude and direction as entries.
    pub(crate) fn entries(&self, given: bool) -> [Entry; 4] {
        let Vec2 { x, y } = self.components;
        let values = [Some(x), Some(y), Some(self.magnitude), self.direction];
        std::array::from_fn(|i| Entry {
            value: values[i],
            given,
            bound: self.bounds[i],
        })
    }
}

/// Factor above a few rounding errors of a computed bound.
pub(in crate::report) const ROUND_UP_FACTOR: f64 = 1.0 + 8.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bound_of_shown_zero_includes_hidden_value() {
        let entry = Entry {
            value: Some(3e-17),
            given: false,
            bound: Some(4e-17),
        };
        assert_eq!(entry.display_value(), Some(0.0));
        assert!(entry.display_bound() >= Some(7e-17));
        let entry = Entry {
            value: Some(5e-17),
            ..entry
        };
        assert_eq!(entry.display_bound(), entry.bound);
    }
}
